// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/choice.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "diagnosis/planning/cause_planning.h"
#include "diagnosis/planning/pose_pool.h"
#include "estimation/report/hand_end.h"

namespace handsight {
namespace {

constexpr std::size_t least_to_plan = 6;  // used observations
constexpr int least_in_vain = 2;          // moves in a row, before what the fit says of what is seen is mistrusted
constexpr int usual_pool = 600, spread_pool = 200, cause_pool = 150;
constexpr double near_in_vain = 0.15;  // rad (m) of the joint that differs most
constexpr double most_turned = 60 * M_PI / 180;
constexpr double least_lead = 0.2;  // of the eigenvalues: less is no plane

/// Uniform in [0, 1), the same on every platform.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1.0p-53; }

std::vector<Vector3> seen_markers(const Fit& fit) {
  std::vector<Vector3> markers;
  for (std::size_t m = 0; m < fit.problem.marker_is_seen.size(); ++m)
    if (fit.problem.marker_is_seen[m]) markers.push_back(estimate(fit).markers_in_tcp[m]);
  return markers;
}

Vector3 find_middle(const std::vector<Vector3>& points) {
  Vector3 middle = Vector3::Zero();
  for (const Vector3& x : points) middle += x / static_cast<double>(points.size());
  return middle;
}

/// The direction across flat markers, unit; nothing where they are too few or not flat.
std::optional<Vector3> make_normal(const std::vector<Vector3>& markers) {
  if (markers.size() < 3) return std::nullopt;
  const Vector3 middle = find_middle(markers);
  Matrix3 spread = Matrix3::Zero();
  for (const Vector3& x : markers) spread += (x - middle) * (x - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(spread);
  if (!(eigen.eigenvalues()[0] < least_lead * eigen.eigenvalues()[1])) return std::nullopt;
  return eigen.eigenvectors().col(0);
}

bool is_in_view(const Camera& camera, const Rigid& camera_from_tcp, const std::vector<Vector3>& markers,
                const std::optional<Vector3>& normal) {
  const double margin = std::min(40.0, 0.05 * std::min(camera.width, camera.height));
  for (const Vector3& m : markers)
    if (!is_visible(camera, camera_from_tcp * m, margin)) return false;
  if (!normal) return true;
  const Vector3 to = (camera_from_tcp * find_middle(markers)).normalized();
  return std::abs((camera_from_tcp.rotation * *normal).dot(to)) > std::cos(most_turned);
}

double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const JointRanges& ranges) {
  return (a - b).cwiseQuotient((ranges.upper - ranges.lower).cwiseMax(1e-6)).norm();
}

double distance_to(const Eigen::VectorXd& a, const std::vector<Eigen::VectorXd>& all, const JointRanges& ranges) {
  double least = 1e300;
  for (const Eigen::VectorXd& b : all) least = std::min(least, distance(a, b, ranges));
  return least;
}

std::vector<Eigen::VectorXd> taken_in(const Session& session) {
  std::vector<Eigen::VectorXd> taken;
  for (const Observation& o : session.observations)
    if (is_used(o)) taken.push_back(o.position);
  return taken;
}

/// The one that lies farthest from all that were taken; it is taken then.
std::optional<Eigen::VectorXd> take_farthest(std::vector<Eigen::VectorXd>& pool, std::vector<Eigen::VectorXd>& taken,
                                             const JointRanges& ranges) {
  if (pool.empty()) return std::nullopt;
  std::size_t best = 0;
  double most = -1;
  for (std::size_t i = 0; i < pool.size(); ++i)
    if (const double d = distance_to(pool[i], taken, ranges); d > most) most = d, best = i;
  const Eigen::VectorXd position = pool[best];
  pool.erase(pool.begin() + static_cast<std::ptrdiff_t>(best));
  taken.push_back(position);
  return position;
}

std::vector<Eigen::VectorXd> seen_pool(const Session& session, const Fit& fit, const Reach& reach, int count,
                                       std::uint64_t seed) {
  const PoseJudge judge(session, fit);
  std::vector<Eigen::VectorXd> pool = pose_pool(session, judge, count, seed);
  std::erase_if(pool,
                [&](const Eigen::VectorXd& q) { return !can_be_taken(reach, q) || !is_well_seen(reach, fit, q); });
  return pool;
}

/// Nothing is known of where the target sits: a step at a time from where it was seen, or from where the robot stands.
/// `share` of the usual steps.
std::vector<Eigen::VectorXd> pool_about(const std::vector<Eigen::VectorXd>& seen, const Reach& reach, int count,
                                        std::uint64_t seed, double share = 1) {
  std::mt19937_64 random(seed);
  std::vector<Eigen::VectorXd> pool;
  const int most_tries = 20 * std::max(count, 20);
  for (int tries = 0; tries < most_tries && static_cast<int>(pool.size()) < count; ++tries) {
    Eigen::VectorXd q = seen[static_cast<std::size_t>(random() % seen.size())];
    const double size = share * (0.06 + 0.12 * uniform(random));  // of the range
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const double range = std::min(reach.ranges.upper[j] - reach.ranges.lower[j], 4.0);
      q[j] += size * range * (2 * uniform(random) - 1);
    }
    q = q.cwiseMax(reach.ranges.lower).cwiseMin(reach.ranges.upper);
    if (can_be_taken(reach, q)) pool.push_back(q);
  }
  return pool;
}

void add_spread(const Session& session, const Knowledge& known, const Reach& reach, const Eigen::VectorXd& from,
                const ChoiceOptions& options, std::vector<ChosenPose>& chosen) {
  std::vector<Eigen::VectorXd> taken = taken_in(session), pool;
  if (known.fit) try {
      pool = seen_pool(session, *known.fit, reach, spread_pool, options.seed);
    } catch (const InputError&) {  // no pose is seen by what little is known
    }
  if (taken.empty()) taken.push_back(from);
  if (pool.empty()) pool = pool_about(taken, reach, spread_pool / 4, options.seed);
  for (int i = 0; i < options.count; ++i)
    if (const auto position = take_farthest(pool, taken, reach.ranges))
      chosen.push_back({*position, PoseReason::spread});
}

void add_near_seen(const Session& session, const Reach& reach, const Eigen::VectorXd& from,
                   const ChoiceOptions& options, std::vector<ChosenPose>& chosen) {
  std::vector<Eigen::VectorXd> seen = taken_in(session);
  if (seen.empty()) seen.push_back(from);
  const double share = std::pow(0.7, options.in_vain - least_in_vain);
  for (const Eigen::VectorXd& q : pool_about(seen, reach, options.count, options.seed, share))
    chosen.push_back({q, PoseReason::near_seen});
}

/// May it be taken, and is it none of those that are chosen already?
std::function<bool(const Eigen::VectorXd&)> takes(const Knowledge& known, const Reach& reach,
                                                  const std::vector<ChosenPose>& chosen) {
  return [&](const Eigen::VectorXd& q) {
    for (const ChosenPose& c : chosen)
      if ((c.position - q).cwiseAbs().maxCoeff() < near_in_vain) return false;
    return can_be_taken(reach, q) && is_well_seen(reach, *known.fit, q);
  };
}

PlanOptions plan_options(const ExperimentModel& model, const ChoiceOptions& options, int count) {
  PlanOptions o;
  o.count = count;
  o.effects = model.held;
  o.estimated = model.estimated;
  o.seed = options.seed;
  return o;
}

void add_for_causes(const Session& session, const ExperimentModel& model, const Knowledge& known, const Reach& reach,
                    const ChoiceOptions& options, int count, std::vector<ChosenPose>& chosen) {
  PlanOptions o = plan_options(model, options, count);
  o.pool = cause_pool;
  o.may_take = takes(known, reach, chosen);
  try {
    for (const Eigen::VectorXd& position : plan_for_causes(session, o)) chosen.push_back({position, PoseReason::cause});
  } catch (const InputError&) {  // no pose of the pool can be had
  }
}

void add_planned(const Session& session, const ExperimentModel& model, const Knowledge& known, const Reach& reach,
                 const ChoiceOptions& options, int count, bool between, std::vector<ChosenPose>& chosen) {
  PlanOptions o = plan_options(model, options, count);
  if (between)
    o.between = known.competing;
  else
    o.estimated.insert(o.estimated.end(), known.likely.begin(), known.likely.end());
  o.pool = usual_pool;
  o.seed += between ? 1000003 : 0;
  o.may_take = takes(known, reach, chosen);
  try {
    const Plan planned = plan(session, o);
    if (between && !planned.tells_apart) return;
    for (const PlannedPose& pose : planned.poses)
      chosen.push_back({pose.position, between ? PoseReason::between : PoseReason::precision});
  } catch (const InputError&) {  // no pose of the pool can be had
  }
}

}  // namespace

