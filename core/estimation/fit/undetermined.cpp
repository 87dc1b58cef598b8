// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/undetermined.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "chain/unknown_angle.h"
#include "estimation/solvers/inverse_parts.h"

namespace handsight {
namespace {

constexpr double least_turn = 1e-3, least_shift = 1e-4;  // rad and m: less is no motion of a hand

/// Of several sessions or fixtures each has a mount of its own: their frames' directions are not those of one sensor.
bool is_of_parts(const Fit& fit) { return !fit.problem.source->chain.parts.empty(); }

/// The rotation that a motion of the markers in the TCP's frame has on the whole.
Vector3 turn_of(const std::vector<Vector3>& markers, const Eigen::VectorXd& shifts) {
  Vector3 middle = Vector3::Zero(), shift = Vector3::Zero();
  const auto count = static_cast<double>(markers.size());
  for (std::size_t m = 0; m < markers.size(); ++m) {
    middle += markers[m] / count;
    shift += shifts.segment<3>(3 * static_cast<Eigen::Index>(m)) / count;
  }
  Matrix3 spread = 1e-12 * Matrix3::Identity();
  Vector3 moment = Vector3::Zero();
  for (std::size_t m = 0; m < markers.size(); ++m) {
    const Vector3 arm = markers[m] - middle;
    spread += arm.squaredNorm() * Matrix3::Identity() - arm * arm.transpose();
    moment += arm.cross(Vector3(shifts.segment<3>(3 * static_cast<Eigen::Index>(m)) - shift));
  }
  return spread.ldlt().solve(moment);
}

/// The turns of body and sensor by each direction of the unknowns: 6 x directions.
Eigen::MatrixXd turns_of(const Problem& problem, const Unknowns& u, const Eigen::MatrixXd& directions) {
  Eigen::MatrixXd turns = Eigen::MatrixXd::Zero(6, directions.cols());
  for (Eigen::Index i = 0; i < directions.cols(); ++i) {
    turns.col(i).head<3>() = turn_of(u.markers_in_tcp, directions.col(i));
    if (problem.mount_is_estimated) turns.col(i).tail<3>() = directions.col(i).segment<3>(problem.mount_column() + 3);
  }
  return turns;
}

/// The longest way of a marker or of the sensor.
double measure_length(const Problem& problem, const Eigen::VectorXd& direction) {
  double length = 1e-300;
  for (Eigen::Index m = 0; m < problem.marker_count; ++m) length = std::max(length, direction.segment<3>(3 * m).norm());
  if (problem.mount_is_estimated) length = std::max(length, direction.segment<3>(problem.mount_column()).norm());
  return length;
}

/// The same space, parted in shifts and what turns besides; each column as long as what is not known.
Eigen::MatrixXd parted(const Problem& problem, const Unknowns& u, const Eigen::MatrixXd& directions) {
  Eigen::MatrixXd unit = directions;
  for (Eigen::Index i = 0; i < unit.cols(); ++i) unit.col(i) /= unit.col(i).norm();
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(turns_of(problem, u, unit), Eigen::ComputeFullV);
  constexpr double least = 1e-5;
  const Eigen::Index turning = (svd.singularValues().array() > least).count();
  Eigen::MatrixXd turned = unit * svd.matrixV().leftCols(turning);
  Eigen::MatrixXd shifted = unit * svd.matrixV().rightCols(unit.cols() - turning);
  if (shifted.cols() > 0) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(shifted);
    shifted = qr.householderQ() * Eigen::MatrixXd::Identity(shifted.rows(), shifted.cols());
    turned -= shifted * (shifted.transpose() * turned);
  }
  const Eigen::MatrixXd turns = turns_of(problem, u, turned);
  for (Eigen::Index i = 0; i < turned.cols(); ++i)
    turned.col(i) *=
        std::sqrt(unknown_angle_variance) / std::max(turns.col(i).head<3>().norm(), turns.col(i).tail<3>().norm());
  for (Eigen::Index i = 0; i < shifted.cols(); ++i)
    shifted.col(i) *= unknown_length / measure_length(problem, shifted.col(i));
  Eigen::MatrixXd all(directions.rows(), directions.cols());
  all << turned, shifted;
  return all;
}

}  // namespace

