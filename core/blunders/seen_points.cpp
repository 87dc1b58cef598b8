// SPDX-License-Identifier: Apache-2.0
#include "blunders/seen_points.h"

#include <algorithm>

#include "chain/chain.h"
#include "chain/sighting.h"
#include "estimation/problem/target_pose.h"
#include "estimation/start/shape_start.h"
#include "session/sample.h"

namespace handsight {
namespace {

constexpr std::size_t few = 9;  // points of a board
constexpr int stand_in = few_of_a_piece;

std::vector<int> used_places(const Session& session) {
  std::vector<int> used;
  for (std::size_t i = 0; i < session.observations.size(); ++i)
    if (is_used(session.observations[i])) used.push_back(static_cast<int>(i));
  return used;
}

std::vector<int> spread_of(const std::vector<int>& all, int most) {
  const int count = static_cast<int>(all.size());
  if (count <= most) return all;
  std::vector<int> some;
  for (int i = 0; i < most; ++i) some.push_back(all[static_cast<std::size_t>(i * (count - 1) / (most - 1))]);
  return some;
}

void show_nothing(Observation& o) {
  o.sightings.clear();
  o.target_pose.reset();
}

std::vector<int> seen_counts(const Session& session) {
  std::vector<int> counts(static_cast<std::size_t>(session.marker_count), 0);
  for (const Observation& o : session.observations)
    if (is_used(o))
      for (const Sighting& s : o.sightings) ++counts[static_cast<std::size_t>(s.marker)];
  return counts;
}

/// Of those that are seen about as often as any, each time the one farthest from those that are taken already.
std::vector<std::size_t> spread_markers(const std::vector<Vector3>& places, const std::vector<int>& counts) {
  const int often = *std::max_element(counts.begin(), counts.end());
  std::vector<double> distance(places.size(), 1e9);
  std::vector<std::size_t> taken;
  while (taken.size() < few) {
    std::size_t best = places.size();
    for (std::size_t m = 0; m < places.size(); ++m)
      if (2 * counts[m] >= often && distance[m] > 0 && (best == places.size() || distance[m] > distance[best]))
        best = m;
    if (best == places.size()) break;
    taken.push_back(best);
    for (std::size_t m = 0; m < places.size(); ++m)
      distance[m] = std::min(distance[m], (places[m] - places[best]).norm());
  }
  std::sort(taken.begin(), taken.end());
  return taken;
}

std::vector<Sighting> shown_by_pose(const Session& session, const Observation& o) {
  std::vector<Sighting> shown;
  const auto pieces = by_piece(*session.shape, o.sightings);
  for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
    const auto pose = target_pose(&*session.rig, pieces[piece], session.shape->markers);
    if (!pose) continue;
    const std::vector<Vector3> points = few_points(*session.shape, static_cast<int>(piece));
    for (int i = 0; i < stand_in; ++i)
      shown.push_back({.marker = stand_in * static_cast<int>(piece) + i,
                       .point = pose->pose.sensor_from_body * points[static_cast<std::size_t>(i)]});
  }
  return shown;
}

std::vector<Sighting> triangulated(const Session& session, const Observation& o) {
  std::vector<Sighting> shown;
  for (const Sighting& s : o.sightings)
    if (const auto seen = triangulate(*session.rig, s)) shown.push_back({.marker = s.marker, .point = seen->point});
  return shown;
}

}  // namespace

Session thinned_session(const Session& session) {
  const std::vector<int> chosen = spread_of(used_places(session), most_sights);
  const int count = static_cast<int>(session.observations.size());
  std::vector<char> is_near(session.observations.size(), 0), is_chosen(session.observations.size(), 0);
  for (const int i : chosen) {
    is_chosen[static_cast<std::size_t>(i)] = 1;
    for (int k = std::max(0, i - farthest_shift); k <= std::min(count - 1, i + farthest_shift); ++k)
      is_near[static_cast<std::size_t>(k)] = 1;
  }
  std::vector<int> near;
  for (int i = 0; i < count; ++i)
    if (is_near[static_cast<std::size_t>(i)]) near.push_back(i);
  Session thin = take_part(session, near);
  for (std::size_t k = 0; k < near.size(); ++k)
    if (!is_chosen[static_cast<std::size_t>(near[k])]) show_nothing(thin.observations[k]);
  return thin;
}

Session with_few_markers(const Session& session) {
  if (!session.rig || !session.shape || session.shape->piece_count() > 1 || session.shape->markers.size() <= few + 3)
    return session;
  const std::vector<std::size_t> taken = spread_markers(session.shape->markers, seen_counts(session));
  std::vector<int> number(session.shape->markers.size(), -1);
  Session small = session;
  small.target.reset();
  small.shape->markers.clear();
  for (const std::size_t m : taken) {
    number[m] = static_cast<int>(small.shape->markers.size());
    small.shape->markers.push_back(session.shape->markers[m]);
  }
  small.marker_count = static_cast<int>(taken.size());
  for (Observation& o : small.observations) {
    std::erase_if(o.sightings, [&](const Sighting& s) { return number[static_cast<std::size_t>(s.marker)] < 0; });
    for (Sighting& s : o.sightings) s.marker = number[static_cast<std::size_t>(s.marker)];
    if (o.sightings.size() < 4) o.sightings.clear();
  }
  return small;
}

namespace {

Session with_points(const Session& session, bool by_pose) {
  Session points = session;
  points.rig.reset();
  points.target.reset();
  points.shape.reset();
  if (by_pose) points.marker_count = stand_in * session.shape->piece_count();
  for (Observation& o : points.observations)
    o.sightings = !is_used(o) ? std::vector<Sighting>()
                  : by_pose   ? shown_by_pose(session, o)
                              : triangulated(session, o);
  return points;
}

std::size_t count_shown(const Session& session) {
  return static_cast<std::size_t>(std::ranges::count_if(
      session.observations, [](const Observation& o) { return is_used(o) && !o.sightings.empty(); }));
}

}  // namespace

Session as_point_session(const Session& session) {
  if (!session.rig) return session;
  Session points = with_points(session, session.shape.has_value());
  // A target of quite another size has no pose before two cameras; its points have places all the same.
  if (session.shape && session.rig->count() > 1 && 2 * count_shown(points) < count_shown(session))
    return with_points(session, false);
  return points;
}

std::vector<HandSight> list_sights(const Session& points) {
  const Chain chain = make_chain(points);
  std::vector<HandSight> sights;
  for (const Observation& o : points.observations) {
    if (!is_used(o)) continue;
    const ChainEnds ends = chain_ends(chain, o.position);
    HandSight& sight = sights.emplace_back();
    sight.mount_from_tcp = inverse(ends.root_from_mount) * ends.root_from_tcp;
    for (const Sighting& s : o.sightings)
      if (s.point) sight.points.push_back({s.marker, *s.point});
    if (sight.points.empty()) sights.pop_back();
  }
  return sights;
}

std::optional<HandEye> solve_hand_eye(const Session& points) {
  const bool is_given = !points.mount.estimate && points.mount.known;
  return hand_eye(list_sights(points), points.marker_count,
                  is_given ? std::optional(points.mount.mount_from_sensor) : std::nullopt);
}

}  // namespace handsight
