// SPDX-License-Identifier: Apache-2.0
// Fit, diagnose, improve, compare and simulate by a Model.
#include "correct/robot_file.h"
#include "handsight/handsight.h"

namespace handsight {
namespace {

template <class Options>
Options with_model(Options options, const Model& model, const Session& session) {
  ModelTerms terms = list_terms(model, session);
  options.effects = std::move(terms.held);
  options.estimated = std::move(terms.estimated);
  return options;
}

std::vector<EffectTerm> all_terms(const Model& model, const Session& session) {
  ModelTerms terms = list_terms(model, session);
  terms.held.insert(terms.held.end(), terms.estimated.begin(), terms.estimated.end());
  return terms.held;
}

}  // namespace

Fit fit(const Session& session, const Model& model, const FitOptions& options) {
  return fit(session, with_model(options, model, session));
}

FitReport report(const Session& session, const Fit& fit, const Model& model, const FitOptions& options) {
  return report(session, fit, with_model(options, model, session));
}

Diagnosis diagnose(const Session& session, const Model& model, const DiagnosisOptions& options) {
  return diagnose(session, with_model(options, model, session));
}

Improvement improve(const Session& session, const Model& model, const ImprovementOptions& options) {
  return improve(session, with_model(options, model, session));
}

Comparison compare(const Session& before, const Session& after, const Model& model,
                   const ComparisonProgress& progress) {
  return compare(before, after, all_terms(model, after), progress);
}

SimulatedSession simulate(const Session& like, const Model& truth, const SimulationOptions& options) {
  SimulationOptions with = options;
  with.effects = all_terms(truth, like);
  return simulate_session(like, with);
}

CalibratedRobot calibrated_robot(const Session& session, const Fit& fit, const Model& model,
                                 const FitOptions& options) {
  const FitOptions with = with_model(options, model, session);
  return with_robot_file(
      calibrated_robot(session, fit, report(session, fit, with), with, std::string("handsight ") + version()), session);
}

}  // namespace handsight
