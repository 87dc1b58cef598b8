// SPDX-License-Identifier: Apache-2.0
#include "compare/calibrated_sides.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "base/error.h"

namespace handsight {
namespace {

/// The inverse of a covariance; what has none in it is held.
Eigen::MatrixXd precision_of(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd sizes = covariance.diagonal().cwiseMax(1e-18).cwiseSqrt();
  Eigen::MatrixXd scaled = sizes.cwiseInverse().asDiagonal() * covariance * sizes.cwiseInverse().asDiagonal();
  scaled.diagonal().array() += 1e-9;
  const Eigen::MatrixXd inverse = scaled.ldlt().solve(Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols()));
  return sizes.cwiseInverse().asDiagonal() * inverse * sizes.cwiseInverse().asDiagonal();
}

/// What the calibration says of xi, mount and effects, in prior sigmas; choices have none.
Eigen::MatrixXd known_covariance(const CalibratedRobot& before, const Problem& p) {
  std::vector<Eigen::Index> kept{0, 1, 2, 3, 4, 5};
  Eigen::Index number = 6;
  for (const EffectTerm& t : before.model.effects)
    for (std::size_t i = 0; i < t.values.size(); ++i, ++number)
      if (!term_effect(t).parameters[i].is_choice) kept.push_back(number);
  Eigen::MatrixXd covariance = before.model.covariance(kept, kept);
  for (Eigen::Index e = 0; e < p.effect_count(); ++e) {
    const double size = p.columns_of_effects[static_cast<std::size_t>(e)].sigma;
    covariance.row(6 + e) /= size;
    covariance.col(6 + e) /= size;
  }
  const Eigen::Index mount = p.mount_is_estimated ? 6 : 0, count = covariance.rows() + mount;
  Eigen::MatrixXd known = Eigen::MatrixXd::Zero(count, count);
  known.topLeftCorner(6, 6) = covariance.topLeftCorner(6, 6);
  if (mount > 0) known.block(6, 6, 6, 6) = before.calibration.mount_from_sensor->covariance;
  const Eigen::Index numbers = covariance.rows() - 6;
  known.bottomRightCorner(numbers, numbers) = covariance.bottomRightCorner(numbers, numbers);
  known.topRightCorner(6, numbers) = covariance.topRightCorner(6, numbers);
  known.bottomLeftCorner(numbers, 6) = covariance.bottomLeftCorner(numbers, 6);
  return known;
}

}  // namespace

Session as_calibrated(const CalibratedRobot& before, const Session& after) {
  if (after.is_touch())
    throw InputError(
        "A calibration does not say where what is touched stood; name the earlier session of touches in its place.");
  Session session = after;
  session.marker_count = std::max(session.marker_count, static_cast<int>(before.calibration.markers.size()));
  if (session.tcp != before.tcp || session.mount.link != before.mount || session.joints != before.joint_names)
    throw InputError(
        "The session's TCP, mount or joints are not those of the calibration; name a session of the same robot.");
  if (static_cast<int>(before.calibration.markers.size()) < session.marker_count)
    throw InputError(
        message("The session has {} markers, the calibration {}; name a session with the same marker body.",
                session.marker_count, before.calibration.markers.size()));
  if (!before.model.mount_from_sensor && session.mount.estimate && !session.mount.known)
    throw InputError("Neither the calibration nor the session says where the sensor sits: a few poses cannot tell it.");
  session.mount.estimate = before.calibration.mount_from_sensor.has_value();
  if (before.model.mount_from_sensor) session.mount.mount_from_sensor = *before.model.mount_from_sensor;
  return session;
}

ComparedSides make_sides(const CalibratedRobot& before, const Session& session, const Chain& chain) {
  ComparedSides sides;
  sides.after.problem = make_problem(session, chain, {}, before.model.effects);
  const Problem& p = sides.after.problem;
  if (p.observations.empty())
    throw InputError("The session has no observation with markers that can be used; label some poses.");
  sides.after.weight =
      1 / (session.is_tracker() ? session.sigma_point.value_or(before.calibration.fit.noise_m.value_or(2e-4))
                                : session.sigma_pixel.value_or(before.calibration.fit.noise_pixel.value_or(0.2)));
  for (const Vector3& m : before.calibration.markers)
    sides.start.markers_in_tcp.push_back(before.model.tcp_from_body * m);
  sides.start.mount_from_sensor = session.mount.mount_from_sensor;
  sides.start.effects = effect_values(p);
  sides.known = precision_of(known_covariance(before, p));
  // The scatter is reported in the TCP's axes, at its origin; here it is that of the body against the sensor.
  if (!before.model.repeatability.covariance.isZero(0)) {
    const Matrix6 there = adjoint(sensor_from_tcp_at(p.observations.front(), sides.start.mount_from_sensor));
    sides.repeatability = there * before.model.repeatability.covariance * there.transpose();
  }
  return sides;
}

}  // namespace handsight
