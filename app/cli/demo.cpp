#include "app/cli/commands.h"

namespace searig::app {

void add_demo(CLI::App&) {}

}  // namespace searig::app
