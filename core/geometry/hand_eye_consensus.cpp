// SPDX-License-Identifier: Apache-2.0
#include "geometry/hand_eye_consensus.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "base/median.h"

namespace handsight {
namespace {

constexpr std::size_t fewest_rows = 8;
constexpr int draws = 600;
constexpr double lever = 0.3;          // m: how far off a turn is felt
constexpr double least_turn = 0.1;     // rad: a motion that turns less says little of axes
constexpr double most_unlike = 0.1;    // rad: by which the turns of a motion may differ
constexpr double least_spread = 0.05;  // of the sine between two axes
constexpr double at_least = 0.005;     // rad: what agrees, however exact the others are
constexpr double times_usual = 3;      // what others leave

/// What A and B moved between two rows: M_a X = X M_b.
struct Motion {
  Rigid a, b;
  Vector3 turn_a, turn_b;
};

Motion motion_between(const std::vector<Rigid>& a, const std::vector<Rigid>& b, std::size_t i, std::size_t j) {
  Motion m{inverse(a[j]) * a[i], b[j] * inverse(b[i]), {}, {}};
  m.turn_a = vector_from_rotation(m.a.rotation);
  m.turn_b = vector_from_rotation(m.b.rotation);
  return m;
}

bool may_be_one_motion(const Motion& m) {
  return std::min(m.turn_a.norm(), m.turn_b.norm()) > least_turn &&
         std::abs(m.turn_a.norm() - m.turn_b.norm()) < most_unlike;
}

Matrix3 nearest_turn(const Matrix3& sum) {
  const Eigen::JacobiSVD<Matrix3> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * Vector3(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

/// By motions about two axes at least.
Rigid solve_by_axes(const std::vector<Motion>& motions) {
  Matrix3 sum = Matrix3::Zero(), normal = 1e-12 * Matrix3::Identity();
  for (const Motion& m : motions) sum += m.turn_a * m.turn_b.transpose();
  const Vector3 across_a = motions[0].turn_a.cross(motions[1].turn_a),
                across_b = motions[0].turn_b.cross(motions[1].turn_b);
  if (motions.size() == 2) sum += across_a * across_b.transpose();  // two axes say the third
  Rigid x{nearest_turn(sum), Vector3::Zero()};
  Vector3 right = Vector3::Zero();
  for (const Motion& m : motions) {
    const Matrix3 of = m.a.rotation - Matrix3::Identity();
    normal += of.transpose() * of;
    right += of.transpose() * (x.rotation * m.b.translation - m.a.translation);
  }
  x.translation = normal.inverse() * right;
  return x;
}

/// Of turns about one axis: where it points, all towards the first's side.
Vector3 one_axis(const std::vector<Motion>& motions, Vector3 Motion::*turn) {
  Vector3 sum = Vector3::Zero();
  for (const Motion& m : motions) sum += m.*turn * (m.turn_a.dot(motions.front().turn_a) < 0 ? -1.0 : 1.0);
  return sum.normalized();
}

/// By motions about one axis: the turn about it and the place across it follow from how far things moved; the place
/// along it is 0.
Rigid solve_by_shifts(const std::vector<Motion>& motions) {
  const Vector3 axis = one_axis(motions, &Motion::turn_a);
  const Matrix3 to_axis = Eigen::Quaterniond::FromTwoVectors(one_axis(motions, &Motion::turn_b), axis).matrix();
  const Vector3 first = axis.unitOrthogonal(), second = axis.cross(first);
  const Eigen::Matrix<double, 2, 3> across =
      (Eigen::Matrix<double, 2, 3>() << first.transpose(), second.transpose()).finished();
  // (R_a - 1) place - Rot(angle) shift_b = -shift_a, of what lies across the axis; unknown: place, cos and sin.
  Eigen::Matrix4d normal = 1e-12 * Eigen::Matrix4d::Identity();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const Motion& m : motions) {
    const Vector2 shift_b = across * (to_axis * m.b.translation);
    Eigen::Matrix<double, 2, 4> row;
    row.leftCols<2>() = across * (m.a.rotation - Matrix3::Identity()) * across.transpose();
    row.col(2) = -shift_b, row.col(3) = Vector2(shift_b.y(), -shift_b.x());
    normal += row.transpose() * row;
    right -= row.transpose() * (across * m.a.translation);
  }
  const Eigen::Vector4d found = normal.ldlt().solve(right);
  const double angle = std::atan2(found[3], found[2]);
  Rigid x{Eigen::AngleAxisd(angle, axis).matrix() * to_axis, Vector3::Zero()};
  Eigen::Matrix2d of_place = 1e-12 * Eigen::Matrix2d::Identity();
  Vector2 place = Vector2::Zero();
  for (const Motion& m : motions) {
    const Eigen::Matrix2d turned = across * (m.a.rotation - Matrix3::Identity()) * across.transpose();
    of_place += turned.transpose() * turned;
    place += turned.transpose() * (across * (x.rotation * m.b.translation - m.a.translation));
  }
  x.translation = across.transpose() * of_place.ldlt().solve(place);
  return x;
}

/// Do all turns go about one axis?
bool have_one_axis(const std::vector<Motion>& motions) {
  Matrix3 spread = Matrix3::Zero();
  for (const Motion& m : motions) spread += m.turn_a * m.turn_a.transpose();
  const Vector3 along = Eigen::SelfAdjointEigenSolver<Matrix3>(spread, Eigen::EigenvaluesOnly).eigenvalues();
  return along[1] < least_spread * least_spread * along[2];
}

Rigid solve(const std::vector<Motion>& motions) {
  return have_one_axis(motions) ? solve_by_shifts(motions) : solve_by_axes(motions);
}

/// The middle of these rows' A_i X B_i.
Rigid middle_of(const std::vector<Rigid>& all, const std::vector<std::size_t>& rows) {
  Matrix3 sum = Matrix3::Zero();
  Vector3 place = Vector3::Zero();
  for (const std::size_t i : rows) sum += all[i].rotation, place += all[i].translation;
  return {nearest_turn(sum), place / static_cast<double>(rows.size())};
}

/// How far each row is from the middle of some.
std::vector<double> left_of(const std::vector<Rigid>& a, const std::vector<Rigid>& b, const Rigid& x,
                            const std::vector<std::size_t>& rows) {
  std::vector<Rigid> all;
  for (std::size_t i = 0; i < a.size(); ++i) all.push_back(a[i] * x * b[i]);
  const Rigid middle = middle_of(all, rows);
  std::vector<double> left;
  for (const Rigid& one : all)
    left.push_back(std::hypot(vector_from_rotation(Matrix3(middle.rotation.transpose() * one.rotation)).norm(),
                              (one.translation - middle.translation).norm() / lever));
  return left;
}

std::vector<std::size_t> rows_within(const std::vector<double>& left, double most) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < left.size(); ++i)
    if (left[i] <= most) rows.push_back(i);
  return rows;
}

/// Of each two rows that turn against each other.
std::vector<Motion> motions_of(const std::vector<Rigid>& a, const std::vector<Rigid>& b,
                               const std::vector<std::size_t>& rows) {
  std::vector<Motion> motions;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = i + 1; k < rows.size(); ++k)
      if (const Motion m = motion_between(a, b, rows[i], rows[k]); m.turn_a.norm() > 0.5 * least_turn)
        motions.push_back(m);
  return motions;
}

