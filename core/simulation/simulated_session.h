// SPDX-License-Identifier: Apache-2.0
// Sessions with known truth, from a robot and the cameras or the tracker of another session.
#pragma once

#include <string>
#include <vector>

#include "effects/effect.h"
#include "session/session.h"
#include "simulation/random.h"
#include "simulation/simulation_options.h"

namespace handsight {

/// An image point that is a wrong corner.
struct WrongCorner {
  std::int64_t id = 0;  // of the observation
  int marker = 0;
  int camera = 0;                 // of the rig
  Vector2 off = Vector2::Zero();  // px
};

/// What was simulated.
struct SimulatedSession {
  Session session;  // every marker labelled in every camera that sees it, by="import"
  std::vector<Vector3> markers_in_tcp;
  Vector3 normal_in_tcp = Vector3::UnitZ();  // the marker plane's outward normal
  std::vector<Vector3> normals_in_tcp;       // of each marker of a body of tags that look different ways; else empty
  Rigid mount_from_sensor;                   // the true one, before any effect
  std::optional<Rig> true_rig;               // with the effects on rig and cameras
  std::vector<EffectTerm> effects;
  double noise = 0;
  std::vector<WrongCorner> wrong_corners;
  /// Per observation, for rendering: where things truly were. Cameras but the first may have taken theirs later.
  std::vector<Rigid> root_from_tcp, root_from_sensor, later_root_from_tcp, later_root_from_sensor;
  std::vector<std::vector<Vector3>> markers;  // m, TCP frame, in this observation
};

/// `like` gives robot, tcp, mount, cameras or tracker, joints and the number of markers; where its labelled
/// observations span a joint by more than 0.2 rad, poses are drawn from that span. Throws InputError where no visible
/// pose is found.
SimulatedSession simulate_session(const Session& like, const SimulationOptions& options);

/// The same in postures that are given, with their times and velocities; what one observation measures does not depend
/// on those after it, but for effects that follow the whole session's duration. Markers that no camera sees are left
/// out.
SimulatedSession simulate_at(const Session& like, const SimulationOptions& options,
                             const std::vector<Observation>& given);

/// Parses "58:joint:arm_4=0.12", "75:marker:1=0.012" or "98:right_image:arm_2=0.05".
Disturbance parse_disturbance(const std::string& text, const Robot& robot);

/// Writes truth.xml: markers, tcp_from_body, mount, noise, effects, disturbances.
void write_truth(const SimulatedSession& simulated, const SimulationOptions& options,
                 const std::filesystem::path& file);

}  // namespace handsight
