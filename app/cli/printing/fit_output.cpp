// SPDX-License-Identifier: Apache-2.0
#include "fit_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/degrees.h"
#include "effects/units.h"
#include "estimation/fit/fit_covariance.h"
#include "estimation/fit/sure_fit.h"
#include "estimation/fit/touch_unknown.h"
#include "estimation/fit/undetermined.h"
#include "json_values.h"

namespace handsight::cli {
std::string text_or_unknown(const std::optional<double>& value, double scale, const char* unit) {
  return value ? fmt::format("{:.3f} {}", scale * *value, unit) : "unknown";
}

namespace {

std::string with_sigma(const char* name, double value, double sigma, const char* unit) {
  return fmt::format("  {:<6} {:>11.4f} +- {:<8.4f} {}", name, value + 0.0, sigma, unit);  // no minus before a zero
}

/// Place and turns of a pose with their sigmas; where nothing is known of a number, no figure stands beside it.
void print_pose(const Output& out, const Rigid& pose, const Matrix6& covariance, bool rotation_is_observed,
                const std::array<bool, 3>& is_untold = {}, bool accuracy_is_known = true) {
  const UndeterminedMotions unknown = undetermined_motions(covariance);
  const Vector6 sigma = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  const Vector3 rpy = degrees * rpy_from_rotation(pose.rotation);
  const char* names[] = {"x", "y", "z", "roll", "pitch", "yaw"};
  for (int i = 0; i < 6; ++i) {
    const bool is_place = i < 3;
    const double value = is_place ? 1e3 * pose.translation[i] : rpy[i - 3];
    if (is_place && !accuracy_is_known && !is_untold[static_cast<std::size_t>(i)])
      out.line(fmt::format("  {:<6} {:>11.4f} mm, how exactly is not known", names[i], value + 0.0));
    else if (unknown.numbers[static_cast<std::size_t>(i)] || (is_place && is_untold[static_cast<std::size_t>(i)]))
      out.line(fmt::format("  {:<6} {:>11.4f}    {}, left at its start", names[i], value + 0.0,
                           is_place || rotation_is_observed ? "not determined" : "not observed"));
    else
      out.line(with_sigma(names[i], value, (is_place ? 1e3 : degrees) * sigma[i], is_place ? "mm" : "deg"));
  }
}

Json parameters_json(const Session& session, const Fit& fit, const std::string& id) {
  Json list = Json::array();
  for (std::size_t t = 0; t < fit.effects.size(); ++t) {
    const FittedEffect& e = fit.effects[t];
    if (e.term.id != id) continue;
    const Effect* effect = &term_effect(e.term);
    for (std::size_t p = 0; p < effect->parameters.size(); ++p) {
      const bool is_told = !is_left_at_prior(session, fit, t, p);
      list.push_back(
          {{"of", e.term.place >= 0 ? Json(place_name(*effect, e.term.place, session.robot)) : Json(nullptr)},
           {"name", effect->parameters[p].name},
           {"value", is_told ? Json(e.term.values[p]) : Json(nullptr)},
           {"sigma", is_told ? number(e.sigmas[p]) : Json(nullptr)},
           {"unit", unit_at(*effect, p, e.term.place, session.robot)}});
      if (is_small(e.term)) list.back()["usual_size"] = e.term.size;
    }
  }
  return list;
}

Json effects_json(const Session& session, const Fit& fit) {
  const std::vector<FittedEffect>& effects = fit.effects;
  Json list = Json::array();
  const auto add = [&](const std::string& id, const EffectDefinition* definition) {
    Json parameters = parameters_json(session, fit, id);
    if (parameters.empty()) return;
    list.push_back({{"id", id}, {"parameters", parameters}});
    if (definition) list.back()["definition"] = effect_definition_text(*definition);
  };
  OwnEffects own;
  for (const FittedEffect& e : effects)
    if (e.term.own) own.push_back(e.term.own);
  for (const Effect* effect : catalogue_beside(own)) add(effect->id, nullptr);
  std::vector<std::string> reported;
  for (const FittedEffect& e : effects)
    if (e.term.own && std::find(reported.begin(), reported.end(), e.term.id) == reported.end()) {
      reported.push_back(e.term.id);
      add(e.term.id, e.term.own->definition.get());
    }
  return list;
}

void print_effects(const Output& out, const Session& session, const Fit& fit) {
  if (fit.effects.empty()) return;
  out.line();
  out.line("Effects in the model");
  for (std::size_t t = 0; t < fit.effects.size(); ++t) {
    const FittedEffect& e = fit.effects[t];
    const Effect& effect = term_effect(e.term);
    const std::string place = place_name(effect, e.term.place, session.robot);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      const std::string name = fmt::format("  {:<22} {:<12} {:<11}", e.term.id, place, effect.parameters[p].name);
      if (is_left_at_prior(session, fit, t, p)) {
        out.line(name + " not determined by these touches");
        continue;
      }
      out.line(fmt::format("{} {:>11.4g}{} {}{}", name, e.term.values[p],
                           e.sigmas[p] > 0 ? fmt::format(" +- {:<8.2g}", e.sigmas[p]) : std::string(" (held)    "),
                           unit_at(effect, p, e.term.place, session.robot),
                           is_small(e.term) ? ", a little at each joint" : ""));
    }
  }
}

Json errors_json(const ErrorSummary& e, const std::string& prefix) {
  return {{prefix + "rms_pixel", number(e.rms_pixel)},
          {prefix + "rms_m", number(e.rms_m)},
          {prefix + "mean_m", number(e.mean_m)}};
}

/// Of x y z (m) and the rotation vector (rad), from the noise; null where either is not known.
Json deviation_sigma(const Fit& fit, const ObservationReport& o) {
  if (!o.deviation || !fit.noise) return nullptr;
  return numbers(Vector6(*fit.noise * o.deviation->unit_covariance.diagonal().cwiseMax(0).cwiseSqrt()));
}

Json observations_json(const Fit& fit, const FitReport& reported) {
  Json list = Json::array();
  for (const ObservationReport& o : reported.per_observation)
    list.push_back({{"id", o.id},
                    {"rms_pixel", number(o.rms_pixel)},
                    {"rms_m", number(o.rms_m)},
                    {"tcp_from_tcp_est", o.deviation ? motion(o.deviation->tcp_from_tcp_est) : Json(nullptr)},
                    {"tcp_from_tcp_est_sigma", deviation_sigma(fit, o)},
                    {"outlier", o.outlier}});
  return list;
}

/// Where nothing is known: of which pose, along or about which axis.
void add_undetermined(const char* of, const std::string& frame, const Matrix6& covariance, Json& list) {
  const UndeterminedMotions motions = undetermined_motions(covariance);
  for (Eigen::Index i = 0; i < motions.directions.cols(); ++i)
    list.push_back({{"of", of},
                    {"in", frame},
                    {"shift", numbers(Vector3(motions.directions.col(i).head<3>()))},
                    {"turn", numbers(Vector3(motions.directions.col(i).tail<3>()))}});
}

/// Fixtures by name: along which axes a place is not determined has no meaning of a plane, say.
void add_undetermined_fixtures(const Session& session, const Fit& fit, Json& list) {
  const std::vector<char> are = undetermined_fixtures(session, fit);
  for (std::size_t f = 0; f < are.size(); ++f)
    if (are[f])
      list.push_back({{"of", session.fixtures[f].id},
                      {"in", find_mount(session, static_cast<int>(f)).link},
                      {"shift", nullptr},
                      {"turn", nullptr}});
}

Json undetermined_json(const Session& session, const Fit& fit) {
  Json list = Json::array();
  if (has_no_answer(fit)) return list;
  add_undetermined("tcp_from_body", session.tcp, body_covariance_at_origin(fit), list);
  if (session.is_touch()) {
    add_undetermined_fixtures(session, fit, list);
    return list;
  }
  if (session.mount.estimate)
    add_undetermined("mount_from_sensor", session.mount.link, mount_covariance_at_origin(fit), list);
  return list;
}

void print_errors(const Output& out, const Fit& fit, const FitReport& reported) {
  const bool pixels = reported.fitted.rms_pixel.has_value();
  if (pixels)
    out.line(fmt::format("Error     {} rms fitted, {} held out; noise {}",
                         text_or_unknown(reported.fitted.rms_pixel, 1, "px"),
                         text_or_unknown(reported.held_out.rms_pixel, 1, "px"), text_or_unknown(fit.noise, 1, "px")));
  out.line(fmt::format(
      "{}{} mean, {} rms, {} max fitted; {} mean held out{}", pixels ? "          " : "Error     ",
      text_or_unknown(reported.fitted.mean_m, 1e3, "mm"), text_or_unknown(reported.fitted.rms_m, 1e3, "mm"),
      text_or_unknown(reported.fitted.max_m, 1e3, "mm"), text_or_unknown(reported.held_out.mean_m, 1e3, "mm"),
      pixels ? "" : "; noise " + text_or_unknown(fit.noise, 1e3, "mm a coordinate")));
  if (reported.held_out_region.rms_m || reported.held_out_region.rms_pixel)
    out.line(fmt::format("          {} where a region of poses is held out: elsewhere it may be as large",
                         pixels ? text_or_unknown(reported.held_out_region.rms_pixel, 1, "px")
                                : text_or_unknown(reported.held_out_region.mean_m, 1e3, "mm") + " mean"));
  if (fit.chi2_per_dof) out.line(fmt::format("          chi-squared per degree of freedom {:.2f}", *fit.chi2_per_dof));
}

/// Where the sensor sits on its link, where that was estimated: what is asked for with the camera on the hand.
void print_mount(const Output& out, const Session& s, const Fit& fit) {
  const bool is_fixture = !s.parts.empty() && s.parts.front().fixture >= 0;  // told with the others
  if (!s.mount.estimate || is_fixture) return;
  const char* sensor = s.pose_sensor               ? "sensor"
                       : s.is_tracker()            ? "tracker"
                       : is_left_and_right(*s.rig) ? "left"
                                                   : "first";
  out.line(fmt::format("\nmount_from_{}, on {} (where the {} sits)", sensor, s.mount.link,
                       s.pose_sensor    ? "sensor"
                       : s.is_tracker() ? "tracker"
                                        : "camera"));
  print_pose(out, estimate(fit).mount_from_sensor, mount_covariance_at_origin(fit), true);
}

void print_answer(const Output& out, const Session& session, const Fit& fit) {
  out.line(fmt::format("tcp_from_body{}{}", session.robot.is_of_poses ? ", on " + session.tcp : std::string(),
                       fit.converged() ? "" : " (NOT CONVERGED)"));
  print_pose(out, fit.tcp_from_body, body_covariance_at_origin(fit), fit.rotation_is_observed,
             undetermined_tip(session, fit), !is_accuracy_unknown(fit));
  if (is_accuracy_unknown(fit)) return;
  out.line(fit.covariance_kind == CovarianceKind::noise ? "  (sigmas from the noise; rotations about the TCP's x, y, z)"
           : fit.noise ? "  (sigmas from how the observations differ: the model does not agree with them to the noise)"
                       : "  (sigmas from how the observations differ: the noise is not known)");
  if (const auto target = tcp_from_target(session, fit)) {
    const Vector3 xyz = 1e3 * target->translation, angles = degrees * rpy_from_rotation(target->rotation);
    out.line(fmt::format("The target's own frame in {}: {:.4f} {:.4f} {:.4f} mm, rpy {:.4f} {:.4f} {:.4f} deg",
                         session.robot.is_of_poses ? "that of " + session.tcp : "the TCP's", xyz.x(), xyz.y(), xyz.z(),
                         angles.x(), angles.y(), angles.z()));
  }
  print_mount(out, session, fit);
}

}  // namespace

