// SPDX-License-Identifier: Apache-2.0
// handsight-cli: everything that the workbench does, without a window.
#include <iostream>

#include "command.h"

namespace {

using namespace handsight;

int run(int argc, char** argv) {
  CLI::App app("Find out where a robot's hand really is, and why it is not where the model says.", "handsight-cli");
  app.set_version_flag("--version", "handsight " HANDSIGHT_VERSION);
  app.require_subcommand(1);
  const std::vector<cli::Command> commands = {
      cli::add_check(app),    cli::add_detect(app),  cli::add_label(app),
      cli::add_online(app),   cli::add_fit(app),     cli::add_diagnose(app),
      cli::add_improve(app),  cli::add_predict(app), cli::add_effective_mass(app),
      cli::add_simulate(app), cli::add_effects(app), cli::add_plan(app)};
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? cli::done : cli::wrong_input;
  }
  for (const cli::Command& command : commands)
    if (command.app->parsed()) return command.run();
  return cli::wrong_input;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';
    return cli::wrong_input;
  } catch (const std::exception& error) {
    std::cerr << "handsight-cli failed, which is an error of its own: " << error.what() << '\n';
    return 3;
  }
}
