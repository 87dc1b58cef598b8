// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/session_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chain/arrangement.h"
#include "chain/chain.h"
#include "chain/sighting.h"
#include "estimation/fit/touch_counts.h"
#include "estimation/report/session_warnings.h"
#include "session/fixtures/fixture_kind.h"
#include "vision/image/image_file.h"

namespace handsight {
namespace {

Message device_of(const Session& session) {
  if (session.pose_sensor) return "A pose sensor";
  if (!session.rig) return "A tracker";
  if (is_left_and_right(*session.rig)) return "Two cameras";
  constexpr const char* counts[] = {"One camera",   "Two cameras", "Three cameras", "Four cameras",
                                    "Five cameras", "Six cameras", "Seven cameras", "Eight cameras"};
  return message("{} ({})", counts[session.rig->count() - 1], listed_names(*session.rig));
}

/// What the sensor looks at, beside the numbers of it.
Message target_of(const Session& session) {
  if (session.pose_sensor) return "poses of a target";
  if (session.target) return message("the {} points of a target", session.marker_count);
  return message("{} marker{}", session.marker_count, session.marker_count == 1 ? "" : "s");
}

Message print_of(const Target& target) {
  if (has_places(target) && !are_places_exact(target)) {
    double most = 0;
    for (const TagPlace& place : target.places) most = std::max(most, place.sigma);
    return message("its tags are placed to {:.2g} mm", 1e3 * most);
  }
  if (!target.places.empty() && !target.sigma) return "the places of its tags are estimated";
  if (!target.sigma) return "its points are estimated";
  return *target.sigma == 0 ? "its points are held as described"
                            : message("its points are known to {:.2g} mm", 1e3 * *target.sigma);
}

/// Images that every camera of the rig has of this observation; cameras without one.
int missing_images(const Session& session, const Observation& o) {
  int missing = 0;
  for (int c = 0; session.rig && c < session.rig->count(); ++c)
    missing += o.images[static_cast<std::size_t>(c)].empty();
  return missing;
}

/// What is touched, how often, and whether its place is known.
void list_fixtures(const Session& session, SessionCheck& check) {
  for (std::size_t f = 0; f < session.fixtures.size(); ++f) {
    const Fixture& fixture = session.fixtures[f];
    const Mount& mount = find_mount(session, static_cast<int>(f));
    const auto touches = std::count_if(session.observations.begin(), session.observations.end(), [&](const auto& o) {
      return o.part == static_cast<int>(f) && !o.sightings.empty();
    });
    check.contents.push_back(message("Fixture {} on {}, a {}: {} touches{}; its place is {}.", fixture.id, mount.link,
                                     fixture.kind->tag, touches,
                                     fixture.sigma ? message(", {:g} m each", *fixture.sigma) : Message(),
                                     !mount.estimate       ? Message("known")
                                     : fixture.place_sigma ? message("known to {:g} m", *fixture.place_sigma)
                                     : mount.known         ? Message("guessed, part of the fit")
                                                           : Message("unknown, part of the fit")));
  }
}

/// Are there enough touches for what is asked?
void check_touches(const Session& session, SessionCheck& check) {
  if (!session.is_touch()) return;
  if (const auto untouched = untouched_text(session)) check.problems.push_back(*untouched);
  if (const auto lacking = touches_lacking_text(session)) check.warnings.push_back(*lacking);
}

void list_contents(const Session& session, const Chain& chain, SessionCheck& check) {
  int moving = 0, masses = 0;
  for (const Joint& j : chain.robot.joints) moving += j.moves() ? 1 : 0;
  for (const Link& l : chain.robot.links) masses += l.mass > 0 ? 1 : 0;
  if (chain.robot.is_of_poses)
    check.contents.emplace_back(
        "Poses of the flange as the robot's controller tells them: no joints, so that effects of joints are not "
        "offered.");
  else
    check.contents.push_back(
        message("Robot {}: {} links ({} with mass), {} moving joints, {} of them measured; TCP is {}.",
                chain.robot.name, chain.robot.links.size(), masses, moving, chain.joints.size(), session.tcp));
  if (session.is_touch()) {
    list_fixtures(session, check);
  } else {
    check.contents.push_back(message("{} on {}, mount {}.", device_of(session), session.mount.link,
                                     !session.mount.estimate ? "known"
                                     : session.mount.known   ? "guessed, part of the fit"
                                                             : "unknown, part of the fit"));
    check.contents.push_back(arrangement_sentence(session, chain));
  }
  int labelled = 0, with_images = 0, unused = 0;
  for (const Observation& o : session.observations) {
    labelled += o.sightings.empty() ? 0 : 1;
    with_images += has_images(o) && missing_images(session, o) == 0 ? 1 : 0;
    unused += o.decision == Decision::rejected || o.decision == Decision::excluded ? 1 : 0;
  }
  check.contents.push_back(message("{} observations: {} {}, {} with images, {} rejected or excluded; {}.",
                                   session.observations.size(), labelled,
                                   session.pose_sensor ? "measured"
                                   : session.target    ? "show the target"
                                                       : "labelled",
                                   with_images, unused, target_of(session)));
  if (session.target)
    check.contents.push_back(message("Target: {}; {}.", describe_target(*session.target), print_of(*session.target)));
  if (session.is_touch()) return;
  const auto& declared = session.rig ? session.sigma_pixel : session.sigma_point;
  check.contents.push_back(
      declared              ? message("Declared noise of one coordinate: {:g} {}.", *declared, session.rig ? "px" : "m")
      : session.pose_sensor ? Message("The noise is not declared; the fit can only say how far the poses are apart.")
      : session.target      ? Message("The noise is not declared; it is estimated from the target's points.")
                            : Message("The noise is not declared; it is estimated where three markers are seen."));
}

void check_images(const Session& session, SessionCheck& check) {
  if (!session.rig) return;
  auto look = [&](const std::string& file, const Camera& camera, std::int64_t id) {
    if (file.empty()) return;
    try {
      read_image(folder(session) / file, camera, file);
    } catch (const InputError& error) {
      check.problems.push_back(message("Observation {}: {}", id, error.sentence()));
    }
  };
  for (const Observation& o : session.observations) {
    for (int c = 0; c < session.rig->count(); ++c)
      look(o.images[static_cast<std::size_t>(c)], session.rig->at(c).camera, o.id);
    if (is_pair(*session.rig) && !session.target && has_images(o) && missing_images(session, o) > 0)
      check.warnings.push_back(
          message("Observation {} has an image of one camera only; it is not looked for markers.", o.id));
  }
}

void check_limits(const Session& session, const Chain& chain, SessionCheck& check) {
  for (std::size_t j = 0; j < chain.joints.size(); ++j) {
    const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[j])];
    int outside = 0;
    std::int64_t first = 0;
    for (const Observation& o : session.observations) {
      const double q = o.position[static_cast<Eigen::Index>(j)];
      if (q >= joint.lower - 1e-6 && q <= joint.upper + 1e-6) continue;
      if (outside++ == 0) first = o.id;
    }
    if (outside > 0)
      check.warnings.push_back(
          message("Joint {} is outside its limits in {} observations, first in {}.", joint.name, outside, first));
  }
}

