// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/hand_end.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "effects/own_effect.h"
#include "effects/term_numbers.h"

namespace handsight {
namespace {

bool is_carried(const Robot& robot, int link) {
  const std::vector<int> joints = joints_to(robot, link);
  return std::any_of(joints.begin(), joints.end(),
                     [&](int j) { return robot.joints[static_cast<std::size_t>(j)].moves(); });
}

bool moves_nothing(const JointChange& c) {
  return c.angle == 0 && c.multiplier_error == 0 && c.share == 0 && c.frame.isZero(0) && c.after.isZero(0) &&
         c.compliance == 0 && c.lateral_compliance == 0 && c.gap == 0;
}

/// Does a term move the robot itself, not what stands at the chain's ends? A payload hangs at the TCP link, which
/// stands still here.
bool moves_robot(const EffectTerm& term, const Chain& chain) {
  const Effect& effect = term_effect(term);
  if (effect.definition) {
    constexpr std::array<std::string_view, 3> ends{"hand_", "body_", "mount_"};
    return std::any_of(effect.definition->moves.begin(), effect.definition->moves.end(), [&](const DefinedMove& m) {
      return std::none_of(ends.begin(), ends.end(), [&](std::string_view end) { return m.site.starts_with(end); });
    });
  }
  EffectTerm one = term;
  for (std::size_t p = 0; p < one.values.size(); ++p)
    if (!effect.parameters[p].is_choice) one.values[p] = effect.parameters[p].sigma;
  ObservationState c = states_at(chain, Eigen::VectorXd::Constant(static_cast<Eigen::Index>(chain.joints.size()), 0.3));
  c.velocity.setConstant(1);
  c.approach.setConstant(1);
  const RobotChange change = moved_sites(c, {one}).robot;
  return !std::all_of(change.joints.begin(), change.joints.end(), moves_nothing) || change.tilt_x != 0 ||
         change.tilt_y != 0 || !change.base_compliance.isZero(0);
}

/// Places of the numbers of xi and of the terms that move the robot, among those of all terms; the others are left out
/// of `terms`.
std::vector<Eigen::Index> keep_robot_terms(const Chain& chain, std::vector<EffectTerm>& terms,
                                           std::vector<Eigen::Index> places, Eigen::Index offset) {
  const std::vector<Eigen::Index> first = first_numbers(terms, offset);
  std::vector<EffectTerm> kept;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (!moves_robot(terms[t], chain)) continue;
    for (Eigen::Index i = first[t]; i < first[t + 1]; ++i) places.push_back(i);
    kept.push_back(terms[t]);
  }
  terms = std::move(kept);
  return places;
}

/// Leaves the terms at the ends out. Of the target's place, which `doubt` speaks of first, the hand does not depend.
PredictionModel of_robot_alone(PredictionModel model, const Chain& chain) {
  const Eigen::Index all = first_numbers(model.effects, 6).back();
  const std::vector<Eigen::Index> places = keep_robot_terms(chain, model.effects, {0, 1, 2, 3, 4, 5}, 6);
  model.covariance = Eigen::MatrixXd(model.covariance(places, places));
  model.rotation_is_observed = true;
  if (!model.model_uncertainty.is_any()) return model;
  const std::vector<Eigen::Index> with_others = keep_robot_terms(chain, model.model_uncertainty.others, places, all);
  model.model_uncertainty.covariance = Eigen::MatrixXd(model.model_uncertainty.covariance(with_others, with_others));
  model.model_uncertainty.covariance.topRows<6>().setZero();
  model.model_uncertainty.covariance.leftCols<6>().setZero();
  return model;
}

}  // namespace

bool hand_carries_sensor(const Chain& chain) {
  return !is_carried(chain.robot, chain.tcp_link) && is_carried(chain.robot, chain.mount_link);
}

Chain chain_of_hand(const Chain& chain) {
  Chain exchanged = chain;
  std::swap(exchanged.tcp_link, exchanged.mount_link);
  return exchanged;
}

Eigen::MatrixXd hand_covariance(const Fit& fit) {
  const Problem& p = fit.problem;
  const std::vector<Eigen::Index> first_of_term = first_numbers(p.terms, 6);
  Eigen::MatrixXd by_columns = Eigen::MatrixXd::Zero(first_of_term.back(), fit.parameter_covariance.cols());
  // M exp(s) = exp(Ad(M) s) M
  by_columns.block<6, 6>(0, p.mount_column()) = adjoint(estimate(fit).mount_from_sensor);
  for (std::size_t c = 0; c < p.columns_of_effects.size(); ++c) {
    const EffectColumn& column = p.columns_of_effects[c];
    by_columns(first_of_term[column.term] + static_cast<Eigen::Index>(column.parameter),
               p.effect_column() + static_cast<Eigen::Index>(c)) = 1;
  }
  const Eigen::MatrixXd covariance = by_columns * fit.parameter_covariance * by_columns.transpose();
  return 0.5 * (covariance + covariance.transpose());
}

TcpRepeatability hand_repeatability(const Fit& fit) {
  return tcp_repeatability(fit, [&](const ProblemObservation& o) {
    const Rigid& mount_from_sensor = estimate(fit).mount_from_sensor;
    // The hand errs by E where the target seems to by D: E mount_from_tcp D = mount_from_tcp.
    return Matrix6(-adjoint(mount_from_sensor * sensor_from_tcp_at(o, mount_from_sensor)));
  });
}

std::optional<PredictionModel> model_of_hand(const Fit& fit, const ModelUncertainty& model_uncertainty) {
  if (!fit.problem.mount_is_estimated) return std::nullopt;
  PredictionModel model{list_terms(fit), hand_repeatability(fit), hand_covariance(fit), estimate(fit).mount_from_sensor,
                        fit.tcp_from_body};
  model.model_uncertainty = model_uncertainty;
  return of_robot_alone(std::move(model), fit.problem.source->chain);
}

std::optional<PredictionModel> model_of_hand(const Calibration& calibration, const Chain& chain) {
  if (!calibration.mount_from_sensor) return std::nullopt;
  Calibration exchanged = calibration;
  std::swap(exchanged.tcp_from_body, *exchanged.mount_from_sensor);
  const Matrix6 to_mount = adjoint(exchanged.tcp_from_body.motion);
  exchanged.tcp_from_body.covariance = to_mount * exchanged.tcp_from_body.covariance * to_mount.transpose();
  exchanged.model_covariance = calibration.hand_covariance;
  exchanged.tcp_repeatability = calibration.hand_repeatability;
  return of_robot_alone(prediction_model(exchanged, chain.robot), chain);
}

}  // namespace handsight
