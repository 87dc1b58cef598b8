// SPDX-License-Identifier: Apache-2.0
// What a calibration says of the target itself: how it is bent, how far its points lie from where they are described,
// and what description fits them.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "camera_calibration/camera_calibration.h"
#include "print/target.h"

namespace handsight {

struct BoardReport {
  BoardShape shape = BoardShape::held;
  Vector3 bend = Vector3::Zero();    // 1/m: along x, along y, askew; of free points the bend that is nearest to them
  double bow = 0;                    // m, how far the middle stands off a line between the ends, where that is most
  double off_rms = 0, off_most = 0;  // m, of points from where they are described; 0 where they are held
  std::vector<Vector3> points;       // m, by number, in the target's frame; empty where they are held
  std::vector<Message> sentences;    // what the board is, the size that nobody can see included
  std::vector<Message> warnings;     // what of it is not as described
};

/// `images` and what they were calibrated to; `target`: what they show, as it is described.
BoardReport board_report(const BoardImages& images, const CameraCalibration& calibration, const Target& target);

}  // namespace handsight
