#include "app/cli/commands.h"

namespace searig::app {

void add_desktop(CLI::App&) {}

}  // namespace searig::app
