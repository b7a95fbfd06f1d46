#include "app/report/diagnosis_plots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/report/quantity.h"
#include "estimator/model/predict.h"
#include "estimator/physics/catalogue.h"
#include "estimator/physics/motion.h"

namespace searig::app {
namespace {

constexpr double half_width_s = 0.024;  // of the derivatives, as predict() takes them
constexpr std::size_t most_dots = 4000;

/// What is compared in a picture. `before` is empty where there is nothing to compare with.
struct Residuals {
  std::vector<double> t_s, before, after;
  std::string before_name, after_name;
};

/// The model as it came, at the load cell's samples, where `like` has a value.
std::vector<double> as_given(const Examined& examined, Against path,
                             const std::vector<double>& like) {
  const auto& traces = examined.diagnosis.traces;
  const auto torques = estimator::predict(*examined.given, examined.signals.module);
  const auto& model_nm = path == Against::spring ? torques.loadcell_nm : torques.drive_nm;
  if (model_nm.empty()) return {};
  std::vector<double> out = estimator::sample_at(examined.signals.module.t_s, model_nm, traces.t_s);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = std::isfinite(like[i]) ? traces.measured_nm[i] - out[i] : like[i];
  }
  return out;
}

Residuals residuals_of(const Examined& examined, Against path) {
  const auto& d = examined.diagnosis;
  const bool spring = path == Against::spring;
  Residuals r{d.traces.t_s, spring ? d.traces.spring_before_nm : d.traces.drive_before_nm,
              spring ? d.traces.spring_after_nm : d.traces.drive_after_nm,
              "before: same physics, best numbers", "after: with what was missing"};
  if (d.verdict == estimator::Verdict::unexplained) {
    r.after_name = "after: with a curve that has no name";
  } else if (d.verdict == estimator::Verdict::recalibrate && examined.given) {
    r.before = as_given(examined, path, r.after);
    r.before_name = "before: numbers as the model had them";
    r.after_name = "after: best numbers";
  } else if (d.verdict != estimator::Verdict::missing_physics) {
    r.before.clear();
    r.after_name = "what is left";
  }
  return r;
}

std::string words_for(Against path) {
  return path == Against::spring ? "Load cell less spring" : "Load cell less motor current";
}

/// A line must not join what lies apart: the drive sticks in between, or another recording begins.
void break_at_gaps(Series& series, double longest_s) {
  Series out = series;
  out.x.clear(), out.y.clear();
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!out.x.empty() && series.x[i] - series.x[i - 1] > longest_s) {
      out.x.push_back(series.x[i]);
      out.y.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    out.x.push_back(series.x[i]);
    out.y.push_back(series.y[i]);
  }
  series = std::move(out);
}

std::vector<Series> lines_of(const Residuals& r) {
  std::vector<Series> out;
  if (!r.before.empty()) {
    out.push_back({r.before_name, r.t_s, r.before, Style::line, Hue::vermilion});
  }
  out.push_back({r.after_name, r.t_s, r.after, Style::line, Hue::blue});
  for (Series& series : out) break_at_gaps(series, 1.0);
  return out;
}

/// A few wild samples must not flatten all the others.
Range y_range_of(const Residuals& r, std::optional<Range> within = {}) {
  std::vector<double> size;
  for (std::size_t i = 0; i < r.t_s.size(); ++i) {
    if (within && (r.t_s[i] < within->low || r.t_s[i] > within->high)) continue;
    for (const auto* column : {&r.before, &r.after}) {
      if (i < column->size() && std::isfinite((*column)[i])) size.push_back(std::abs((*column)[i]));
    }
  }
  if (size.empty()) return {-1.0, 1.0};
  std::ranges::sort(size);
  const double most = size[static_cast<std::size_t>(0.998 * double(size.size() - 1))];
  const double half = 1.15 * std::min(size.back(), 1.6 * most);
  return {-half, half};
}

/// Where the finding changes the residual most, of windows of that length.
double busiest(const Residuals& r, double seconds) {
  double best = -1.0, best_start = r.t_s.empty() ? 0.0 : r.t_s.front(), sum = 0.0;
  const auto energy = [&](std::size_t i) {
    if (r.before.empty()) return 0.0;
    const double difference = r.before[i] - r.after[i];
    return std::isfinite(difference) ? difference * difference : 0.0;
  };
  std::size_t from = 0;
  for (std::size_t i = 0; i < r.t_s.size(); ++i) {
    sum += energy(i);
    while (r.t_s[i] - r.t_s[from] > seconds) sum -= energy(from++);
    if (sum > best && r.t_s[i] - r.t_s.front() >= seconds) best = sum, best_start = r.t_s[from];
  }
  return best_start;
}

}  // namespace

