// SPDX-License-Identifier: Apache-2.0
// From two sides to what has changed between them, in words. Internal to comparison.cpp.
#pragma once

#include "chain/chain.h"
#include "compare/comparison_result.h"
#include "compare/shared_model.h"
#include "effects/effect.h"
#include "geometry/rigid.h"
#include "session/session.h"

namespace handsight {

/// Verdict, sentence and changes; wider than the model where both sides miss it.
void judge(const ComparedSides& sides, Comparison& comparison);

/// Where the used observations of a session stood.
std::vector<Eigen::VectorXd> used_positions(const Session& session);

/// How far changes move the body against the robot's root, over these poses (m).
struct HandWay {
  double mean = 0, largest = 0;
};
HandWay hand_way(const Chain& chain, const std::vector<Eigen::VectorXd>& poses, const std::vector<EffectTerm>& effects,
                 const std::vector<EffectTerm>& changes, const Rigid& tcp_from_body);

/// How far the best change moves the body against the robot's root, over these poses.
void measure_hand(const Chain& chain, const std::vector<Eigen::VectorXd>& poses, const std::vector<EffectTerm>& effects,
                  const Rigid& tcp_from_body, Comparison& comparison);

}  // namespace handsight
