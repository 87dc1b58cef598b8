// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/export.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/utc_now.h"
#include "chain/body_frame.h"
#include "effects/term_numbers.h"
#include "effects/units.h"
#include "estimation/fit/part_fit.h"
#include "estimation/report/hand_end.h"
#include "estimation/report/part_report.h"

namespace handsight {

namespace {

/// Terms as elements of a file: those of one effect together, in the order in which the effects first stand; the second
/// term of an effect at a place is in the effect's second element, and so on.
std::vector<std::vector<std::size_t>> terms_by_element(const std::vector<EffectTerm>& all) {
  std::vector<std::string> ids;
  std::vector<std::vector<std::vector<std::size_t>>> elements;  // by effect
  for (std::size_t t = 0; t < all.size(); ++t) {
    const EffectTerm& term = all[t];
    const auto found = static_cast<std::size_t>(std::find(ids.begin(), ids.end(), term.id) - ids.begin());
    if (found == ids.size()) {
      ids.push_back(term.id);
      elements.emplace_back();
    }
    std::size_t earlier = 0;  // terms of the effect at the same place
    for (std::size_t s = 0; s < t; ++s) earlier += all[s].id == term.id && all[s].place == term.place;
    if (elements[found].size() <= earlier) elements[found].resize(earlier + 1);
    elements[found][earlier].push_back(t);
  }
  std::vector<std::vector<std::size_t>> list;
  for (auto& of_effect : elements) list.insert(list.end(), of_effect.begin(), of_effect.end());
  return list;
}

struct WrittenTerms {
  std::vector<CalibrationEffect> effects;
  std::vector<Eigen::Index> number_of;  // of each parameter of the file, among those of the terms
};

/// `sigmas`: of the terms' numbers, one after the other.
WrittenTerms written(const std::vector<EffectTerm>& terms, const std::vector<double>& sigmas, const Robot& robot,
                     std::vector<EffectDefinition>& definitions) {
  const std::vector<Eigen::Index> first_of_term = first_numbers(terms);
  WrittenTerms w;
  for (const std::vector<std::size_t>& element : terms_by_element(terms)) {
    CalibrationEffect& one = w.effects.emplace_back();
    for (const std::size_t t : element) {
      const Effect& effect = term_effect(terms[t]);
      one.id = effect.id;
      const auto is_reported = [&](const EffectDefinition& d) { return d.id == effect.id; };
      if (effect.definition && std::none_of(definitions.begin(), definitions.end(), is_reported))
        definitions.push_back(*effect.definition);
      const std::string of = place_name(effect, terms[t].place, robot);
      for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
        const Eigen::Index number = first_of_term[t] + static_cast<Eigen::Index>(p);
        one.parameters.push_back({of, effect.parameters[p].name, terms[t].values[p],
                                  sigmas[static_cast<std::size_t>(number)], unit_at(effect, p, terms[t].place, robot)});
        w.number_of.push_back(number);
      }
    }
  }
  return w;
}

/// Places of a file's numbers among a fit's: xi, then those of its terms.
std::vector<Eigen::Index> after_xi(const std::vector<Eigen::Index>& number_of) {
  std::vector<Eigen::Index> locate{0, 1, 2, 3, 4, 5};
  for (const Eigen::Index number : number_of) locate.push_back(6 + number);
  return locate;
}

void set_effects(const Session& session, const Fit& fit, Calibration& c) {
  std::vector<double> sigmas;
  for (const FittedEffect& e : fit.effects) sigmas.insert(sigmas.end(), e.sigmas.begin(), e.sigmas.end());
  WrittenTerms own = written(list_terms(fit), sigmas, session.robot, c.definitions);
  c.effects = std::move(own.effects);
  if (c.effects.empty()) return;
  const std::vector<Eigen::Index> locate = after_xi(own.number_of);
  const auto in_file = [&](const Eigen::MatrixXd& of_fit) -> std::optional<Eigen::MatrixXd> {
    if (of_fit.cols() != static_cast<Eigen::Index>(locate.size())) return std::nullopt;
    return of_fit(locate, locate);
  };
  c.model_covariance = in_file(fit.model_covariance);
  if (session.mount.estimate && hand_carries_sensor(fit.problem.source->chain))
    c.hand_covariance = in_file(hand_covariance(fit));
}

/// The positions of the used observations; of very many some that are spread over them.
std::vector<Eigen::VectorXd> used_positions(const Session& session) {
  constexpr std::size_t most = 300;
  std::vector<Eigen::VectorXd> all, some;
  for (const Observation& o : session.observations)
    if (is_used(o)) all.push_back(o.position);
  if (all.size() <= most) return all;
  for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * all.size() / most]);
  return some;
}

}  // namespace

