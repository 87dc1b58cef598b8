// SPDX-License-Identifier: Apache-2.0
// One step of the online calibration: what is asked of it and what it says.
#pragma once

#include <optional>
#include <string>

#include "base/message.h"
#include "chain/body_frame.h"
#include "chain/chain.h"
#include "effects/effect.h"
#include "vision/corners/corner_options.h"
#include "vision/markers/known_markers.h"

namespace handsight {

struct OnlineOptions {
  MatchOptions match;
  DetectorOptions detector;
  double new_pose_rad = 0.034906585;  // 2 degrees: less motion of every joint is no new observation
  double new_pose_m = 0.01;           // the same for prismatic joints
  std::vector<EffectTerm> effects;    // of joints and loads, in the model at these values
  std::optional<BodySides> sides;
};

/// What the user sees of one observation.
struct OnlineStep {
  std::int64_t id = 0;
  bool accepted = false;
  Message reason;             // why it was rejected, or what is to be said of an accepted one
  bool from_images = false;   // its markers were found in its images
  bool is_open = false;       // not decided: it is tried again when the mount is known
  double milliseconds = 0;    // spent on it, detection included, reading of files not
  bool has_estimate = false;  // the rest is there
  Rigid tcp_from_body;
  Vector6 sigma = Vector6::Zero();  // of x y z (m) and the rotations about the axes (rad)
  Matrix6 covariance = Matrix6::Zero();
  bool covariance_is_scatter = false;
  std::optional<Rigid> tcp_from_tcp_est;  // thesis (4.51)
  std::vector<Sighting> sightings;        // found in the images (also of a rejected one, where they were found)
  std::size_t kept = 0;                   // observations in the estimate; none is retired
};

/// That the user has excluded it, and why.
Message excluded_text(const Observation& observation);

/// Why an observation at `position` shows nothing new after one at `last`: no joint has moved enough. Empty: it is new.
Message motion_refusal(const Chain& chain, const OnlineOptions& options, const Eigen::VectorXd& last,
                       const Eigen::VectorXd& position, std::int64_t last_id);

/// Writes into the observation what a step decided: the decision with its reason, and the markers found in its images.
void keep_step(const OnlineStep& step, Observation& observation);

}  // namespace handsight