struct Best {
  Rigid x;
  double half = 1e300;
  std::vector<std::size_t> rows;
};

void try_triple(const std::vector<Rigid>& a, const std::vector<Rigid>& b, const std::array<std::size_t, 3>& rows,
                Best& best) {
  const std::vector<Motion> two{motion_between(a, b, rows[0], rows[1]), motion_between(a, b, rows[0], rows[2])};
  if (!may_be_one_motion(two[0]) || !may_be_one_motion(two[1])) return;
  const Rigid x = solve(two);
  const double half = median(left_of(a, b, x, {rows.begin(), rows.end()}));
  if (half < best.half) best = {x, half, {rows.begin(), rows.end()}};
}

}  // namespace

std::size_t HandEyeConsensus::count() const {
  return static_cast<std::size_t>(std::count(agrees.begin(), agrees.end(), true));
}

std::optional<HandEyeConsensus> hand_eye_consensus(const std::vector<Rigid>& a, const std::vector<Rigid>& b) {
  const std::size_t count = std::min(a.size(), b.size());
  if (count < fewest_rows) return std::nullopt;
  Best best;
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::size_t> row(0, count - 1);
  for (int draw = 0; draw < draws; ++draw) {
    const std::array<std::size_t, 3> rows{row(random), row(random), row(random)};
    if (rows[0] != rows[1] && rows[0] != rows[2] && rows[1] != rows[2]) try_triple(a, b, rows, best);
  }
  if (best.rows.empty()) return std::nullopt;
  std::vector<double> left = left_of(a, b, best.x, best.rows);
  for (int pass = 0; pass < 6; ++pass) {
    std::vector<std::size_t> rows = rows_within(left, std::max(times_usual * median(left), at_least));
    if (pass > 0) {  // by what those leave that agree already, not by what half of all leave
      std::vector<double> of_these;
      for (const std::size_t i : best.rows) of_these.push_back(left[i]);
      rows = rows_within(left, std::max(times_usual * median(of_these), at_least));
    }
    const std::vector<Motion> motions = motions_of(a, b, rows);
    if (rows.size() < 3 || motions.size() < 3) break;
    best.x = solve(motions), best.rows = rows;
    left = left_of(a, b, best.x, best.rows);
  }
  HandEyeConsensus found{best.x, std::vector<bool>(count, false), 0};
  double sum = 0;
  for (const std::size_t i : best.rows) found.agrees[i] = true, sum += left[i] * left[i];
  found.left = std::sqrt(sum / static_cast<double>(best.rows.size()));
  return found;
}

}  // namespace handsight
