// searig calibrate: a load cell's counts under known weights -> a calibration to record with.
#include <ctime>
#include <filesystem>
#include <iostream>
#include <memory>

#include "acquisition/calibration/loadcell_calibration.h"
#include "acquisition/error.h"
#include "acquisition/recording/csv.h"
#include "acquisition/recording/text_file.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"

namespace searig::app {
namespace {

using acquisition::KnownWeight;
using acquisition::LoadcellCalibration;

struct Options {
  std::vector<std::string> readings;
  std::string out, json;
  double lever_arm_m = 1.0;
  double gravity = 9.80665;
};

/// "1.5:103580" is 1.5 kg that read as 103580 counts.
KnownWeight reading(const std::string& text, double gravity) {
  const std::size_t colon = text.find(':');
  double kg = 0.0, counts = 0.0;
  if (colon == std::string::npos || !CLI::detail::lexical_cast(text.substr(0, colon), kg) ||
      !CLI::detail::lexical_cast(text.substr(colon + 1), counts))
    throw acquisition::InputError("'" + text + "' is neither a file nor KILOGRAMS:COUNTS.");
  return {kg * gravity, counts};
}

/// A CSV with mass_kg (or force_n) and counts, a row for each reading.
std::vector<KnownWeight> readings_in(const std::filesystem::path& path, double gravity) {
  const acquisition::CsvFile file(path, true);
  const bool by_mass = file.find("mass_kg") < file.header().size();
  const std::size_t force = file.find(by_mass ? "mass_kg" : "force_n");
  const std::size_t counts = file.find("counts");
  if (force == file.header().size()) file.refuse_missing("mass_kg (or force_n)");
  if (counts == file.header().size()) file.refuse_missing("counts");
  const acquisition::CsvRows rows =
      file.read(std::vector{force, counts}, acquisition::Faults::refuse);
  std::vector<KnownWeight> weights;
  for (std::size_t i = 0; i < rows.lines.size(); ++i)
    weights.push_back({rows.columns[0][i] * (by_mass ? gravity : 1.0), rows.columns[1][i]});
  return weights;
}

LoadcellCalibration calibration_of(const Options& options) {
  std::vector<KnownWeight> weights;
  for (const std::string& text : options.readings) {
    if (std::filesystem::is_regular_file(text)) {
      const auto more = readings_in(text, options.gravity);
      weights.insert(weights.end(), more.begin(), more.end());
    } else {
      weights.push_back(reading(text, options.gravity));
    }
  }
  LoadcellCalibration calibration = acquisition::calibrate(std::move(weights));
  calibration.lever_arm_m = options.lever_arm_m;
  const std::time_t now = std::time(nullptr);
  std::tm day{};
  gmtime_r(&now, &day);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", &day);
  calibration.date = text;
  return calibration;
}

nlohmann::json answer(const LoadcellCalibration& c) {
  return {{"format", "searig-calibration/1"},
          {"date", c.date},
          {"tare_counts", c.tare_counts},
          {"tare_ci95_counts", c.tare_ci95_counts},
          {"newton_per_count", c.newton_per_count},
          {"newton_per_count_ci95", c.newton_per_count_ci95},
          {"polarity", c.newton_per_count > 0.0 ? 1 : -1},
          {"lever_arm_m", c.lever_arm_m},
          {"residual_sd_n", c.residual_sd_n},
          {"residuals_n", c.residuals_n},
          {"doubts", acquisition::doubts(c)}};
}

void run(const Options& options) {
  const LoadcellCalibration calibration = calibration_of(options);
  if (!options.out.empty()) acquisition::write_text_file(options.out, to_toml(calibration));
  if (options.json != "-") {
    std::cout << describe(calibration) << '\n';
    for (const std::string& doubt : acquisition::doubts(calibration))
      std::cout << "Look at this: " << doubt << ".\n";
    if (!options.out.empty())
      std::cout << options.out << ": record with --calibration " << options.out << '\n';
  }
  if (!options.json.empty()) write_json(answer(calibration), options.json);
}

}  // namespace

void add_calibrate(CLI::App& app) {
  auto* command = app.add_subcommand("calibrate", "Fit a load cell's counts to known weights");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("READINGS", options->readings,
                   "KILOGRAMS:COUNTS, or CSV files with mass_kg (or force_n) and counts")
      ->required();
  command->add_option("--lever-arm", options->lever_arm_m,
                      "From the joint to the load cell, m; negative where it pulls the other way");
  command->add_option("--gravity", options->gravity, "m/s^2 where the weights hung (9.80665)")
      ->check(CLI::PositiveNumber);
  command->add_option("--out", options->out, "File to write, for searig record --calibration");
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->footer(
      "Example:\n  searig calibrate 0:84012 1:103621 2:123240 5:182065 --lever-arm 0.15 --out "
      "loadcell.toml");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
