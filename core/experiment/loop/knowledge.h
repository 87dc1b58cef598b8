// SPDX-License-Identifier: Apache-2.0
// What an experiment knows so far: the fit, what is missing, and how far off the hand may be.
#pragma once

#include "diagnosis/planning/planning.h"
#include "diagnosis/verdict/diagnosis_result.h"
#include "estimation/fit/fit_result.h"

namespace handsight {

/// A box of the workspace, root frame, m.
struct WorkBox {
  Vector3 lower = Vector3::Zero(), upper = Vector3::Zero();

  bool holds(const Vector3& x) const {
    return (x.array() >= lower.array()).all() && (x.array() <= upper.array()).all();
  }
};

/// The model that is measured for: effects that are held, and those that are estimated.
struct ExperimentModel {
  std::vector<EffectTerm> held, estimated;
};

/// A cause for which, or for none of which, the measurements speak.
struct SettledCause {
  std::string id;  // empty: nothing is missing, or what has no name
  std::vector<std::string> where;
  std::vector<EffectTerm> terms;
  /// Of it against all others together, none and the likeliest curve without a name among them, those left out that
  /// cannot be distinguished from it; of what has no name against none and all names; of none against the mean of the
  /// causes that the poses can show, of all prior sigmas, small ones too.
  double odds = 1;
  std::optional<Message> follows = {};  // of what has no name: the variable that it follows
};

inline constexpr std::size_t least_to_diagnose = 5;  // used observations
inline constexpr std::size_t least_for_none = 20;    // ... before it is said that nothing is missing that has a name

struct Knowledge {
  std::size_t used = 0;                       // observations
  std::optional<Fit> fit;                     // nothing where too little is known for one
  std::optional<Diagnosis> diagnosis;         // from least_to_diagnose used observations on
  std::optional<SettledCause> settled;        // what is likeliest, however unsure
  std::optional<CompetingEffects> competing;  // the two likeliest that cannot be distinguished
  std::vector<EffectTerm> likely;             // terms that poses should show, beside the model
  std::optional<double> hand_limit;  // m: of 95 of 100 poses, the error below which the hand is in 95 of 100 cases
};

/// The fit and, `with_diagnosis`, what is missing. `poses`: where the hand's limit is asked for.
Knowledge assess_knowledge(const Session& session, const ExperimentModel& model, bool with_diagnosis,
                           const std::vector<Eigen::VectorXd>& poses);

/// The error below which the hand is in 95 of 100 cases, m, in 95 of 100 of these poses. Nothing without poses, and
/// where the measurements leave a direction of the unknowns open: its covariance is no number.
std::optional<double> hand_limit(const Fit& fit, const std::vector<Eigen::VectorXd>& poses);

/// What the evidence of a diagnosis is for: its best named candidate, what has no name, or none.
SettledCause settled_cause(const Diagnosis& diagnosis);

}  // namespace handsight
