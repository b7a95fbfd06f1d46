#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>

#include "tests/proving/plan/generate.h"
#include "tests/proving/score/controls.h"
#include "tests/proving/score/score.h"

namespace {

struct GenerateOptions {
  std::string out, set = "full";
  std::uint64_t seed = 1;
  int count = 0, threads = 2;
};

CLI::App* add_generate(CLI::App& app, GenerateOptions& o) {
  auto* c = app.add_subcommand("generate", "Write recordings and, apart from them, their answers");
  c->footer("Example: searig-prove generate --out /tmp/ground --set small");
  c->add_option("--out", o.out, "Folder to write to")->required();
  c->add_option("--seed", o.seed, "Another seed, another proving ground");
  c->add_option("--set", o.set, "small, full, or one stratum such as 'single weak'");
  c->add_option("--count", o.count, "At most so many");
  c->add_option("--threads", o.threads, "At once");
  return c;
}

CLI::App* add_scoring(CLI::App& app, const std::string& name, const std::string& what,
                      searig::proving::ScoreOptions& o) {
  auto* c = app.add_subcommand(name, what);
  c->footer("Example: searig-prove " + name +
            " build/release/searig /tmp/ground --out results.json");
  c->add_option("tool", o.tool.program, "The program that diagnoses")->required();
  c->add_option("directory", o.directory, "What generate wrote, or the practice folder")
      ->required();
  c->add_option("--only", o.only, "One stratum, or names that begin so");
  c->add_option("--jobs", o.jobs, "At once");
  c->add_option("--timeout", o.tool.timeout_s, "Seconds for one recording");
  c->add_option("--with", o.tool.extra_arguments,
                "A further argument for the tool, such as a negative control");
  c->add_option("--out", o.save_results, "Write results and summary here");
  c->add_option("--answers", o.load_results, "Score these results instead of running the tool");
  c->add_flag("-v,--verbose", o.verbose,
              "One line for every recording, not only for what went wrong");
  return c;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace searig::proving;
  CLI::App app{
      "The blind proving ground: recordings with sealed truth, and the score of a tool on them"};
  app.require_subcommand(1);
  GenerateOptions making;
  ScoreOptions scoring;
  const CLI::App* make = add_generate(app, making);
  add_scoring(app, "score", "Run TOOL diagnose on every recording and hold it against the truth",
              scoring);
  const CLI::App* control = add_scoring(
      app, "controls", "The same with parts of the method left out, side by side", scoring);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  try {
    if (*make)
      generate(plan_set(making.set, making.seed, making.count), making.out, making.threads);
    else if (*control)
      controls(scoring, std::cout);
    else
      score(scoring, std::cout);
    return 0;
  } catch (const std::invalid_argument& e) {
    std::fprintf(stderr, "searig-prove: %s\n", e.what());
    return 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "searig-prove: %s\n", e.what());
    return 1;
  }
}
