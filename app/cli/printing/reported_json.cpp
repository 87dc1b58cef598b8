// SPDX-License-Identifier: Apache-2.0
#include "reported_json.h"

namespace handsight::cli {

Json check_json(const Session& session, const SessionCheck& check) {
  return {{"contents", check.contents},
          {"warnings", check.warnings},
          {"problems", check.problems},
          {"notes", session.notes}};
}

Json attribution_json(const ErrorAttribution& attribution) {
  return {{"cameras", attribution.cameras}, {"body", attribution.body}, {"robot", attribution.robot}};
}

Json prediction_json(const TcpPrediction& p, bool rotation_is_observed) {
  Json sigma = numbers(p.sigma());
  for (std::size_t i = 3; i < 6 && !rotation_is_observed; ++i) sigma[i] = nullptr;
  return {{"root_from_tcp", motion(p.root_from_tcp)},
          {"root_from_tcp_est", motion(p.root_from_tcp_est)},
          {"root_from_body_est", motion(p.root_from_body_est)},
          {"root_from_sensor_est", p.root_from_sensor_est ? motion(*p.root_from_sensor_est) : Json(nullptr)},
          {"sigma", sigma}};
}

Json correction_json(const Eigen::VectorXd& commanded, const Correction& c) {
  return {{"position", numbers(commanded)},
          {"corrected", numbers(c.position)},
          {"error_before_m", number(c.error_before_m)},
          {"error_after_m", number(c.error_after_m)},
          {"error_before_rad", number(c.error_before_rad)},
          {"error_after_rad", number(c.error_after_rad)},
          {"sigma_m", number(c.sigma_m)},
          {"reached", c.reached}};
}

Eigen::VectorXd commanded_position(const ObservationState& c) {
  Eigen::VectorXd position(static_cast<Eigen::Index>(c.chain->joints.size()));
  for (Eigen::Index i = 0; i < position.size(); ++i)
    position[i] = c.sensor[c.chain->joints[static_cast<std::size_t>(i)]];
  return position;
}

}  // namespace handsight::cli