void add_undetermined_columns(const Fit& fit, Eigen::MatrixXd& factor) {
  const Solution& s = fit.solution;
  if (s.unobservable == 0 || is_of_parts(fit)) return;
  const InverseParts parts = inverse_parts(s.basis.transpose() * s.normal.information * s.basis);
  std::vector<Eigen::Index> none;
  for (Eigen::Index i = 0; i < parts.inverse.size(); ++i)
    if (!(parts.inverse[i] > 0) && !parts.half.col(i).isZero(0)) none.push_back(i);
  if (none.empty()) return;
  const Eigen::MatrixXd columns = parted(fit.problem, s.unknowns, s.basis * parts.half(Eigen::all, none));
  factor.conservativeResize(Eigen::NoChange, factor.cols() + columns.cols());
  factor.rightCols(columns.cols()) = columns;
}

UndeterminedMotions undetermined_motions(const Matrix6& covariance) {
  constexpr double nothing_known = 1;  // m^2, rad^2
  constexpr double touched = 1e-3;
  UndeterminedMotions motions;
  motions.directions.resize(6, 0);
  const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(covariance);
  for (int i = 0; i < 6; ++i) {
    if (!(eigen.eigenvalues()[i] > nothing_known)) continue;
    motions.directions.conservativeResize(Eigen::NoChange, motions.directions.cols() + 1);
    motions.directions.rightCols<1>() = eigen.eigenvectors().col(i);
  }
  for (int i = 0; i < 6; ++i)
    motions.numbers[static_cast<std::size_t>(i)] =
        motions.is_any() && motions.directions.row(i).cwiseAbs().maxCoeff() > touched;
  return motions;
}

Matrix6 body_covariance_at_origin(const Fit& fit) {
  Matrix6 at_origin = Matrix6::Identity();
  at_origin.topRightCorner<3, 3>() = -cross_matrix(fit.tcp_from_body.translation);
  return at_origin * fit.covariance * at_origin.transpose();
}

Matrix6 mount_covariance_at_origin(const Fit& fit) {
  const Eigen::Index mount = fit.problem.mount_column();
  Matrix6 turned = Matrix6::Zero();
  turned.topLeftCorner<3, 3>() = turned.bottomRightCorner<3, 3>() = estimate(fit).mount_from_sensor.rotation;
  return turned * fit.parameter_covariance.block<6, 6>(mount, mount) * turned.transpose();
}

