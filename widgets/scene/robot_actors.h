// SPDX-License-Identifier: GPL-3.0-or-later
// A robot's links as actors, by their visuals or as plausible limbs.
#pragma once

#include <vtkRenderer.h>

#include <QString>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "robot/mesh.h"
#include "robot/robot.h"
#include "widgets/scene/vtk_tools.h"

namespace handsight::widgets {

struct LinkActor {
  int link = 0;
  Rigid link_from_shape;
  QColor color;
  vtkSmartPointer<vtkActor> actor;
};

struct RobotActors {
  std::vector<LinkActor> parts;
  std::vector<QString> notes;  // meshes that could not be shown, a sentence each
};

/// A mesh, or the sentence why it cannot be shown.
struct ReadMesh {
  Mesh mesh;
  QString refusal;
};
using ReadMeshes = std::map<std::string, ReadMesh>;  // by the name that shapes have for it

bool has_meshes(const Robot& robot);
/// Safe in any thread.
ReadMeshes read_meshes(const Robot& robot, const std::filesystem::path& mesh_folder);

/// Shapes of every link; a link without any gets limbs from its frame to those of the joints that it carries. Meshes
/// that are not among those that were read are left out.
RobotActors make_robot_actors(const Robot& robot, const ReadMeshes& meshes);

/// The same surfaces again as they lie on the floor when light falls from above: in one colour, without light.
RobotActors make_shadow_actors(const RobotActors& robot, const QColor& color);
/// One motion per link; the floor is the plane z = height.
void place_shadow(const RobotActors& shadow, const std::vector<Rigid>& root_from_link, double height);

void add_to(vtkRenderer& renderer, const RobotActors& actors);
void remove_from(vtkRenderer& renderer, const RobotActors& actors);
void set_visible(const RobotActors& actors, bool visible);

/// One motion per link of the robot.
void place_links(const RobotActors& actors, const std::vector<Rigid>& root_from_link);

/// posture + times * (bent - posture), link by link.
std::vector<Rigid> magnified(const std::vector<Rigid>& posture, const std::vector<Rigid>& bent, double times);

}  // namespace handsight::widgets
