// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/planning/pose_pool.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace handsight {
namespace {

constexpr double limit_margin = 0.01;  // share of a joint's range that is left free at both ends
constexpr double unlimited = 1e29;

/// A bell of standard deviation 0.5, never beyond 1.5: bounded steps for walks.
double bell(std::mt19937_64& random) { return uniform(random) + uniform(random) + uniform(random) - 1.5; }

struct Span {
  double lower = 1e300, upper = -1e300;
};

Span taken_span(const Session& session, Eigen::Index joint) {
  Span span;
  for (const Observation& o : session.observations) {
    span.lower = std::min(span.lower, o.position[joint]);
    span.upper = std::max(span.upper, o.position[joint]);
  }
  return span;
}

/// The normal of the plane of the markers; nothing where they are fewer than three, on a line, or no plane.
std::optional<Vector3> plane_normal(const std::vector<Vector3>& markers, const Vector3& middle) {
  if (markers.size() < 3) return std::nullopt;
  Matrix3 spread = Matrix3::Zero();
  for (const Vector3& m : markers) spread += (m - middle) * (m - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(spread);
  if (eigen.eigenvalues()[1] < 1e-3 * eigen.eigenvalues()[2] || eigen.eigenvalues()[0] > 0.2 * eigen.eigenvalues()[1])
    return std::nullopt;
  return eigen.eigenvectors().col(0);
}

}  // namespace

PoseJudge::PoseJudge(const Session& session, const Fit& fit) : fit_(fit), rigid_(fit.problem.source->chain) {
  for (Joint& joint : rigid_.robot.joints) joint.stiffness = 0;
  const std::vector<Vector3>& all = estimate(fit).markers_in_tcp;
  for (std::size_t m = 0; m < all.size(); ++m)
    if (fit.problem.marker_is_seen[m]) markers_.push_back(all[m]);
  for (const Vector3& m : markers_) middle_ += m / static_cast<double>(markers_.size());
  set_limits(session);
  if (fit.problem.rig || session.pose_sensor) learn_what_shows();
  if (!fit.problem.rig && session.pose_sensor) learn_sight();
}

void PoseJudge::set_limits(const Session& session) {
  const auto count = static_cast<Eigen::Index>(rigid_.joints.size());
  lower_.resize(count);
  upper_.resize(count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const Joint& joint = rigid_.robot.joints[static_cast<std::size_t>(rigid_.joints[static_cast<std::size_t>(j)])];
    const Span taken = taken_span(session, j);
    const double middle = 0.5 * (taken.lower + taken.upper);
    const bool slides = joint.kind == JointKind::prismatic;
    double lower = joint.lower, upper = joint.upper;
    if (lower < -unlimited) lower = slides ? taken.lower : std::min(middle - std::numbers::pi, taken.lower);
    if (upper > unlimited) upper = slides ? taken.upper : std::max(middle + std::numbers::pi, taken.upper);
    const double margin = limit_margin * std::max(upper - lower, 0.0);
    lower_[j] = lower + margin;
    upper_[j] = std::max(upper - margin, lower_[j]);
  }
}

void PoseJudge::learn_what_shows() {
  std::vector<Vector3> ways;  // to the first camera, TCP frame
  double nearest = 1e300, farthest = 0;
  for (const ProblemObservation& o : fit_.problem.observations) {
    const Rigid left_from_tcp = sensor_from_tcp_at(o, estimate(fit_));
    const Vector3 x = left_from_tcp * middle_;
    nearest = std::min(nearest, x.norm());
    farthest = std::max(farthest, x.norm());
    ways.push_back(left_from_tcp.rotation.transpose() * -x.normalized());
  }
  const bool few = ways.size() < 5;
  nearest_ = (few ? 0.6 : 0.8) * nearest;
  farthest_ = (few ? 1.6 : 1.25) * farthest;
  Vector3 mean = Vector3::Zero();
  for (const Vector3& w : ways) mean += w / static_cast<double>(ways.size());
  if (mean.norm() < 0.3) return;  // seen from all around
  facing_ = mean.normalized();
  if (const auto normal = plane_normal(markers_, middle_); normal && std::abs(normal->dot(*facing_)) > 0.3)
    facing_ = normal->dot(*facing_) > 0 ? *normal : Vector3(-*normal);
  double turned = 0;
  for (const Vector3& w : ways) turned = std::max(turned, std::acos(std::clamp(facing_->dot(w), -1.0, 1.0)));
  most_turned_ = std::clamp(turned, 0.7, 1.2);
}

void PoseJudge::learn_sight() {
  std::vector<Vector3> lines;
  for (const ProblemObservation& o : fit_.problem.observations)
    lines.push_back((sensor_from_tcp_at(o, estimate(fit_)) * middle_).normalized());
  Vector3 mean = Vector3::Zero();
  for (const Vector3& line : lines) mean += line / static_cast<double>(lines.size());
  if (lines.empty() || mean.norm() < 0.3) return;  // it sees all around
  sight_ = mean.normalized();
  double widest = 0;
  for (const Vector3& line : lines) widest = std::max(widest, std::acos(std::clamp(sight_->dot(line), -1.0, 1.0)));
  widest_ = std::clamp(1.25 * widest, 0.3, 1.2);
}

double PoseJudge::unseen_by_poses(const Rigid& sensor_from_tcp) const {
  const Vector3 x = sensor_from_tcp * middle_, line = x.normalized();
  double total = 2 * std::max(0.0, nearest_ - x.norm()) + 2 * std::max(0.0, x.norm() - farthest_);
  if (sight_) total += std::max(0.0, std::acos(std::clamp(sight_->dot(line), -1.0, 1.0)) - widest_);
  if (!facing_) return total;
  const Vector3 normal = sensor_from_tcp.rotation * *facing_;
  return total + std::max(0.0, std::acos(std::clamp(-normal.dot(line), -1.0, 1.0)) - most_turned_);
}

double PoseJudge::unseen_by(const Camera& camera, const Vector3& x, const Vector3& normal,
                            const Vector3& middle) const {
  const double margin = std::min(40.0, 0.05 * std::min(camera.width, camera.height));  // the whole label is seen
  double total = 2 * std::max(0.0, nearest_ - middle.norm()) + 2 * std::max(0.0, middle.norm() - farthest_);
  if (facing_) {
    const double turned = std::acos(std::clamp(-normal.dot(x) / std::max(x.norm(), 1e-9), -1.0, 1.0));
    total += std::max(0.0, turned - most_turned_);
  }
  if (!is_visible(camera, x, margin)) total += 0.05 + std::atan2(x.head<2>().norm(), x.z());
  return total;
}

double PoseJudge::unseen(const Rigid& sensor_from_tcp) const {
  if (!fit_.problem.rig) return sight_ || facing_ ? unseen_by_poses(sensor_from_tcp) : 0;
  const Rig& rig = *fit_.problem.rig;
  const Vector3 facing = facing_.value_or(Vector3::Zero());
  double total = 0;
  for (const Vector3& m : markers_) {
    LeastTwo least;
    for (const RigCamera& c : rig.cameras) {
      const Rigid camera_from_tcp = c.camera_from_first * sensor_from_tcp;
      least.add(unseen_by(c.camera, camera_from_tcp * m, camera_from_tcp.rotation * facing, camera_from_tcp * middle_));
    }
    total += least.sum();
  }
  return total;
}

double PoseJudge::violation(const Eigen::VectorXd& position) const {
  double total = 0;
  for (Eigen::Index j = 0; j < position.size(); ++j)
    total += std::max(0.0, lower_[j] - position[j]) + std::max(0.0, position[j] - upper_[j]);
  const Posture posture = solve_posture<double>(rigid_.robot, joint_values(rigid_.robot, rigid_.joints, position),
                                                RobotChange{}, rigid_.gravity, false);
  for (std::size_t j = 0; j < rigid_.robot.joints.size(); ++j) {
    const Joint& joint = rigid_.robot.joints[j];
    if (joint.is_mimic())
      total += std::max(0.0, joint.lower - posture.value[j]) + std::max(0.0, posture.value[j] - joint.upper);
  }
  const Rigid root_from_left =
      posture.root_from_link[static_cast<std::size_t>(rigid_.mount_link)] * estimate(fit_).mount_from_sensor;
  return total + unseen(inverse(root_from_left) * posture.root_from_link[static_cast<std::size_t>(rigid_.tcp_link)]);
}

namespace {

class Walker {
 public:
  Walker(const PoseJudge& judge, std::uint64_t seed) : judge_(judge), random_(seed) {}

