#include "app/cli/commands.h"

namespace searig::app {

void add_simulate(CLI::App&) {}

}  // namespace searig::app
