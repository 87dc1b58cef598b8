// SPDX-License-Identifier: Apache-2.0
#include "session/merge.h"

#include <algorithm>
#include <map>

#include "session/session_xml.h"

namespace handsight {
namespace {

using Places = std::map<std::int64_t, std::size_t>;

Places list_places(const std::vector<Observation>& observations) {
  Places places;
  for (std::size_t i = 0; i < observations.size(); ++i) places.emplace(observations[i].id, i);
  return places;
}

EditableState with_labels_of(EditableState state, const EditableState& other) {
  state.sightings = other.sightings;
  return state;
}

bool same_labels(const EditableState& a, const EditableState& b) { return same_state(with_labels_of(a, b), a); }

bool same_decision(const EditableState& a, const EditableState& b) {
  return a.decision == b.decision && a.reason == b.reason;
}

bool same_vector(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return a.size() == b.size() && (a.size() == 0 || (a - b).isZero(0));
}

bool same_pose(const std::optional<Rigid>& a, const std::optional<Rigid>& b) {
  if (!a || !b) return !a && !b;
  return (a->translation - b->translation).isZero(0) && (a->rotation - b->rotation).isZero(0);
}

/// What nobody labels or decides.
bool same_measurement(const Observation& a, const Observation& b) {
  return a.time == b.time && same_vector(a.position, b.position) && same_vector(a.velocity, b.velocity) &&
         same_vector(a.torque, b.torque) && a.images == b.images && same_pose(a.target_pose, b.target_pose);
}

/// Everything but the observations, as a session says it.
std::string frame_text(const Session& session) {
  Session frame;
  frame.title = session.title;
  frame.robot_file = session.robot_file;
  frame.robot.is_of_poses = session.robot.is_of_poses;
  frame.tcp = session.tcp;
  frame.repeatability = session.repeatability;
  frame.gravity = session.gravity;
  frame.mount = session.mount;
  frame.rig = session.rig;
  frame.sigma_pixel = session.sigma_pixel;
  frame.sigma_point = session.sigma_point;
  frame.pose_sensor = session.pose_sensor;
  frame.target = session.target;
  frame.marker_count = session.marker_count;
  frame.joints = session.joints;
  return session_text(frame);
}

/// Do labels and positions of the one mean the same in the other?
bool speak_alike(const Session& a, const Session& b) {
  const auto cameras = [](const Session& s) { return s.rig ? camera_names(*s.rig) : std::vector<std::string>{}; };
  return a.is_tracker() == b.is_tracker() && a.pose_sensor.has_value() == b.pose_sensor.has_value() &&
         cameras(a) == cameras(b) && a.joints == b.joints && a.marker_count == b.marker_count;
}

/// One observation that was changed here, put into theirs.
void put_in(const ObservationEdit& own, Observation& theirs, Merge& merge) {
  const EditableState there = read_state(theirs);
  EditableState result = there;
  Observation mine = theirs;
  set_state(mine, own.after);
  bool is_kept = false;
  const auto decide = [&](auto same, auto take, Collision::What what) {
    if (same(own.after, own.before) || same(own.after, there)) return;
    if (!same(own.before, there)) {
      merge.collisions.push_back({what, own.id, mine, theirs});
      return;
    }
    take(result, own.after);
    is_kept = true;
  };
  decide(
      same_labels, [](EditableState& to, const EditableState& s) { to.sightings = s.sightings; },
      Collision::What::labels);
  decide(
      same_decision,
      [](EditableState& to, const EditableState& s) {
        to.decision = s.decision;
        to.reason = s.reason;
      },
      Collision::What::decision);
  set_state(theirs, result);
  merge.kept += is_kept;
}

/// At its place in the order of time, behind those of the same time.
void insert_by_time(Session& session, const Observation& o) {
  auto& all = session.observations;
  all.insert(std::upper_bound(all.begin(), all.end(), o.time,
                              [](double time, const Observation& other) { return time < other.time; }),
             o);
}

const Observation* find_observation(const std::vector<Observation>& all, std::int64_t id) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Observation& o) { return o.id == id; });
  return found == all.end() ? nullptr : &*found;
}

/// One that came here, beside one that may have come there under its number.
void add_new(const Observation& own, Merge& merge) {
  Observation o = own;
  if (const Observation* same = find_observation(merge.session.observations, o.id)) {
    if (same_measurement(o, *same) && same_state(read_state(o), read_state(*same))) return;
    for (const Observation& other : merge.session.observations) o.id = std::max(o.id, other.id + 1);
    merge.renumbered.emplace_back(own.id, o.id);
  }
  insert_by_time(merge.session, o);
  ++merge.kept;
}

