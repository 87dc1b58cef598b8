// SPDX-License-Identifier: Apache-2.0
// How much may differ from pose to pose and follow nothing: assumptions of it under which evidence is weighed.
#pragma once

#include "base/message.h"
#include "diagnosis/evidence/evidence.h"

namespace handsight {

/// What scatters: all joints alike, the hand's place beside them, or each joint by itself beside it.
enum class Scattering { joints, joints_and_place, each_joint_and_place };

/// The scatter under which what the model leaves is likeliest, sought from `start` on by Fisher's scoring over the
/// variances (Searle, Casella and McCulloch, Variance Components, 1992, ch. 8); no more than 30 mrad and 10 mm, 0 below
/// 1 urad and 1 um. The place
/// may share where the noise is known: a tracker's own noise would be the same otherwise.
Repeatability likely_repeatability(const LinearModel& model, const Repeatability& start, const NoiseKnowledge& noise,
                                   Scattering scattering);

/// What to weigh evidence under, from none on upwards: 0.1, 0.3, 1 and 3 mrad of the joints, or where it makes the
/// model clearly likelier its likely scatter and parts of it, with joints that differ where Schwarz's criterion is for
/// that. Candidates of the model are not looked at.
std::vector<Repeatability> repeatability_levels(const LinearModel& model, const NoiseKnowledge& noise);

/// What of the place's scatter is worth reporting: m.
inline constexpr double least_reported_place = 1e-5;

/// "joints that repeat to 1.3 mrad and a hand whose place scatters by 0.9 mm"; empty where there is none worth
/// telling.
Message repeatability_text(const Repeatability& repeatability);

}  // namespace handsight
