// SPDX-License-Identifier: Apache-2.0
#include "experiment/paths/collision_world.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "base/error.h"
#include "robot/posture.h"
#ifdef HANDSIGHT_HAS_PATHS
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#endif

namespace handsight {

std::optional<Message> what_paths_need() {
#ifdef HANDSIGHT_HAS_PATHS
  return std::nullopt;
#else
  return "This program was built without FCL and OMPL, with which it finds paths without collisions: install "
         "libfcl-dev and libompl-dev, configure the build again and build it.";
#endif
}

#ifdef HANDSIGHT_HAS_PATHS

namespace {

constexpr double often = 0.95, sometimes = 0.1;
constexpr int drawn_postures = 200;
constexpr double sight_radius = 0.005;  // m: a line of sight is this thick
constexpr double sight_left = 0.06;     // m: what lies so near to an end belongs to it

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;
using Place = fcl::Transform3d;

Geometry geometry_of(const RobotSolid& s, double wider) {
  const Vector3& h = s.size;
  switch (s.kind) {
    case RobotSolidKind::box:
      return std::make_shared<fcl::Boxd>(2 * (h.x() + wider), 2 * (h.y() + wider), 2 * (h.z() + wider));
    case RobotSolidKind::capsule:
      return std::make_shared<fcl::Capsuled>(h.x() + wider, 2 * h.z());
    case RobotSolidKind::cylinder:
      return std::make_shared<fcl::Cylinderd>(h.x() + wider, 2 * (h.z() + wider));
    default:
      return std::make_shared<fcl::Sphered>(h.x() + wider);
  }
}

Place locate(const Rigid& rigid) {
  Place place = Place::Identity();
  place.linear() = rigid.rotation;
  place.translation() = rigid.translation;
  return place;
}

bool meet(const fcl::CollisionGeometryd& a, const Place& at_a, const fcl::CollisionGeometryd& b, const Place& at_b) {
  const fcl::CollisionRequestd request(1, false);
  fcl::CollisionResultd result;
  return fcl::collide(&a, at_a, &b, at_b, request, result) > 0;
}

/// A solid with FCL's shapes of it: as it is, and wider by half the clearance.
struct Thing {
  RobotSolid solid;  // of the cell: link -1, link_from_solid is root_from_solid
  int body = -1;     // links that are fixed to each other; -1: of the cell
  double reach = 0;  // m; infinite for planes
  Geometry tight, wide;
  std::string name;
};

enum class Watch { not_at_all, tightly, with_clearance };

struct Pair {
  std::size_t a = 0, b = 0;  // bodies, or a body and `bodies + place in the cell`
  Watch watch = Watch::with_clearance;
};

}  // namespace

struct CollisionWorld::Parts {
  Chain chain;
  std::vector<Thing> things;                     // of the robot, then of the cell
  std::vector<std::vector<std::size_t>> groups;  // things of each body, then each thing of the cell alone
  std::vector<int> body_of_link;
  std::vector<Pair> pairs;
  std::vector<double> reach_of_joint;  // m (1 for sliding ones), by Chain::joints: how far its farthest point is
  double clearance = usual_clearance;
  std::vector<Message> notes;

  std::vector<Rigid> root_from_links(const Eigen::VectorXd& position, Eigen::VectorXd* values = nullptr) const {
    Posture posture =
        solve_posture<double>(chain.robot, joint_values(chain.robot, chain.joints, position), {}, chain.gravity, false);
    if (values)
      *values =
          Eigen::Map<const Eigen::VectorXd>(posture.value.data(), static_cast<Eigen::Index>(posture.value.size()));
    return std::move(posture.root_from_link);
  }

  std::vector<Place> places(const std::vector<Rigid>& links) const {
    std::vector<Place> places;
    for (const Thing& t : things)
      places.push_back(locate(t.body < 0 ? t.solid.link_from_solid
                                         : links[static_cast<std::size_t>(t.solid.link)] * t.solid.link_from_solid));
    return places;
  }

  bool are_near(std::size_t a, std::size_t b, const std::vector<Place>& at, double margin) const {
    const double most = things[a].reach + things[b].reach + margin;
    return !std::isfinite(most) || (at[a].translation() - at[b].translation()).squaredNorm() < most * most;
  }

  bool do_meet(const Pair& pair, const std::vector<Place>& at, bool wide) const {
    for (const std::size_t a : groups[pair.a])
      for (const std::size_t b : groups[pair.b])
        if (are_near(a, b, at, wide ? clearance : 0) &&
            meet(wide ? *things[a].wide : *things[a].tight, at[a], wide ? *things[b].wide : *things[b].tight, at[b]))
          return true;
    return false;
  }

