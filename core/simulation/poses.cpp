// SPDX-License-Identifier: Apache-2.0
#include "simulation/poses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handsight {
namespace {

constexpr int most_tries = 500;
constexpr double one_face = 0.98;    // of the product of two normals
constexpr double image_margin = 40;  // px: the whole label stays in the image

constexpr double least_slide = 0.1;  // m, half of it: of a sliding joint without limits that hardly moved

JointSpan taken_span(const Session& like, Eigen::Index column) {
  JointSpan span{1e300, -1e300};
  for (const Observation& o : like.observations) {
    span.lower = std::min(span.lower, o.position[column]);
    span.upper = std::max(span.upper, o.position[column]);
  }
  return span;
}

}  // namespace

JointSpan joint_span(const Session& like, const Joint& joint, Eigen::Index column, double share) {
  const bool is_limited = joint.lower >= -1e29 && joint.upper <= 1e29;
  const std::size_t taken = like.observations.size();
  const JointSpan span = taken_span(like, column);
  if (taken >= 5 && span.upper - span.lower > 0.2) return span;
  if (taken > 0 && !is_limited && joint.kind == JointKind::prismatic) {
    const double middle = 0.5 * (span.lower + span.upper);
    const double half = std::max(0.5 * (span.upper - span.lower), least_slide);
    return {middle - half, middle + half};
  }
  const double lower = is_limited ? joint.lower : -std::numbers::pi;
  const double upper = is_limited ? joint.upper : std::numbers::pi;
  const double middle = 0.5 * (lower + upper);
  return {middle + share * (lower - middle), middle + share * (upper - middle)};
}

PoseSampler::PoseSampler(const Session& like, const Chain& chain, const ShownBody& body,
                         const SimulationOptions& options)
    : chain_(chain), body_(body), options_(options), mount_from_sensor_(like.mount.mount_from_sensor) {
  const auto count = static_cast<Eigen::Index>(chain.joints.size());
  lower_.resize(count);
  upper_.resize(count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
    const JointSpan span = joint_span(like, joint, j, options.joint_range);
    lower_[j] = span.lower;
    upper_[j] = span.upper;
  }
}

double PoseSampler::violation(const Eigen::VectorXd& position) const {
  if (!chain_.rig) return 0;
  const ObservationState c = states_at(chain_, position);
  const Rigid first_from_tcp =
      sensor_from_tcp(observed_ends(c, moved_sites(c, options_.effects, options_.curves)).ends, mount_from_sensor_);
  double total = 0;
  if (body_.normals_in_tcp.empty()) {
    for (std::size_t m = 0; m < body_.markers_in_tcp.size(); ++m) total += unseen(first_from_tcp, m);
    return total;
  }
  double least = 1e300;  // of the faces
  for (const Vector3& face : body_.normals_in_tcp) {
    total = 0;
    for (std::size_t m = 0; m < body_.markers_in_tcp.size(); ++m)
      if (body_.normals_in_tcp[m].dot(face) > one_face) total += unseen(first_from_tcp, m);
    least = std::min(least, total);
  }
  return least;
}

double PoseSampler::unseen(const Rigid& first_from_tcp, std::size_t marker) const {
  const Vector3 x = first_from_tcp * body_.markers_in_tcp[marker];
  const Vector3 normal = first_from_tcp.rotation * normal_at(body_, marker);
  LeastTwo least;
  for (const RigCamera& one : chain_.rig->cameras)
    least.add(unseen(one.camera, one.camera_from_first * x, one.camera_from_first.rotation * normal));
  return least.sum();
}

/// 0 where the camera sees the point well; else how far from that it is, in rough units of a radian.
double PoseSampler::unseen(const Camera& camera, const Vector3& x, const Vector3& normal) const {
  const double distance = x.norm();
  const double off_axis = std::atan2(x.head<2>().norm(), x.z());
  const double turned = std::acos(std::clamp(-normal.dot(x) / distance, -1.0, 1.0));
  double total = std::max(0.0, turned - options_.most_turned) + 2 * std::max(0.0, options_.nearest - distance) +
                 2 * std::max(0.0, distance - options_.farthest);
  if (!is_visible(camera, x, image_margin)) total += 0.05 + off_axis;
  return total;
}

Eigen::VectorXd PoseSampler::drawn(Random& random) const {
  Eigen::VectorXd position(lower_.size());
  for (Eigen::Index j = 0; j < position.size(); ++j) position[j] = random.uniform(lower_[j], upper_[j]);
  return position;
}

/// Some joints moved by a share of their range, inside the limits.
Eigen::VectorXd PoseSampler::moved(const Eigen::VectorXd& from, double share, Random& random) const {
  Eigen::VectorXd position = from;
  for (Eigen::Index j = 0; j < position.size(); ++j)
    if (random.uniform() < 0.5)
      position[j] = std::clamp(position[j] + share * (upper_[j] - lower_[j]) * random.gaussian(), lower_[j], upper_[j]);
  return position;
}

/// From `start` downhill in what is violated, by random steps that shrink; nothing where it gets stuck.
std::optional<Eigen::VectorXd> PoseSampler::made_visible(Eigen::VectorXd position, Random& random) const {
  double cost = violation(position);
  double share = 0.3;
  for (int step = 0; step < 400 && cost > 0; ++step) {
    const Eigen::VectorXd next = moved(position, share, random);
    const double next_cost = violation(next);
    share = next_cost < cost ? std::min(0.4, 1.3 * share) : std::max(0.02, 0.97 * share);
    if (next_cost >= cost) continue;
    position = next;
    cost = next_cost;
  }
  return cost > 0 ? std::nullopt : std::optional(position);
}

Eigen::VectorXd PoseSampler::next(Random& random) {
  const bool near_last = options_.follow && last_.size() > 0;
  for (int attempt = 0; attempt < most_tries; ++attempt) {
    const auto found = made_visible(near_last ? moved(last_, 0.15, random) : drawn(random), random);
    if (!found) continue;
    // The way downhill ends at the border of what is seen: a walk inside it forgets where it came in.
    last_ = *found;
    for (int step = 0; step < (near_last ? 5 : 40); ++step) {
      const Eigen::VectorXd walked = moved(last_, 0.1, random);
      if (violation(walked) == 0) last_ = walked;
    }
    return last_;
  }
  throw InputError(message(
      "No pose in {} searches shows all {} markers to {} between {:.2f} and {:.2f} m; check the mount of the "
      "cameras, or widen --joint-range.",
      most_tries, body_.markers_in_tcp.size(), cameras_that_must_see(chain_.rig), options_.nearest, options_.farthest));
}

}  // namespace handsight
