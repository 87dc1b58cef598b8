// SPDX-License-Identifier: Apache-2.0
#include "convert/turns_by_images.h"

#include <algorithm>

#include "base/files.h"
#include "chain/chain.h"
#include "convert/choose_turns.h"
#include "convert/pair_poses.h"
#include "detection/target_finding.h"
#include "estimation/problem/target_pose.h"
#include "session/sample.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

constexpr int enough = 20;  // observations whose images are looked at

std::vector<int> spread_places(std::size_t count) {
  std::vector<int> places;
  const int all = static_cast<int>(count), taken = std::min(all, enough);
  for (int i = 0; i < taken; ++i) places.push_back(i * (all - 1) / std::max(1, taken - 1));
  return places;
}

/// The target's poses in some of the images, and of which observations they are.
struct Seen {
  std::vector<std::size_t> rows;
  std::vector<Rigid> poses;
};

/// Of several tags each is a body of its own.
int most_seen_piece(const Session& session) {
  std::vector<int> counts(static_cast<std::size_t>(session.shape->piece_count()), 0);
  for (const Observation& o : session.observations)
    for (const Sighting& s : o.sightings)
      ++counts[static_cast<std::size_t>(session.shape->piece(static_cast<std::size_t>(s.marker)))];
  return static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

std::vector<Sighting> of_piece(const KnownShape& shape, int piece, const std::vector<Sighting>& all) {
  std::vector<Sighting> some;
  for (const Sighting& s : all)
    if (shape.piece(static_cast<std::size_t>(s.marker)) == piece) some.push_back(s);
  return some;
}

Seen seen_in_images(const Session& session) {
  Seen seen;
  const std::vector<int> places = spread_places(session.observations.size());
  Session some = take_part(session, places);
  find_targets(some);
  if (!some.shape) return seen;
  const int piece = most_seen_piece(some);
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (some.observations[k].sightings.empty()) continue;
    const std::vector<Sighting> of_one = of_piece(*some.shape, piece, some.observations[k].sightings);
    if (const auto pose = target_pose(&*some.rig, of_one, some.shape->markers)) {
      seen.rows.push_back(static_cast<std::size_t>(places[k]));
      seen.poses.push_back(pose->pose.sensor_from_body);
    }
  }
  return seen;
}

}  // namespace

void choose_turns_by_images(NamedPoses& flange, bool eye_in_hand, Conversion& c) {
  const Seen seen = seen_in_images(c.session);
  NamedPoses target{"the images", "", {.poses = seen.poses}};
  NamedPoses some = take_rows(flange, seen.rows);
  if (seen.rows.empty()) {
    take_usual_turns(flange, c.notes);
    return;
  }
  choose_turns(some, target, eye_in_hand, c.notes);
  flange.turns.readings = some.turns.readings;
  read_turns(flange.turns, flange.turns.readings.front(), flange.series);
  Session& s = c.session;
  for (std::size_t i = 0; i < s.observations.size() && i < flange.series.poses.size(); ++i)
    s.observations[i].position = make_position(flange.series.poses[i]);
  s.source.reset();  // poses are written anew
  replace_file(s.file, session_text(s));
  s = read_session(s.file);
}

}  // namespace handsight
