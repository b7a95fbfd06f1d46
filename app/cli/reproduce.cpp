// searig reproduce: the paper's Table I and figures on its digital twin.
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/progress_line.h"
#include "app/reproduce/answer.h"
#include "app/reproduce/page.h"

namespace searig::app {
namespace {

struct Options {
  std::filesystem::path out;
  std::string json;
  reproduce::Settings settings;
};

reproduce::Reproduction run_trials(const Options& options) {
  ProgressLine line;
  return reproduce::reproduce(options.settings, [&](double share) { line.say("trials", share); });
}

void run(const Options& options) {
  std::error_code error;
  std::filesystem::create_directories(options.out, error);
  if (error) {
    throw std::runtime_error(options.out.string() + ": cannot be made: " + error.message() + ".");
  }
  const auto all = run_trials(options);
  const auto figures = reproduce::figures(all);
  for (const auto& figure : figures) reproduce::write_files(figure, options.out);
  const auto report = options.out / "reproduction.html";
  reproduce::page(all, figures).write(report);
  if (options.json != "-") {
    for (const auto& words : reproduce::describe(all)) std::cout << words << '\n';
    std::cout << "Report: " << report.string() << "; figures beside it, as PNG and CSV.\n";
  }
  if (!options.json.empty()) write_json(reproduce::to_json(all, figures), options.json);
}

}  // namespace

void add_reproduce(CLI::App& app) {
  auto* command =
      app.add_subcommand("reproduce", "The paper's Table I and figures on its digital twin");
  const auto options = std::make_shared<Options>();
  command->add_option("--out", options->out, "Folder for the page, the pictures and their numbers")
      ->required();
  command->add_option("--seeds", options->settings.seeds, "How many trials (default 30)")
      ->check(CLI::Range(1, 1000));
  command->add_option("--jobs", options->settings.jobs,
                      "Trials at the same time (0: one per core)");
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->footer("Example:\n  searig reproduce --out reproduction");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