namespace {

Message axis_text(Vector3 axis, bool of_tcp) {
  constexpr double along = 0.9999;
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  if (axis[largest] > along || axis[largest] < -along)
    return of_tcp ? message("the TCP's {}", "xyz"[largest]) : message("the {} of the mount's link", "xyz"[largest]);
  if (axis[largest] < 0) axis = -axis;
  const std::string numbers = fmt::format("{:.2f} {:.2f} {:.2f}", axis.x() + 0.0, axis.y() + 0.0, axis.z() + 0.0);
  return of_tcp ? message("({}) of the TCP", numbers) : message("({}) of the mount's link", numbers);
}

/// As what is across the third, where there are two.
Message across_text(const std::vector<Vector3>& axes, bool of_tcp) {
  return axis_text(axes[0].cross(axes[1]).normalized(), of_tcp);
}

Message place_text(const std::vector<Vector3>& axes, bool of_tcp) {
  if (axes.size() >= 3) return "its place";
  return axes.size() == 1 ? message("its place along {}", axis_text(axes[0], of_tcp))
                          : message("its place across {}", across_text(axes, of_tcp));
}

Message turn_text(const std::vector<Vector3>& axes, bool of_tcp) {
  if (axes.size() >= 3) return "its turn";
  return axes.size() == 1 ? message("its turn about {}", axis_text(axes[0], of_tcp))
                          : message("its turn but about {}", across_text(axes, of_tcp));
}

/// "its place along the TCP's z", "its turn about the TCP's z".
std::vector<Message> motions_texts(const UndeterminedMotions& motions, bool of_tcp) {
  constexpr double turns = 0.1;
  std::vector<Vector3> shifts, axes;
  for (Eigen::Index i = 0; i < motions.directions.cols(); ++i) {
    const Vector3 shift = motions.directions.col(i).head<3>(), turn = motions.directions.col(i).tail<3>();
    if (turn.norm() > turns)
      axes.push_back(turn.normalized());
    else
      shifts.push_back(shift.normalized());
  }
  std::vector<Message> texts;
  if (!shifts.empty()) texts.push_back(place_text(shifts, of_tcp));
  if (!axes.empty()) texts.push_back(turn_text(axes, of_tcp));
  return texts;
}

/// What the hand does against the sensor's link from observation to observation.
struct HandMotion {
  int turned_axes = 0;  // about how many axes it turns: 0, 1, more
  bool shifts = false;
};

HandMotion hand_motion(const Problem& problem) {
  HandMotion motion;
  if (problem.observations.empty()) return motion;
  const auto mount_from_tcp = [](const ProblemObservation& o) { return inverse(o.root_from_mount) * o.root_from_tcp; };
  const Rigid first = mount_from_tcp(problem.observations.front());
  Vector3 axis = Vector3::Zero();
  for (const ProblemObservation& o : problem.observations) {
    const Rigid now = mount_from_tcp(o);
    const Vector3 turn = vector_from_rotation(Matrix3(now.rotation * first.rotation.transpose()));
    motion.shifts = motion.shifts || (now.translation - first.translation).norm() > least_shift;
    if (turn.norm() < least_turn) continue;
    if (motion.turned_axes == 0) axis = turn.normalized();
    motion.turned_axes = std::max(motion.turned_axes, turn.cross(axis).norm() > least_turn ? 2 : 1);
  }
  return motion;
}

Message reason_text(const Problem& problem) {
  const HandMotion motion = hand_motion(problem);
  if (motion.turned_axes == 0 && !motion.shifts) return "the hand stands in one and the same pose in all observations";
  if (motion.turned_axes == 0) return "no pose turns the hand";
  if (motion.turned_axes == 1) return "every pose turns the hand about the same axis";
  return "these poses do not show it";
}

}  // namespace

std::vector<Message> undetermined_texts(const Fit& fit) {
  std::vector<Message> texts;
  if (is_of_parts(fit)) return texts;
  const bool has_mount = fit.problem.mount_is_estimated && fit.parameter_covariance.cols() > 0;
  const UndeterminedMotions body =
      fit.rotation_is_observed ? undetermined_motions(body_covariance_at_origin(fit)) : UndeterminedMotions{};
  const UndeterminedMotions mount =
      has_mount ? undetermined_motions(mount_covariance_at_origin(fit)) : UndeterminedMotions{};
  const Message reason =
      reason_text(fit.problem) + (mount.is_any() ? "; the sensor's mount and the body can move together" : "");
  for (const Message& what : motions_texts(body, true))
    texts.push_back(
        message("TCP->Body is not determined in {}: {}. Its numbers there are where the fit began.", what, reason));
  for (const Message& what : motions_texts(mount, false))
    texts.push_back(message(
        "The sensor's mount is not determined in {}: {}. Its numbers there are where the fit began.", what, reason));
  return texts;
}

bool never_moved(const Fit& fit) {
  if (is_of_parts(fit)) return false;
  const HandMotion motion = hand_motion(fit.problem);
  return fit.problem.mount_is_estimated && motion.turned_axes == 0 && !motion.shifts;
}

}  // namespace handsight
