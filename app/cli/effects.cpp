// searig effects: what can be simulated, found missing and named.
#include <iostream>
#include <memory>

#include "app/cli/commands.h"
#include "app/report/catalogue_text.h"

namespace searig::app {

void add_effects(CLI::App& app) {
  auto* command = app.add_subcommand("effects", "The physical effects that a diagnosis can name");
  const auto markdown = std::make_shared<bool>(false);
  command->add_flag("--markdown", *markdown, "With equations, parameters and sources");
  command->footer("Example:\n  searig effects --markdown > docs/catalogue.md");
  command->callback(
      [markdown] { std::cout << (*markdown ? catalogue_markdown() : catalogue_lines()); });
}

}  // namespace searig::app
