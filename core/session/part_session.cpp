// SPDX-License-Identifier: Apache-2.0
// One part of a joined session by itself again.
#include "session/by_time.h"
#include "session/joined.h"

namespace handsight {
namespace {

/// Of a session of touches, whose fixtures are touched in turn, the place is that among all touches.
PlaceInWhole place_in_whole(const Session& all, const Observation& o) {
  if (o.whole) return *o.whole;
  PlaceInWhole place;
  const std::vector<int> order = by_time(all);
  const auto at = [&](std::size_t k) -> const Observation& {
    return all.observations[static_cast<std::size_t>(order[k])];
  };
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (&at(k) != &o) continue;
    place.order = static_cast<int>(k);
    if (k > 0) place.position_before = at(k - 1).position;
  }
  place.start = at(0).time;
  place.end = at(order.size() - 1).time;
  return place;
}

}  // namespace

Session part_session(const Session& all, int number) {
  const SessionPart& part = all.parts[static_cast<std::size_t>(number)];
  Session s;
  s.file = part.file;
  s.title = part.title;
  s.robot_file = all.robot_file;
  s.robot = all.robot;
  s.tcp = part.tcp;
  s.repeatability = all.repeatability;
  s.gravity = all.gravity;
  s.mount = part.mount == 0 ? all.mount : all.other_mounts[static_cast<std::size_t>(part.mount - 1)];
  s.joints = all.joints;
  s.marker_count = part.marker_count;
  s.effect_definitions = all.effect_definitions;
  if (part.camera_count > 0) {
    s.rig.emplace();
    for (int c = 0; c < part.camera_count; ++c) s.rig->cameras.push_back(all.rig->at(part.first_camera + c));
    if (all.sigma_pixel) s.sigma_pixel = part.residual_unit * *all.sigma_pixel;
  } else {
    const auto& unit = all.rig ? all.sigma_pixel : all.sigma_point;
    if (unit) s.sigma_point = part.residual_unit * *unit;
  }
  if (all.shape && all.shape->piece_count() == 1) {
    s.shape = all.shape;
    s.target = all.target;
  } else if (all.shape) {
    KnownShape shape;
    for (int i = 0; i < part.marker_count; ++i) {
      const auto m = static_cast<std::size_t>(part.first_marker + i);
      shape.markers.push_back(all.shape->markers[m]);
      shape.pieces.push_back(all.shape->pieces[m] - all.shape->pieces[static_cast<std::size_t>(part.first_marker)]);
      if (shape.piece_sigmas.size() <= static_cast<std::size_t>(shape.pieces.back()))
        shape.piece_sigmas.push_back(all.shape->piece_sigma(all.shape->pieces[m]));
    }
    const bool has_shape = shape.piece_count() < part.marker_count;
    shape.sigma = shape.piece_sigmas.front();
    if (shape.piece_count() == 1) shape.pieces.clear(), shape.piece_sigmas.clear();
    if (has_shape) s.shape = std::move(shape);
  }
  for (const Observation& from : all.observations) {
    if (from.part != number) continue;
    Observation o = from;
    o.part = 0;
    o.id -= part.first_id;
    o.time -= part.first_time;
    auto whole = std::make_shared<PlaceInWhole>(place_in_whole(all, from));
    whole->order -= part.first_order;
    whole->start -= part.first_time;
    whole->end -= part.first_time;
    o.whole = std::move(whole);
    o.images = {};
    for (int c = 0; c < part.camera_count; ++c)
      o.images[static_cast<std::size_t>(c)] = from.images[static_cast<std::size_t>(part.first_camera + c)];
    for (Sighting& sighting : o.sightings) {
      sighting.marker -= part.first_marker;
      for (CameraPoint& p : sighting.in_cameras) p.camera -= part.first_camera;
    }
    s.observations.push_back(std::move(o));
  }
  return s;
}

std::optional<Session> touches_of_body(const Session& all, int body) {
  Session s;
  std::vector<int> take_part(all.parts.size(), -1);  // by the number among all
  for (std::size_t p = 0; p < all.parts.size(); ++p) {
    if (all.parts[p].fixture < 0 || all.parts[p].body != body) continue;
    const SessionPart& from = all.parts[p];
    take_part[p] = static_cast<int>(s.parts.size());
    if (s.parts.empty()) {
      s = part_session(all, static_cast<int>(p));
      s.observations.clear();
    }
    const Mount& mount = find_mount(all, from.mount);
    if (s.parts.empty())
      s.mount = mount;
    else
      s.other_mounts.push_back(mount);
    SessionPart part;
    part.title = from.title;
    part.tcp = from.tcp;
    part.mount = part.fixture = take_part[p];
    part.marker_count = from.marker_count;
    s.parts.push_back(std::move(part));
    s.fixtures.push_back(all.fixtures[static_cast<std::size_t>(from.fixture)]);
  }
  if (s.parts.empty()) return std::nullopt;
  for (const Observation& from : all.observations) {
    const auto p = static_cast<std::size_t>(from.part);
    if (take_part[p] < 0) continue;
    Observation o = from;
    o.part = take_part[p];
    for (Sighting& sighting : o.sightings) sighting.marker -= all.parts[p].first_marker;
    s.observations.push_back(std::move(o));
  }
  return s;
}

}  // namespace handsight
