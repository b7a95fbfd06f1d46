#include "app/cli/commands.h"

namespace searig::app {

void add_evaluate(CLI::App&) {}

}  // namespace searig::app
