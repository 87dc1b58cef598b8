// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/fit_noise.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "base/shown_number.h"
#include "chain/sighting.h"

namespace handsight {
const std::optional<double>& declared_noise(const Session& session) {
  return session.is_tracker() ? session.sigma_point : session.sigma_pixel;
}

double finest_noise(const Session& session) { return session.is_tracker() ? 2e-6 : 2e-3; }

namespace {

/// Robust scale of one coordinate: from the median squared length of the sightings' residuals, which for noise alone is
/// about (1 - 2/9k)^3 k variances for k rows.
std::optional<double> median_residual(const Problem& problem, const Unknowns& unknowns) {
  std::vector<double> variances;
  for (const ProblemObservation& o : problem.observations)
    for (const Sighting& s : o.sightings) {
      const Vector3 x = sensor_from_tcp_at(o, unknowns) * marker_at(o, unknowns, s.marker);
      const SightingNormal n = sighting_normal(problem.rig_or_null(), s, x);
      if (n.rows > 0) variances.push_back(n.cost / (n.rows * std::pow(1 - 2.0 / (9 * n.rows), 3)));
    }
  const double usual = median(std::move(variances));
  return usual > 0 ? std::optional(std::sqrt(usual)) : std::nullopt;
}

/// The robot-free noise where it is one, else that of repeated poses.
std::optional<NoiseEstimate> seen_noise(const Problem& images, const Unknowns& unknowns) {
  auto estimated = estimate_noise(images, unknowns);
  if (estimated && are_rigid_by_construction(images, unknowns, *estimated)) estimated.reset();
  return estimated ? estimated : noise_from_repeats(images, unknowns);
}

/// px to m: the root mean square of the triangulated points' sigmas for noise of 1.
double metres_per_unit(const Problem& points) {
  double sum = 0, count = 0;
  for (const ProblemObservation& o : points.observations)
    for (const Matrix3& c : o.point_covariances) {
      sum += c.trace() / 3;
      ++count;
    }
  return count > 0 ? std::sqrt(sum / count) : 1;
}

}  // namespace

/// The sigma (m) that writing the points with so many decimals gives them; 0 where they have more than a file would.
static double find_rounding(const Problem& points) {
  const auto all_are_multiples = [&](double step) {
    const auto is_multiple = [step](double x) { return std::abs(x / step - std::round(x / step)) < 1e-3; };
    return std::all_of(points.observations.begin(), points.observations.end(), [&](const ProblemObservation& o) {
      return std::all_of(o.sightings.begin(), o.sightings.end(), [&](const Sighting& s) {
        return s.point && is_multiple(s.point->x()) && is_multiple(s.point->y()) && is_multiple(s.point->z());
      });
    });
  };
  for (const double step : {1e-3, 1e-4, 1e-5, 1e-6})
    if (all_are_multiples(step)) return step / std::sqrt(12.0);
  return 0;
}

bool are_rigid_by_construction(const Problem& images, const Unknowns& unknowns, const NoiseEstimate& estimate) {
  if (estimate.sigma > (images.rig ? 1e-3 : std::max(1e-6, 2 * find_rounding(images)))) return false;
  const auto usual = median_residual(images, unknowns);
  return usual && *usual > 100 * estimate.sigma;
}

std::optional<double> noise_at_start(const Session& session, const Problem& images, const Unknowns& start) {
  const auto& declared = declared_noise(session);
  if (declared && *declared > 0) return declared;
  const auto seen = seen_noise(images, start);
  if (seen && seen->sigma > 0) return seen->sigma;
  const double reported = usual_sigma(session);
  return reported > 0 ? std::optional(reported) : std::nullopt;
}

void set_prior_noise(const Session& session, const Unknowns& start, Problem& images) {
  const auto noise = noise_at_start(session, images, start);
  images.noise_is_guessed = !noise;
  images.noise = noise.value_or(session.is_tracker() ? 1e-3 : 0.3);
}

double loss_noise(const Session& session, const Problem& images, const Problem& fitted, const Unknowns& start,
                  const FitOptions& options) {
  if (options.loss == Loss::none) return 1;
  const double unit = options.objective == Objective::camera && images.rig ? metres_per_unit(fitted) : 1;
  if (const auto noise = noise_at_start(session, images, start)) return *noise * unit;
  const auto usual = median_residual(images, solve(images, start, {.most_iterations = 30}).unknowns);
  return usual.value_or(session.is_tracker() ? 1e-3 : 0.3) * unit;
}

static Message text_of_a_wrong_declaration(double declared, const NoiseEstimate& seen, bool of_tracker) {
  const double scale = of_tracker ? 1e3 : 1;
  return message(
      "The declared noise, {0} {3}, and the noise seen in the measurements, {1} +- {2} {3}, differ by more than 3 "
      "sigma; "
      "check the declaration, or look for wrong {4}.",
      number(shown_number(scale * declared)), number(shown_number(scale * seen.sigma)),
      number(shown_number(scale * seen.error, 1)), of_tracker ? "mm" : "px",
      of_tracker ? "points of the tracker" : "corners and camera errors");
}

/// Of a session that was computed without noise what is left is rounding and the priors' pull: asking what is missing
/// there would never end.
static bool is_finer_than_sensors(const Session& session, const Problem& images, const Fit& fit) {
  if (declared_noise(session)) return false;
  const double finest = finest_noise(session);
  if (fit.noise_estimate && fit.noise_estimate->sigma > finest) return false;
  return median_residual(images, fit.solution.unknowns).value_or(0) <= finest;
}

void set_noise(const Session& session, const Problem& images, Fit& fit) {
  const char* unit = session.is_tracker() ? "m" : "px";
  fit.noise_estimate = estimate_noise(images, fit.solution.unknowns);
  if (fit.noise_estimate && is_finer_than_sensors(session, images, fit)) {
    fit.noise = finest_noise(session);
    fit.noise_estimate.reset();
    fit.notes.push_back(
        message("What is left is finer than any sensor measures, as in a session that was computed without noise; "
                "{:g} {} are taken for its noise.",
                *fit.noise, unit));
    return;
  }
  if (fit.noise_estimate && are_rigid_by_construction(images, fit.solution.unknowns, *fit.noise_estimate)) {
    fit.notes.push_back(
        message("The markers stand against each other to {:.1g} {}, as no sensor measures: they are rigid by "
                "construction, like a tracker's virtual points, and do not tell the noise.",
                fit.noise_estimate->sigma, unit));
    fit.noise_estimate.reset();
  }
  const auto& declared = declared_noise(session);
  if (!declared && !fit.noise_estimate) fit.noise_estimate = noise_from_repeats(images, fit.solution.unknowns);
  if (declared) {
    fit.noise = declared;
  } else if (fit.noise_estimate) {
    fit.noise = fit.noise_estimate->sigma;
    if (fit.noise_estimate->from_repeats)
      fit.notes.push_back(message(
          "The noise, {:.3g} {}, is that of poses which were measured again; how well the robot repeats is part of it.",
          *fit.noise, unit));
  }
  if (const double reported = usual_sigma(session); !fit.noise && reported > 0) {
    fit.noise = reported;
    fit.notes.push_back(message(
        "Nothing but the measurements' own sigmas (usually {:.3g} {}) tells the noise; they are taken at their word.",
        reported, unit));
  }
  if (declared && fit.noise_estimate && std::abs(fit.noise_estimate->sigma - *declared) > 3 * fit.noise_estimate->error)
    fit.notes.push_back(text_of_a_wrong_declaration(*declared, *fit.noise_estimate, session.is_tracker()));
}

}  // namespace handsight