  Message display_name(const Pair& pair) const {
    return message("{} and {}", things[groups[pair.a].front()].name, things[groups[pair.b].front()].name);
  }

  void join_links();
  void add_cell(const Cell& cell);
  void add_pairs(const RobotSolids& solids);
  void set_watches(const std::vector<Eigen::VectorXd>& taken);
  void set_reaches();
  std::vector<Eigen::VectorXd> drawn() const;
};

void CollisionWorld::Parts::join_links() {
  body_of_link.assign(chain.robot.links.size(), -1);
  int bodies = 0;
  body_of_link[0] = bodies++;
  for (const Joint& joint : chain.robot.joints)  // parents come before their children
    body_of_link[static_cast<std::size_t>(joint.child_link)] =
        joint.moves() ? bodies++ : body_of_link[static_cast<std::size_t>(joint.parent_link)];
  groups.assign(static_cast<std::size_t>(bodies), {});
}

void CollisionWorld::Parts::add_cell(const Cell& cell) {
  const auto add = [&](Thing thing) {
    groups.push_back({things.size()});
    things.push_back(std::move(thing));
  };
  int number = 0;
  for (const CellBox& box : cell.boxes) {
    const RobotSolid solid{RobotSolidKind::box, -1, box.root_from_box, 0.5 * box.size};
    add({solid, -1, solid.reach(), geometry_of(solid, 0), geometry_of(solid, 0.5 * clearance),
         message("box {} of the cell", ++number)});
  }
  std::vector<CellPlane> planes = cell.planes;
  const bool has_floor = planes.empty() && chain.gravity.norm() > 0;
  if (has_floor) planes.push_back({-chain.gravity.normalized(), 0});
  number = 0;
  for (const CellPlane& plane : planes)
    add({RobotSolid{.link = -1}, -1, INFINITY, std::make_shared<fcl::Halfspaced>(plane.normal, plane.offset),
         std::make_shared<fcl::Halfspaced>(plane.normal, plane.offset + 0.5 * clearance),
         has_floor ? "the floor" : message("plane {} of the cell", ++number)});
}

void CollisionWorld::Parts::add_pairs(const RobotSolids& solids) {
  const std::size_t bodies = static_cast<std::size_t>(*std::max_element(body_of_link.begin(), body_of_link.end())) + 1;
  std::set<std::pair<std::size_t, std::size_t>> out;
  const auto leave_out = [&](int link_a, int link_b) {
    const auto a = static_cast<std::size_t>(body_of_link[static_cast<std::size_t>(link_a)]);
    const auto b = static_cast<std::size_t>(body_of_link[static_cast<std::size_t>(link_b)]);
    out.insert({std::min(a, b), std::max(a, b)});
  };
  for (const Joint& joint : chain.robot.joints) leave_out(joint.parent_link, joint.child_link);
  for (const auto& [first, second] : solids.never_watched) {
    const int a = find_link(chain.robot, first), b = find_link(chain.robot, second);
    if (a >= 0 && b >= 0) leave_out(a, b);
  }
  for (std::size_t a = 0; a < bodies; ++a)
    for (std::size_t b = a + 1; b < groups.size(); ++b) {
      if (groups[a].empty() || groups[b].empty()) continue;
      if (b < bodies ? out.contains({a, b}) : a == 0) continue;  // what stands about does not move against the root
      pairs.push_back({a, b, Watch::with_clearance});
    }
}

std::vector<Eigen::VectorXd> CollisionWorld::Parts::drawn() const {
  std::mt19937_64 random(1);
  std::vector<Eigen::VectorXd> postures;
  for (int i = 0; i < drawn_postures; ++i) {
    Eigen::VectorXd& q = postures.emplace_back(static_cast<Eigen::Index>(chain.joints.size()));
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
      const double low = std::max(joint.lower, -M_PI), high = std::min(joint.upper, M_PI);
      q[j] = low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
    }
  }
  return postures;
}

