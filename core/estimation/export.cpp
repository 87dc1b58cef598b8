// SPDX-License-Identifier: Apache-2.0
#include "estimation/export.h"

#include <algorithm>
#include <ctime>

#include "effects/term_numbers.h"
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

/// The terms of a fit, those of one effect together, in the order in which the effects first stand.
std::vector<std::size_t> terms_by_effect(const Fit& fit) {
  std::vector<std::size_t> order;
  const auto& all = fit.effects;
  for (std::size_t first = 0; first < all.size(); ++first) {
    if (std::find(order.begin(), order.end(), first) != order.end()) continue;
    for (std::size_t t = first; t < all.size(); ++t)
      if (all[t].term.id == all[first].term.id) order.push_back(t);
  }
  return order;
}

void set_effects(const Session& session, const Fit& fit, Calibration& c) {
  const std::vector<Eigen::Index> first_of_term = first_numbers(terms_of(fit), 6);
  std::vector<Eigen::Index> place_of{0, 1, 2, 3, 4, 5};  // of the file's numbers in the fit's
  for (const std::size_t t : terms_by_effect(fit)) {
    const FittedEffect& fitted = fit.effects[t];
    const Effect& effect = effect_of(fitted.term);
    if (c.effects.empty() || c.effects.back().id != effect.id) {
      c.effects.push_back({effect.id, {}});
      if (effect.definition) c.definitions.push_back(*effect.definition);
    }
    const std::string of = place_name(effect, fitted.term.joint, session.robot);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      const EffectParameter& parameter = effect.parameters[p];
      c.effects.back().parameters.push_back(
          {of, parameter.name, fitted.term.values[p], fitted.sigmas[p], parameter.unit});
      place_of.push_back(first_of_term[t] + static_cast<Eigen::Index>(p));
    }
  }
  if (!c.effects.empty() && fit.model_covariance.cols() == first_of_term.back())
    c.model_covariance = fit.model_covariance(place_of, place_of);
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
  set_effects(session, fit, c);
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
