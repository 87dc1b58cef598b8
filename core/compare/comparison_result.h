// SPDX-License-Identifier: Apache-2.0
// What a comparison of two sessions, or of a calibration and a session, finds.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "effects/effect.h"

namespace handsight {

/// One thing that may have changed: the numbers of an effect that only the second side has.
struct Change {
  std::string id;                  // camera_mount, stereo_rig, lens, body_slip, marker_slip, joint_offset, payload, ...
  std::vector<std::string> where;  // joints or markers
  std::vector<EffectTerm> terms;   // with values
  Eigen::VectorXd sigma;           // of the values in their order, choices left out
  std::vector<std::string> units;  // theirs
  double ln_bayes_factor = 0;      // against nothing having changed; the mean over the places where it may sit
  double explained = 0;            // chi-squared that it takes away
};

/// One number of both sides.
struct NumberChange {
  std::string name;  // "tcp_from_body x", "joint_offset of a2: offset"
  std::string unit;
  double before = 0, after = 0, sigma = 0;  // of the difference
  double in_sigmas() const { return sigma > 0 ? (after - before) / sigma : 0; }
};

enum class ComparisonVerdict {
  unchanged,  // nothing passes
  changed,    // one change passes, and after it nothing else does
  several,    // after the best change another one still passes
};

struct Comparison {
  ComparisonVerdict verdict = ComparisonVerdict::unchanged;
  Message sentence;                                 // for people
  std::vector<Change> changes;                      // best first
  std::vector<std::string> indistinguishable_from;  // ids within odds of 20 of the best, where one passes
  double threshold = 0;  // ln of a Bayes factor that is no chance: 1 in 200 where nothing changed
  std::vector<NumberChange> numbers;
  std::optional<double> hand_mean_m, hand_max_m;  // how far the hand is from where it was, over the poses of both
  bool model_fits = true;  // false: both sides miss their noise; what the model lacks was fitted beside the change
  std::vector<Message> notes;
};

/// Hears how much is done (0 to 1; a share smaller than before means: still at work). Where it answers no the
/// comparison ends as soon as it can, with an InputError that says so.
using ComparisonProgress = std::function<bool(double share)>;

}  // namespace handsight
