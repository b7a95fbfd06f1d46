#include "app/reproduce/figure.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>

#include "app/report/axis.h"
#include "app/report/png.h"
#include "app/report/quantity.h"
#include "app/reproduce/window.h"
#include "app/reproduce/words.h"

namespace searig::app::reproduce {
namespace {

constexpr const char *time_label = "Time (sec)", *torque_label = "Torque (N·m)";

/// The rows that the paper's Table I has, in its colours here.
Hue hue_of(const std::string& key) {
  if (key == "best_fit") return Hue::ink;
  return key == "current" ? Hue::vermilion : Hue::blue;
}

/// "Figure 4: torque ..." is "Torque ..." where the number stands above it.
std::string without_number(const std::string& title) {
  return capital(title.substr(title.find(": ") + 2));
}

Figure table_figure(const Reproduction& all) {
  Figure out{.name = "table_1", .title = "Table I: the average error of the torque models"};
  out.plot = {.title = "Table I, trial by trial", .x_label = "Trial", .y_label = "Error (%)"};
  std::vector<double> trial;
  for (const auto& t : all.trials) trial.push_back(static_cast<double>(t.seed));
  out.columns.push_back({"trial", trial});
  for (const Row& row : table_1(all, all.trials)) {
    out.columns.push_back({row.key + "_error_percent", row.trials});
    if (!row.paper) continue;
    out.plot.series.push_back({row.name, trial, row.trials, Style::dots, hue_of(row.key)});
    out.plot.levels.push_back(
        {*row.paper, "the paper's " + number(*row.paper, 0) + " %", hue_of(row.key)});
  }
  out.plot.x_range = Range{0, trial.back() + 1};
  out.plot.y_range = Range{0, 35};
  return out;
}

constexpr double degrees(double rad) {
  return rad * 180.0 / std::numbers::pi;
}

Figure mullins_figure(const Reproduction& all) {
  const auto& cycles = all.cycles;
  const std::size_t count = cycles.stiffness_nm_per_rad.size();
  const std::size_t per_cycle = cycles.t_s.size() / count;
  Figure out{.name = "figure_03", .title = "Figure 3: the Mullins effect"};
  out.plot = {.title = "Mullins effect: the spring softens upon repeated cycling",
              .x_label = "Angular displacement (degrees)",
              .y_label = torque_label};
  const auto add = [&](std::size_t cycle, Hue hue) {
    Series series{"cycle " + std::to_string(cycle + 1) + ": " +
                      number(cycles.stiffness_nm_per_rad[cycle], 1) + " N·m/rad",
                  {},
                  {},
                  Style::line,
                  hue};
    for (std::size_t i = cycle * per_cycle; i <= (cycle + 1) * per_cycle; ++i) {
      series.x.push_back(degrees(cycles.deflection_rad[i]));
      series.y.push_back(cycles.torque_nm[i]);
    }
    out.plot.series.push_back(std::move(series));
  };
  add(0, Hue::ink), add(count / 4, Hue::blue), add(count - 1, Hue::vermilion);
  out.plot.x_range = Range{-8, 8}, out.plot.y_range = Range{-8, 8};
  out.size = {700, 440};
  out.columns = {{"t_s", cycles.t_s},
                 {"deflection_rad", cycles.deflection_rad},
                 {"torque_nm", cycles.torque_nm}};
  return out;
}

/// Measured torque and one estimate of it.
Figure torque_figure(std::string name, std::string title, const Window& window,
                     const std::vector<double>& estimate, const std::vector<double>& at_loadcell,
                     Series style) {
  Figure out{.name = std::move(name), .title = std::move(title)};
  out.plot = {.title = without_number(out.title), .x_label = time_label, .y_label = torque_label};
  style.x = window.t_s, style.y = estimate;
  out.plot.series = {
      {"measured by the load cell", window.measured_t_s, window.measured_nm, Style::line, Hue::ink},
      std::move(style)};
  out.columns = {{"t_s", window.measured_t_s},
                 {"measured_nm", window.measured_nm},
                 {"estimated_nm", at_loadcell}};
  return out;
}

Figure error_figure(std::string name, std::string title, const Window& window) {
  Figure out{.name = std::move(name), .title = std::move(title)};
  out.plot = {
      .title = without_number(out.title), .x_label = time_label, .y_label = "Torque error (N·m)"};
  out.plot.series = {
      {"motor current", window.measured_t_s, window.current_error_nm, Style::line, Hue::vermilion},
      {"spring deflection, stiffness estimated online", window.measured_t_s, window.online_error_nm,
       Style::line, Hue::blue}};
  out.plot.levels = {{0.0, "", Hue::ink}};
  out.columns = {{"t_s", window.measured_t_s},
                 {"current_error_nm", window.current_error_nm},
                 {"online_error_nm", window.online_error_nm}};
  return out;
}

Figure weight_figure(const Window& window) {
  Figure out{.name = "figure_05", .title = "Figure 5: how far the motor current is trusted"};
  out.plot = {.title = "Heuristic Weight", .x_label = time_label, .y_label = "Weight"};
  out.plot.series = {{"", window.t_s, window.weight, Style::line, Hue::purple}};
  out.plot.y_range = Range{0, 1};
  out.columns = {{"t_s", window.t_s}, {"weight", window.weight}};
  return out;
}

Figure stiffness_figure(const Window& window, double best_fit) {
  Figure out{.name = "figure_11", .title = "Figure 11: the stiffness from a poor start"};
  out.plot = {.title = "Estimated spring constant, started ten times too high",
              .x_label = time_label,
              .y_label = "Spring constant (N·m/rad)"};
  out.plot.series = {
      {"estimated online", window.t_s, window.stiffness_nm_per_rad, Style::line, Hue::green}};
  out.plot.levels = {{best_fit, "best fit of the whole trial", Hue::ink}};
  out.plot.y_range = Range{0, 10.5 * best_fit};
  out.columns = {{"t_s", window.t_s}, {"stiffness_nm_per_rad", window.stiffness_nm_per_rad}};
  return out;
}

}  // namespace

std::vector<Figure> figures(const Reproduction& all) {
  const double seconds = all.settings.protocol.figure_seconds;
  const Window good = window_of(all.shown, all.shown.good, seconds);
  const Window poor = window_of(all.shown, all.shown.poor, seconds);
  const Series current{"motor current, equation (2)", {}, {}, Style::line, Hue::vermilion};
  const Series online{
      "spring deflection, stiffness estimated online", {}, {}, Style::line, Hue::blue};
  std::vector<Figure> out = {
      table_figure(all),
      mullins_figure(all),
      torque_figure("figure_04", "Figure 4: torque from the motor current", good, good.current_nm,
                    good.measured_current_nm, current),
      weight_figure(good),
      torque_figure("figure_06", "Figure 6: torque from the spring, online", good, good.online_nm,
                    good.measured_online_nm, online),
      error_figure("figure_07", "Figure 7: the errors of both", good),
      torque_figure("figure_09", "Figure 9: torque from a poor start", poor, poor.online_nm,
                    poor.measured_online_nm, online),
      error_figure("figure_10", "Figure 10: the errors from a poor start", poor),
      stiffness_figure(poor, all.shown.figures.best_fit_k_nm_per_rad)};
  for (std::size_t i = 2; i < out.size(); ++i) {
    out[i].plot.x_range = Range{0, seconds};
    out[i].plot.x_ticks = 3;  // 0, 5, 10, 15, as in the paper
  }
  const std::vector<Words> words = {
      table_words(all),        mullins_words(all),     current_words(all, good),
      weight_words(good),      online_words(good),     error_words(good),
      poor_torque_words(poor), poor_error_words(poor), stiffness_words(all, poor)};
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].paper = words[i].paper;
    out[i].ours = words[i].ours;
    out[i].verdict = words[i].verdict();
    out[i].agrees = words[i].agrees;
  }
  return out;
}

void write_files(const Figure& figure, const std::filesystem::path& folder) {
  write_png(figure.plot, folder / (figure.name + ".png"), figure.size);
  const auto file = folder / (figure.name + ".csv");
  std::string text;
  for (const auto& column : figure.columns) text += (text.empty() ? "" : ",") + column.name;
  for (std::size_t i = 0; i < figure.columns.front().values.size(); ++i) {
    text += '\n';
    for (const auto& column : figure.columns) {
      char digits[32];
      const auto end = std::to_chars(digits, digits + sizeof digits, column.values[i]).ptr;
      if (&column != &figure.columns.front()) text += ',';
      text.append(digits, end);
    }
  }
  std::ofstream out(file, std::ios::binary);
  out << text << '\n' << std::flush;
  if (!out) throw std::runtime_error(file.string() + ": cannot be written.");
}

}  // namespace searig::app::reproduce