void print_fit(const Output& out, const Session& session, const Fit& fit, const FitReport& reported,
               const FitOptions&) {
  out.line(fmt::format("{}: {} observations, {} used", session.title.empty() ? "Session" : session.title,
                       reported.observations, reported.used));
  for (const Unused& u : reported.rejected) out.line(fmt::format("  not used: {} ({})", u.id, u.reason));
  out.line();
  const bool is_answer = !has_no_answer(fit);
  if (is_answer)
    print_answer(out, session, fit);
  else
    out.line("tcp_from_body: NO ANSWER; no number of this fit is one to be used");
  out.line();
  print_errors(out, fit, reported);
  if (fit.objective == Objective::angle_axis)
    out.line(fmt::format("          weights: {:.3f} mm and {:.4f} deg", 1e3 * fit.angle_axis_sigma_m,
                         degrees * fit.angle_axis_sigma_rad));
  if (is_answer) print_effects(out, session, fit);
  std::string outliers;
  for (const ObservationReport& o : reported.per_observation)
    if (o.outlier) outliers += (outliers.empty() ? "" : ", ") + std::to_string(o.id);
  if (!outliers.empty()) out.line("Stand out of the others: " + outliers);
  print_parts(out, session, fit, reported);
  for (const Message& note : fit.notes) out.line("Note: " + note);
}

