#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "tests/proving/plan/generate.h"

int main(int argc, char** argv) {
  using namespace searig::proving;
  CLI::App app{"The blind proving ground: recordings with sealed truth, and the score of a tool on them"};
  app.require_subcommand(1);

  auto* make = app.add_subcommand("generate", "Write recordings and, apart from them, their answers");
  make->footer("Example: searig-prove generate --out /tmp/ground --set small");
  std::string out, set = "full";
  std::uint64_t seed = 1;
  int count = 0, threads = 2;
  make->add_option("--out", out, "Folder to write to")->required();
  make->add_option("--seed", seed, "Another seed, another proving ground");
  make->add_option("--set", set, "small, full, or one stratum such as 'single weak'");
  make->add_option("--count", count, "At most so many");
  make->add_option("--threads", threads, "At once");

  CLI11_PARSE(app, argc, argv);
  try {
    if (*make) generate(plan_set(set, seed, count), out, threads);
    return 0;
  } catch (const std::invalid_argument& e) {
    std::fprintf(stderr, "searig-prove: %s\n", e.what());
    return 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "searig-prove: %s\n", e.what());
    return 1;
  }
}
