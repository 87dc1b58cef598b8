// SPDX-License-Identifier: Apache-2.0
// The poses to measure next: those that settle the estimate best, or those that best tell two effects apart.
#pragma once

#include <functional>

#include "base/message.h"
#include "effects/effect.h"
#include "geometry/rigid.h"
#include "session/session.h"

namespace handsight {

/// What is compared where two effects are to be distinguished; each joins the model in turn.
struct CompetingEffects {
  std::string first_name, second_name;    // as the user wrote them
  std::vector<EffectTerm> first, second;  // numbers are estimated, choices are set
};

struct PlanOptions {
  int count = 10;                     // poses, 1 to most_planned_poses
  std::vector<EffectTerm> effects;    // in the model, held
  std::vector<EffectTerm> estimated;  // in the model, estimated
  std::optional<CompetingEffects> between;
  int pool = 2000;  // poses to choose from; fewer for models so large that it would take long
  std::uint64_t seed = 1;
  std::function<bool(const Eigen::VectorXd&)> may_take;  // says no of poses that cannot be had; empty: all can
};
inline constexpr int most_planned_poses = 100;

struct PlannedPose {
  Eigen::VectorXd position;         // rad or m, in the order of the session's joints
  int fixture = -1;                 // that is touched there, into Session::fixtures; -1: the session is none of touches
  double gain = 0;                  // nats that this pose adds, see Plan
  Vector6 sigma = Vector6::Zero();  // of tcp_from_body, expected after it: m, then rad
  /// ln of the Bayes factor for the true one of two effects, expected of all new poses up to this one: where the first
  /// is true, where the second is.
  std::optional<Vector2> ln_bayes_factor;
};

/// Gains are expected of the linearised model and of normal noise. For precision: the information about all parameters
/// of the model (half of ln det of its gain). Between two effects: the ln Bayes factor for the true one, mean of both.
struct Plan {
  std::vector<PlannedPose> poses;  // in the order in which they are to be taken
  /// Of tcp_from_body with the observations so far, as `sigma` is counted; NaN where they do not determine it.
  Vector6 sigma_before = Vector6::Zero();
  bool never_moved = false;  // the hand, so far
  bool rotation_is_observed = true;
  double noise = 0;                              // px or m of one coordinate, that was reckoned with
  std::optional<double> ln_bayes_factor_before;  // of the first effect against the second, in the measurements so far
  bool tells_apart = true;                       // false: no pose would tell the two effects apart
  std::size_t pool = 0;                          // poses that were to choose from
  std::vector<Message> notes;                    // a sentence each
};

/// Greedy: each pose the best after those before it, at least some degrees away from those and from all that were
/// taken. InputError where nothing can be fitted, where count is out of range, where no pose is visible, or where the
/// two effects are the same or in the model already.
Plan plan(const Session& session, const PlanOptions& options = {});

}  // namespace handsight
