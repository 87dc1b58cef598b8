// SPDX-License-Identifier: Apache-2.0
// The calibrated robot of rigid links as the writers of robot descriptions take it: what its URDF says, read once.
#pragma once

#include <filesystem>

#include "base/message.h"
#include "export/rigid/urdf_file.h"

namespace handsight {

/// What a link weighs: kg, and kg m^2 about the centre of mass in the link's axes.
struct LinkInertia {
  double mass = 0;
  Vector3 center = Vector3::Zero();  // m, in the link's frame
  Matrix3 inertia = Matrix3::Zero();

  /// Is it a body's: mass and moments above zero?
  bool is_proper() const;
};

/// Of one joint, where the URDF says them: N m (N) and rad/s (m/s).
struct JointStrength {
  std::optional<double> effort, velocity;
};

struct DescribedRobot {
  UrdfFile urdf;                               // the text, the names of hand, body and sensor, what it misses
  Robot robot;                                 // read from that text: no springs, no Denavit-Hartenberg joints
  std::vector<LinkInertia> inertias;           // by link
  std::vector<std::vector<Shape>> collisions;  // by link; its visual shapes are in `robot`
  std::vector<JointStrength> strengths;        // by joint
  std::filesystem::path mesh_folder;           // where its meshes are named from; empty: not known
  std::string comment;                         // for the head of a file, without "--"
};

/// InputError as urdf_file.
DescribedRobot described_robot(const CalibratedRobot& robot, Holds holds = Holds::origins);

/// A mesh as a file in `out_folder` names it: relative to it, with slashes. Nothing where the mesh is not there.
std::optional<std::string> mesh_reference(const DescribedRobot& robot, const std::string& written,
                                          const std::filesystem::path& out_folder);

/// "What this kind of file cannot hold ...": a sentence with the millimetres that are left. Empty where nothing is.
Message left_sentence(const RigidFit& fit);

}  // namespace handsight
