// SPDX-License-Identifier: Apache-2.0
// One model after another, each with a change that explains more, until nothing is left to change.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "diagnosis/selection/improvement_result.h"

namespace handsight {

/// `session` outlives it.
class ModelWalk {
 public:
  ModelWalk(const Session& session, const ImprovementOptions& options);

  /// From the session's own model.
  void begin();
  /// From a model with names, whatever has led to it.
  void begin_at(Diagnosis model);
  /// From the model at which another walk came to its end, without the terms of one effect; that does not come again at
  /// once, nor, where it is a curve, another curve.
  void begin_without(const std::string& id, const Diagnosis& end);
  /// As far as it goes; after begin().
  void run();
  /// Takes in what is there a little at each joint, and goes on as far as that leads.
  void run_beside_background();
  /// Goes on from where another walk came to its end, which may have begun with more terms.
  void take(ModelWalk&& other);

  /// Not concluded: its bill, shares and inclusion probabilities are not made yet.
  Improvement& so_far() { return m_; }
  const std::vector<RefusedStep>& refused_last() const { return refused_; }  // of the last model
  /// Did another cause have more evidence than the first that was taken, but not beside small deviations?
  bool has_passed_over() const { return has_passed_over_; }
  /// Of the last model; asked once.
  const InclusionProbabilities& certain();

 private:
  void begin_with(const std::vector<EffectTerm>& estimated);
  void stand_at(Diagnosis model);
  /// False where nothing is left, or it was stopped.
  bool one_more();
  /// Other names are sought once there are names that were chosen.
  bool may_seek() const { return !m_.stopped && (has_begun_with_names_ || m_.steps.size() > 1); }
  ModelChange one_that_is_likely();
  void step_to(ModelChange&& change);
  void note_refusals(const ModelChange& change);

  const Session& session_;
  ImprovementOptions options_;
  Improvement m_;
  Improvement settled_;                            // names alone: the last model that no unnamed curve outdoes
  std::vector<RefusedStep> refused_;               // of the last model
  std::optional<InclusionProbabilities> certain_;  // of the last model; absent: not asked yet
  bool has_begun_with_names_ = false, has_passed_over_ = false;
  int sought_ = 0;  // times
  bool sought_simpler_ = false, sought_fuller_ = false, sought_likeliest_ = false;
  std::set<std::string> tried_;  // likely names
};

}  // namespace handsight
