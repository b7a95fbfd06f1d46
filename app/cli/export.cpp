// searig export: a recording on one clock, for other programs.
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "acquisition/recording/text_file.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/session/export_csv.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string recording;
  std::string format = "csv";
  std::string out;
  std::string json;
  bool long_form = false;
};

void say(const Session& session, const fs::path& out) {
  std::cout << out.string() << ": " << session.signals.loadcell.t_s.size()
            << " load-cell samples on the module's clock, +- " << 1e3 * session.clock.ci95_s
            << " ms\n";
  if (!session.clock.trusted) std::cout << "clocks: NOT TRUSTED: " << session.clock.why << '\n';
}

nlohmann::json answer(const Session& session, const fs::path& out) {
  return {{"format", "searig-export/1"},
          {"file", out.string()},
          {"module_samples", session.signals.module.t_s.size()},
          {"loadcell_samples", session.signals.loadcell.t_s.size()},
          {"clock", {{"ci95_s", session.clock.ci95_s}, {"trusted", session.clock.trusted}}}};
}

void run(const Options& options) {
  const Session session = open_session(options.recording);
  fs::path out = options.out;
  std::error_code not_there;
  if (fs::is_directory(out, not_there)) out /= session.recording.name + ".csv";
  const std::string text = options.long_form ? to_csv_long(session) : to_csv_table(session);
  if (options.out == "-") {
    std::cout << text << std::flush;
    if (!std::cout) throw std::runtime_error("stdout: cannot be written.");
    if (!options.json.empty()) write_json(answer(session, "-"), options.json);
    return;
  }
  acquisition::write_text_file(out, text);
  if (options.json != "-") say(session, out);
  if (!options.json.empty()) write_json(answer(session, out), options.json);
}

}  // namespace

void add_export(CLI::App& app) {
  auto* command = app.add_subcommand("export", "Write a recording, on one clock, for others");
  const auto options = std::make_shared<Options>();
  command->add_option("RECORDING", options->recording, "A folder with a recording.toml, or .mcap")
      ->required();
  command->add_option("--format", options->format, "csv")->check(CLI::IsMember({"csv"}));
  command->add_option("--out", options->out, "File, or folder to put it in (- for stdout)")
      ->required();
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->add_flag("--long", options->long_form,
                    "One value per row as received, nothing interpolated");
  command->footer("Example:\n  searig export my_recording --format csv --out my_recording.csv");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
