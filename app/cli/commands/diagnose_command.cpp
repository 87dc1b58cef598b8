// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "command.h"
#include "diagnosis/verdict/diagnosis.h"
#include "diagnosis/verdict/stand_in.h"
#include "estimation/fit/sure_fit.h"
#include "estimation/report/fit_report.h"
#include "options/named_effects.h"
#include "printing/bill_output.h"
#include "printing/blunder_output.h"
#include "printing/diagnosis_output.h"
#include "printing/json_values.h"
#include "printing/outputs.h"
#include "printing/proof_output.h"

namespace handsight::cli {
namespace {

struct DiagnoseArguments {
  std::string session, proof_file;
  std::vector<std::string> effects;
  Output output;
};

/// Does the target's size explain nearly all, as a size that an effect can tell? Then no other mistake is looked for.
bool is_size_alone(const Diagnosis& d) {
  constexpr double nearly_all = 0.8;
  if (d.candidates.empty()) return false;
  const DiagnosisCandidate& best = d.candidates.front();
  if (best.id == "target_scale" && is_too_large(best.terms.front(), d.model.fit.problem.source->chain)) return false;
  return best.id == "target_scale" && best.ln_bayes_factor >= d.threshold && best.explained.value_or(0) > nearly_all;
}

/// What `fit` leaves held out of the same session, where it weighs the robot's own error from pose to pose: a diagnosis
/// counts each pixel alike, so that what is missing does not pass for such an error. Absent where nothing is weighed.
std::optional<ErrorSummary> left_by_fit(const Session& session, const DiagnosisOptions& o, const Diagnosis& d) {
  if (!session.rig || d.sample || d.verdict == Verdict::adequate || has_no_answer(d.model.fit)) return std::nullopt;
  FitOptions as_fit;
  as_fit.effects = o.effects;
  as_fit.estimated = o.estimated;
  const Fit weighed = fit(session, as_fit);
  if (!weighed.converged() || !weighed.problem.flange_error.is_any()) return std::nullopt;
  return report(session, weighed, as_fit).held_out;
}

int run(const DiagnoseArguments& o) {
  const Session session = open_searched_session(o.session, o.output);
  require_output(o.proof_file, "--proof");
  DiagnosisOptions options;
  add_effects(o.effects, session, options.effects, options.estimated);
  Progress progress("diagnose", 100);
  options.on_progress = [&](double share) {
    progress.at(static_cast<std::size_t>(100 * share));
    return true;
  };
  const Diagnosis d = diagnose(session, options);
  const bool in_full = !o.output.json_file.empty() || !o.proof_file.empty();
  const Proofs proofs = make_proofs(session, d, in_full);
  const std::optional<ErrorSummary> by_fit = left_by_fit(session, options, d);
  print_diagnosis(o.output, session, d, by_fit);
  print_proof(o.output, d, proofs);
  const std::vector<BillRow> bill = make_bill(d.model.fit);
  print_bill(o.output, bill);
  const std::vector<Blunder> blunders =
      is_size_alone(d) ? std::vector<Blunder>() : list_blunders(d.model.session, d.model.fit);
  print_blunders(o.output, o.session, blunders);
  if (!o.proof_file.empty()) {
    write_output(o.proof_file, proof_csv(d, proofs), "--proof");
    o.output.line("Written: " + o.proof_file);
  }
  if (!o.output.json_file.empty()) {
    Json result = diagnosis_json(session, d);
    if (by_fit)
      result["left_by_fit"] = {{"held_out_rms_pixel", number(by_fit->rms_pixel)},
                               {"held_out_rms_m", number(by_fit->rms_m)},
                               {"held_out_mean_m", number(by_fit->mean_m)}};
    add_proof(proofs, result);
    result["bill"] = bill_json(bill);
    result["blunders"] = blunders_json(blunders);
    o.output.json(result);
  }
  return d.verdict == Verdict::unexplained || d.verdict == Verdict::too_few_observations ? answer_is_no : done;
}

}  // namespace

Command add_diagnose(const CommandLine& program) {
  auto options = std::make_shared<DiagnoseArguments>();
  const CommandLine command =
      program.command("diagnose", "Compares the model with the measurements and ranks what is missing");
  add_session_option(command, options->session);
  command.option("--effects", options->effects,
                 "Effects already in the model: id or id:joint+joint to estimate, id:joint.parameter=value to hold");
  command.option("--proof", options->proof_file,
                 "Writes the proof plots of all candidates that count as a CSV: what each observation says of it");
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
