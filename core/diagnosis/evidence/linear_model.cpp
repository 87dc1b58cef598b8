// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/linear_model.h"

#include <Eigen/QR>
#include <cmath>

#include "base/threads.h"
#include "chain/sighting.h"
#include "estimation/problem/column_products.h"
#include "estimation/problem/robot_scale.h"
#include "estimation/solvers/normal_equations.h"
#include "estimation/solvers/priors.h"

namespace handsight {
namespace {

constexpr double metres_per_radian = 0.3;  // a sliding joint's repeatability beside that of a turning one

/// Candidates that act on cameras or single markers, in the order of their columns.
std::vector<Eigen::Index> direct_columns(const Problem& problem, Eigen::Index base_effects) {
  std::vector<char> direct(static_cast<std::size_t>(problem.effect_count()), 0);
  for (Eigen::Index c = 0; c < problem.cameras_by_effect.cols(); ++c)
    if (!problem.cameras_by_effect.col(c).isZero(0)) direct[static_cast<std::size_t>(c)] = 1;
  for (const ProblemObservation& o : problem.observations)
    for (const EffectMotion::MarkerColumn& m : o.motion.markers) direct[static_cast<std::size_t>(m.column)] = 1;
  std::vector<Eigen::Index> columns;
  for (Eigen::Index c = base_effects; c < problem.effect_count(); ++c)
    if (direct[static_cast<std::size_t>(c)]) columns.push_back(c);
  return columns;
}

/// The rows of one observation before they are parted: body motion 6 | base, direct candidates, error.
struct Rows {
  Eigen::MatrixXd by_body;
  Eigen::MatrixXd rest;
};

class Builder {
 public:
  Builder(const Problem& problem, const Unknowns& unknowns, Eigen::Index base_effects, double noise)
      : p_(problem), u_(unknowns), base_effects_(base_effects), noise_(noise) {
    direct_ = direct_columns(problem, base_effects);
    model_.base = p_.effect_column() + base_effects;
    place_of_.assign(static_cast<std::size_t>(p_.effect_count()), -1);
    for (std::size_t i = 0; i < direct_.size(); ++i)
      place_of_[static_cast<std::size_t>(direct_[i])] = static_cast<Eigen::Index>(i);
    cameras_.resize(p_.cameras_by_effect.rows(),
                    p_.cameras_by_effect.cols() > 0 ? static_cast<Eigen::Index>(direct_.size()) : 0);
    for (Eigen::Index i = 0; i < cameras_.cols(); ++i)
      cameras_.col(i) = p_.cameras_by_effect.col(direct_[static_cast<std::size_t>(i)]);
  }

  LinearModel build() {
    const Eigen::Index candidates = p_.effect_count() - base_effects_;
    Eigen::Index total = 0;
    for (const ProblemObservation& o : p_.observations) total += std::min<Eigen::Index>(6, take_rows(o));
    if (holds_robot_scale(p_)) ++total;
    model_.external.resize(total, model_.base + candidates);
    model_.external_error.resize(total);
    const Eigen::Index inner = model_.base + static_cast<Eigen::Index>(direct_.size()) + 1;
    model_.internal = Eigen::MatrixXd::Zero(inner, inner);
    add_observations();
    add_robot_scale();
    model_.external.conservativeResize(next_, Eigen::NoChange);
    model_.external_error.conservativeResize(next_);
    add_shape();
    add_camera_images();
    model_.internal = Eigen::MatrixXd(model_.internal.selfadjointView<Eigen::Lower>());
    scale_and_weigh();
    return std::move(model_);
  }

 private:
  static Eigen::Index take_rows(const ProblemObservation& o) {
    Eigen::Index rows = 0;
    for (const Sighting& s : o.sightings) rows += row_count(s);
    return rows;
  }

