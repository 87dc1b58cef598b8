// SPDX-License-Identifier: Apache-2.0
#include "blunders/rotation_readings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handsight {
namespace {

double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

/// The two triples of roll, pitch, yaw of a rotation, each number within half a turn.
std::vector<Vector3> as_roll_pitch_yaw(const Matrix3& rotation) {
  const Vector3 rpy = rpy_from_rotation(rotation);
  return {
      rpy,
      {wrapped(rpy.x() + std::numbers::pi), wrapped(std::numbers::pi - rpy.y()), wrapped(rpy.z() + std::numbers::pi)}};
}

/// The rotation vectors of a rotation, of a length up to what three angles within half a turn have.
std::vector<Vector3> as_vectors(const Matrix3& rotation) {
  const Vector3 v = vector_from_rotation(rotation);
  if (v.norm() < 1e-12) return {v};
  std::vector<Vector3> all;
  for (const double turns : {0.0, -1.0, 1.0}) {
    const Vector3 one = v * (1 + turns * 2 * std::numbers::pi / v.norm());
    if (one.cwiseAbs().maxCoeff() < std::numbers::pi + 1e-3) all.push_back(one);
  }
  return all;
}

/// Programs give a pitch of no more than a right angle.
bool has_usual_pitch(const Vector3& rpy) { return std::abs(rpy.y()) < std::numbers::pi / 2 + 1e-3; }

Matrix3 by(const Vector3& n, const std::string& convention) {
  const auto about = [](int axis, double angle) { return rotation_about<double>(Vector3::Unit(axis), angle); };
  if (convention == "rotation_vector") return rotation_from_vector<double>(n);
  if (convention == "rpy") return rotation_from_rpy(n);
  if (convention == "moving_xyz") return about(0, n[0]) * about(1, n[1]) * about(2, n[2]);
  if (convention == "zyx") return about(2, n[0]) * about(1, n[1]) * about(0, n[2]);
  return about(2, n[0]) * about(1, n[1]) * about(2, n[2]);
}

}  // namespace

const std::vector<std::string>& rotation_conventions() {
  static const std::vector<std::string> all{"rotation_vector", "rpy", "moving_xyz", "zyx", "zyz"};
  return all;
}

std::vector<Matrix3> read_again(const Matrix3& wrong, const std::string& convention) {
  std::vector<Vector3> numbers = convention == "rpy" ? as_vectors(wrong) : as_roll_pitch_yaw(wrong);
  if (convention == "rotation_vector") {  // controllers give them no longer than half a turn
    std::stable_sort(numbers.begin(), numbers.end(),
                     [](const Vector3& a, const Vector3& b) { return a.norm() < b.norm(); });
    while (numbers.size() > 1 && numbers.back().norm() > std::numbers::pi + 1e-3) numbers.pop_back();
  }
  if (convention == "rpy" && std::any_of(numbers.begin(), numbers.end(), has_usual_pitch))
    std::erase_if(numbers, [](const Vector3& n) { return !has_usual_pitch(n); });
  std::vector<Matrix3> rotations;
  for (const Vector3& n : numbers) rotations.push_back(by(n, convention));
  return rotations;
}

}  // namespace handsight
