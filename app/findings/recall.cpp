// SPDX-License-Identifier: GPL-3.0-or-later
#include "findings/recall.h"

namespace handsight::app {
namespace {

/// x y z, then roll pitch yaw.
Vector6 six(const Rigid& motion) {
  Vector6 v;
  v << motion.translation, rpy_from_rotation(motion.rotation);
  return v;
}

}  // namespace

std::vector<OnlineStep> recalled_steps(const Session& session, const std::function<bool()>& goes_on) {
  std::vector<OnlineStep> steps;
  OnlineCalibration online(session);
  for (const Observation& o : session.observations) {
    if (!goes_on()) break;
    if (!is_used(o) || o.sightings.empty()) continue;
    Observation labelled = o;
    labelled.decision = Decision::none;
    steps.push_back(online.add(labelled, nullptr));
  }
  return steps;
}

widgets::ConvergencePoint convergence_point(const OnlineStep& step) {
  widgets::ConvergencePoint p{.count = static_cast<int>(step.kept), .observation = step.id};
  p.tcp_from_body = six(step.tcp_from_body);
  p.sigma = step.sigma;
  if (step.tcp_from_tcp_est) p.tcp_from_tcp_est = six(*step.tcp_from_tcp_est);
  // Every observation adds about as much: of one alone the variance is that of all times their number. Where the
  // variance is that of scatter, what is shown is more than noise as it is.
  if (!step.covariance_is_scatter) p.deviation_sigma = (p.count * step.covariance.diagonal()).cwiseMax(0).cwiseSqrt();
  return p;
}

std::vector<widgets::ConvergencePoint> list_convergence(const std::vector<OnlineStep>& steps) {
  std::vector<widgets::ConvergencePoint> points;
  for (const OnlineStep& step : steps)
    if (step.has_estimate && step.accepted) points.push_back(convergence_point(step));
  return points;
}

}  // namespace handsight::app
