// SPDX-License-Identifier: Apache-2.0
// handsight-cli: everything that the workbench does, without a window.
#include <csignal>
#include <iostream>
#include <new>
#include <sstream>

#include "base/text.h"
#include "base/threads.h"
#include "command.h"
#include "describe.h"

namespace {

using namespace handsight;

int run(int argc, char** argv) {
  CLI::App app("Find out where a robot's hand really is, and why it is not where the model says.", "handsight-cli");
  app.set_version_flag("--version", "handsight " HANDSIGHT_VERSION);
  app.require_subcommand(1);
  app.add_option("--threads", most_threads(),
                 "At most so many at once (as many as the processor runs); results are the same")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  std::string described;  // for packages: the manual page, completions of shells
  CLI::App* const describe =
      app.add_subcommand("describe", "Writes the manual page or a shell's completion")->group("");
  describe->add_option("WHAT", described)->required()->check(CLI::IsMember({"man", "bash", "zsh", "fish"}));
  const std::vector<cli::Command> commands = {
      cli::add_check(app),   cli::add_detect(app),  cli::add_label(app),          cli::add_online(app),
      cli::add_fit(app),     cli::add_inspect(app), cli::add_diagnose(app),       cli::add_improve(app),
      cli::add_predict(app), cli::add_convert(app), cli::add_export(app),         cli::add_correct(app),
      cli::add_compare(app), cli::add_batch(app),   cli::add_effective_mass(app), cli::add_simulate(app),
      cli::add_effects(app), cli::add_plan(app),    cli::add_target(app),         cli::add_cameras(app)};
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const int code = app.exit(error, out, err);
    std::cout << printable(out.str());
    std::cerr << printable(err.str());
    return code == 0 ? cli::done : cli::wrong_input;
  }
  if (describe->parsed()) {
    std::cout << (described == "man" ? cli::manual_page(app, HANDSIGHT_VERSION) : cli::completion(app, described));
    return cli::done;
  }
  for (const cli::Command& command : commands)
    if (command.app->parsed()) return command.run();
  return cli::wrong_input;
}

int fails_with(const std::string& sentence, int exit_code) {
  std::cerr << printable(sentence) << '\n';
  return exit_code;
}

/// A result that did not arrive is no success.
int flushed(int exit_code) {
  std::cout.flush();
  if (std::cout) return exit_code;
  return fails_with(
      "Standard output cannot be written (is the disk full, or the reader gone?): the result is not whole.",
      cli::wrong_input);
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that has gone or a file that may not grow are told by the writing itself.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return flushed(run(argc, argv));
  } catch (const InputError& error) {
    return flushed(fails_with(shortened(error.what(), 600), cli::wrong_input));  // options may be long
  } catch (const std::bad_alloc&) {
    return fails_with("There is not enough memory for this; expected a smaller session or fewer observations.",
                      cli::wrong_input);
  } catch (const std::exception& error) {
    return fails_with(std::string("handsight-cli failed, which is an error of its own: ") + error.what(), 3);
  }
}
