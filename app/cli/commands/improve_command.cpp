// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "command.h"
#include "diagnosis/selection/improvement.h"
#include "estimation/report/export.h"
#include "options/named_effects.h"
#include "printing/blunder_output.h"
#include "printing/fit_output.h"
#include "printing/improvement_output.h"

namespace handsight::cli {
namespace {

struct ImproveArguments {
  std::string session;
  std::vector<std::string> effects;
  bool names_only = false, thorough = false;
  Output output;
};

double fitted_rms(const ImprovementStep& step) {
  return step.fitted.rms_pixel ? *step.fitted.rms_pixel : step.fitted.rms_m.value_or(0);
}

/// Mistakes explain most of what is wrong: where effects did, none is left to look for.
std::vector<Blunder> blunders_of_what_is_left(const Improvement& m) {
  constexpr double most = 0.2;  // of the error at the start
  const bool is_explained = m.last.verdict == Verdict::adequate || m.steps.empty() ||
                            fitted_rms(m.steps.back()) < most * fitted_rms(m.steps.front());
  return is_explained ? std::vector<Blunder>() : list_blunders(m.last.model.session, m.last.model.fit);
}

int run(const ImproveArguments& o) {
  const Session session = open_searched_session(o.session, o.output);
  ImprovementOptions options;
  add_effects(o.effects, session, options.effects, options.estimated);
  options.with_curves = !o.names_only;
  if (o.thorough) {
    options.is_thorough = true;
    options.most_models = most_models_of_thorough;
  }
  Progress progress("improve", 100);
  options.on_progress = [&](double done) {
    progress.at(static_cast<std::size_t>(100 * done));
    return true;
  };
  const Improvement m = improve(session, options);
  print_improvement(o.output, session, m);
  const std::vector<Blunder> blunders = blunders_of_what_is_left(m);
  print_blunders(o.output, o.session, blunders);
  Json result = improvement_json(session, m);
  result["blunders"] = blunders_json(blunders);
  o.output.json(result);
  if (!o.output.export_file.empty())
    o.output.calibration(make_calibration(session, m.last.model.fit, m.last.report, m.last.model_options,
                                          "handsight " HANDSIGHT_VERSION, m.inclusion_probabilities.model_uncertainty));
  const bool no = m.last.verdict == Verdict::unexplained || m.last.verdict == Verdict::too_few_observations ||
                  !m.last.model.fit.converged();
  return no ? answer_is_no : done;
}

}  // namespace

Command add_improve(const CommandLine& program) {
  auto options = std::make_shared<ImproveArguments>();
  const CommandLine command = program.command(
      "improve", "Diagnoses, adds what is missing, refits, until the model is adequate or nothing helps");
  add_session_option(command, options->session);
  command.option("--effects", options->effects, "Effects in the model from the start");
  add_export_option(command, options->output);
  command.flag("--names-only", options->names_only, "Take in effects alone, no curves without a name");
  command.flag("--thorough", options->thorough,
               "Leave out one name after another and go on from there, however long that takes (minutes)");
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
