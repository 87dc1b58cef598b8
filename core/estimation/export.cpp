// SPDX-License-Identifier: Apache-2.0
#include "estimation/export.h"

#include <algorithm>
#include <ctime>

#include "effects/term_numbers.h"
#include "effects/units.h"
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

/// The terms of a fit as elements of a file: those of one effect together, in the order in which the effects first
/// stand; the second term of an effect at a place is in the effect's second element, and so on.
std::vector<std::vector<std::size_t>> terms_by_element(const std::vector<FittedEffect>& all) {
  std::vector<std::string> ids;
  std::vector<std::vector<std::vector<std::size_t>>> elements;  // by effect
  for (std::size_t t = 0; t < all.size(); ++t) {
    const EffectTerm& term = all[t].term;
    const auto found = static_cast<std::size_t>(std::find(ids.begin(), ids.end(), term.id) - ids.begin());
    if (found == ids.size()) {
      ids.push_back(term.id);
      elements.emplace_back();
    }
    std::size_t earlier = 0;  // terms of the effect at the same place
    for (std::size_t s = 0; s < t; ++s) earlier += all[s].term.id == term.id && all[s].term.joint == term.joint;
    if (elements[found].size() <= earlier) elements[found].resize(earlier + 1);
    elements[found][earlier].push_back(t);
  }
  std::vector<std::vector<std::size_t>> list;
  for (auto& of_effect : elements) list.insert(list.end(), of_effect.begin(), of_effect.end());
  return list;
}

void set_effects(const Session& session, const Fit& fit, Calibration& c) {
  const std::vector<Eigen::Index> first_of_term = first_numbers(terms_of(fit), 6);
  std::vector<Eigen::Index> place_of{0, 1, 2, 3, 4, 5};  // of the file's numbers in the fit's
  for (const std::vector<std::size_t>& element : terms_by_element(fit.effects)) {
    CalibrationEffect& written = c.effects.emplace_back();
    for (const std::size_t t : element) {
      const FittedEffect& fitted = fit.effects[t];
      const Effect& effect = effect_of(fitted.term);
      written.id = effect.id;
      const auto is_told = [&](const EffectDefinition& d) { return d.id == effect.id; };
      if (effect.definition && std::none_of(c.definitions.begin(), c.definitions.end(), is_told))
        c.definitions.push_back(*effect.definition);
      const std::string of = place_name(effect, fitted.term.joint, session.robot);
      for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
        const EffectParameter& parameter = effect.parameters[p];
        written.parameters.push_back({of, parameter.name, fitted.term.values[p], fitted.sigmas[p],
                                      unit_at(effect, p, fitted.term.joint, session.robot)});
        place_of.push_back(first_of_term[t] + static_cast<Eigen::Index>(p));
      }
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
  if (!c.effects.empty()) c.times = times_of(session);
  if (session.mount.estimate)
    c.mount_from_sensor =
        EstimatedMotion{estimate(fit).mount_from_sensor,
                        fit.parameter_covariance.block<6, 6>(fit.problem.mount_column(), fit.problem.mount_column())};
  const TcpScatter scatter = tcp_scatter(fit);
  if (scatter.observations >= 3) c.tcp_scatter = scatter.covariance;
  return c;
}

}  // namespace handsight