const char* reason_text(PoseReason reason) {
  switch (reason) {
    case PoseReason::spread:
      return "to begin with, spread over what is seen";
    case PoseReason::near_seen:
      return "a small step from where the target was seen";
    case PoseReason::precision:
      return "to settle the estimate";
    case PoseReason::cause:
      return "to find what is missing";
    case PoseReason::between:
      return "to tell the likeliest causes apart";
    case PoseReason::region:
      return "where the robot has not been measured yet";
    default:
      return "once more, for the scatter";
  }
}

const char* reason_name(PoseReason reason) {
  switch (reason) {
    case PoseReason::spread:
      return "spread";
    case PoseReason::near_seen:
      return "near_seen";
    case PoseReason::precision:
      return "precision";
    case PoseReason::cause:
      return "cause";
    case PoseReason::between:
      return "between";
    case PoseReason::region:
      return "region";
    default:
      return "repeat";
  }
}

bool can_be_taken(const Reach& reach, const Eigen::VectorXd& position) {
  if (!reach.ranges.hold(position)) return false;
  for (const Eigen::VectorXd& q : reach.refused)
    if ((q - position).cwiseAbs().maxCoeff() < near_in_vain) return false;
  return !reach.world.touching(position);
}

bool is_well_seen(const Reach& reach, const Fit& fit, const Eigen::VectorXd& position) {
  const std::vector<Vector3> markers = seen_markers(fit);
  if (markers.empty() || reach.chain.is_touch) return true;  // a probe is felt, not seen
  const Rigid& mount_from_sensor = estimate(fit).mount_from_sensor;
  const ChainEnds ends = chain_ends(reach.chain, position);
  const Rigid sensor_from_tcp = inverse(ends.root_from_mount * mount_from_sensor) * ends.root_from_tcp;
  const std::optional<Vector3> normal = make_normal(markers);
  const Vector3 middle = find_middle(markers);
  if (!fit.problem.rig) return !reach.world.is_hidden(position, mount_from_sensor.translation, middle);
  int seen = 0;
  for (const RigCamera& c : fit.problem.rig->cameras) {
    if (!is_in_view(c.camera, c.camera_from_first * sensor_from_tcp, markers, normal)) continue;
    const Vector3 eye = mount_from_sensor * inverse(c.camera_from_first).translation;
    if (!reach.world.is_hidden(position, eye, middle)) ++seen;
  }
  return seen >= std::min(2, fit.problem.rig->count());
}

