// SPDX-License-Identifier: Apache-2.0
#include "geometry/hand_eye_misfit.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/median.h"

namespace handsight {
namespace {

constexpr double lever = 0.3;        // m: how far off a turn is felt
constexpr double least_turn = 0.05;  // rad: a motion that turns less says little
constexpr std::size_t most_poses = 30;
constexpr int passes = 8;

/// What both moved between two poses.
struct Motion {
  Rigid flange, target;
  Vector3 flange_turn, target_turn;
};

std::vector<std::size_t> spread(std::size_t count) {
  std::vector<std::size_t> places;
  const std::size_t taken = std::min(count, most_poses);
  for (std::size_t i = 0; i < taken; ++i) places.push_back(i * (count - 1) / std::max<std::size_t>(1, taken - 1));
  return places;
}

/// Of F_i X T_i = F_j X T_j (eye in hand), or of inverse(S) F_i Y = T_i for all i.
Motion motion_between(const Rigid& f_i, const Rigid& f_j, const Rigid& t_i, const Rigid& t_j, bool eye_in_hand) {
  Motion m;
  m.flange = inverse(f_j) * f_i;
  m.target = eye_in_hand ? t_j * inverse(t_i) : inverse(t_j) * t_i;
  m.flange_turn = vector_from_rotation(m.flange.rotation);
  m.target_turn = vector_from_rotation(m.target.rotation);
  return m;
}

/// Of residuals: what is many times the usual counts little.
std::vector<double> weights_of(const std::vector<double>& residuals, double least) {
  const double usual = std::max(median(residuals), least);
  std::vector<double> weights;
  for (const double r : residuals) weights.push_back(1 / (1 + r * r / (usual * usual)));
  return weights;
}

/// The rotation that turns the target's rotation vectors into the flange's.
Matrix3 turn_between(const std::vector<Motion>& motions, const std::vector<double>& weights) {
  Matrix3 sum = Matrix3::Zero();
  for (std::size_t i = 0; i < motions.size(); ++i)
    sum += weights[i] * motions[i].flange_turn * motions[i].target_turn.transpose();
  const Eigen::JacobiSVD<Matrix3> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * Vector3(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

double left_of_turns(const std::vector<Motion>& motions, Matrix3& turn) {
  std::vector<double> left;
  for (const Motion& m : motions) left.push_back(std::abs(m.flange_turn.norm() - m.target_turn.norm()));
  for (int pass = 0; pass < passes; ++pass) {
    turn = turn_between(motions, weights_of(left, 0.002));
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const Motion& m = motions[i];
      const Matrix3 carried = turn * m.target.rotation * turn.transpose();
      left[i] = vector_from_rotation(Matrix3(m.flange.rotation.transpose() * carried)).norm();
    }
  }
  return median(left);
}

double left_of_shifts(const std::vector<Motion>& motions, const Matrix3& turn) {
  std::vector<double> left(motions.size(), 0.0);
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<double> weights = weights_of(left, 0.001);
    Matrix3 normal = 1e-9 * Matrix3::Identity();
    Vector3 right = Vector3::Zero();
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const Matrix3 a = motions[i].flange.rotation - Matrix3::Identity();
      normal += weights[i] * a.transpose() * a;
      right += weights[i] * a.transpose() * (turn * motions[i].target.translation - motions[i].flange.translation);
    }
    const Vector3 place = normal.inverse() * right;
    for (std::size_t i = 0; i < motions.size(); ++i)
      left[i] = ((motions[i].flange.rotation - Matrix3::Identity()) * place -
                 (turn * motions[i].target.translation - motions[i].flange.translation))
                    .norm();
  }
  return median(left);
}

}  // namespace

Message misfit_text(const Misfit& misfit) {
  return message("{:.2g} degrees and {:.2g} mm", misfit.turn * 180 / std::numbers::pi, 1e3 * misfit.shift);
}

double Misfit::size() const { return std::hypot(turn, shift / lever); }

std::optional<Misfit> hand_eye_misfit(const std::vector<Rigid>& f, const std::vector<Rigid>& t, bool eye_in_hand) {
  const std::vector<std::size_t> places = spread(std::min(f.size(), t.size()));
  if (places.size() < 4) return std::nullopt;
  std::vector<Motion> motions;
  for (const std::size_t i : places)
    for (const std::size_t j : places) {
      if (j <= i) continue;
      const Motion m = motion_between(f[i], f[j], t[i], t[j], eye_in_hand);
      if (std::max(m.flange_turn.norm(), m.target_turn.norm()) > least_turn) motions.push_back(m);
    }
  if (motions.size() < 6) return std::nullopt;
  Misfit misfit;
  Matrix3 turn;
  misfit.turn = left_of_turns(motions, turn);
  misfit.shift = left_of_shifts(motions, turn);
  return misfit;
}

}  // namespace handsight