Against path_of(const Examined& examined, const std::string& effect) {
  const auto* known = estimator::find_effect(effect);
  const bool drive = known && known->path() == estimator::Path::drive;
  return (drive && examined.diagnosis.drive) || !examined.diagnosis.spring ? Against::drive
                                                                           : Against::spring;
}

Against main_path(const Examined& examined) {
  const estimator::Diagnosis& d = examined.diagnosis;
  if (!d.findings.empty()) return path_of(examined, d.findings.front().effect);
  if (d.unexplained && d.drive && !d.unexplained->located.residuals.empty() &&
      d.unexplained->located.residuals.front() == "loadcell-drive") {
    return Against::drive;
  }
  return d.spring ? Against::spring : Against::drive;
}

std::vector<std::pair<double, double>> intervals_to_shade(const Examined& examined) {
  const auto& d = examined.diagnosis;
  std::vector<std::pair<double, double>> intervals;
  if (!d.findings.empty())
    intervals = d.findings.front().located.intervals_s;
  else if (d.unexplained)
    intervals = d.unexplained->located.intervals_s;
  double covered = 0.0;
  for (const auto& [from, to] : intervals) covered += to - from;
  if (covered > 0.85 * seconds_of(examined.parts)) intervals.clear();
  return intervals;
}

bool has_path(const Examined& examined, Against path) {
  const auto& d = examined.diagnosis;
  return path == Against::spring ? d.spring.has_value() : d.drive.has_value();
}

Plot residual_over_time(const Examined& examined, Against path,
                        const std::vector<std::pair<double, double>>& intervals_s) {
  Plot plot{.title = words_for(path),
            .x_label = "time on the module's clock (s)",
            .y_label = "difference (N·m)"};
  const Residuals r = residuals_of(examined, path);
  plot.series = lines_of(r);
  plot.y_range = y_range_of(r);
  for (const auto& [from, to] : intervals_s) plot.shaded.push_back({from, to, Hue::orange});
  plot.shaded_name = "where it shows most";
  if (examined.parts.size() > 1) {
    for (const Part& part : examined.parts) plot.marks.push_back({part.from_s, part.name});
  }
  return plot;
}

Plot closer_look(const Examined& examined, Against path, double seconds) {
  const Residuals r = residuals_of(examined, path);
  Plot plot{.title = words_for(path) + ", enlarged",
            .x_label = "time on the module's clock (s)",
            .y_label = "difference (N·m)"};
  plot.series = lines_of(r);
  const double start = busiest(r, seconds);
  plot.x_range = Range{start, start + seconds};
  plot.y_range = y_range_of(r, plot.x_range);
  return plot;
}

std::optional<Plot> residual_over(const Examined& examined, Against path,
                                  const std::string& channel) {
  const auto motion = estimator::motion_of(examined.signals.module, half_width_s);
  const auto* values = estimator::channel_of(motion, channel);
  if (!values || channel == "time_s") return std::nullopt;
  const Residuals r = residuals_of(examined, path);
  const auto x = estimator::sample_at(examined.signals.module.t_s, *values, r.t_s);
  Plot plot{.title = words_for(path) + " over the " + quantity_of(channel).name,
            .x_label = label_of(channel),
            .y_label = "difference (N·m)"};
  const std::size_t stride = r.t_s.size() / most_dots + 1;
  const auto add = [&](const std::string& name, const std::vector<double>& y, Hue hue) {
    Series series{name, {}, {}, Style::dots, hue};
    for (std::size_t i = 0; i < y.size(); i += stride) {
      series.x.push_back(x[i]);
      series.y.push_back(y[i]);
    }
    if (!y.empty()) plot.series.push_back(std::move(series));
  };
  add(r.before_name, r.before, Hue::vermilion);
  add(r.after_name, r.after, Hue::blue);
  plot.y_range = y_range_of(r);
  return plot;
}

}  // namespace searig::app
