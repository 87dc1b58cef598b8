// SPDX-License-Identifier: Apache-2.0
#include "estimation/export.h"

#include <ctime>

#include "estimation/prediction.h"

namespace handsight {

namespace {

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace

Calibration calibration_of(const Session& session, const Fit& fit, const FitReport& told, const FitOptions&,
                           const std::string& software) {
  Calibration c;
  c.session = session.title;
  c.created = utc_now();
  c.software = software;
  c.tcp_from_body = {fit.tcp_from_body, fit.covariance};
  c.fit = {told.observations,
           told.used,
           static_cast<int>(told.rejected.size()),
           told.fitted.rms_pixel,
           told.held_out.rms_pixel,
           {},
           told.fitted.rms_m,
           told.held_out.rms_m,
           {},
           fit.chi2_per_dof};
  (session.is_tracker() ? c.fit.noise_m : c.fit.noise_pixel) = fit.noise;
  c.markers = fit.markers_in_body;
  for (std::size_t m = 0; m < fit.problem.marker_is_seen.size(); ++m)
    if (!fit.problem.marker_is_seen[m]) c.unseen_markers.push_back(static_cast<int>(m));
  for (const FittedEffect& fitted : fit.effects) {
    const EffectTerm& term = fitted.term;
    const Effect* effect = find_effect(term.id);
    CalibrationEffect* listed = nullptr;
    for (CalibrationEffect& e : c.effects)
      if (e.id == term.id) listed = &e;
    if (!listed) listed = &c.effects.emplace_back(CalibrationEffect{term.id, {}});
    const std::string of = place_name(*effect, term.joint, session.robot);
    for (std::size_t p = 0; p < effect->parameters.size(); ++p)
      listed->parameters.push_back(
          {of, effect->parameters[p].name, term.values[p], fitted.sigmas[p], effect->parameters[p].unit});
  }
  c.tcp = session.tcp;
  c.mount = session.mount.link;
  c.gravity = session.gravity;
  c.joints = session.joints;
  if (session.mount.estimate)
    c.mount_from_sensor =
        EstimatedMotion{estimate(fit).mount_from_sensor,
                        fit.parameter_covariance.block<6, 6>(fit.problem.mount_column(), fit.problem.mount_column())};
  const TcpScatter scatter = tcp_scatter(fit);
  if (scatter.observations >= 3) c.tcp_scatter = scatter.covariance;
  return c;
}

}  // namespace handsight
