// SPDX-License-Identifier: Apache-2.0
#include "estimation/start/target_symmetry.h"

#include <algorithm>

#include "estimation/problem/target_pose.h"
#include "estimation/start/start.h"

namespace handsight {
namespace {

constexpr double reach = 0.1;  // m, along the normal

struct SeenBoard {
  std::size_t place;  // of the problem's observations
  Rigid sensor_from_target;
};

Vector3 find_middle(const KnownShape& shape) {
  Vector3 middle = Vector3::Zero();
  for (const Vector3& x : shape.markers) middle += x / static_cast<double>(shape.markers.size());
  return middle;
}

/// The observations with what is the same both ways round: the board's middle and a place above it.
Problem shown_either_way(const Problem& problem, const std::vector<SeenBoard>& boards) {
  Problem shown = problem;
  shown.rig.reset();
  shown.shape.reset();
  shown.marker_count = 2;
  shown.marker_is_seen = {1, 1};
  hold_effects(shown);
  shown.observations.clear();
  const Vector3 middle = find_middle(*problem.shape);
  for (const SeenBoard& board : boards) {
    ProblemObservation& o = shown.observations.emplace_back(problem.observations[board.place]);
    o.weights.clear();
    o.marker_shifts.clear();
    o.sightings = {{.marker = 0, .point = board.sensor_from_target * middle},
                   {.marker = 1, .point = board.sensor_from_target * Vector3(middle + reach * Vector3::UnitZ())}};
  }
  return shown;
}

}  // namespace

std::vector<char> half_turned(const Problem& problem, const Mount& mount) {
  std::vector<char> turned(problem.observations.size(), 0);
  if (!problem.shape || !problem.rig) return turned;
  std::vector<SeenBoard> boards;
  for (std::size_t k = 0; k < problem.observations.size(); ++k)
    if (const auto pose = target_pose(problem.rig_or_null(), problem.observations[k].sightings, problem.shape->markers))
      boards.push_back({k, pose->pose.sensor_from_body});
  if (boards.size() < 2) return turned;
  const auto start = start_values(shown_either_way(problem, boards), mount);
  if (!start) return turned;
  std::vector<Vector3> across;  // the board's x axis in the TCP frame
  for (const SeenBoard& board : boards) {
    const Rigid tcp_from_sensor = inverse(sensor_from_tcp_at(problem.observations[board.place], *start));
    across.push_back(tcp_from_sensor.rotation * board.sensor_from_target.rotation.col(0));
  }
  Vector3 mean = across.front();
  for (int pass = 0; pass < 3; ++pass) {
    Vector3 sum = Vector3::Zero();
    for (const Vector3& x : across) sum += x.dot(mean) < 0 ? Vector3(-x) : x;
    mean = sum;
  }
  const auto other = static_cast<std::size_t>(
      std::count_if(across.begin(), across.end(), [&](const Vector3& x) { return x.dot(mean) < 0; }));
  const double sign = 2 * other > across.size() ? -1 : 1;
  for (std::size_t i = 0; i < boards.size(); ++i) turned[boards[i].place] = sign * across[i].dot(mean) < 0;
  return turned;
}

void turn_by_half(std::vector<Sighting>& sightings, int count) {
  for (Sighting& s : sightings) s.marker = count - 1 - s.marker;
  std::reverse(sightings.begin(), sightings.end());
}

int undo_target_symmetry(Session& session) {
  if (!session.target || !looks_the_same_turned(*session.target)) return 0;
  const Problem problem = make_problem(session, make_chain(session));
  const std::vector<char> turned = half_turned(problem, session.mount);
  int count = 0;
  for (std::size_t k = 0; k < turned.size(); ++k) {
    if (!turned[k]) continue;
    turn_by_half(session.observations[static_cast<std::size_t>(problem.observations[k].index)].sightings,
                 session.marker_count);
    ++count;
  }
  return count;
}

}  // namespace handsight
