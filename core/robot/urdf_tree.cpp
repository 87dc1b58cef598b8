// SPDX-License-Identifier: Apache-2.0
// Puts the parts of a URDF together to a tree.
#include <algorithm>
#include <unordered_map>

#include "base/error.h"
#include "base/text.h"
#include "robot/urdf_parts.h"

namespace handsight::urdf {

namespace {

using Names = std::unordered_map<std::string, int>;

/// Index by name; refuses a name that stands twice.
template <class Parts, class NameOf>
Names index_names(const Parts& parts, const NameOf& display_name) {
  Names names;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string& name = display_name(parts[i]);
    const auto [first, is_new] = names.emplace(name, static_cast<int>(i));
    if (!is_new)
      refuse(parts[i].node, message("has the name {}, which line {} has already given, expected another name.",
                                    in_quotes(name), parts[static_cast<std::size_t>(first->second)].node.line()));
  }
  return names;
}

int look_up_link(const JointPart& part, const std::string& name, const Names& links, std::string_view role) {
  const auto found = links.find(name);
  if (found == links.end())
    refuse(part.node, message("{} has the {} link {}, expected the name of a link in the file.",
                              in_quotes(part.joint.name), role, in_quotes(name)));
  return found->second;
}

void connect(std::vector<LinkPart>& links, std::vector<JointPart>& joints) {
  const Names names = index_names(links, [](const LinkPart& part) -> const std::string& { return part.link.name; });
  for (std::size_t j = 0; j < joints.size(); ++j) {
    JointPart& part = joints[j];
    part.joint.parent_link = look_up_link(part, part.parent, names, "parent");
    part.joint.child_link = look_up_link(part, part.child, names, "child");
    int& carrier = links[static_cast<std::size_t>(part.joint.child_link)].link.parent_joint;
    if (carrier >= 0)
      refuse(part.node,
             message("{} carries link {}, which joint {} carries already, expected one parent for each link.",
                     in_quotes(part.joint.name), in_quotes(part.child),
                     in_quotes(joints[static_cast<std::size_t>(carrier)].joint.name)));
    carrier = static_cast<int>(j);
  }
}

void resolve_mimics(std::vector<JointPart>& joints) {
  const Names names = index_names(joints, [](const JointPart& part) -> const std::string& { return part.joint.name; });
  for (JointPart& part : joints)
    for (MimicPart& mimic : part.mimics) {
      const auto found = names.find(mimic.joint);
      if (found == names.end())
        refuse(mimic.node, message("of joint {} follows joint {}, expected the name of a joint in the file.",
                                   in_quotes(part.joint.name), in_quotes(mimic.joint)));
      if (!joints[static_cast<std::size_t>(found->second)].joint.moves())
        refuse(mimic.node, message("of joint {} follows joint {}, which is fixed, expected a joint that moves.",
                                   in_quotes(part.joint.name), in_quotes(mimic.joint)));
      mimic.mimic.joint = found->second;
    }
}

/// Joints whose mimics are all settled are settled, again and again; what is left follows itself.
void refuse_mimic_loops(const std::vector<JointPart>& joints) {
  std::vector<std::vector<std::size_t>> followers(joints.size());
  std::vector<std::size_t> open(joints.size());
  std::vector<std::size_t> settled;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    open[j] = joints[j].mimics.size();
    for (const MimicPart& mimic : joints[j].mimics) followers[static_cast<std::size_t>(mimic.mimic.joint)].push_back(j);
    if (open[j] == 0) settled.push_back(j);
  }
  for (std::size_t next = 0; next < settled.size(); ++next)
    for (const std::size_t follower : followers[settled[next]])
      if (--open[follower] == 0) settled.push_back(follower);
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (open[j] > 0)
      refuse(joints[j].node, message("{} follows itself through its <mimic>, expected mimics that end at a joint "
                                     "that moves by itself.",
                                     in_quotes(joints[j].joint.name)));
}

std::size_t find_root(const XmlNode& robot, const std::vector<LinkPart>& links) {
  if (links.empty()) refuse(robot, "has no <link>, expected at least one.");
  std::vector<std::size_t> roots;
  for (std::size_t l = 0; l < links.size(); ++l)
    if (links[l].link.parent_joint < 0) roots.push_back(l);
  if (roots.empty())
    refuse(robot, "has a joint above each of its links, a cycle, expected one root link without a parent.");
  if (roots.size() > 1)
    refuse(links[roots[1]].node,
           message("{} has no parent joint, nor has {}: {} root links, expected one.",
                   in_quotes(links[roots[1]].link.name), in_quotes(links[roots[0]].link.name), roots.size()));
  return roots[0];
}

/// Joints in depth-first order from the root, siblings as in the file.
std::vector<std::size_t> tree_order(std::size_t root, const std::vector<LinkPart>& links,
                                    const std::vector<JointPart>& joints) {
  std::vector<std::vector<std::size_t>> below(links.size());
  for (std::size_t j = joints.size(); j-- > 0;)
    below[static_cast<std::size_t>(joints[j].joint.parent_link)].push_back(j);
  std::vector<std::size_t> order;
  std::vector<std::size_t> open = below[root];
  while (!open.empty()) {
    const std::size_t joint = open.back();
    open.pop_back();
    order.push_back(joint);
    const auto& next = below[static_cast<std::size_t>(joints[joint].joint.child_link)];
    open.insert(open.end(), next.begin(), next.end());
  }
  return order;
}

void refuse_cycles(const std::vector<JointPart>& joints, const std::vector<std::size_t>& order) {
  std::vector<char> reached(joints.size(), 0);
  for (const std::size_t joint : order) reached[joint] = 1;
  const auto missed = std::find(reached.begin(), reached.end(), 0);
  if (missed == reached.end()) return;
  const JointPart& part = joints[static_cast<std::size_t>(missed - reached.begin())];
  refuse(part.node, message("{} is part of a cycle or hangs on one, expected a tree that starts at the root link.",
                            in_quotes(part.joint.name)));
}

}  // namespace

Robot assemble(std::string name, const XmlNode& root, std::vector<LinkPart> links, std::vector<JointPart> joints) {
  connect(links, joints);
  resolve_mimics(joints);
  refuse_mimic_loops(joints);
  const std::size_t root_link = find_root(root, links);
  const std::vector<std::size_t> order = tree_order(root_link, links, joints);
  refuse_cycles(joints, order);

  std::vector<int> new_joint(joints.size()), new_link(links.size());
  new_link[root_link] = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    new_joint[order[i]] = static_cast<int>(i);
    new_link[static_cast<std::size_t>(joints[order[i]].joint.child_link)] = static_cast<int>(i) + 1;
  }
  Robot robot{std::move(name), {std::move(links[root_link].link)}, {}};
  for (const std::size_t j : order) {
    Joint& joint = joints[j].joint;
    Link& link = links[static_cast<std::size_t>(joint.child_link)].link;
    link.parent_joint = new_joint[j];
    joint.parent_link = new_link[static_cast<std::size_t>(joint.parent_link)];
    joint.child_link = new_link[static_cast<std::size_t>(joint.child_link)];
    for (const MimicPart& part : joints[j].mimics) {
      joint.mimics.push_back(part.mimic);
      joint.mimics.back().joint = new_joint[static_cast<std::size_t>(part.mimic.joint)];
    }
    robot.joints.push_back(std::move(joint));
    robot.links.push_back(std::move(link));
  }
  return robot;
}

}  // namespace handsight::urdf
