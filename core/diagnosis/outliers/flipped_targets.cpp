// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/outliers/flipped_targets.h"

#include <algorithm>
#include <numbers>

#include "base/median.h"
#include "base/text.h"
#include "chain/chain.h"
#include "session/pose_points.h"

namespace handsight {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double clearly_turned = 3 * degree;
constexpr double many_times = 5;      // the usual turn
constexpr double right_again = 0.35;  // of the turn as it was reported

double angle_between(const Matrix3& a, const Matrix3& b) {
  return vector_from_rotation(Matrix3(a.transpose() * b)).norm();
}

/// Of rotations the one to which the others are nearest in the median.
Matrix3 most_central(const std::vector<Matrix3>& rotations) {
  std::size_t best = 0;
  double least = 1e9;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    std::vector<double> angles;
    for (const Matrix3& other : rotations) angles.push_back(angle_between(rotations[i], other));
    const double usual = median(angles);
    if (usual < least) least = usual, best = i;
  }
  return rotations[best];
}

struct Shown {
  std::vector<int> places;      // into Session::observations
  std::vector<Rigid> from_tcp;  // sensor_from_tcp
  std::vector<Rigid> poses;     // sensor_from_target, as told
  std::vector<Matrix3> in_tcp;  // tcp_from_target by it
};

Shown shown_in(const Session& session, const Rigid& mount_from_sensor) {
  Shown shown;
  const Chain chain = make_chain(session);
  for (std::size_t i = 0; i < session.observations.size(); ++i) {
    const Observation& o = session.observations[i];
    if (!o.target_pose || !is_used(o)) continue;
    shown.places.push_back(static_cast<int>(i));
    shown.from_tcp.push_back(sensor_from_tcp(chain_ends(chain, o.position), mount_from_sensor));
    shown.poses.push_back(*o.target_pose);
    shown.in_tcp.push_back(shown.from_tcp.back().rotation.transpose() * o.target_pose->rotation);
  }
  return shown;
}

}  // namespace

Rigid mirrored_tilt(const Rigid& pose) {
  const Vector3 sight = pose.translation.normalized();
  const Matrix3 about_sight = rotation_from_vector<double>(Vector3(std::numbers::pi * sight));
  const Matrix3 about_normal = rotation_from_vector<double>(Vector3(0, 0, std::numbers::pi));
  return {about_sight * pose.rotation * about_normal, pose.translation};
}

std::vector<FlippedTarget> flipped_targets(const Session& session, const Fit& fit) {
  if (!session.pose_sensor) return {};
  const Shown shown = shown_in(session, estimate(fit).mount_from_sensor);
  if (shown.places.size() < 5) return {};
  const Matrix3 tcp_from_target = most_central(shown.in_tcp);
  std::vector<double> turned;
  for (const Matrix3& one : shown.in_tcp) turned.push_back(angle_between(one, tcp_from_target));
  const double odd = std::max(clearly_turned, many_times * median(turned));
  std::vector<FlippedTarget> flipped;
  for (std::size_t k = 0; k < shown.places.size(); ++k) {
    if (turned[k] < odd) continue;
    const Rigid mirrored = mirrored_tilt(shown.poses[k]);
    const double left =
        angle_between(Matrix3(shown.from_tcp[k].rotation.transpose() * mirrored.rotation), tcp_from_target);
    if (left > right_again * turned[k] || left > odd) continue;
    const Observation& o = session.observations[static_cast<std::size_t>(shown.places[k])];
    flipped.push_back({shown.places[k], o.id, turned[k], left});
  }
  return flipped;
}

Session without_flipped(Session session, const std::vector<FlippedTarget>& flipped) {
  for (const FlippedTarget& f : flipped) {
    Observation& o = session.observations[static_cast<std::size_t>(f.index)];
    o.decision = Decision::excluded;
    o.reason = "the flat target's pose flipped to its mirror tilt";
  }
  return session;
}

Message flipped_text(const std::vector<FlippedTarget>& flipped) {
  if (flipped.empty()) return "";
  std::vector<std::string> ids;
  double least = 1e9, most = 0;
  for (const FlippedTarget& f : flipped) {
    ids.push_back(std::to_string(f.id));
    least = std::min(least, f.turned / degree);
    most = std::max(most, f.turned / degree);
  }
  const bool is_one = flipped.size() == 1;
  return message(
      "Observation{} {}: the flat target's pose flipped to its mirror tilt (turned by {}; with the tilt mirrored about "
      "the line of sight it is right). Leave {} out.",
      is_one ? "" : "s", shortened(fmt::format("{}", fmt::join(ids, ", ")), 300),
      is_one ? message("{:.0f} degrees", most) : message("{:.0f} to {:.0f} degrees", least, most),
      is_one ? "it" : "them");
}

}  // namespace handsight