void CollisionWorld::Parts::set_watches(const std::vector<Eigen::VectorXd>& taken) {
  std::vector<int> wide(pairs.size()), tight(pairs.size());
  for (const Eigen::VectorXd& q : drawn()) {
    const std::vector<Place> at = places(root_from_links(q));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!do_meet(pairs[i], at, true)) continue;
      ++wide[i];
      tight[i] += do_meet(pairs[i], at, false) ? 1 : 0;
    }
  }
  std::vector<char> near(pairs.size()), touched(pairs.size());
  for (const Eigen::VectorXd& q : taken) {
    const std::vector<Place> at = places(root_from_links(q));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (touched[i] || !do_meet(pairs[i], at, true)) continue;
      near[i] = 1;
      touched[i] = do_meet(pairs[i], at, false) ? 1 : 0;
    }
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    // Always near and often touching: neighbours beyond a short link.
    const bool is_near = wide[i] >= often * drawn_postures;
    if (tight[i] >= (is_near ? sometimes : often) * drawn_postures || touched[i]) {
      pairs[i].watch = Watch::not_at_all;
      if (touched[i] && !is_near)
        notes.push_back(message("{} touch by their shapes where the robot has been: they are not watched.",
                                display_name(pairs[i])));
    } else if (is_near || near[i]) {
      pairs[i].watch = Watch::tightly;
    }
  }
  std::erase_if(pairs, [](const Pair& p) { return p.watch == Watch::not_at_all; });
}

/// The farthest that anything of a body beyond the joint can be from its axis: the way along the links, and their size.
void CollisionWorld::Parts::set_reaches() {
  std::vector<double> beyond(chain.robot.links.size());  // m, by link: of what hangs on it, from its frame
  for (const Thing& t : things)
    if (t.body >= 0)
      beyond[static_cast<std::size_t>(t.solid.link)] = std::max(beyond[static_cast<std::size_t>(t.solid.link)],
                                                                t.solid.link_from_solid.translation.norm() + t.reach);
  std::vector<double> of_joint(chain.robot.joints.size());
  for (std::size_t j = chain.robot.joints.size(); j-- > 0;) {
    const Joint& joint = chain.robot.joints[j];
    double slide = 0;
    if (joint.kind == JointKind::prismatic)
      slide = joint.upper < 1e29 ? std::max(std::abs(joint.lower), std::abs(joint.upper)) : 1;
    const double here = beyond[static_cast<std::size_t>(joint.child_link)] + joint.joint_from_child.translation.norm();
    of_joint[j] = joint.kind == JointKind::prismatic ? 1 : here;
    double& parent = beyond[static_cast<std::size_t>(joint.parent_link)];
    parent = std::max(parent, joint.parent_from_joint.translation.norm() + slide + here);
  }
  for (const int j : chain.joints) {
    double reach = of_joint[static_cast<std::size_t>(j)];
    for (std::size_t k = 0; k < chain.robot.joints.size(); ++k)  // and what follows it
      for (const Mimic& m : chain.robot.joints[k].mimics)
        if (m.joint == j) reach += std::abs(m.multiplier) * of_joint[k];
    reach_of_joint.push_back(reach);
  }
}

CollisionWorld::CollisionWorld(const Chain& chain, const RobotSolids& solids, const Cell& cell,
                               const std::vector<Eigen::VectorXd>& taken, double clearance)
    : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  p.chain = chain;
  for (Joint& joint : p.chain.robot.joints) joint.stiffness = 0;
  p.clearance = clearance;
  p.notes = solids.notes;
  p.join_links();
  for (const RobotSolid& s : solids.solids) {
    const int body = p.body_of_link[static_cast<std::size_t>(s.link)];
    p.groups[static_cast<std::size_t>(body)].push_back(p.things.size());
    p.things.push_back({s, body, s.reach(), geometry_of(s, 0), geometry_of(s, 0.5 * clearance),
                        chain.robot.links[static_cast<std::size_t>(s.link)].name});
  }
  p.add_cell(cell);
  p.add_pairs(solids);
  p.set_watches(taken);
  p.set_reaches();
}

CollisionWorld::~CollisionWorld() = default;
CollisionWorld::CollisionWorld(CollisionWorld&&) noexcept = default;
CollisionWorld& CollisionWorld::operator=(CollisionWorld&&) noexcept = default;

std::optional<Message> CollisionWorld::touching(const Eigen::VectorXd& position, bool with_clearance) const {
  const Parts& p = *parts_;
  Eigen::VectorXd values;
  const std::vector<Rigid> links = p.root_from_links(position, &values);
  for (std::size_t j = 0; j < p.chain.robot.joints.size(); ++j) {
    const Joint& joint = p.chain.robot.joints[j];
    const double value = values[static_cast<Eigen::Index>(j)];
    if (joint.is_mimic() && (value < joint.lower || value > joint.upper))
      return message("{} beyond its limit", joint.name);
  }
  const std::vector<Place> at = p.places(links);
  for (const Pair& pair : p.pairs)
    if (p.do_meet(pair, at, with_clearance && pair.watch == Watch::with_clearance)) return p.display_name(pair);
  return std::nullopt;
}

