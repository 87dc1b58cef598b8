// SPDX-License-Identifier: Apache-2.0
// Sessions with known truth, from a robot and the cameras or the tracker of another session.
#pragma once

#include <string>
#include <vector>

#include "effects/effect.h"
#include "session/session.h"
#include "simulation/curve.h"
#include "simulation/random.h"

namespace handsight {

/// Something that goes wrong in one observation.
struct Disturbance {
  enum class Kind {
    joint,        // the joint's reading is off by `size` (rad, m)
    marker,       // marker `index` stands off by `size` (m) on the hand, a label that came loose
    right_image,  // the images of all cameras but the first were taken while joint `name` was `size` (rad, m) farther
                  // on
  };
  std::int64_t id = 0;
  Kind kind = Kind::joint;
  std::string name;
  int index = 0;
  double size = 0;
};

struct SimulationOptions {
  std::string title = "Simulated";
  int observations = 80;
  std::uint64_t seed = 1;
  std::optional<double> noise;  // px (m with a tracker) of one coordinate; absent: the session's, else 0.2 (2e-4)
  bool declare_noise = true;    // write sigma_pixel (sigma) into the session
  double joint_range = 0.8;     // share of every joint's limits that poses are drawn from
  double nearest = 0.30, farthest = 1.60;  // m from the camera, of the marker body
  double most_turned = 0.9;                // rad: between a marker's normal and the direction to the camera
  std::vector<EffectTerm> effects;         // the hidden truth
  std::vector<Curve> curves;               // and what no effect describes
  std::vector<Disturbance> disturbances;
  double wrong_corners = 0;  // share of the image points that are off by wrong_corner_size in u and in v, 0 to 1
  double unseen = 0;         // share of the markers that no camera saw, 0 to 1
  double body_size = 0.06;   // m: the longest side of the marker body, about
  bool follow = false;       // neighbouring observations are neighbours in posture, as a guided arm's are
  Vector3 shift_in_sensor = Vector3::Zero();  // m: every marker is measured off by this (thesis 5.2)
};

constexpr double wrong_corner_size = 8;  // px, one standard deviation

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

/// Parses "58:joint:arm_4=0.12", "75:marker:1=0.012" or "98:right_image:arm_2=0.05".
Disturbance parse_disturbance(const std::string& text, const Robot& robot);

/// Writes truth.xml: markers, tcp_from_body, mount, noise, effects, disturbances.
void write_truth(const SimulatedSession& simulated, const SimulationOptions& options,
                 const std::filesystem::path& file);

}  // namespace handsight