void set_model_uncertainty(const Robot& robot, const std::vector<EffectTerm>& terms,
                           const ModelUncertainty& model_uncertainty, Calibration& c) {
  c.model_uncertainty.reset();
  if (!model_uncertainty.is_any()) return;
  const Eigen::Index numbers = first_numbers(terms).back();
  std::vector<EffectDefinition> known = c.definitions;
  std::vector<Eigen::Index> locate =
      after_xi(written(terms, std::vector<double>(static_cast<std::size_t>(numbers)), robot, known).number_of);
  std::vector<double> sigmas;
  for (Eigen::Index i = 6 + numbers; i < model_uncertainty.covariance.cols(); ++i)
    sigmas.push_back(std::sqrt(std::max(model_uncertainty.covariance(i, i), 0.0)));
  WrittenTerms others = written(model_uncertainty.others, sigmas, robot, c.definitions);
  for (const Eigen::Index number : others.number_of) locate.push_back(6 + numbers + number);
  c.model_uncertainty = CalibrationUncertainty{std::move(others.effects), model_uncertainty.covariance(locate, locate)};
}

namespace {

/// The same effect at the same place, with the same choices?
bool is_same(const EffectTerm& a, const EffectTerm& b) {
  if (a.id != b.id || a.place != b.place || a.values.size() != b.values.size()) return false;
  const Effect& effect = term_effect(a);
  for (std::size_t p = 0; p < a.values.size(); ++p)
    if (effect.parameters[p].is_choice && a.values[p] != b.values[p]) return false;
  return true;
}

/// A fit whose effects have those that may be there as well beside them, and the doubt for its covariance.
Fit with_others(const Fit& fit, const ModelUncertainty& model_uncertainty) {
  Fit with = fit;
  for (const EffectTerm& t : model_uncertainty.others) {
    const Effect& effect = term_effect(t);
    for (std::size_t p = 0; p < t.values.size(); ++p)
      if (!effect.parameters[p].is_choice)
        with.problem.columns_of_effects.push_back({with.problem.terms.size(), p, effect.parameters[p].sigma});
    with.problem.terms.push_back(t);
  }
  with.parameter_covariance = model_uncertainty.of_columns;
  return with;
}

/// What the choice of the effects of all sessions leaves open of one of them, whose fit is `own`.
ModelUncertainty model_uncertainty_of_part(const Session& joined, const Fit& with_others, int number, const Fit& own) {
  const Fit found = fit_of_part(joined, with_others, number).fit;
  const std::vector<EffectTerm> all = list_terms(found);
  const std::vector<Eigen::Index> first = first_numbers(all, 6);
  std::vector<Eigen::Index> places{0, 1, 2, 3, 4, 5};
  const auto add = [&](std::size_t t) {
    for (Eigen::Index n = first[t]; n < first[t + 1]; ++n) places.push_back(n);
  };
  std::vector<char> is_own(all.size(), 0);
  for (const EffectTerm& t : list_terms(own)) {
    const auto at = std::find_if(all.begin(), all.end(), [&](const EffectTerm& o) { return is_same(t, o); });
    check(at != all.end(), "{} of a session is not among those of all", t.id);
    const auto i = static_cast<std::size_t>(at - all.begin());
    is_own[i] = 1;
    add(i);
  }
  ModelUncertainty model_uncertainty;
  for (std::size_t t = 0; t < all.size(); ++t) {
    if (is_own[t]) continue;
    model_uncertainty.others.push_back(all[t]);
    add(t);
  }
  // Turns that nothing shows are in the fit's own covariance.
  const BodyFrame frame = body_frame(found.sides, estimate(found).markers_in_tcp);
  const Eigen::Index markers = frame.motion_by_markers.cols();
  Eigen::MatrixXd covariance = found.model_covariance;
  covariance.topLeftCorner<6, 6>() = frame.motion_by_markers *
                                     found.parameter_covariance.topLeftCorner(markers, markers) *
                                     frame.motion_by_markers.transpose();
  model_uncertainty.covariance = covariance(places, places);
  return model_uncertainty;
}

/// Of a collection: each part by itself, the first one's beside.
Calibration calibration_of_parts(const Session& joined, const Fit& fit, const FitReport& reported,
                                 const FitOptions& options, const std::string& software,
                                 const ModelUncertainty& model_uncertainty) {
  const bool is_open = model_uncertainty.of_columns.size() > 0;
  const Fit open = is_open ? with_others(fit, model_uncertainty) : Fit();
  std::vector<Calibration> sessions;
  const std::vector<PartReport> reports = part_reports(joined, fit, reported);
  for (std::size_t p = 0; p < reports.size(); ++p) {
    const PartFit part = fit_of_part(joined, fit, static_cast<int>(p));
    const ModelUncertainty own =
        is_open ? model_uncertainty_of_part(joined, open, static_cast<int>(p), part.fit) : ModelUncertainty();
    sessions.push_back(make_calibration(part.session, part.fit, make_report(reports[p]), options, software, own));
  }
  Calibration all = sessions.front();
  all.session = joined.title;
  all.sessions = std::move(sessions);
  return all;
}

}  // namespace