/// Pixels of markers outside the image, and pairs that cannot be one point.
void check_markers(const Session& session, SessionCheck& check) {
  if (!session.rig) return;
  auto inside = [](const Camera& c, const Vector2& p) {
    return p.x() >= -0.5 && p.y() >= -0.5 && p.x() <= c.width - 0.5 && p.y() <= c.height - 0.5;
  };
  for (const Observation& o : session.observations)
    for (const Sighting& s : o.sightings) {
      const auto is_outside = [&](const CameraPoint& p) { return !inside(session.rig->at(p.camera).camera, p.pixel); };
      if (std::any_of(s.in_cameras.begin(), s.in_cameras.end(), is_outside))
        check.warnings.push_back(message("Observation {}: marker {} lies outside the image.", o.id, s.marker));
      if (s.in_cameras.size() > 1 && !triangulate_unweighed(*session.rig, s))
        check.warnings.push_back(
            message("Observation {}: marker {} cannot be triangulated; its {} image points are not one point in "
                    "front of the cameras.",
                    o.id, s.marker, s.in_cameras.size() == 2 ? "two" : "several"));
    }
}

void check_torques(const Session& session, const Chain& chain, SessionCheck& check) {
  const auto count = static_cast<Eigen::Index>(chain.joints.size());
  Eigen::VectorXd measured = Eigen::VectorXd::Zero(count), held = measured, pulled = measured;  // sums of squares
  int with_torque = 0;
  for (const Observation& o : session.observations) {
    const Posture posture =
        solve_posture(chain.robot, joint_values(chain.robot, chain.joints, o.position), chain.gravity);
    if (!posture.converged)
      check.problems.push_back(
          message("Observation {}: the declared springs are too soft for the load; no equilibrium is found.", o.id));
    if (o.torque.size() == 0) continue;
    ++with_torque;
    for (Eigen::Index j = 0; j < count; ++j) {
      // A motor holds against gravity: what it measures is minus the moment of gravity, or, where the driver counts the
      // other way, that moment; a joint has one sign in all observations.
      const double gravity = posture.torque[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
      measured[j] += o.torque[j] * o.torque[j];
      held[j] += std::pow(o.torque[j] + gravity, 2);
      pulled[j] += std::pow(o.torque[j] - gravity, 2);
    }
  }
  if (with_torque == 0) return;
  check.contents.push_back(message("{} observations have measured torques.", with_torque));
  for (Eigen::Index j = 0; j < count; ++j) {
    const double size = std::sqrt(measured[j] / with_torque),
                 off = std::sqrt(std::min(held[j], pulled[j]) / with_torque);
    if (off > 2 && off > 0.2 * size)
      check.warnings.push_back(message(
          "Joint {}: measured torques ({:.1f} N m rms) differ from gravity's moments by {:.1f} N m rms; check masses, "
          "gravity and units.",
          chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])].name, size, off));
  }
}

}  // namespace

SessionCheck check_session(const Session& session) {
  SessionCheck check;
  const Chain chain = make_chain(session);
  list_contents(session, chain, check);
  check.warnings = session_warnings(session);
  if (session.mount.estimate && session.observations.size() > 1 && never_moved(session))
    check.problems.emplace_back(
        "The robot stands in one and the same pose in all observations, and where the sensor sits is asked for: "
        "neither "
        "it nor TCP->Body can be told from one pose. Record poses that shift the hand and turn it about two axes.");
  check_images(session, check);
  check_touches(session, check);
  check_limits(session, chain, check);
  check_markers(session, check);
  check_torques(session, chain, check);
  return check;
}

}  // namespace handsight