  /// Body motions, base columns without the motions of its effects, direct candidates, error.
  Rows rows_at(const ProblemObservation& o, const Rigid& sensor_from_tcp) const {
    Rows rows;
    const Eigen::Index inner = model_.internal.cols();
    rows.by_body.resize(take_rows(o), 6);
    rows.rest = Eigen::MatrixXd::Zero(rows.by_body.rows(), inner);
    const bool base_is_direct = p_.cameras_by_effect.cols() > 0 || !o.motion.markers.empty();
    Eigen::Index row = 0;
    for (const Sighting& s : o.sightings) {
      const Vector3 x = sensor_from_tcp * marker_at(o, u_, s.marker);
      const SightingResidual r = sighting_residual(p_.rig_or_null(), s, x);
      rows.by_body.middleRows(row, r.rows) = by_motion(r.by_point, x);
      const SightingRows<3> by_marker = r.by_point * sensor_from_tcp.rotation;
      rows.rest.block(row, 3 * s.marker, r.rows, 3) = by_marker;
      rows.rest.col(inner - 1).segment(row, r.rows) = r.error;
      auto direct = rows.rest.block(row, model_.base, r.rows, static_cast<Eigen::Index>(direct_.size()));
      if (cameras_.cols() > 0) direct = camera_columns(*p_.rig, s, x) * cameras_;
      for (const EffectMotion::MarkerColumn& m : o.motion.markers) {
        const Eigen::Index place = place_of_[static_cast<std::size_t>(m.column)];
        if (m.marker == s.marker && place >= 0) direct.col(place) += by_marker * m.direction;
      }
      if (base_is_direct && base_effects_ > 0)
        rows.rest.block(row, p_.effect_column(), r.rows, base_effects_) =
            direct_by_effects(p_, o, s, r, x, sensor_from_tcp.rotation).leftCols(base_effects_);
      row += r.rows;
    }
    return rows;
  }

  /// One observation's rows, parted in the external ones (the first part.count) and the internal ones below.
  struct Parted {
    LinearObservation part;
    Eigen::MatrixXd rest;        // as in Rows
    Eigen::MatrixXd candidates;  // external rows by the candidates
  };