std::vector<Eigen::VectorXd> poses_to_judge_by(const Session& session, const Fit& fit, const Reach& reach, int count,
                                               std::uint64_t seed) {
  std::vector<Eigen::VectorXd> pool;
  try {
    pool = seen_pool(session, fit, reach, count, seed);
  } catch (const InputError&) {
    return pool;
  }
  if (reach.box)
    std::erase_if(pool, [&](const Eigen::VectorXd& q) {
      const ChainEnds ends = chain_ends(reach.chain, q);
      const bool exchanged = hand_carries_sensor(reach.chain);
      return !reach.box->holds((exchanged ? ends.root_from_mount : ends.root_from_tcp).translation);
    });
  return pool;
}

std::vector<ChosenPose> choose_poses(const Session& session, const ExperimentModel& model, const Knowledge& known,
                                     const Reach& reach, const Eigen::VectorXd& from, const ChoiceOptions& options) {
  std::vector<ChosenPose> chosen;
  if (options.in_vain >= least_in_vain) {
    add_near_seen(session, reach, from, options, chosen);
    return chosen;
  }
  if (!known.fit || (known.used < least_to_plan && !options.for_cause)) {
    add_spread(session, known, reach, from, options, chosen);
    return chosen;
  }
  std::vector<Eigen::VectorXd> taken = taken_in(session);
  if (options.with_repeat && options.count >= 3)
    chosen.push_back({taken[(options.seed * 7) % taken.size()], PoseReason::repeat});
  if (options.count >= 4) {
    std::vector<Eigen::VectorXd> pool;
    try {
      pool = seen_pool(session, *known.fit, reach, spread_pool, options.seed + 17);
    } catch (const InputError&) {
    }
    if (const auto position = take_farthest(pool, taken, reach.ranges))
      chosen.push_back({*position, PoseReason::region});
  }
  const auto left = [&] { return options.count - static_cast<int>(chosen.size()); };
  if (options.for_cause && left() > 0) add_for_causes(session, model, known, reach, options, left(), chosen);
  if (known.competing && left() > 0) add_planned(session, model, known, reach, options, left(), true, chosen);
  if (left() > 0 && known.used >= least_to_plan)
    add_planned(session, model, known, reach, options, left(), false, chosen);
  if (chosen.empty()) add_spread(session, known, reach, from, options, chosen);
  return chosen;
}

}  // namespace handsight
