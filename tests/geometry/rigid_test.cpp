// SPDX-License-Identifier: Apache-2.0
#include "geometry/rigid.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace handsight {
namespace {

constexpr double pi = std::numbers::pi;

Vector3 random_vector(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  return {uniform(random), uniform(random), uniform(random)};
}

Rigid random_rigid(std::mt19937_64& random) {
  return {rotation_from_vector<double>(random_vector(random, 1.7)), random_vector(random, 2)};
}

/// Eigen's own expressions are the authority: bit by bit, so that sessions computed before give the same numbers.
TEST(Rigid, ProductsAreThoseOfEigenToTheBit) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 10000; ++i) {
    const Rigid a = random_rigid(random), b = random_rigid(random);
    const Vector3 x = random_vector(random, 3);
    EXPECT_EQ(rotated(a.rotation, x), Vector3(a.rotation * x));
    EXPECT_EQ(rotated_back(a.rotation, x), Vector3(a.rotation.transpose() * x));
    EXPECT_EQ(a * x, Vector3(a.rotation * x + a.translation));
    EXPECT_EQ((a * b).rotation, Matrix3(a.rotation * b.rotation));
    EXPECT_EQ((a * b).translation, Vector3(a.rotation * b.translation + a.translation));
    EXPECT_EQ(inverse(a).rotation, Matrix3(a.rotation.transpose()));
    EXPECT_EQ(inverse(a).translation, Vector3(-(a.rotation.transpose() * a.translation)));
  }
}

TEST(Rigid, TheTurnBetweenTwoDirectionsIsEigensAndCarriesOneToTheOther) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 1000; ++i) {
    const Vector3 a = random_vector(random, 2), b = random_vector(random, 2);
    const Eigen::Quaterniond turn = turn_between(a, b);
    EXPECT_EQ(turn.coeffs(), Eigen::Quaterniond::FromTwoVectors(a, b).coeffs());
    EXPECT_LT((turn * a.normalized() - b.normalized()).norm(),
              1e-14 / turn.w());  // nearly opposite: the axis loses digits
    // Opposite directions: any half turn across them.
    const Eigen::Quaterniond half = turn_between(a, -3 * a);
    EXPECT_NEAR(half.norm(), 1, 1e-14);
    EXPECT_LT((half * a.normalized() + a.normalized()).norm(), 1e-7);
  }
}

TEST(Rigid, ChainsCancel) {
  std::mt19937_64 random(1);
  const Rigid c_from_b = random_rigid(random), b_from_a = random_rigid(random);
  const Vector3 x = random_vector(random, 1);
  EXPECT_LT(((c_from_b * b_from_a) * x - c_from_b * (b_from_a * x)).norm(), 1e-15);
  EXPECT_LT((matrix_from_rigid(inverse(b_from_a) * b_from_a) - Matrix4::Identity()).norm(), 1e-15);
}

TEST(Rotation, VectorAndMatrixAgreeAtEveryAngle) {
  std::mt19937_64 random(2);
  for (const double angle : {0.0, 1e-12, 1e-8, 0.9e-4, 1.1e-4, 1e-3, 0.5, 2.0, pi - 1e-3, pi - 1e-7}) {
    const Vector3 v = angle * random_vector(random, 1).normalized();
    const Matrix3 r = rotation_from_vector<double>(v);
    EXPECT_LT((r * r.transpose() - Matrix3::Identity()).norm(), 4e-15) << angle;
    EXPECT_LT((vector_from_rotation(r) - v).norm(), 1e-8 * std::max(angle, 1e-3)) << angle;
    EXPECT_LT((r - Eigen::AngleAxisd(angle, angle > 0 ? Vector3(v.normalized()) : Vector3::UnitX()).toRotationMatrix())
                  .norm(),
              1e-14);
  }
}

