// SPDX-License-Identifier: Apache-2.0
// Online calibration (thesis 4.3): observations one by one, each accepted or rejected with its reason.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
#include "estimation/online/online_target.h"
#include "estimation/problem/running_shape.h"
#include "estimation/solvers/incremental_fit.h"
#include "estimation/start/mount_search.h"
#include "vision/image/image.h"

namespace handsight {

/// The images of one observation, grey.
struct ImagePair {
  Image left, right;
};

/// Feeds observations in order of time. The first one that is labelled (three markers, or all of a smaller body)
/// starts the calibration; labels of later ones are used where there are no images. Where nothing is known of the
/// cameras' mount, nothing says where to look for the markers: until enough observations agree on a mount
/// (mount_search.h) those with images are left open; then they are tried again. Labels by hand or by import count until
/// then, whatever the images.
///
/// A session whose target has a known shape (a board, tags, measured poses) needs no label: OnlineTarget
/// (online_target.h) takes its observations, whose sightings must be there (session/target_finding.h).
class OnlineCalibration {
 public:
  explicit OnlineCalibration(const Session& session, OnlineOptions options = {});

  /// `images` null: the labels of the observation are used. `not_found`: why a target is not among them.
  OnlineStep add(const Observation& observation, const ImagePair* images, const Message& not_found = {});

  /// Earlier observations that were decided after all since the last call, in their order; each replaces its step of
  /// before.
  std::vector<OnlineStep> take_revised() { return std::exchange(revised_, {}); }

  /// While the mount is unknown and observations are left open: how far the search is.
  struct MountProgress {
    std::size_t labelled = 0, open = 0;
    std::optional<std::int64_t> label_next;  // the observation whose label would tell most
  };
  std::optional<MountProgress> mount_progress() const;

  /// The estimate so far; null before the first observation, and with a target of known shape.
  const IncrementalFit* estimate() const { return fit_ ? &*fit_ : nullptr; }
  const std::optional<BodySides>& sides() const { return sides_; }
  std::optional<double> noise() const;

 private:
  static constexpr std::size_t most_waiting = 5;  // labelled observations that an unknown mount is first found from
  int noise_degrees() const;
  /// The corners of an observation that is not decided yet.
  struct Open {
    std::int64_t id = 0;
    Eigen::VectorXd position;
    ProblemObservation posture;
    std::vector<Corner> left, right;
    std::vector<SeenBody> bodies;
    bool has_bodies = false;  // they were looked for
    bool is_labelled = false;
  };

  Message find_markers(const std::vector<Corner>& left, const std::vector<Corner>& right,
                       const ProblemObservation& posture, std::vector<Sighting>& sightings) const;
  bool searches_mount(const Observation& observation, const ImagePair* images) const;
  void leave_open(const Observation& observation, const ImagePair* images, const ProblemObservation& posture,
                  OnlineStep& step);
  void look_for_mount();
  void start_from_labels();
  KnownMarkers labelled_markers() const;
  void try_again();
  OnlineStep tried_again(const Open& open);
  Message open_reason() const;
  Message label_refusal(const std::vector<Sighting>& sightings) const;
  Message start(const ProblemObservation& first);
  void start_from(const std::vector<ProblemObservation>& observations, const Unknowns& values);
  std::vector<Vector3> body_in_tcp() const;
  KnownMarkers known_markers() const;
  void learn_new_markers(const ProblemObservation& observation);
  void learn_shape_and_noise(const ProblemObservation& observation);
  void decide_sides();
  void describe(const ProblemObservation& observation, OnlineStep& step) const;

  std::optional<OnlineTarget> target_;  // does it all where the shape is known
  Chain chain_;
  Mount mount_;
  OnlineOptions options_;
  Problem problem_;
  std::optional<double> declared_noise_;
  double usual_sigma_;  // px or m: what a sighting of weight 1 has; Sighting::usual_sigma
  std::optional<IncrementalFit> fit_;
  RunningShape shape_;
  std::optional<BodySides> sides_;
  bool sides_are_kept_ = false;
  std::vector<ProblemObservation> waiting_;  // an unknown mount needs several before anything can be estimated
  std::vector<Open> open_;                   // in their order, labelled ones among them
  std::vector<OnlineStep> revised_;
  Eigen::VectorXd last_position_;
  std::int64_t last_id_ = -1;
  double internal_squares_ = 0;  // of the body poses: what the noise is seen from
  int internal_rows_ = 0;
};

}  // namespace handsight
