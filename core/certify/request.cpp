// SPDX-License-Identifier: Apache-2.0
#include "certify/request.h"

#include <algorithm>
#include <set>

#include "correct/calibrated_robot.h"
#include "effects/term_numbers.h"

namespace handsight {
namespace {

CertificateRequest request_of(CalibratedRobot robot, const std::string& software, const std::string& model_from) {
  CertificateRequest request;
  request.effects = robot.calibration.effects;
  request.software = software;
  request.model_from = model_from;
  robot = with_moved_hand(std::move(robot));
  request.chain = robot.chain;
  request.prediction = robot.model;
  return request;
}

/// Terms as a fit takes them again: those with a sigma are estimated from where they are, the others held.
void add_terms(const PredictionModel& model, FitOptions& options) {
  const std::vector<Eigen::Index> first = first_numbers(model.effects, 6);
  for (std::size_t t = 0; t < model.effects.size(); ++t) {
    EffectTerm term = model.effects[t];
    term.held.assign(term.values.size(), 0);
    bool is_free_at_all = false;
    for (std::size_t p = 0; p < term.values.size(); ++p) {
      const Eigen::Index number = first[t] + static_cast<Eigen::Index>(p);
      term.held[p] = !(model.covariance(number, number) > 0);
      is_free_at_all = is_free_at_all || is_free(term_effect(term), term, p);
    }
    (is_free_at_all ? options.estimated : options.effects).push_back(std::move(term));
  }
}

bool was_of_its_session(const EffectTerm& term) {
  static const std::set<std::string> ids{"body_slip", "marker_slip", "mount_slip", "mount_drift", "time_lag"};
  return ids.contains(term.id);
}

}  // namespace

CertificateRequest certificate_request(const Session& session, const Fit& fit, const FitOptions& options,
                                       const ModelUncertainty& model_uncertainty, const std::string& software,
                                       const std::string& model_from) {
  CertificateRequest request =
      request_of(calibrated_robot(session, fit, {}, options, software, model_uncertainty), software, model_from);
  request.model.options = options;
  request.model.options.on_iteration = nullptr;
  request.model.model_uncertainty = model_uncertainty;
  return request;
}

bool is_of_session(const Calibration& c, const Session& session) {
  std::vector<Eigen::VectorXd> used;
  for (const Observation& o : session.observations)
    if (is_used(o)) used.push_back(o.position);
  if (c.positions.empty())
    return c.session == session.title && c.fit.observations == static_cast<int>(session.observations.size());
  // Poses that both have: a part of the session is part of it.
  return std::any_of(c.positions.begin(), c.positions.end(), [&](const Eigen::VectorXd& p) {
    return std::any_of(used.begin(), used.end(),
                       [&](const Eigen::VectorXd& u) { return u.size() == p.size() && u == p; });
  });
}

CertificateRequest certificate_request(const Session& session, const Calibration& calibration,
                                       const std::filesystem::path& file, const std::string& software) {
  const CalibratedRobot robot =
      calibrated_robot(calibration, session.robot, session.robot_file, file.filename().string());
  if (robot.joint_names != session.joints)
    throw InputError(
        message("{}: is of the joints {}, and the session has {}; certify with a calibration of the same "
                "robot.",
                file.filename().string(), fmt::join(robot.joint_names, " "), fmt::join(session.joints, " ")));
  const bool is_own = is_of_session(calibration, session);
  CertificateRequest request =
      request_of(robot, software,
                 fmt::format("{} of {}, {}", file.filename().string(), calibration.created,
                             is_own ? "its numbers estimated again for each group of held-out observations"
                                    : "made from other observations, its numbers held as they are"));
  request.calibration = file;
  if (is_own) {
    add_terms(robot.model, request.model.options);
    // What is doubted is reported in the order of the model's terms, which held ones among them would change.
    if (request.model.options.effects.empty()) request.model.model_uncertainty = robot.model.model_uncertainty;
    return request;
  }
  request.model.options.effects = robot.model.effects;
  std::erase_if(request.model.options.effects, was_of_its_session);
  request.model.of_file = request.prediction;
  return request;
}

}  // namespace handsight
