// SPDX-License-Identifier: Apache-2.0
#include "certify/iso_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace handsight {
namespace {

constexpr std::size_t most_poses = 12;

/// The attained poses of one configuration, in order of time.
using Group = std::vector<const AttainedPose*>;

std::vector<Group> groups_of(const AttainedPoses& attained) {
  std::map<int, Group> by_pose;
  for (const AttainedPose& p : attained.all) by_pose[p.same_pose].push_back(&p);
  std::vector<Group> groups;
  for (auto& [pose, group] : by_pose)
    if (group.size() >= 2) groups.push_back(std::move(group));
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.size() > b.size(); });
  return groups;
}

/// Joints of one configuration stand a little differently each time: the error of each cycle is that from its own
/// commanded pose, told at the first one's.
std::vector<Rigid> attained_of(const Group& group, Rigid AttainedPose::*which) {
  std::vector<Rigid> all;
  const Rigid& commanded = group.front()->commanded;
  for (const AttainedPose* p : group) {
    const Rigid& attained = p->*which;
    all.push_back({attained.rotation * p->commanded.rotation.transpose() * commanded.rotation,
                   commanded.translation + attained.translation - p->commanded.translation});
  }
  return all;
}

IsoPose find_instant_pose(const Group& group) {
  const Rigid& commanded = group.front()->commanded;
  return {group.front()->id, pose_figures(commanded, attained_of(group, &AttainedPose::before)),
          pose_figures(commanded, attained_of(group, &AttainedPose::after)), group.front()->shows_turn};
}

IsoDistance distance_of(const Group& a, const Group& b) {
  const Rigid &from = a.front()->commanded, &to = b.front()->commanded;
  const auto figures = [&](Rigid AttainedPose::*which) {
    return distance_figures(from, attained_of(a, which), to, attained_of(b, which));
  };
  return {a.front()->id, b.front()->id, figures(&AttainedPose::before), figures(&AttainedPose::after)};
}

/// Along which axis of the base the hand came from the observation before: 0 to 2; -1: along none of them.
int direction_of(const AttainedPose& p, const std::map<int, Vector3>& hand_of_index) {
  const auto here = hand_of_index.find(p.index);
  if (here == hand_of_index.begin()) return -1;
  const Vector3 way = here->second - std::prev(here)->second;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(way[axis]) > 0.95 * way.norm() && way.norm() > 1e-3) return axis;
  return -1;
}

std::optional<IsoDirections> directions_of(const Group& group, const std::map<int, Vector3>& hand_of_index) {
  std::array<Group, iso_directions> by_direction;
  for (const AttainedPose* p : group)
    if (const int axis = direction_of(*p, hand_of_index); axis >= 0)
      by_direction[static_cast<std::size_t>(axis)].push_back(p);
  std::vector<std::vector<Rigid>> attained;
  std::size_t fewest = group.size();
  for (const Group& one : by_direction) {
    if (one.size() < 2) return std::nullopt;
    fewest = std::min(fewest, one.size());
    // The commanded pose is that of the whole group.
    std::vector<Rigid> all;
    for (const AttainedPose* p : one) all.push_back(attained_of({group.front(), p}, &AttainedPose::after).back());
    attained.push_back(std::move(all));
  }
  return IsoDirections{group.front()->id, static_cast<int>(fewest),
                       direction_figures(group.front()->commanded, attained)};
}

/// The corners of the diagonal plane of a cube and its middle (6.2.4), a tenth of the diagonals inside.
std::array<Vector3, iso_poses> cube_places(const std::vector<const AttainedPose*>& all) {
  Vector3 lowest = all.front()->commanded.translation, highest = lowest;
  for (const AttainedPose* p : all) {
    lowest = lowest.cwiseMin(p->commanded.translation);
    highest = highest.cwiseMax(p->commanded.translation);
  }
  const Vector3 middle = 0.5 * (lowest + highest);
  const double reach = 0.8 * 0.5 * (highest - lowest).minCoeff();
  return {middle, middle + reach * Vector3(-1, -1, 1), middle + reach * Vector3(-1, 1, 1),
          middle + reach * Vector3(1, 1, -1), middle + reach * Vector3(1, -1, -1)};
}

std::vector<PoseToRecord> plan_of(const Session& session, const AttainedPoses& attained,
                                  const std::map<int, int>& cycles_of_pose) {
  std::vector<PoseToRecord> plan;
  std::vector<const AttainedPose*> left;
  for (const AttainedPose& p : attained.all) left.push_back(&p);
  const auto places = cube_places(left);
  for (std::size_t i = 0; i < places.size() && !left.empty(); ++i) {
    const auto nearest = std::min_element(left.begin(), left.end(), [&](const AttainedPose* a, const AttainedPose* b) {
      return (a->commanded.translation - places[i]).norm() < (b->commanded.translation - places[i]).norm();
    });
    const AttainedPose& p = **nearest;
    plan.push_back({fmt::format("P{}", i + 1), session.observations[static_cast<std::size_t>(p.index)].position,
                    p.commanded.translation, std::max(0, iso_cycles - cycles_of_pose.at(p.same_pose))});
    const int taken = p.same_pose;
    std::erase_if(left, [&](const AttainedPose* other) { return other->same_pose == taken; });
  }
  return plan;
}

int with_all_cycles(const std::vector<Group>& groups) {
  return static_cast<int>(std::count_if(groups.begin(), groups.end(),
                                        [](const Group& g) { return static_cast<int>(g.size()) >= iso_cycles; }));
}

void say_what_lacks(const std::vector<Group>& groups, IsoTest& test) {
  const int whole = with_all_cycles(groups);
  if (!test.has_accuracy)
    test.lacking.push_back(fmt::format(
        "AP and RP by the standard need {} poses with {} cycles each; the session has {} such poses and {} that were "
        "attained at least twice.",
        iso_poses, iso_cycles, whole, groups.size()));
  if (!test.has_distance)
    test.lacking.push_back(
        fmt::format("AD by the standard needs two poses with {} cycles each; the session has {}.", iso_cycles, whole));
  if (!test.has_directions)
    test.lacking.push_back(fmt::format(
        "vAP by the standard needs a pose with {} cycles from each of three perpendicular directions; the session has "
        "{} poses that were approached along all three axes of the base.",
        iso_cycles, test.directions.size()));
}

}  // namespace

IsoTest iso_test(const Session& session, const AttainedPoses& attained) {
  IsoTest test;
  const std::vector<Group> groups = groups_of(attained);
  std::map<int, int> cycles_of_pose;
  std::map<int, Vector3> hand_of_index;
  for (const AttainedPose& p : attained.all) {
    ++cycles_of_pose[p.same_pose];
    hand_of_index[p.index] = p.commanded.translation;
  }
  for (std::size_t g = 0; g < std::min(groups.size(), most_poses); ++g) {
    test.poses.push_back(find_instant_pose(groups[g]));
    if (g > 0) test.distances.push_back(distance_of(groups[g - 1], groups[g]));
  }
  for (const Group& g : groups)
    if (const auto d = directions_of(g, hand_of_index)) test.directions.push_back(*d);
  test.has_accuracy = with_all_cycles(groups) >= iso_poses;
  test.has_distance = with_all_cycles(groups) >= 2;
  test.has_directions = std::any_of(test.directions.begin(), test.directions.end(),
                                    [](const IsoDirections& d) { return d.cycles >= iso_cycles; });
  say_what_lacks(groups, test);
  if (!test.lacking.empty() && !attained.all.empty()) test.plan = plan_of(session, attained, cycles_of_pose);
  return test;
}

}  // namespace handsight
