// SPDX-License-Identifier: Apache-2.0
// What a session holds of the tests of ISO 9283, and what it lacks.
#pragma once

#include <string>

#include "certify/attained.h"
#include "certify/iso9283.h"

namespace handsight {

/// A pose that was attained at least twice, before correction and after.
struct IsoPose {
  std::int64_t first_id = 0;  // of its observations
  PoseFigures before, after;
  bool shows_turn = true;
};

/// Two of these poses.
struct IsoDistance {
  std::int64_t from_id = 0, to_id = 0;
  DistanceFigures before, after;
};

/// A pose that was approached along all three axes of the base.
struct IsoDirections {
  std::int64_t first_id = 0;
  int cycles = 0;  // of the direction with the fewest
  DirectionFigures figures;
};

/// A pose to record: a measured one, near a place of the standard's cube.
struct PoseToRecord {
  std::string place;         // P1 to P5
  Eigen::VectorXd position;  // rad or m
  Vector3 hand;              // m, base
  int cycles = 0;            // that are missing
};

struct IsoTest {
  std::vector<IsoPose> poses;  // those with most cycles first, at most twelve
  std::vector<IsoDistance> distances;
  std::vector<IsoDirections> directions;
  bool has_accuracy = false, has_distance = false, has_directions = false;  // as the standard asks for them
  std::vector<std::string> lacking;                                         // a sentence each; empty: nothing
  std::vector<PoseToRecord> plan;
};

/// `attained` is of this session.
IsoTest iso_test(const Session& session, const AttainedPoses& attained);

}  // namespace handsight
