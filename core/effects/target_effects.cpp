// SPDX-License-Identifier: Apache-2.0
#include "effects/target_effects.h"

#include <algorithm>
#include <cmath>

#include "chain/body_frame.h"
#include "effects/part_effects.h"

namespace handsight {
namespace {

bool is_flat(const KnownShape& shape) {
  constexpr double nearly = 1e-9;  // m
  return std::all_of(shape.markers.begin(), shape.markers.end(),
                     [&](const Vector3& x) { return std::abs(x.z() - shape.markers.front().z()) < nearly; });
}

/// Is the shape of the markers known, and are there enough of them to have one?
bool has_known_shape(const Session& session) {
  return session.shape && session.shape->sigma && session.shape->piece_count() == 1 &&
         session.shape->markers.size() >= 3;
}

std::vector<Vector3> places_by_order(const Session& session, const Chain& chain) {
  std::vector<Vector3> places;
  const std::vector<ObservationState> all = observation_states(session, chain);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto order = static_cast<std::size_t>(all[i].order);
    if (order >= places.size()) places.resize(order + 1, Vector3::Zero());
    if (session.observations[i].target_pose) places[order] = session.observations[i].target_pose->translation;
  }
  return places;
}

/// Of a joined session of several bodies: what each of known shape has of its own.
void add_of_bodies(const Session& session, const Chain& chain, OwnEffects& all) {
  std::vector<std::pair<int, Effect>> scales, bends;
  std::vector<int> bodies;
  for (std::size_t p = 0; p < session.parts.size(); ++p) {
    const SessionPart& part = session.parts[p];
    if (std::find(bodies.begin(), bodies.end(), part.body) != bodies.end()) continue;
    bodies.push_back(part.body);
    const auto first = static_cast<std::size_t>(part.first_marker), count = static_cast<std::size_t>(part.marker_count);
    if (count < 3 || session.shape->piece(first) != session.shape->piece(first + count - 1)) continue;
    const auto begin = session.shape->markers.begin() + part.first_marker;
    const KnownShape own{{begin, begin + part.marker_count}};
    scales.emplace_back(static_cast<int>(p), target_scale(described_in_body(own)));
    if (is_flat(own)) bends.emplace_back(static_cast<int>(p), target_bend(own));
  }
  for (const auto& effects : {scales, bends})
    if (!effects.empty()) all.push_back(std::make_shared<const Effect>(at_bodies(effects, chain)));
}

}  // namespace

OwnEffects target_effects(const Session& session, const Chain& chain) {
  OwnEffects all;
  const auto add = [&](Effect effect) { all.push_back(std::make_shared<const Effect>(std::move(effect))); };
  if (!session.parts.empty() && session.shape && session.shape->piece_count() > 1) {
    add_of_bodies(session, chain, all);
  } else if (session.pose_sensor) {
    add(target_scale_of_poses(places_by_order(session, chain)));
  } else if (has_known_shape(session)) {
    add(target_scale(described_in_body(*session.shape)));
    if (is_flat(*session.shape)) add(target_bend(*session.shape));
    if (session.target && has_places(*session.target) && session.target->ids.size() > 1)
      add(tag_placement(*session.target));
  }
  return all;
}

void move_no_target(const ObservationState&, int, std::span<const double>, Sites&) {}

bool has_no_target(const Effect& effect) {
  using Move = void (*)(const ObservationState&, int, std::span<const double>, Sites&);
  const Move* move = effect.move.target<Move>();
  return move && *move == &move_no_target;
}

Rigid body_from_described(const KnownShape& shape) {
  const BodySides sides = choose_sides({shape.markers.begin(), shape.markers.end()});
  return inverse(body_frame(sides, shape.markers).tcp_from_body);
}

std::vector<Vector3> described_in_body(const KnownShape& shape) {
  const Rigid body_from_target = body_from_described(shape);
  std::vector<Vector3> in_body;
  for (const Vector3& in_target : shape.markers) in_body.push_back(body_from_target * in_target);
  return in_body;
}

}  // namespace handsight
