// SPDX-License-Identifier: Apache-2.0
#include "estimation/start/multi_start.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/normal_equations.h"
#include "estimation/start/start_markers.h"

namespace handsight {
namespace {

constexpr std::size_t spread = 60;  // observations: enough for a start
constexpr std::size_t followed = 5;
constexpr std::size_t given_back = 3;
constexpr double hardly_held = 100;  // prior sigmas: a start is sought wherever the measurements lead

bool cameras_are_free(const Problem& problem) { return problem.rig && problem.cameras_by_effect.cols() > 0; }

/// The same problem with only those effects free whose column of camera numbers `is_free` takes (the rig's numbers,
/// zero for an effect that moves no camera).
Problem with_free_cameras(const Problem& images, const std::function<bool(const Eigen::VectorXd&)>& is_free) {
  Problem part = images;
  part.columns_of_effects.clear();
  for (Eigen::Index i = 0; i < images.effect_count(); ++i)
    if (images.cameras_by_effect.cols() > 0 && !images.cameras_by_effect.col(i).isZero(0) &&
        is_free(images.cameras_by_effect.col(i))) {
      part.columns_of_effects.push_back(images.columns_of_effects[static_cast<std::size_t>(i)]);
      part.columns_of_effects.back().sigma *= hardly_held;
    }
  place_observations(part);
  return part;
}

/// What the first camera saw.
Problem first_alone(const Problem& images) {
  Problem first = images;
  for (ProblemObservation& o : first.observations) {
    std::erase_if(o.sightings, [](const Sighting& s) { return !seen_by(s, 0); });
    for (Sighting& s : o.sightings) s.in_cameras.resize(1);
  }
  std::erase_if(first.observations, [](const ProblemObservation& o) { return o.sightings.empty(); });
  return first;
}

/// Does an effect move numbers of the first camera and of no other?
bool moves_first_alone(const Eigen::VectorXd& by, int cameras) {
  return by.head(first_number(cameras, 0)).isZero(0) && by.tail(camera_number_count * (cameras - 1)).isZero(0);
}

/// Adds the equations of one viewing ray (or point) to those of the markers and of the mount's translation: what is
/// across the ray of mount_from_tcp x - t is 0.
struct RaySystem {
  Eigen::MatrixXd h;
  Eigen::VectorXd g;

  explicit RaySystem(Eigen::Index columns)
      : h(Eigen::MatrixXd::Zero(columns, columns)), g(Eigen::VectorXd::Zero(columns)) {}

  void add(Eigen::Index marker, const Rigid& mount_from_tcp, const Matrix3& across, const Vector3& offset) {
    const Eigen::Index t = h.rows() - 3, m = 3 * marker;
    const Matrix3 by_marker = across * mount_from_tcp.rotation;
    const Vector3 right = across * (offset - mount_from_tcp.translation);
    h.block<3, 3>(m, m) += by_marker.transpose() * by_marker;
    h.block<3, 3>(m, t) -= by_marker.transpose() * across;
    h.block<3, 3>(t, m) -= across * by_marker;
    h.block<3, 3>(t, t) += across * across;
    g.segment<3>(m) += by_marker.transpose() * right;
    g.segment<3>(t) -= across * right;
  }
};

/// Markers and translation of the mount for a rotation of it, by all viewing rays (or points).
Unknowns with_rotation_by_rays(const Problem& problem, const Unknowns& like, const Matrix3& rotation) {
  RaySystem system(3 * problem.marker_count + 3);
  for (const ProblemObservation& o : problem.observations) {
    const Rigid mount_from_tcp = inverse(o.root_from_mount) * o.root_from_tcp;
    for (const Sighting& s : o.sightings) {
      if (s.point) system.add(s.marker, mount_from_tcp, Matrix3::Identity(), rotation * *s.point);
      for (const CameraPoint& seen : s.in_cameras) {
        if (!problem.rig) continue;
        const RigCamera& c = problem.rig->at(seen.camera);
        const auto ray = undistort(c.camera, seen.pixel);
        if (!ray) continue;
        const Rigid first_from_camera = inverse(c.camera_from_first);
        const Vector3 d = (rotation * first_from_camera.rotation * ray->homogeneous()).normalized();
        system.add(s.marker, mount_from_tcp, Matrix3::Identity() - d * d.transpose(),
                   rotation * first_from_camera.translation);
      }
    }
  }
  const Eigen::VectorXd x = pseudo_inverse(system.h) * system.g;
  Unknowns u = like;
  for (int m = 0; m < problem.marker_count; ++m)
    if (system.h(3 * m, 3 * m) > 0) u.markers_in_tcp[static_cast<std::size_t>(m)] = x.segment<3>(3 * m);
  u.mount_from_sensor = {rotation, x.tail<3>()};
  return u;
}

/// Rotations to try: the given one, those 25 degrees beside it (with those every one within 30 degrees is within 20),
/// and all round.
std::vector<Matrix3> rotations_to_try(const Matrix3& given) {
  constexpr double beside = 25 * std::numbers::pi / 180;
  std::vector<Matrix3> all{given};
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0})
      for (const double z : {-1.0, 0.0, 1.0})
        if (const Vector3 axis(x, y, z); axis.norm() > 0)
          all.push_back(given * rotation_from_vector<double>(Vector3(beside * axis.normalized())));
  for (const Matrix3& r : axis_rotations()) all.push_back(r);
  return all;
}

