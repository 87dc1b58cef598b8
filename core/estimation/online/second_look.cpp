// SPDX-License-Identifier: Apache-2.0
#include "estimation/online/second_look.h"

#include <algorithm>

#include "vision/corners/corner_detector.h"
#include "vision/markers/following_observation.h"

namespace handsight {
namespace {

KnownMarkers known_markers(const Fit& fit, double sigma) {
  KnownMarkers known;
  for (std::size_t m = 0; m < fit.markers_in_body.size(); ++m) {
    known.in_body.push_back(fit.problem.marker_is_seen[m] ? std::optional(fit.markers_in_body[m]) : std::nullopt);
    known.sigma.push_back(sigma);
  }
  return known;
}

std::vector<Sighting> sightings_of(const Match& match, const std::vector<Corner>& left,
                                   const std::vector<Corner>& right) {
  std::vector<Sighting> list;
  for (const MatchedMarker& m : match.markers) {
    Sighting s{.marker = m.marker, .by = MarkedBy::import};
    const auto take = [&](const Corner& corner, int camera) {
      see(s, camera, corner.position, pixel_sigma(measured_covariance(corner)));
    };
    if (m.left >= 0) take(left[static_cast<std::size_t>(m.left)], 0);
    if (m.right >= 0) take(right[static_cast<std::size_t>(m.right)], 1);
    list.push_back(s);
  }
  return list;
}

/// How the gates are opened, one fault after the other.
struct Look {
  double side_sigma, marker_gate, body_gate, turn_gate, epipolar;
};
constexpr Look looks[] = {
    {0.0005, 0.005, 0.25, 0.60, 2},   // the hand is elsewhere
    {0.0080, 0.020, 0.10, 0.40, 2},   // a marker is elsewhere on the hand
    {0.0150, 0.040, 0.30, 0.60, 40},  // the images are of two moments
};

}  // namespace

bool wants_second_look(const Session& session, const Observation& o) {
  return session.rig && is_pair(*session.rig) && o.decision == Decision::rejected && o.sightings.empty() &&
         !o.images[0].empty() && !o.images[1].empty();
}

std::optional<std::vector<Sighting>> second_look(const Session& session, const Fit& fit, const Observation& observation,
                                                 const ImagePair& images) {
  if (!session.rig || !is_pair(*session.rig)) return std::nullopt;
  Session alone = session;
  alone.source.reset();
  Observation posed = observation;
  posed.decision = Decision::none;
  posed.sightings = {seen_at(0, Vector2(0, 0))};
  alone.observations = {posed};
  const Problem problem = make_problem(alone, make_chain(alone));
  const Rigid sensor_from_body = sensor_from_tcp_at(problem.observations[0], estimate(fit)) * fit.tcp_from_body;
  const std::vector<Corner> left = detect_corners(images.left), right = detect_corners(images.right);
  for (const Look& look : looks) {
    MatchOptions options;
    options.marker_gate = look.marker_gate;
    options.body_gate = look.body_gate;
    options.turn_gate = look.turn_gate;
    options.pairs.epipolar_threshold = look.epipolar;
    const Match match = match_markers(make_stereo(*session.rig), left, right, known_markers(fit, look.side_sigma),
                                      sensor_from_body, options);
    if (match.accepted() && match.markers.size() >= 3) return sightings_of(match, left, right);
  }
  return std::nullopt;
}

}  // namespace handsight