/// Do all labels name markers and cameras of the session, all positions its joints?
bool fit_into(const SessionEdit& own, const Session& session) {
  const auto labels_fit = [&](const std::vector<Sighting>& sightings) {
    return std::all_of(sightings.begin(), sightings.end(), [&](const Sighting& s) {
      const bool cameras_fit = std::all_of(s.in_cameras.begin(), s.in_cameras.end(), [&](const CameraPoint& c) {
        return session.rig && c.camera < session.rig->count();
      });
      return s.marker < session.marker_count && cameras_fit && s.point.has_value() == session.is_tracker();
    });
  };
  return std::all_of(own.observations.begin(), own.observations.end(),
                     [&](const ObservationEdit& e) { return labels_fit(e.after.sightings); }) &&
         std::all_of(own.added.begin(), own.added.end(), [&](const Observation& o) {
           return labels_fit(o.sightings) && o.position.size() == static_cast<Eigen::Index>(session.joints.size());
         });
}

}  // namespace

SessionEdit own_changes(const Session& base, const Session& now) {
  SessionEdit own;
  const Places before = list_places(base.observations);
  for (const Observation& o : now.observations) {
    const auto known = before.find(o.id);
    if (known == before.end()) {
      own.added.push_back(o);
      continue;
    }
    const EditableState was = read_state(base.observations[known->second]), is = read_state(o);
    if (!same_state(was, is)) own.observations.push_back({o.id, was, is});
  }
  return own;
}

SessionEdit own_changes(const std::vector<DoneEdit>& done) {
  std::map<std::int64_t, ObservationEdit> net;
  std::map<std::int64_t, Observation> added;
  for (const auto& [edit, forward] : done) {
    if (forward)
      for (const Observation& o : edit.added) added.emplace(o.id, o);
    for (const ObservationEdit& o : edit.observations) {
      const EditableState& from = forward ? o.before : o.after;
      const EditableState& to = forward ? o.after : o.before;
      net.emplace(o.id, ObservationEdit{o.id, from, from}).first->second.after = to;
    }
    if (!forward)
      for (const Observation& o : edit.added) added.erase(o.id);
  }
  SessionEdit own;
  for (auto& [id, edit] : net) {
    const auto is_new = added.find(id);
    if (is_new != added.end()) set_state(is_new->second, edit.after);
    if (is_new == added.end() && !same_state(edit.before, edit.after)) own.observations.push_back(edit);
  }
  for (auto& [id, o] : added) own.added.push_back(std::move(o));
  return own;
}

Merge merged(const SessionEdit& own, const Session* here, Session theirs) {
  Merge merge;
  merge.session = std::move(theirs);
  if (own.is_empty()) return merge;
  if (here ? !speak_alike(*here, merge.session) : !fit_into(own, merge.session)) {
    merge.collisions.push_back({Collision::What::session, 0, {}, {}});
    return merge;
  }
  Places there = list_places(merge.session.observations);
  for (const ObservationEdit& edit : own.observations) {
    const auto found = there.find(edit.id);
    if (found != there.end()) {
      put_in(edit, merge.session.observations[found->second], merge);
      continue;
    }
    const Observation* mine = here ? find_observation(here->observations, edit.id) : nullptr;
    if (mine) merge.collisions.push_back({Collision::What::gone, edit.id, *mine, {}});
    merge.lost += mine == nullptr;
  }
  for (const Observation& o : own.added) add_new(o, merge);
  return merge;
}

void take_mine(const Collision& c, Session& session) {
  const auto found = std::find_if(session.observations.begin(), session.observations.end(),
                                  [&](const Observation& o) { return o.id == c.id; });
  if (c.what == Collision::What::gone) {
    if (found == session.observations.end()) insert_by_time(session, c.mine);
    return;
  }
  if (found == session.observations.end()) return;
  if (c.what == Collision::What::labels) found->sightings = c.mine.sightings;
  if (c.what == Collision::What::decision) {
    found->decision = c.mine.decision;
    found->reason = c.mine.reason;
  }
}

std::optional<SessionEdit> edit_between(const Session& from, const Session& to) {
  if (frame_text(from) != frame_text(to)) return std::nullopt;
  SessionEdit edit;
  std::size_t place = 0;  // in `from`
  for (const Observation& after : to.observations) {
    if (place == from.observations.size() || from.observations[place].id != after.id) {
      if (find_observation(from.observations, after.id)) return std::nullopt;  // in another order
      edit.added.push_back(after);
      continue;
    }
    const Observation& before = from.observations[place++];
    if (!same_measurement(before, after)) return std::nullopt;
    if (!same_state(read_state(before), read_state(after)))
      edit.observations.push_back({after.id, read_state(before), read_state(after)});
  }
  if (place < from.observations.size()) return std::nullopt;
  return edit;
}

}  // namespace handsight
