// SPDX-License-Identifier: Apache-2.0
/// @file
/// What has changed between sessions of one robot, or since a calibration: handsight::compare.
#pragma once

#include "compare/comparison.h"
#include "compare/several_comparison.h"
#include "handsight/predict.h"

namespace handsight {

/// Two sessions of one robot with the same markers: which single change explains the difference. The effects of the
/// model are estimated, the same for both.
/// Throws InputError where the sessions are not of one robot, one kind of sensor and one number of markers.
Comparison compare(const Session& before, const Session& after, const Model& model,
                   const ComparisonProgress& progress = {});

// Declared beside it, in compare/comparison.h: a calibration and a later session of a few poses (whether camera, hand
// and arm are as they were), and two calibrations (their numbers, and how far the hand is between them).

}  // namespace handsight
