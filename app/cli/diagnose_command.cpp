// SPDX-License-Identifier: Apache-2.0
#include "command.h"
#include "diagnosis_output.h"

namespace handsight::cli {
namespace {

struct Options {
  std::string session;
  std::vector<std::string> effects;
  Output output;
};

int run(const Options& o) {
  const Session session = open_session(o.session, o.output);
  DiagnosisOptions options;
  add_effects(o.effects, session, options.effects, options.estimated);
  Progress progress("diagnose", 100);
  options.on_progress = [&](double share) {
    progress.at(static_cast<std::size_t>(100 * share));
    return true;
  };
  const Diagnosis d = diagnose(session, options);
  print_diagnosis(o.output, session, d);
  o.output.json(diagnosis_json(session, d));
  return d.verdict == Verdict::unexplained || d.verdict == Verdict::too_few_observations ? answer_is_no : done;
}

}  // namespace

Command add_diagnose(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("diagnose", "Compares the model with the measurements and ranks what is missing");
  add_session_option(*command, options->session);
  command->add_option(
      "--effects", options->effects,
      "Effects already in the model: id or id:joint+joint to estimate, id:joint.parameter=value to hold");
  add_json_option(*command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
