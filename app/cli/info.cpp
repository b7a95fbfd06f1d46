#include "app/cli/commands.h"

namespace searig::app {

void add_info(CLI::App&) {}

}  // namespace searig::app
