// SPDX-License-Identifier: Apache-2.0
// Online calibration while nothing is known of the mount: observations are left open until several agree on one.
#include <fmt/format.h>

#include <algorithm>

#include "estimation/online/online.h"
#include "estimation/problem/body_pose.h"
#include "estimation/start/start.h"
#include "vision/corners/corner_detector.h"
#include "vision/markers/body_candidates.h"
#include "vision/markers/following_observation.h"

namespace handsight {
namespace {

constexpr std::size_t most_looked_at = 60;  // of the open observations, the newest: the search grows with their square

/// Labels that were not found by an earlier play; three at least, else none.
std::vector<Sighting> labels_by_somebody(const Observation& o) {
  std::vector<Sighting> labels;
  for (const Sighting& s : o.sightings)
    if (s.by != MarkedBy::tracker && s.in_cameras.size() > 1) labels.push_back(s);
  if (labels.size() < 3) labels.clear();
  return labels;
}

/// The covariance of the corner that was labelled; of none near it, that of a steady hand.
Eigen::Matrix2d covariance_at(const std::vector<Corner>& corners, const Vector2& px) {
  for (const Corner& c : corners)
    if ((c.position - px).norm() < 1) return c.covariance + 0.01 * Eigen::Matrix2d::Identity();
  return 0.25 * Eigen::Matrix2d::Identity();
}

std::vector<SeenBody> seen_bodies(const StereoRig& rig, const std::vector<Corner>& left,
                                  const std::vector<Corner>& right, const KnownMarkers& known,
                                  const MatchOptions& options) {
  std::vector<SeenBody> bodies;
  for (const BodyCandidate& c : body_candidates(rig, left, right, known, options)) {
    SeenBody seen{{}, c.sensor_from_body, c.sigma, c.turn_sigma};
    for (const MatchedMarker& m : c.markers)
      seen.sightings.push_back(seen_at(m.marker, left[static_cast<std::size_t>(m.left)].position,
                                       right[static_cast<std::size_t>(m.right)].position, MarkedBy::tracker));
    bodies.push_back(std::move(seen));
  }
  return bodies;
}

}  // namespace

bool OnlineCalibration::searches_mount(const Observation& observation, const ImagePair* images) const {
  if (fit_ || !mount_.estimate || mount_.known || problem_.marker_count < 3) return false;
  if (!problem_.rig || !is_pair(*problem_.rig)) return false;
  return images || !labels_by_somebody(observation).empty();
}

/// The markers as the first labelled observation shows them, in its sensor's frame.
KnownMarkers OnlineCalibration::labelled_markers() const {
  KnownMarkers known;
  known.in_body.resize(static_cast<std::size_t>(problem_.marker_count));
  known.sigma.resize(known.in_body.size(), 0);
  for (const Open& o : open_) {
    if (!o.is_labelled) continue;
    for (const Sighting& s : o.posture.sightings) {
      const CameraPoint *left = seen_by(s, 0), *right = seen_by(s, 1);
      if (!left || !right) continue;
      const auto point = triangulate(make_stereo(*problem_.rig), left->pixel, right->pixel,
                                     covariance_at(o.left, left->pixel), covariance_at(o.right, right->pixel));
      if (!point) continue;
      known.in_body[static_cast<std::size_t>(s.marker)] = point->point;
      known.sigma[static_cast<std::size_t>(s.marker)] = std::sqrt(point->covariance.trace() / 3);
    }
    break;
  }
  return known;
}

Message OnlineCalibration::open_reason() const {
  const auto progress = mount_progress();
  if (!progress || progress->labelled == 0)
    return "left open: nothing is known of the cameras' mount, and no observation is labelled yet";
  Message text = message(
      "left open until the cameras' mount is known: {} labelled and {} open observations do not agree on one yet",
      progress->labelled, progress->open);
  if (progress->label_next) text += message("; observation {} would tell most if labelled", *progress->label_next);
  return text;
}

std::optional<OnlineCalibration::MountProgress> OnlineCalibration::mount_progress() const {
  if (fit_ || open_.empty()) return std::nullopt;
  MountProgress progress;
  std::vector<MountWitness> witnesses;
  for (const Open& o : open_) {
    (o.is_labelled ? progress.labelled : progress.open) += 1;
    witnesses.push_back({o.posture, {}, o.is_labelled});
  }
  const int next = most_telling_witness(witnesses);
  if (next >= 0) progress.label_next = open_[static_cast<std::size_t>(next)].id;
  return progress;
}

void OnlineCalibration::leave_open(const Observation& observation, const ImagePair* images,
                                   const ProblemObservation& posture, OnlineStep& step) {
  Open open{observation.id, observation.position, posture, {}, {}, {}, false, false};
  if (images) {
    open.left = detect_corners(images->left, options_.detector);
    open.right = detect_corners(images->right, options_.detector);
  }
  open.posture.sightings = labels_by_somebody(observation);
  open.is_labelled = !open.posture.sightings.empty();
  last_position_ = observation.position;
  last_id_ = observation.id;
  open_.push_back(std::move(open));
  look_for_mount();
  if (!fit_) {
    step.accepted = open_.back().is_labelled;
    step.is_open = !step.accepted;
    step.from_images = step.is_open;
    if (step.accepted) step.sightings = open_.back().posture.sightings;
    if (step.is_open) step.reason = open_reason();
    return;
  }
  // What was left open is decided now, and this one among it.
  try_again();
  step = revised_.back();
  revised_.pop_back();
}

void OnlineCalibration::look_for_mount() {
  const KnownMarkers known = labelled_markers();
  if (std::count_if(known.in_body.begin(), known.in_body.end(), [](const auto& x) { return x.has_value(); }) < 3)
    return;
  std::vector<MountWitness> witnesses;
  std::vector<Open*> theirs;
  std::size_t open = 0;
  for (Open& o : open_) open += o.is_labelled ? 0 : 1;
  for (Open& o : open_) {
    if (!o.is_labelled && open-- > most_looked_at) continue;
    if (!o.has_bodies && !o.is_labelled)
      o.bodies = seen_bodies(make_stereo(*problem_.rig), o.left, o.right, known, options_.match);
    if (o.is_labelled && !o.has_bodies) {
      std::vector<Vector3> in_body;
      for (const auto& x : known.in_body) in_body.push_back(x.value_or(Vector3::Zero()));
      std::vector<Sighting> of_known;
      for (const Sighting& s : o.posture.sightings)
        if (known.in_body[static_cast<std::size_t>(s.marker)]) of_known.push_back(s);
      const auto pose = body_pose_from_points(problem_.rig_or_null(), of_known, in_body);
      if (pose) o.bodies.push_back({of_known, *pose, 0.005, 0.1});
    }
    o.has_bodies = true;
    witnesses.push_back({o.posture, o.bodies, o.is_labelled});
    theirs.push_back(&o);
  }
  const auto found = search_mount(problem_, witnesses, known, options_.match);
  if (!found) return start_from_labels();
  std::vector<ProblemObservation> agreeing;
  for (std::size_t w = 0; w < witnesses.size(); ++w) {
    const int chosen = found->chosen[w];
    if (chosen < 0) continue;
    agreeing.push_back(witnesses[w].posture);
    if (!witnesses[w].is_labelled)
      agreeing.back().sightings = witnesses[w].bodies[static_cast<std::size_t>(chosen)].sightings;
    theirs[w]->posture.sightings = agreeing.back().sightings;
  }
  start_from(agreeing, found->start);
  learn_shape_and_noise(agreeing.back());
  decide_sides();
}

/// Many labels settle a mount even where the robot is too far off for the gates.
void OnlineCalibration::start_from_labels() {
  Problem labelled = problem_;
  for (const Open& o : open_)
    if (o.is_labelled) labelled.observations.push_back(o.posture);
  if (labelled.observations.size() < most_waiting) return;
  const auto values = start_values(labelled, mount_);
  if (!values) return;
  start_from(labelled.observations, *values);
  learn_shape_and_noise(labelled.observations.back());
  decide_sides();
}

OnlineStep OnlineCalibration::tried_again(const Open& open) {
  OnlineStep step;
  step.id = open.id;
  ProblemObservation posture = open.posture;
  const bool is_in = !posture.sightings.empty();  // it is one of those that settled the mount
  step.sightings = posture.sightings;
  step.from_images = !open.is_labelled;
  if (!is_in) step.reason = find_markers(open.left, open.right, posture, step.sightings);
  posture.sightings = step.sightings;
  step.accepted = step.reason.empty();
  if (step.accepted && !is_in) {
    learn_new_markers(posture);
    fit_->add(posture);
    learn_shape_and_noise(posture);
    decide_sides();
  }
  describe(posture, step);
  return step;
}

void OnlineCalibration::try_again() {
  for (const Open& open : open_) {
    revised_.push_back(tried_again(open));
    if (!revised_.back().accepted) continue;
    last_position_ = open.position;
    last_id_ = open.id;
  }
  open_.clear();
}

}  // namespace handsight