TEST(Rotation, HalfTurnGivesOneOfTwoVectors) {
  const Matrix3 r = rotation_from_vector<double>(Vector3(0, pi, 0));
  EXPECT_NEAR(vector_from_rotation(r).norm(), pi, 1e-12);
  EXPECT_LT((rotation_from_vector<double>(vector_from_rotation(r)) - r).norm(), 1e-12);
}

TEST(FixedAngles, AreRzRyRx) {
  const double roll = 0.3, pitch = -0.5, yaw = 1.2;
  const Matrix3 expected = (Eigen::AngleAxisd(yaw, Vector3::UnitZ()) * Eigen::AngleAxisd(pitch, Vector3::UnitY()) *
                            Eigen::AngleAxisd(roll, Vector3::UnitX()))
                               .toRotationMatrix();
  EXPECT_LT((rotation_from_rpy({roll, pitch, yaw}) - expected).norm(), 1e-15);
}

TEST(FixedAngles, AreTheirOwnInverse) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> angle(-pi, pi), half(-pi / 2, pi / 2);
  for (int i = 0; i < 1000; ++i) {
    const double yaw = angle(random), pitch = half(random), roll = angle(random);
    const Vector3 rpy(roll, pitch, yaw);
    EXPECT_LT((rpy_from_rotation(rotation_from_rpy(rpy)) - rpy).norm(), 1e-9);
  }
}

TEST(FixedAngles, AtGimbalLockTheRotationIsKept) {
  for (const double pitch : {pi / 2, -pi / 2}) {
    const Matrix3 r = rotation_from_rpy({0.4, pitch, -0.9});
    const Vector3 rpy = rpy_from_rotation(r);
    EXPECT_NEAR(std::abs(rpy.y()), pi / 2, 1e-7);
    EXPECT_LT((rotation_from_rpy(rpy) - r).norm(), 1e-7);
  }
}

TEST(SmallMotion, BetweenIsItsInverse) {
  std::mt19937_64 random(4);
  const Rigid a = random_rigid(random);
  Vector6 v;
  v << random_vector(random, 0.1), random_vector(random, 0.3);
  EXPECT_LT((small_motion_between(a, small_motion<double>(v) * a) - v).norm(), 1e-14);
  EXPECT_LT((small_motion<double>(v).translation - v.head<3>()).norm(), 0.0 + 1e-18);  // not the SE(3) exponential
}

TEST(Adjoint, CarriesAMotionRateToAnotherFrame) {
  std::mt19937_64 random(5);
  const Rigid b_from_a = random_rigid(random);
  Vector6 rate_in_a;
  rate_in_a << random_vector(random, 1), random_vector(random, 1);
  const Vector6 rate_in_b = adjoint(b_from_a) * rate_in_a;
  const Vector3 x = random_vector(random, 1);
  const Vector3 velocity_in_a = rate_in_a.head<3>() + Vector3(rate_in_a.tail<3>()).cross(x);
  const Vector3 x_in_b = b_from_a * x;
  EXPECT_LT(
      (b_from_a.rotation * velocity_in_a - rate_in_b.head<3>() - Vector3(rate_in_b.tail<3>()).cross(x_in_b)).norm(),
      1e-14);
}

TEST(AlignPoints, FindsTheMotionEvenFromAPlaneAndNeverAReflection) {
  std::mt19937_64 random(6);
  const Rigid b_from_a = random_rigid(random);
  Eigen::Matrix3Xd in_a(3, 4);
  in_a << 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0;
  const Eigen::Matrix3Xd in_b = (b_from_a.rotation * in_a).colwise() + b_from_a.translation;
  const Rigid found = align_points(in_b, in_a, Eigen::Vector4d(1, 2, 1, 0.5));
  EXPECT_LT((matrix_from_rigid(found) - matrix_from_rigid(b_from_a)).norm(), 1e-14);
  EXPECT_NEAR(found.rotation.determinant(), 1, 1e-14);
}

}  // namespace
}  // namespace handsight
