// SPDX-License-Identifier: Apache-2.0
// The parts of a URDF file as written, before they are put together to a tree. Internal to urdf*.cpp.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/message.h"
#include "base/xml.h"
#include "robot/robot.h"

namespace handsight::urdf {

using Colors = std::map<std::string, Eigen::Vector4d>;
using Notes = std::vector<Message>;

struct MimicPart {
  XmlNode node;
  std::string joint;
  Mimic mimic;  // its joint is not yet known
};

struct JointPart {
  XmlNode node;
  std::string parent, child;
  Joint joint;  // its links and mimics are not yet known
  std::vector<MimicPart> mimics;
};

struct LinkPart {
  XmlNode node;
  Link link;
};

void add_note(Notes& notes, const XmlNode& node, const Message& sentence);

/// Named materials of the whole robot.
Colors read_colors(const XmlNode& robot);

/// The box, cylinder, sphere or mesh of a <geometry>; nothing where it is of another kind.
std::optional<Shape> read_geometry(const XmlNode& geometry);

std::vector<Shape> read_shapes(const XmlNode& link, const Colors& colors, Notes& notes);
LinkPart read_link(const XmlNode& node, const Colors& colors, Notes& notes);
JointPart read_joint(const XmlNode& node, Notes& notes);

/// Puts links and joints in the order of the tree; refuses what is no tree.
Robot assemble(std::string name, const XmlNode& root, std::vector<LinkPart> links, std::vector<JointPart> joints);

}  // namespace handsight::urdf
