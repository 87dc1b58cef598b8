// SPDX-License-Identifier: Apache-2.0
// Online calibration with a target whose shape is known: boards and tags that images show, or measured poses. Nothing
// is labelled and nothing is searched: every observation shows by itself where the target is.
#pragma once

#include <optional>

#include "base/message.h"
#include "estimation/online/online_step.h"
#include "estimation/solvers/held_fit.h"

namespace handsight {

class OnlineTarget {
 public:
  /// The session has a known shape. Its print is taken as it is described, whatever its sigma.
  OnlineTarget(const Session& session, const OnlineOptions& options);

  /// The sightings of the observation count, found in images or measured; `refusal`: why there are none.
  OnlineStep add(const Observation& observation, const Message& refusal = {});

  std::optional<double> noise() const;

 private:
  Message target_refusal(const ProblemObservation& posture);
  void undo_half_turn(ProblemObservation& posture, OnlineStep& step) const;
  void start();
  void start_anew();
  BodySides sides() const;
  void describe(const ProblemObservation& o, OnlineStep& step) const;

  Chain chain_;
  Mount mount_;
  OnlineOptions options_;
  Problem problem_;
  std::optional<double> declared_noise_;
  double usual_sigma_;
  bool looks_the_same_turned_ = false;  // a chessboard whose two ends cannot be distinguished
  std::optional<HeldFit> fit_;
  std::vector<ProblemObservation> waiting_;  // until an unknown mount can be found
  Eigen::VectorXd last_position_;
  std::int64_t last_id_ = -1;
  double internal_squares_ = 0;  // of the poses: what the noise is seen from
  int internal_rows_ = 0;
};

}  // namespace handsight