  const Joint& joint_of(Eigen::Index place) const {
    const Chain& chain = p_.source->chain;
    return chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(place)])];
  }

  Parted parted(const ProblemObservation& o) const {
    const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u_);
    Rows rows = rows_at(o, sensor_from_tcp);
    const Eigen::Matrix<double, 6, Eigen::Dynamic> motion = motion_by_columns(p_, o, u_);
    const Eigen::Index mount = p_.effect_column() - p_.mount_column();
    rows.rest.middleCols(p_.mount_column(), mount + base_effects_) +=
        rows.by_body * motion.leftCols(mount + base_effects_);

    Parted parted;
    LinearObservation& part = parted.part;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
    qr.setThreshold(1e-9);
    qr.compute(rows.by_body);
    part.count = qr.rank();
    rows.rest.applyOnTheLeft(qr.householderQ().adjoint());
    part.by_body = Eigen::MatrixXd(qr.matrixR().topRows(part.count).template triangularView<Eigen::Upper>()) *
                   qr.colsPermutation().transpose();
    part.sensor_from_tcp = sensor_from_tcp;
    const Rigid sensor_from_root = inverse(o.root_from_mount * find_mount(o, u_) * o.sensor_motion);
    part.joint_motions = adjoint(sensor_from_root) * o.motion.tcp_by_value;
    // A problem without effects has no motions by joints.
    for (Eigen::Index j = 0; j < part.joint_motions.cols(); ++j)
      if (joint_of(j).kind == JointKind::prismatic) part.joint_motions.col(j) *= metres_per_radian;
    part.by_joints = part.by_body * part.joint_motions / noise_;

    parted.candidates = part.by_body * motion.rightCols(p_.effect_count() - base_effects_);
    for (std::size_t i = 0; i < direct_.size(); ++i)
      parted.candidates.col(direct_[i] - base_effects_) +=
          rows.rest.col(model_.base + static_cast<Eigen::Index>(i)).head(part.count);
    part.by_body /= noise_;
    part.internal = static_cast<int>(rows.rest.rows() - part.count);
    part.internal_squares = rows.rest.bottomRows(part.internal).rightCols<1>().squaredNorm() / (noise_ * noise_);
    parted.rest = std::move(rows.rest);
    return parted;
  }

  void take(Parted parted, GatheredRows& inner_rows) {
    LinearObservation& part = parted.part;
    part.first = next_;
    auto external = model_.external.middleRows(next_, part.count);
    external.leftCols(model_.base) = parted.rest.topRows(part.count).leftCols(model_.base);
    external.rightCols(model_.candidates()) = parted.candidates;
    model_.external_error.segment(next_, part.count) = parted.rest.rightCols<1>().head(part.count);
    next_ += part.count;
    if (part.internal > 0) inner_rows.add(parted.rest.bottomRows(part.internal));
    model_.rows += static_cast<int>(parted.rest.rows());
    model_.internal_rows += part.internal;
    model_.observations.push_back(std::move(part));
  }

  /// Some at a time: what they leave before it is put together takes as much memory as the whole.
  void add_observations() {
    constexpr std::size_t at_once = 64, worth_threads = 16;
    GatheredRows inner_rows(model_.internal);
    for (std::size_t first = 0; first < p_.observations.size(); first += at_once) {
      std::vector<Parted> some(std::min(at_once, p_.observations.size() - first));
      each_part(static_cast<int>(some.size()), some.size() >= worth_threads, [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        some[at] = parted(p_.observations[first + at]);
      });
      for (Parted& one : some) take(std::move(one), inner_rows);
    }
    inner_rows.settle();
  }

  /// What is known of the markers' shape is one more measurement, that no motion of the body moves.
  void add_shape() {
    if (!p_.has_shape_prior()) return;
    Prior prior = shape_prior(p_, u_.markers_in_tcp);
    const double to_noise = noise_ * noise_ / (p_.noise * p_.noise);
    const Eigen::Index count = prior.gradient.size(), error = model_.internal.cols() - 1;
    model_.internal.topLeftCorner(count, count) += to_noise * prior.information;
    model_.internal.row(error).head(count) += to_noise * prior.gradient.transpose();
    model_.internal(error, error) += to_noise * prior.cost;
  }

  /// So are images of a board, of the cameras.
  void add_camera_images() {
    if (!learns_from_camera_images(p_) || base_effects_ == 0) return;
    const Prior prior = camera_prior(p_);
    const Eigen::Index at = p_.effect_column(), error = model_.internal.cols() - 1;
    const double weight = noise_ * noise_;
    model_.internal.block(at, at, base_effects_, base_effects_) +=
        weight * prior.information.topLeftCorner(base_effects_, base_effects_);
    model_.internal.row(error).segment(at, base_effects_) += weight * prior.gradient.head(base_effects_).transpose();
    model_.internal(error, error) += weight * prior.cost;
  }

  /// So are the robot's own lengths where nothing else tells one: a row that belongs to no observation.
  void add_robot_scale() {
    if (!holds_robot_scale(p_)) return;
    const Eigen::RowVectorXd by_effect = noise_ / robot_scale_sigma * p_.robot_scale->by_effect.transpose();
    auto row = model_.external.row(next_);
    row.setZero();
    row.tail(by_effect.size()) = by_effect;
    model_.external_error[next_] = -noise_ * p_.robot_scale->change / robot_scale_sigma;
    ++next_;
  }

  void scale_and_weigh() {
    model_.external /= noise_;
    model_.external_error /= noise_;
    model_.internal /= noise_ * noise_;
    model_.internal_of.assign(static_cast<std::size_t>(model_.candidates()), -1);
    for (Eigen::Index c = 0; c < model_.candidates(); ++c) {
      const double sigma = p_.columns_of_effects[static_cast<std::size_t>(base_effects_ + c)].sigma;
      model_.external.col(model_.base + c) *= sigma;
      const Eigen::Index place = place_of_[static_cast<std::size_t>(base_effects_ + c)];
      if (place < 0) continue;
      model_.internal_of[static_cast<std::size_t>(c)] = model_.base + place;
      model_.internal.row(model_.base + place) *= sigma;
      model_.internal.col(model_.base + place) *= sigma;
    }
    model_.prior.precision = model_.prior.gradient = Eigen::VectorXd::Zero(model_.base);
    for (Eigen::Index c = 0; c < base_effects_; ++c) {
      const double plausible = p_.columns_of_effects[static_cast<std::size_t>(c)].sigma;
      const double sigma = plausible * times_prior_sigma(u_.effects[c] / plausible);
      const Eigen::Index column = p_.effect_column() + c;
      model_.external.col(column) *= sigma;
      model_.internal.row(column) *= sigma;
      model_.internal.col(column) *= sigma;
      model_.prior.precision[column] = 1;
      model_.prior.gradient[column] = -u_.effects[c] / sigma;
      model_.prior.cost += std::pow(u_.effects[c] / sigma, 2);
    }
  }

  const Problem& p_;
  const Unknowns& u_;
  Eigen::Index base_effects_;
  double noise_;
  std::vector<Eigen::Index> direct_;
  std::vector<Eigen::Index> place_of_;  // per effect column: among the direct candidates, or -1
  Eigen::MatrixXd cameras_;             // the rig's numbers by direct candidates
  LinearModel model_;
  Eigen::Index next_ = 0;
};

}  // namespace

double times_prior_sigma(double in_prior_sigmas) {
  constexpr double not_surprising = 3;
  return std::max(1.0, std::abs(in_prior_sigmas) / not_surprising);
}

LinearModel linear_model(const Problem& problem, const Unknowns& unknowns, Eigen::Index base_effects, double noise) {
  return Builder(problem, unknowns, base_effects, noise).build();
}

}  // namespace handsight
