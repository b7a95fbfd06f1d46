#include "app/cli/demo_report.h"

#include "app/report/axis.h"
#include "estimator/model/predict.h"

namespace searig::app {
namespace {

using estimator::Evaluation;

std::string with_unit(double value, int decimals, const char* unit) {
  return number(value, decimals) + " " + unit;
}

std::vector<std::string> row(const char* name, std::optional<double> k,
                             const estimator::Score& score, const char* paper) {
  return {name, k ? number(*k, 2) : "–", number(score.error_percent, 1) + " %",
          number(score.rmse_nm, 3), paper};
}

std::vector<std::vector<std::string>> table_one(const DemoResult& result) {
  const Evaluation &good = result.good_start, &poor = result.poor_start;
  std::vector<std::vector<std::string>> rows;
  if (good.best_fit) {
    rows.push_back(
        row("Linear (best fit)", good.best_fit->k_nm_per_rad, good.best_fit->score, "7 %"));
  }
  if (good.online) {
    rows.push_back(row("Online", good.online->k_nm_per_rad, good.online->score, "–"));
  }
  if (poor.online) {
    rows.push_back(row("Online, start ten times too high", poor.online->k_nm_per_rad,
                       poor.online->score, "–"));
  }
  if (result.bare_drive.online) {
    const auto& online = *result.bare_drive.online;
    rows.push_back(row("Online, drive without friction", online.k_nm_per_rad, online.score, "8 %"));
  }
  if (good.current) rows.push_back(row("Motor current", {}, good.current->score, "–"));
  if (result.bare_drive.current) {
    rows.push_back(
        row("Motor current, drive without friction", {}, result.bare_drive.current->score, "21 %"));
  }
  return rows;
}

Plot torque_plot(const History& history) {
  Plot plot{.title = "Torque", .x_label = "time (s)", .y_label = "torque (N·m)"};
  plot.series = {
      {"measured by the load cell", history.measured_t_s, history.measured_nm, Style::line,
       Hue::ink},
      {history.estimated_from, history.t_s, history.estimated_nm, Style::line, Hue::blue}};
  return plot;
}

Plot current_plot(const History& history) {
  Plot plot{
      .title = "Torque from the motor current", .x_label = "time (s)", .y_label = "torque (N·m)"};
  plot.series = {{"measured by the load cell", history.measured_t_s, history.measured_nm,
                  Style::line, Hue::ink},
                 {"motor current, equation (2)", history.t_s, history.current_nm, Style::line,
                  Hue::vermilion}};
  return plot;
}

/// Estimated less measured, at the load cell's own times.
std::vector<double> errors(const History& history, const std::vector<double>& estimate) {
  auto error = estimator::sample_at(history.t_s, estimate, history.measured_t_s);
  for (std::size_t i = 0; i < error.size(); ++i) error[i] -= history.measured_nm[i];
  return error;
}

Plot error_plot(const History& history, const History& bare) {
  Plot plot{.title = "Torque error", .x_label = "time (s)", .y_label = "error (N·m)"};
  plot.series = {{"motor current, equation (2)", bare.measured_t_s, errors(bare, bare.current_nm),
                  Style::line, Hue::vermilion},
                 {"online estimate", history.measured_t_s, errors(history, history.estimated_nm),
                  Style::line, Hue::blue}};
  return plot;
}

Plot weight_plot(const History& history) {
  Plot plot{
      .title = "Trust in the motor current", .x_label = "time (s)", .y_label = "weight (0 to 1)"};
  plot.series = {{"", history.t_s, history.weight, Style::line, Hue::purple}};
  plot.y_range = Range{-0.03, 1.05};
  return plot;
}

Plot stiffness_plot(const History& history, const DemoResult& result) {
  Plot plot{.title = "Spring stiffness", .x_label = "time (s)", .y_label = "stiffness (N·m/rad)"};
  plot.series = {
      {"online estimate", history.t_s, history.stiffness_nm_per_rad, Style::line, Hue::green},
      {"the simulated spring's own", result.truth_t_s, result.truth_nm_per_rad, Style::line,
       Hue::ink}};
  return plot;
}

/// The first 15 s, as long as the paper's figures are.
Plot first_seconds(Plot plot, const History& history) {
  plot.x_range = Range{0.0, std::min(15.0, history.t_s.empty() ? 1.0 : history.t_s.back())};
  return plot;
}

void write_torques(HtmlReport& report, const History& history, const History& bare) {
  report.heading("Torque");
  report.figure(torque_plot(history),
                "The torque that the spring's deflection and the stiffness of that moment give, "
                "against the load cell (the paper's figure 9).",
                {900, 300});
  report.figure(first_seconds(torque_plot(history), history), "Its beginning, enlarged.",
                {900, 300});
  report.figure(first_seconds(current_plot(bare), history),
                "What the motor current alone says by the paper's equation (2) (figure 4): the "
                "train's friction and play stand between it and the truth.",
                {900, 280});
  report.figure(first_seconds(weight_plot(history), history),
                "How far the current is trusted (equation 3, figure 5): while the spring is being "
                "loaded, and not otherwise.",
                {900, 200});
  report.figure(first_seconds(error_plot(history, bare), history), "Both errors (figure 7).",
                {900, 240});
}

void write_stiffness(HtmlReport& report, const History& history, const DemoResult& result) {
  report.heading("Stiffness");
  report.figure(first_seconds(stiffness_plot(history, result), history),
                "From a first guess ten times too high (figure 11).", {900, 260});
  Plot zoomed = stiffness_plot(history, result);
  if (!result.truth_nm_per_rad.empty()) {
    zoomed.y_range = Range{0.0, 1.5 * result.truth_nm_per_rad.front()};
  }
  report.figure(
      zoomed,
      "The simulated rubber softens as it is worked (Mullins effect), and the estimate "
      "follows. The rubber also resists speed a little, so that what is measured in motion "
      "lies up to 5 % above its stiffness at rest.",
      {900, 260});
}

void write_clocks(HtmlReport& report, const Session& session, const SteppedRig& rig,
                  const DemoResult& result) {
  const auto truth = rig.true_clock_map();
  const auto& found = session.clock;
  report.heading("Clocks");
  report.paragraph("Verdict: " + std::string(found.trusted ? "trusted" : "not trusted") + ": " +
                   found.why);
  report.table(
      {"load-cell clock to module clock", "found", "truth"},
      {{"rate of the load cell's clock against the module's (ppm)",
        number(1e6 * (1.0 / found.rate - 1.0), 2), number(1e6 * (1.0 / truth.rate - 1.0), 2)},
       {"error of the mapped time at the middle (ms)", number(1e3 * result.clock_error_s, 2), "0"},
       {"95 % interval (ms)", "±" + number(1e3 * found.ci95_s, 2), "–"}},
      "The truth is known because the rig is simulated.");
}

void write_streams(HtmlReport& report, const Session& session) {
  std::vector<std::vector<std::string>> rows;
  for (const auto* stream : {&session.recording.module, &session.recording.loadcell}) {
    const auto& counts = stream->counts;
    rows.push_back({stream->name, std::to_string(counts.received), std::to_string(counts.lost),
                    std::to_string(counts.doubled), std::to_string(counts.garbled),
                    std::to_string(counts.out_of_order)});
  }
  report.table({"stream", "received", "lost", "doubled", "garbled", "out of order"}, rows);
}

}  // namespace

HtmlReport demo_report(const Session& session, const SteppedRig& rig, const DemoResult& result) {
  const History history = history_of(session.signals, result.poor_start);
  HtmlReport report("Calibration of a simulated series elastic actuator");
  report.paragraph(
      "A module with a geared motor and a rubber spring follows a motion while a hand pulls at its "
      "lever. The stiffness of the spring is estimated from the motor current while the experiment "
      "goes on; a load cell at the lever says what the torque really was.");
  const auto& online = result.poor_start.online;
  report.facts(
      {{"stiffness, online", online ? with_unit(online->k_nm_per_rad, 1, "N·m/rad") : "–"},
       {"true stiffness", with_unit(result.truth_nm_per_rad.back(), 1, "N·m/rad")},
       {"torque error, online",
        result.good_start.online ? number(result.good_start.online->score.error_percent, 1) + " %"
                                 : "–"},
       {"clocks", "±" + with_unit(1e3 * session.clock.ci95_s, 1, "ms")},
       {"length", with_unit(result.good_start.seconds, 0, "s")}});
  report.table({"torque model", "stiffness (N·m/rad)", "error", "RMSE (N·m)", "paper"},
               table_one(result),
               "The paper's Table I on this recording. Error: mean |estimate − measured| over mean "
               "|measured|, at the load cell's own times. The online stiffness is the last.");
  report.paragraph("Drive torque: " + result.good_start.drive_from +
                   "; without friction: " + result.bare_drive.drive_from + ".");
  write_torques(report, history, history_of(session.signals, result.bare_drive));
  write_stiffness(report, history, result);
  write_clocks(report, session, rig, result);
  write_streams(report, session);
  report.heading("The model that was believed");
  report.code(estimator::to_toml(rig.model()));
  return report;
}

}  // namespace searig::app
