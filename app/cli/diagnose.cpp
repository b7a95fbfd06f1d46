#include "app/cli/commands.h"

namespace searig::app {

void add_diagnose(CLI::App&) {}

}  // namespace searig::app
