// searig recover: what a damaged or unfinished recording still holds, as a whole file.
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

#include "acquisition/error.h"
#include "acquisition/recording/mapped_file.h"
#include "acquisition/recording/mcap/layout.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "acquisition/recording/mcap/recover.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/new_mcap.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;
namespace mcap = acquisition::mcap;

struct Options {
  fs::path damaged, out;
  std::string json;
};

std::uint64_t count(const mcap::Recovered& recovered, const char* topic) {
  const auto found = recovered.messages.find(topic);
  return found == recovered.messages.end() ? 0 : found->second;
}

/// What was lost, in one sentence.
std::string loss(const mcap::Recovered& recovered, std::size_t size) {
  const std::string sentence = mcap::cut_off(recovered.ending, size);
  return sentence.empty() ? "The file is whole: nothing was lost." : sentence;
}

nlohmann::json answer(const Options& options, const mcap::Recovered& recovered, std::size_t size) {
  const bool all = recovered.ending.all_data();
  return {{"format", "searig-recover/1"},
          {"file", options.out.string()},
          {"whole", recovered.ending.end == mcap::End::whole},
          {"lost_bytes", all ? 0 : size - recovered.ending.valid_bytes},
          {"what", loss(recovered, size)},
          {"seconds", recovered.seconds},
          {"module_samples", count(recovered, mcap::module_topic)},
          {"loadcell_samples", count(recovered, mcap::loadcell_topic)}};
}

void say(const Options& options, const mcap::Recovered& recovered, std::size_t size) {
  std::cout << loss(recovered, size) << '\n';
  std::printf("%s: %.3f s, %llu samples of the module and %llu of the load cell\n",
              options.out.c_str(), recovered.seconds,
              static_cast<unsigned long long>(count(recovered, mcap::module_topic)),
              static_cast<unsigned long long>(count(recovered, mcap::loadcell_topic)));
}

void run(const Options& options) {
  const acquisition::MappedFile file(options.damaged);
  mcap::Recovered recovered;
  new_mcap(options.out, [&](const mcap::Writer::Sink& sink) {
    recovered = mcap::recover(file.bytes(), "searig " SEARIG_VERSION, sink);
    if (recovered.messages.empty())
      throw acquisition::InputError(options.damaged.string() + ": " + recovered.ending.why +
                                    "; there is nothing that could be recovered.");
  });
  const std::size_t size = file.bytes().size();
  give(
      options.json, [&] { say(options, recovered, size); },
      [&] { return answer(options, recovered, size); });
}

}  // namespace

void add_recover(CLI::App& app) {
  auto* command =
      app.add_subcommand("recover", "Make a whole file of what a damaged recording still holds");
  const auto options = std::make_shared<Options>();
  command->add_option("FILE", options->damaged, "Recording (.mcap), damaged or never finished")
      ->required();
  command->add_option("--out", options->out, "File to make")->required();
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->footer("Example:\n  searig recover crashed.mcap --out recovered.mcap");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