Calibration make_calibration(const Session& session, const Fit& fit, const FitReport& reported,
                             const FitOptions& options, const std::string& software,
                             const ModelUncertainty& model_uncertainty) {
  if (session.is_touch()) {  // one hand, whatever it touches
    const PartFit part = fit_of_part(session, fit, 0);
    Calibration c = make_calibration(part.session, part.fit, reported, options, software);
    c.session = session.title;
    if (!c.effects.empty()) c.times = list_times(session);
    c.positions = used_positions(session);
    return c;
  }
  if (!session.parts.empty()) return calibration_of_parts(session, fit, reported, options, software, model_uncertainty);
  Calibration c;
  c.session = session.title;
  c.created = utc_now();
  c.software = software;
  c.tcp_from_body = {fit.tcp_from_body, fit.covariance};
  c.fit = {reported.observations,
           reported.used,
           static_cast<int>(reported.rejected.size()),
           reported.fitted.rms_pixel,
           reported.held_out.rms_pixel,
           {},
           reported.fitted.rms_m,
           reported.held_out.rms_m,
           {},
           fit.chi2_per_dof};
  (session.is_tracker() ? c.fit.noise_m : c.fit.noise_pixel) = fit.noise;
  c.markers = fit.markers_in_body;
  for (std::size_t m = 0; m < fit.problem.marker_is_seen.size(); ++m)
    if (!fit.problem.marker_is_seen[m]) c.unseen_markers.push_back(static_cast<int>(m));
  set_effects(session, fit, c);
  set_model_uncertainty(session.robot, list_terms(fit), model_uncertainty, c);
  c.tcp = session.tcp;
  c.mount = session.mount.link;
  c.gravity = session.gravity;
  c.joints = session.joints;
  if (!c.effects.empty()) c.times = list_times(session);
  if (!session.robot.is_of_poses) c.positions = used_positions(session);
  if (session.mount.estimate)
    c.mount_from_sensor =
        EstimatedMotion{estimate(fit).mount_from_sensor,
                        fit.parameter_covariance.block<6, 6>(fit.problem.mount_column(), fit.problem.mount_column())};
  const TcpRepeatability repeatability = tcp_repeatability(fit);
  if (repeatability.observations >= 3) c.tcp_repeatability = repeatability.covariance;
  if (!session.mount.estimate || !hand_carries_sensor(fit.problem.source->chain)) return c;
  if (const TcpRepeatability of_hand = hand_repeatability(fit); of_hand.observations >= 3)
    c.hand_repeatability = of_hand.covariance;
  return c;
}

}  // namespace handsight