bool CollisionWorld::is_hidden(const Eigen::VectorXd& position, const Vector3& in_mount, const Vector3& in_tcp) const {
  const Parts& p = *parts_;
  const std::vector<Rigid> links = p.root_from_links(position);
  const Vector3 from = links[static_cast<std::size_t>(p.chain.mount_link)] * in_mount;
  const Vector3 to = links[static_cast<std::size_t>(p.chain.tcp_link)] * in_tcp, way = to - from;
  const double length = way.norm() - 2 * sight_left;
  if (!(length > 0)) return false;
  RobotSolid sight = {
      RobotSolidKind::capsule, 0, {Matrix3::Identity(), 0.5 * (from + to)}, {sight_radius, 0, 0.5 * length}};
  sight.link_from_solid.rotation.col(2) = way.normalized();
  sight.link_from_solid.rotation.col(0) = way.normalized().unitOrthogonal();
  sight.link_from_solid.rotation.col(1) =
      sight.link_from_solid.rotation.col(2).cross(sight.link_from_solid.rotation.col(0));
  const Geometry line = geometry_of(sight, 0);
  const Place at_line = locate(sight.link_from_solid);
  const std::vector<Place> at = p.places(links);
  const int mount_body = p.body_of_link[static_cast<std::size_t>(p.chain.mount_link)];
  const int tcp_body = p.body_of_link[static_cast<std::size_t>(p.chain.tcp_link)];
  for (std::size_t t = 0; t < p.things.size(); ++t) {
    const Thing& thing = p.things[t];
    if (!std::isfinite(thing.reach)) continue;  // a floor
    if (thing.body >= 0 && (thing.body == mount_body || thing.body == tcp_body)) continue;
    if ((at[t].translation() - at_line.translation()).norm() > thing.reach + sight.reach()) continue;
    if (meet(*thing.tight, at[t], *line, at_line)) return true;
  }
  return false;
}

double CollisionWorld::farthest_way(const Eigen::VectorXd& step) const {
  double way = 0;
  for (Eigen::Index j = 0; j < step.size(); ++j)
    way += std::abs(step[j]) * parts_->reach_of_joint[static_cast<std::size_t>(j)];
  return way;
}

void CollisionWorld::carry(const RobotSolid& solid) {
  Parts& p = *parts_;
  const int body = p.body_of_link[static_cast<std::size_t>(solid.link)];
  auto& group = p.groups[static_cast<std::size_t>(body)];
  const bool is_new = group.empty();
  group.push_back(p.things.size());
  p.things.push_back({solid, body, solid.reach(), geometry_of(solid, 0), geometry_of(solid, 0.5 * p.clearance),
                      p.chain.robot.links[static_cast<std::size_t>(solid.link)].name});
  if (is_new) group.pop_back(), p.things.pop_back();  // a body without shapes has no pairs
}

const std::vector<Message>& CollisionWorld::notes() const { return parts_->notes; }
std::size_t CollisionWorld::watched_pairs() const { return parts_->pairs.size(); }

#else

struct CollisionWorld::Parts {
  std::vector<Message> notes;
};

CollisionWorld::CollisionWorld(const Chain&, const RobotSolids&, const Cell&, const std::vector<Eigen::VectorXd>&,
                               double) {
  throw InputError(*what_paths_need());
}
CollisionWorld::~CollisionWorld() = default;
CollisionWorld::CollisionWorld(CollisionWorld&&) noexcept = default;
CollisionWorld& CollisionWorld::operator=(CollisionWorld&&) noexcept = default;
// Never reached: there is no world.
std::optional<Message> CollisionWorld::touching(const Eigen::VectorXd&, bool) const { return what_paths_need(); }
bool CollisionWorld::is_hidden(const Eigen::VectorXd&, const Vector3&, const Vector3&) const { return true; }
double CollisionWorld::farthest_way(const Eigen::VectorXd&) const { return 0; }
void CollisionWorld::carry(const RobotSolid&) {}
const std::vector<Message>& CollisionWorld::notes() const { return parts_->notes; }
std::size_t CollisionWorld::watched_pairs() const { return 0; }

#endif

}  // namespace handsight