  Eigen::VectorXd drawn() {
    Eigen::VectorXd position = judge_.lower();
    for (Eigen::Index j = 0; j < position.size(); ++j)
      position[j] += uniform(random_) * (judge_.upper()[j] - judge_.lower()[j]);
    return position;
  }

  Eigen::VectorXd clamped(const Eigen::VectorXd& position) const {
    return position.cwiseMax(judge_.lower()).cwiseMin(judge_.upper());
  }

  /// Downhill in what is violated, by random steps that shrink; nothing where it gets stuck.
  std::optional<Eigen::VectorXd> made_good(Eigen::VectorXd position) {
    double cost = judge_.violation(position), share = 0.6;
    for (int step = 0; step < 300 && cost > 0; ++step) {
      const Eigen::VectorXd next = moved(position, share);
      const double next_cost = judge_.violation(next);
      share = next_cost < cost ? std::min(0.8, 1.3 * share) : std::max(0.04, 0.97 * share);
      if (next_cost >= cost) continue;
      position = next;
      cost = next_cost;
    }
    return cost > 0 ? std::nullopt : std::optional(position);
  }

  /// Some steps inside what is good; true where it came away from `position`.
  bool walk(Eigen::VectorXd& position) {
    bool came_away = false;
    for (int step = 0; step < 8 || (!came_away && step < 40); ++step) {
      const Eigen::VectorXd next = moved(position, step % 2 == 0 ? 0.1 : 0.4);
      if (judge_.violation(next) > 0) continue;
      position = next;
      came_away = true;
    }
    return came_away;
  }