Json fit_json(const Session& session, const Fit& fit, const FitReport& reported, const FitOptions&) {
  Json result{{"converged", fit.converged()}, {"observations", reported.observations}, {"used", reported.used}};
  Json rejected = Json::array();
  for (const Unused& u : reported.rejected) rejected.push_back({{"id", u.id}, {"reason", u.reason}});
  result["rejected"] = rejected;
  result.update(errors_json(reported.fitted, ""));
  result["max_m"] = number(reported.fitted.max_m);
  result.update(errors_json(reported.held_out, "held_out_"));
  result["held_out_region_pixel"] = number(reported.held_out_region.rms_pixel);
  result["held_out_region_rms_m"] = number(reported.held_out_region.rms_m);
  result["held_out_region_mean_m"] = number(reported.held_out_region.mean_m);
  const bool tracker = session.is_tracker();
  const Json noise = number(fit.noise), null = nullptr;
  const Json estimated = fit.noise_estimate ? number(fit.noise_estimate->sigma) : null;
  result["noise_pixel"] = tracker ? null : noise;
  result["noise_m"] = tracker ? noise : null;
  result["noise_estimated_pixel"] = tracker ? null : estimated;
  result["noise_estimated_m"] = tracker ? estimated : null;
  result["chi2_per_dof"] = number(fit.chi2_per_dof);
  result["tcp_from_body"] = {{"matrix", motion(fit.tcp_from_body)}, {"covariance", matrix(fit.covariance)}};
  const auto target = tcp_from_target(session, fit);
  result["tcp_from_target"] = target ? motion(*target) : Json(nullptr);
  result["undetermined"] = undetermined_json(session, fit);
  result["covariance_from"] = fit.covariance_kind == CovarianceKind::noise ? "noise" : "scatter";
  Json markers = Json::array();
  for (std::size_t m = 0; m < fit.markers_in_body.size(); ++m)
    markers.push_back(fit.problem.marker_is_seen[m] ? numbers(fit.markers_in_body[m]) : null);
  result["markers"] = markers;
  result["mount_from_sensor"] = motion(estimate(fit).mount_from_sensor);
  result["effects"] = effects_json(session, fit);
  result["per_observation"] = observations_json(fit, reported);
  if (!session.parts.empty()) {
    result["held_out_session_pixel"] = number(reported.held_out_session.rms_pixel);
    result["held_out_session_rms_m"] = number(reported.held_out_session.rms_m);
    result["held_out_session_mean_m"] = number(reported.held_out_session.mean_m);
    result[session.is_touch() ? "fixtures" : "sessions"] = parts_json(session, fit, reported);
  }
  result["notes"] = fit.notes;
  return result;
}

}  // namespace handsight::cli
