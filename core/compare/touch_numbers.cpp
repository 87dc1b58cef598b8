// SPDX-License-Identifier: Apache-2.0
#include "compare/touch_numbers.h"

#include <algorithm>
#include <cmath>

#include "effects/own_effect.h"
#include "estimation/fit/fit_parts.h"
#include "session/fixtures/fixture_kind.h"

namespace handsight {
namespace {

void add_difference(std::vector<NumberChange>& all, const std::string& name, const char* unit, double before,
                    double after, double variance) {
  constexpr double unknown = 1;  // m or rad: of more nothing is known (UndeterminedMotions)
  if (variance < unknown) all.push_back({name, unit, before, after, std::sqrt(std::max(0.0, variance))});
}

void add_tips(std::vector<NumberChange>& all, const Fit& a, const Fit& b) {
  const auto &from = estimate(a).markers_in_tcp, &to = estimate(b).markers_in_tcp;
  const std::size_t count = std::min(from.size(), to.size());
  for (std::size_t m = 0; m < count; ++m)
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Eigen::Index row = 3 * static_cast<Eigen::Index>(m) + i;
      add_difference(all, (count > 1 ? "tip " + std::to_string(m) + " " : "tip ") + motion_axes[i], "m", from[m][i],
                     to[m][i], a.parameter_covariance(row, row) + b.parameter_covariance(row, row));
    }
}

void add_place(std::vector<NumberChange>& all, const std::string& name, const FitPart& a, const FitPart& b) {
  const auto of_place = [](const FitPart& p) -> Matrix3 {
    const Matrix3& r = p.mount_from_sensor.rotation;
    return r * p.mount_covariance->topLeftCorner<3, 3>() * r.transpose();
  };
  const Matrix3 covariance = of_place(a) + of_place(b);
  for (Eigen::Index i = 0; i < 3; ++i)
    add_difference(all, name + " " + motion_axes[i], "m", a.mount_from_sensor.translation[i],
                   b.mount_from_sensor.translation[i], covariance(i, i));
}

/// How high b's plane lies above the origin of a's, along its normal, and how it is turned against it: a plane's frame
/// may have its origin anywhere in it, and its normal either way.
void add_height(std::vector<NumberChange>& all, const std::string& name, const FitPart& a, const FitPart& b) {
  const Rigid from_b = inverse(a.mount_from_sensor) * b.mount_from_sensor;
  const double along = from_b.rotation(2, 2);
  if (std::abs(along) < 0.5) return;  // another plane
  const Vector3 normal = from_b.rotation.col(2) / along, origin = -(from_b.rotation.transpose() * from_b.translation);
  Eigen::Matrix<double, 1, 6> by_b;
  by_b << 0, 0, 1, origin.y(), -origin.x(), 0;
  const Matrix6 &c_a = *a.mount_covariance, &c_b = *b.mount_covariance;
  add_difference(all, name + " height", "m", 0, normal.dot(from_b.translation),
                 c_a(2, 2) + (by_b * c_b * by_b.transpose())(0));
  Matrix3 turn_of_b = Matrix3::Zero();
  turn_of_b.topLeftCorner<2, 2>() = c_b.block<2, 2>(3, 3);
  const Matrix3 turned = from_b.rotation * turn_of_b * from_b.rotation.transpose();
  add_difference(all, name + " rx", "rad", 0, -normal.y(), c_a(3, 3) + turned(0, 0));
  add_difference(all, name + " ry", "rad", 0, normal.x(), c_a(4, 4) + turned(1, 1));
}

}  // namespace

std::vector<NumberChange> list_touch_numbers(const Session& first, const Session& second, const Fit& a, const Fit& b) {
  std::vector<NumberChange> all;
  add_tips(all, a, b);
  const std::vector<FitPart> before = list_parts(first, a), after = list_parts(second, b);
  for (std::size_t p = 0; p < first.parts.size(); ++p)
    for (std::size_t q = 0; q < second.parts.size(); ++q) {
      const Fixture &from = first.fixtures[static_cast<std::size_t>(first.parts[p].fixture)],
                    &to = second.fixtures[static_cast<std::size_t>(second.parts[q].fixture)];
      const bool is_same = from.id == to.id && from.kind == to.kind && before[p].mount_covariance &&
                           after[q].mount_covariance && before[p].place_is_determined && after[q].place_is_determined;
      if (!is_same) continue;
      if (from.kind->place == FixturePlace::origin) add_place(all, from.id, before[p], after[q]);
      if (from.kind->place == FixturePlace::height) add_height(all, from.id, before[p], after[q]);
    }
  return all;
}

}  // namespace handsight
