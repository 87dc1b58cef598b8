// SPDX-License-Identifier: Apache-2.0
// handsight-cli: everything that the workbench does, without a window.
#include <csignal>
#include <iostream>
#include <new>

#include "base/freed_memory.h"
#include "base/text.h"
#include "base/threads.h"
#include "command.h"
#include "describe.h"

namespace {

using namespace handsight;

int run(int argc, char** argv) {
  const auto program = cli::make_program(
      "handsight-cli", "Find out where a robot's hand really is, and why it is not where the model says.",
      "handsight " HANDSIGHT_VERSION);
  const cli::CommandLine line{program.get()};
  line.option("--threads", most_threads(),
              "At most so many at once (as many as the processor runs); results are the same")
      .from_to(1, 1024)
      .shown_as("N");
  std::string described;  // for packages: the manual page, completions of shells
  const cli::CommandLine describe = line.command("describe", "Writes the manual page or a shell's completion").hidden();
  describe.option("WHAT", described).required().one_of({"man", "bash", "zsh", "fish"});
  const std::vector<cli::Command> commands = {
      cli::add_check(line),   cli::add_detect(line),     cli::add_label(line),          cli::add_online(line),
      cli::add_fit(line),     cli::add_inspect(line),    cli::add_diagnose(line),       cli::add_improve(line),
      cli::add_predict(line), cli::add_convert(line),    cli::add_export(line),         cli::add_correct(line),
      cli::add_compare(line), cli::add_batch(line),      cli::add_effective_mass(line), cli::add_simulate(line),
      cli::add_effects(line), cli::add_plan(line),       cli::add_target(line),         cli::add_cameras(line),
      cli::add_certify(line), cli::add_experiment(line), cli::add_recheck(line)};
  if (const std::optional<int> ended = cli::parse(*program, argc, argv)) return *ended;
  if (describe.is_given()) {
    std::cout << (described == "man" ? cli::manual_page(line, HANDSIGHT_VERSION) : cli::completion(line, described));
    return cli::done;
  }
  for (const cli::Command& command : commands)
    if (command.line.is_given()) return command.run();
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
  // A reader that has gone or a file that may not grow are reported by the writing itself.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  keep_freed_memory();
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