void sort_by_cost(std::vector<Solution>& solutions) {
  std::stable_sort(solutions.begin(), solutions.end(), [](const Solution& a, const Solution& b) {
    return std::pair(!a.normal.in_front, a.normal.cost) < std::pair(!b.normal.in_front, b.normal.cost);
  });
}

/// Leaves out what leads to the same place as one before it.
void drop_equal(std::vector<Solution>& sorted) {
  std::vector<Solution> kept;
  for (Solution& s : sorted)
    if (std::none_of(kept.begin(), kept.end(), [&](const Solution& k) {
          return small_motion_between(k.unknowns.mount_from_sensor, s.unknowns.mount_from_sensor).norm() < 1e-3;
        }))
      kept.push_back(std::move(s));
  sorted = std::move(kept);
}

/// Body and mount for cameras and effects as they are: the best few.
std::vector<Solution> placed_mounts(const Problem& problem, const Unknowns& given) {
  std::vector<Solution> tried{solve(problem, given, {.most_iterations = 8})};
  if (problem.mount_is_estimated) {
    for (const Matrix3& rotation : rotations_to_try(given.mount_from_sensor.rotation))
      tried.push_back(solve(problem, with_rotation_by_rays(problem, given, rotation), {.most_iterations = 8}));
  } else {
    Unknowns by_rays = given;
    by_rays.markers_in_tcp = start_markers(problem, given.mount_from_sensor);
    tried.push_back(solve(problem, by_rays, {.most_iterations = 8}));
  }
  sort_by_cost(tried);
  drop_equal(tried);
  tried.resize(std::min(tried.size(), followed));
  for (Solution& s : tried) s = solve(problem, s.unknowns, {.most_iterations = 60});
  sort_by_cost(tried);
  drop_equal(tried);
  tried.resize(std::min(tried.size(), given_back));
  return tried;
}

/// Goes on with these cameras' numbers free from a solution with fewer; `terms` holds the effects' values.
Solution released(Problem part, const std::vector<EffectTerm>& values, const Unknowns& from) {
  part.terms = values;
  place_observations(part);
  Unknowns start = from;
  start.effects = effect_values(part);
  return solve(part, start, {.most_iterations = 60});
}

std::vector<EffectTerm> terms_at(const Problem& part, const std::vector<EffectTerm>& before, const Solution& s) {
  Problem at = part;
  at.terms = before;
  set_effect_values(at, s.unknowns.effects);
  return at.terms;
}

}  // namespace

namespace {

/// How many times more than few robots explain a solution leaves.
double far_off(const Problem& images, const Solution& s) {
  if (s.normal.rows == 0) return 0;
  double much = 0.03;
  if (images.rig) {
    double longest = 0;
    for (const RigCamera& c : images.rig->cameras) longest = std::max(longest, c.camera.fx);
    much = 0.003 * longest;
  }
  return std::sqrt(s.normal.data_cost() / s.normal.rows) / much;
}

}  // namespace

bool looks_lost(const Problem& images, const Solution& s) {
  return !s.stopped && (!s.converged || !s.normal.in_front || far_off(images, s) > 1);
}

bool is_no_answer(const Problem& images, const Solution& s) { return !s.normal.in_front || far_off(images, s) > 10; }

std::vector<Unknowns> competing_starts(const Problem& images, const Unknowns& given) {
  const bool cameras = cameras_are_free(images);
  if (!cameras && !images.mount_is_estimated) return {};
  if (!images.source->chain.parts.empty()) return {};  // each part's own fit has looked round
  const Problem thin = thinned(images, spread);
  Problem body = cameras ? first_alone(thin) : thin;
  if (body.observations.empty()) body = thin;
  hold_effects(body);
  Unknowns start = given;
  start.effects.resize(0);
  std::vector<Solution> found = placed_mounts(body, start);

  std::vector<std::pair<double, Unknowns>> ends;
  for (const Solution& s : found) {
    std::vector<EffectTerm> terms = images.terms;
    Solution last = s;
    if (cameras) {
      const Problem first = with_free_cameras(
          first_alone(thin), [&](const Eigen::VectorXd& by) { return moves_first_alone(by, images.rig->count()); });
      if (first.effect_count() > 0 && !first.observations.empty()) {
        last = released(first, terms, last.unknowns);
        terms = terms_at(first, terms, last);
      }
      const Problem all = with_free_cameras(thin, [](const Eigen::VectorXd&) { return true; });
      last = released(all, terms, last.unknowns);
      terms = terms_at(all, terms, last);
    }
    Problem whole = images;
    whole.terms = terms;
    Unknowns u = last.unknowns;
    u.effects = effect_values(whole);
    if (!u.effects.allFinite()) continue;
    place_observations(whole);
    const std::vector<Vector3> by_rays = start_markers(whole, u.mount_from_sensor);
    for (std::size_t m = 0; m < by_rays.size(); ++m)
      if (!(last.normal.information(3 * static_cast<Eigen::Index>(m), 3 * static_cast<Eigen::Index>(m)) > 0))
        u.markers_in_tcp[m] = by_rays[m];
    ends.emplace_back(normal_equations(whole, u).cost, u);
  }
  std::stable_sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Unknowns> starts;
  for (auto& [cost, u] : ends) starts.push_back(std::move(u));
  return starts;
}

}  // namespace handsight
