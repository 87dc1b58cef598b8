// SPDX-License-Identifier: Apache-2.0
// The error that is to be expected over the workspace.
#pragma once

#include <cstdint>
#include <functional>

#include "estimation/report/prediction.h"

namespace handsight {

/// One drawn pose, as the sensor's link sees the hand (seen_hand.h): where the nominal robot has the hand (m, root),
/// how far the model has it from there (m), and below what its error is then in 95 of 100 cases where that is corrected
/// (m).
struct ExpectedError {
  Vector3 hand = Vector3::Zero();
  double before = 0, limit = 0;
};

/// `count` poses, each joint drawn between the least and the greatest value that was measured; the same for the same
/// seed. `chain` and `model` are of the hand that the robot moves. Nothing without positions.
std::vector<ExpectedError> expected_errors(const Chain& chain, const PredictionModel& model,
                                           const std::vector<Eigen::VectorXd>& positions, int count,
                                           std::uint64_t seed);

/// A view of them: the mean of what lies in a cell.
struct MapCell {
  double across = 0, up = 0;  // m: the cell's middle
  double before = 0, limit = 0;
  int poses = 0;
};
struct MapView {
  const char *across = "", *up = "";  // "x", "y", "z"
  double cell = 0;                    // m
  std::vector<MapCell> cells;
};

/// Seen along one axis of the root frame: `across` and `up` are 0 to 2.
MapView map_view(const std::vector<ExpectedError>& errors, int across, int up, int cells_a_side = 24);

}  // namespace handsight
