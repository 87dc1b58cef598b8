// SPDX-License-Identifier: Apache-2.0
#include "command.h"
#include "diagnosis_output.h"
#include "estimation/export.h"
#include "fit_output.h"
#include "session/calibration_xml.h"

namespace handsight::cli {
namespace {

struct Options {
  std::string session, export_file;
  std::vector<std::string> effects;
  Output output;
};

int run(const Options& o) {
  const Session session = open_session(o.session);
  ImprovementOptions options;
  add_effects(o.effects, session, options.effects, options.estimated);
  Progress progress("improve", 100);
  options.on_progress = [&](double done) {
    progress.at(static_cast<std::size_t>(100 * done));
    return true;
  };
  const Improvement m = improve(session, options);
  print_improvement(o.output, session, m);
  o.output.json(improvement_json(session, m));
  if (!o.export_file.empty()) {
    write_calibration(o.export_file, calibration_of(session, m.last.model.fit, m.last.report, m.last.model_options,
                                                    "handsight " HANDSIGHT_VERSION));
    o.output.line("Written: " + o.export_file);
  }
  const bool no = m.last.verdict == Verdict::unexplained || m.last.verdict == Verdict::too_few_observations ||
                  !m.last.model.fit.converged();
  return no ? answer_is_no : done;
}

}  // namespace

Command add_improve(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "improve", "Diagnoses, adds what is missing, refits, until the model is adequate or nothing helps");
  add_session_option(*command, options->session);
  command->add_option("--effects", options->effects, "Effects in the model from the start");
  command->add_option("--export", options->export_file, "Write the calibration XML of the last model");
  add_json_option(*command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
