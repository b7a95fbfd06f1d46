// searig simulate: the recording that a model would have made.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "acquisition/recording/text_file.h"
#include "acquisition/recording/write_recording.h"
#include "app/cli/commands.h"
#include "app/session/motion_spec.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string model_or_spec, like, out;
  double noise_nm = 0.0, noise_a = 0.0;
  std::uint64_t seed = 1;
};

void keep(const Simulated& simulated, const estimator::Model& model, const fs::path& out) {
  acquisition::write_recording(simulated.recording, out);
  acquisition::write_text_file(out / "model.toml", to_toml(model));
  std::printf("Simulated: %s, %zu samples of the module, %zu of the load cell, with model.toml\n",
              out.c_str(), simulated.recording.module.t_s.size(),
              simulated.recording.loadcell.t_s.size());
  for (const auto& note : simulated.notes) std::printf("Note: %s.\n", note.c_str());
}

void run_like(const Options& options) {
  std::error_code ignored;
  if (fs::equivalent(options.like, options.out, ignored))
    throw std::runtime_error(options.out + " is the recording itself; it is not overwritten.");
  const auto model = find_model(std::filesystem::path(), options.model_or_spec);
  const Session like = open_session(options.like);
  keep(simulate(*model, like, {options.noise_nm, options.noise_a, options.seed}), *model,
       options.out);
}

void run_spec(const Options& options) {
  const MotionSpec spec = read_motion_spec(options.model_or_spec);
  const Session like = session_of(recording_of(spec));
  keep(simulate(spec.model, like, spec.noise), spec.model, options.out);
}

}  // namespace

void add_simulate(CLI::App& app) {
  auto* command = app.add_subcommand("simulate", "The recording that a model would have made");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("MODEL", options->model_or_spec,
                   "A model file with --like; without, a spec that has model and motion")
      ->required();
  auto* like = command->add_option("--like", options->like,
                                   "Recording whose motion, clocks and sample times are taken");
  command->add_option("--out", options->out, "Folder for the simulated recording")->required();
  const CLI::Validator number = CLI::NonNegativeNumber;
  command->add_option("--noise-nm", options->noise_nm, "White noise on the load cell, N*m")
      ->check(number)
      ->needs(like);
  command->add_option("--noise-a", options->noise_a, "White noise on the current, A")
      ->check(number)
      ->needs(like);
  command->add_option("--seed", options->seed, "Of the noise (default 1)")->needs(like);
  command->footer(
      "Examples:\n  searig simulate better.toml --like my_recording --out simulated\n"
      "  searig simulate spec.toml --out simulated\n\n"
      "A spec:\n"
      "  format = \"searig-spec/1\"\n"
      "  model = \"model.toml\"          # or [model.spring.linear] and so on, here\n"
      "  [motion]\n"
      "  kind = \"multisine\"            # triangle, sine, multisine, staircase, hold\n"
      "  seconds = 60.0\n"
      "  amplitudes_rad = [0.05, 0.2]  # of the deflection, one after the other\n"
      "  frequencies_hz = [0.1, 1.0]   # beside them; steps per second of a staircase\n"
      "  output_rad = 0.3              # swing of the lever; 0: locked\n"
      "  [rates]\n"
      "  module_hz = 500.0\n"
      "  loadcell_hz = 50.0\n"
      "  [noise]\n"
      "  loadcell_nm = 0.01\n"
      "  current_a = 0.02\n"
      "  seed = 1\n"
      "  [temperature]                 # from, to\n"
      "  spring_c = [25.0, 35.0]\n"
      "  winding_c = [25.0, 60.0]");
  command->callback([options] { options->like.empty() ? run_spec(*options) : run_like(*options); });
}

}  // namespace searig::app