 private:
  /// About half of the joints moved by a share of their range.
  Eigen::VectorXd moved(const Eigen::VectorXd& from, double share) {
    Eigen::VectorXd position = from;
    for (Eigen::Index j = 0; j < position.size(); ++j)
      if (uniform(random_) < 0.5)
        position[j] = std::clamp(position[j] + share * bell(random_) * (judge_.upper()[j] - judge_.lower()[j]),
                                 judge_.lower()[j], judge_.upper()[j]);
    return position;
  }

  const PoseJudge& judge_;
  std::mt19937_64 random_;
};

}  // namespace

std::vector<Eigen::VectorXd> pose_pool(const Session& session, const PoseJudge& judge, int count, std::uint64_t seed) {
  constexpr int chains = 40, most_failures = 300;
  Walker walker(judge, seed);
  std::vector<Eigen::VectorXd> starts;
  const std::size_t taken = session.observations.size();
  for (std::size_t i = 0; i < std::min<std::size_t>(taken, chains / 2); ++i)
    if (const auto good = walker.made_good(
            walker.clamped(session.observations[i * taken / std::min<std::size_t>(taken, 20)].position)))
      starts.push_back(*good);
  for (int failures = 0; starts.size() < chains && failures < most_failures;) {
    if (const auto good = walker.made_good(walker.drawn())) {
      starts.push_back(*good);
    } else {
      ++failures;
    }
  }
  if (starts.empty())
    throw InputError(
        message("{}: in {} searches no pose within the joint limits shows all markers to {}; check the limits in the "
                "robot's file and the mount of the cameras.",
                session.file.filename().string(), most_failures, cameras_that_must_see(session.rig)));
  std::vector<Eigen::VectorXd> pool;
  for (int round = 0, wanted = count; wanted > 0 && round * chains < 2 * count + chains; ++round)
    for (Eigen::VectorXd& position : starts) {
      if (wanted == 0) break;
      if (!walker.walk(position)) continue;
      pool.push_back(position);
      --wanted;
    }
  if (pool.empty()) pool = starts;  // ranges too small for steps that stay in what is seen
  return pool;
}

}  // namespace handsight
