#include "app/cli/commands.h"

namespace searig::app {

void add_export(CLI::App&) {}

}  // namespace searig::app
