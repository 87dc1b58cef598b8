// SPDX-License-Identifier: Apache-2.0
// A diagnosis, and what a fit leaves out, for people and as JSON.
#pragma once

#include <set>
#include <string>

#include "command.h"
#include "diagnosis/outliers/flipped_targets.h"
#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight::cli {

void print_diagnosis(const Output& output, const Session& session, const Diagnosis& diagnosis);
/// The points that a fit leaves out.
Json lone_json(const std::vector<LoneObservation>& lone);
Json flipped_json(const std::vector<FlippedTarget>& flipped);
Json wrong_points_json(const std::vector<WrongPoint>& wrong, const Session& session);
Json diagnosis_json(const Session& session, const Diagnosis& diagnosis, const std::set<std::string>& refused = {});

}  // namespace handsight::cli
