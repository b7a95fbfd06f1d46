#include "estimator/diagnosis/search/refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace searig::estimator {
namespace {

constexpr int time_cells = 48;
constexpr double for_a_while = 1.15;  // times the gain of a change for good, and
constexpr double further = 20.0;      // in deviance

/// How much an atom would gain beside the rest.
class Trial {
 public:
  Trial(const Bench& bench, const Hypothesis& rest) : bench_(bench), fit_(bench.fit(rest)) {}

  double gain(const Atom& atom) const { return projection_.gain(columns(atom)).sse; }
  Eigen::MatrixXd free_columns(const Atom& atom) const {
    return projection_.free_part(columns(atom));
  }
  const Eigen::VectorXd& residual() const { return projection_.residual(); }

 private:
  Eigen::MatrixXd columns(const Atom& atom) const {
    return bench_.whitening()(bench_.stack(atom.path, atom.feature, 0.0, 0.0));
  }

  const Bench& bench_;
  Fit fit_;
  Projection projection_{fit_.free_columns, fit_.free_right};
};

Atom moved(const Atom& atom, double from, double to) {
  Atom out = atom;
  out.from = from, out.to = to;
  out.feature = atom.at(from, to);
  return out;
}

/// A run of cells and what it gains.
struct Window {
  int first = 0, end = time_cells;
  double gain = -1.0;
};

/// The best of all windows of time, or of those that last to the end. A window is the sum of its
/// cells, so their moments and products tell every window's gain.
Window best_window(const Eigen::VectorXd& moment, const Eigen::MatrixXd& product, bool to_the_end) {
  Window best;
  for (int first = to_the_end ? 1 : 0; first < time_cells; ++first) {
    double m = 0.0, p = 0.0, own = 0.0;
    for (int cell = first; cell < time_cells; ++cell) {
      m += moment[cell];
      own += product(cell, cell);
      p += product(cell, cell) + 2.0 * product.col(cell).segment(first, cell - first).sum();
      const bool last = cell + 1 == time_cells;
      // What is left of a window that the rest of the hypothesis spans is rounding.
      if (p <= 1e-6 * own || last != to_the_end) continue;
      if (const double gain = m * m / p; gain > best.gain) best = {first, cell + 1, gain};
    }
  }
  return best;
}

/// The window of time in which the atom explains most, from a coarse grid.
Atom placed_in_time(const Trial& trial, const Atom& atom, double end_s) {
  const double cell_s = end_s / time_cells;
  Eigen::MatrixXd cells(trial.residual().size(), time_cells);
  for (int i = 0; i < time_cells; ++i)
    cells.col(i) = trial.free_columns(moved(atom, i * cell_s, (i + 1) * cell_s));
  const Eigen::VectorXd moment = cells.transpose() * trial.residual();
  const Eigen::MatrixXd product = cells.transpose() * cells;
  const Window for_good = best_window(moment, product, true);
  const Window while_it_lasts = best_window(moment, product, false);
  const bool lasts = atom.at_once && while_it_lasts.gain < for_a_while * for_good.gain + further;
  const Window& window = lasts ? for_good : while_it_lasts;
  Atom out = moved(atom, window.first * cell_s, lasts ? end_s : window.end * cell_s);
  out.at_once = lasts;
  if (atom.at_once && !lasts) out.what += ", for a while";
  return trial.gain(out) > trial.gain(atom) ? out : atom;
}

/// Both edges in time, to a tenth of a coarse cell and then finer.
Atom with_sharp_edges(const Trial& trial, Atom best, double end_s) {
  double most = trial.gain(best);
  for (const double step : {end_s / time_cells / 20.0, end_s / time_cells / 200.0})
    for (const bool begin : {true, false}) {
      if (best.at_once && !begin) continue;
      const Atom start = best;
      for (int i = -24; i <= 24; ++i) {
        const double from = start.from + (begin ? i * step : 0.0);
        const double to = start.to + (begin ? 0.0 : i * step);
        if (!(to > from)) continue;
        const Atom other = moved(start, from, to);
        if (const double g = trial.gain(other); g > most) most = g, best = other;
      }
    }
  return best;
}

/// Borders over any other channel, downhill from the coarse ones.
Atom with_moved_borders(const Trial& trial, Atom best) {
  double most = trial.gain(best);
  double step = 0.5 * (best.to - best.from);
  const std::array<std::pair<double, double>, 8> moves{
      {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};
  for (int round = 0; round < 8; ++round, step *= 0.6)
    for (const auto& [from, to] : moves) {
      const double begins = best.from + step * from, ends = best.to + step * to;
      if (!(ends > begins)) continue;
      const Atom other = moved(best, begins, ends);
      if (const double g = trial.gain(other); g > most) most = g, best = other;
    }
  return best;
}

}  // namespace

Atom refined(const Bench& bench, const Hypothesis& rest, const Atom& atom) {
  if (!atom.at) return atom;
  const Trial trial(bench, rest);
  if (atom.channel != "time_s") return with_moved_borders(trial, atom);
  const double end_s = bench.experiment().motion.t.back();
  return with_sharp_edges(trial, placed_in_time(trial, atom, end_s), end_s);
}

std::pair<std::size_t, std::size_t> loudest_run(std::span<const double> squares,
                                                std::span<const double> counts) {
  double all = 0.0, rows = 0.0;
  for (std::size_t i = 0; i < squares.size(); ++i) all += squares[i], rows += counts[i];
  const auto badness = [](double sum, double n) {  // -2 log likelihood, up to constants
    return n > 0.0 && sum > 0.0 ? n * std::log(sum / n) : 0.0;
  };
  std::pair<std::size_t, std::size_t> best{0, squares.size() - 1};
  double least = badness(all, rows);
  for (std::size_t first = 0; first < squares.size(); ++first) {
    double in = 0.0, n = 0.0;
    for (std::size_t last = first; last < squares.size(); ++last) {
      in += squares[last], n += counts[last];
      if (n <= 0.0 || in / n <= (all - in) / std::max(1.0, rows - n)) continue;
      const double now = badness(in, n) + badness(all - in, rows - n);
      if (now < least) least = now, best = {first, last};
    }
  }
  return best;
}

}  // namespace searig::estimator
