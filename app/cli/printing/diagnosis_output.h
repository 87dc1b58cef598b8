// SPDX-License-Identifier: Apache-2.0
// A diagnosis, and what a fit leaves out, for people and as JSON.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "command.h"
#include "diagnosis/outliers/flipped_targets.h"
#include "diagnosis/verdict/diagnosis_result.h"
#include "estimation/report/error_summary.h"

namespace handsight::cli {

/// `left_by_fit`: the held-out error of a fit that weighs the robot's own error from pose to pose, where there is one.
void print_diagnosis(const Output& output, const Session& session, const Diagnosis& diagnosis,
                     const std::optional<ErrorSummary>& left_by_fit = {});
/// The points that a fit leaves out.
Json lone_json(const std::vector<LoneObservation>& lone);
Json flipped_json(const std::vector<FlippedTarget>& flipped);
Json wrong_points_json(const std::vector<WrongPoint>& wrong, const Session& session);
Json diagnosis_json(const Session& session, const Diagnosis& diagnosis, const std::set<std::string>& refused = {});

}  // namespace handsight::cli
