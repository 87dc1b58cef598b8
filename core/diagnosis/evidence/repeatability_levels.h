// SPDX-License-Identifier: Apache-2.0
// How much may differ from pose to pose and follow nothing: assumptions of it under which evidence is weighed.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "diagnosis/evidence/evidence.h"

namespace handsight {

/// What to weigh evidence under, from none on upwards: 0.1, 0.3, 1 and 3 mrad of the joints, or where it makes the
/// model clearly likelier its likely scatter and parts of it, with joints that differ where Schwarz's criterion is for
/// that. Candidates of the model are not looked at.
std::vector<Repeatability> repeatability_levels(const LinearModel& model, const NoiseKnowledge& noise);

/// What of the place's scatter is worth reporting: m.
inline constexpr double least_reported_place = 1e-5;

/// "joints that repeat to 1.3 mrad and a hand whose place scatters by 0.9 mm"; empty where there is none worth
/// telling. Where joints differ the worst is named: `joints` are the names of the chain's.
Message repeatability_text(const Repeatability& repeatability, const std::vector<std::string>& joints = {});

}  // namespace handsight
