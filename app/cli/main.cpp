// searig: the command line. Exit 0 done, 1 the work failed, 2 wrong use.
#include <exception>
#include <iostream>

#include "app/cli/commands.h"

int main(int argc, char** argv) {
  using namespace searig::app;
  CLI::App app{"searig: the truth about a series elastic actuator"};
  app.set_version_flag("--version", SEARIG_VERSION);
  app.require_subcommand(1);
  add_demo(app);
  add_reproduce(app);
  add_calibrate(app);
  add_record(app);
  add_info(app);
  add_sync(app);
  add_evaluate(app);
  add_diagnose(app);
  add_merge(app);
  add_simulate(app);
  add_effects(app);
  add_export(app);
  add_import(app);
  add_recover(app);
  add_desktop(app);
  app.footer("Example:\n  searig demo --seconds 30 --out out\n\nsearig COMMAND --help says more.");

  try {
    app.parse(argc, argv);  // runs the chosen command's callback
  } catch (const CLI::RequiredError& error) {
    if (app.get_subcommands().empty() && argc > 1 &&
        argv[1][0] != '-') {  // CLI11 would only miss a subcommand
      std::cerr << "searig: there is no command " << argv[1] << "; searig --help lists them.\n";
      return 2;
    }
    return app.exit(error), 2;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::cerr << "searig: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
