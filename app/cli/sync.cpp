#include "app/cli/commands.h"

namespace searig::app {

void add_sync(CLI::App&) {}

}  // namespace searig::app
