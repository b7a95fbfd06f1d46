// searig desktop: opens the window, which is a program of its own.
#include "app/cli/commands.h"
#include "app/cli/desktop_program.h"

namespace searig::app {

void add_desktop(CLI::App& app) {
  auto* command =
      app.add_subcommand("desktop", "Open the window: searig desktop [RECORDING] [OPTIONS]");
  command->prefix_command();  // everything after it is searig-desktop's own
  command->set_help_flag();   // its help too
  command->footer("Example:\n  searig desktop my_recording\n  searig desktop --live");
  command->callback([command] { become(find_desktop_program(), command->remaining()); });
}

}  // namespace searig::app
