// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/model_version.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "diagnosis/ranking/outlier_rejection.h"
#include "diagnosis/residuals/residual_views.h"
#include "estimation/fit/part_fit.h"
#include "estimation/fit/undetermined.h"
#include "estimation/report/export.h"
#include "words/core_words.h"

namespace handsight::app {

ErrorAndNoise error_and_noise(const ModelVersion& version) {
  return version.fit ? story_error(*version.fit, *version.report) : ErrorAndNoise{};
}

Vector6 origin_sigma(const Fit& fit) {
  const Matrix6 covariance = body_covariance_at_origin(fit);
  const UndeterminedMotions unknown = undetermined_motions(covariance);
  Vector6 sigma = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  for (int i = 0; i < 6; ++i)
    if (unknown.numbers[static_cast<std::size_t>(i)]) sigma[i] = std::numeric_limits<double>::quiet_NaN();
  return sigma;
}

namespace {

std::shared_ptr<const Inspection> inspection_of(const Session& session, const SecondLooks& looks,
                                                const ModelVersion& version) {
  auto inspection = std::make_shared<Inspection>(inspect(session, *version.fit, *version.report, looks));
  mark_left_out(version.wrong_points, version.lone, *inspection);
  return inspection;
}

HandModel hand_model(PartFit part) {
  HandModel hand{nullptr, part.fit.tcp_from_body, origin_sigma(part.fit), prediction_model(part.fit)};
  hand.session = std::make_shared<const Session>(std::move(part.session));
  return hand;
}

/// Everything that a fit says, of a session with all its points.
void tell(const Session& session, const SecondLooks& looks, Fit fitted, std::shared_ptr<const FitReport> reported,
          ModelVersion& version) {
  for (std::size_t i = 0; i < reported->per_observation.size(); ++i)
    version.find_row[reported->per_observation[i].id] = static_cast<int>(i);
  version.calibration = std::make_shared<Calibration>(
      make_calibration(session, fitted, *reported, version.options, "handsight " HANDSIGHT_VERSION));
  const bool are_touches = session.is_touch();
  if (session.parts.size() > 1 || are_touches) {
    version.parts = part_reports(session, fitted, *reported);  // of touches fixture by fixture
    for (int p = 0; !are_touches && p < static_cast<int>(session.parts.size()); ++p)
      version.hands.push_back(hand_model(fit_of_part(session, fitted, p)));
  }
  version.prediction = prediction_model(fitted);
  version.bill = make_bill(fitted);
  // From here on only some are looked at one by one.
  fitted.problem.observations = evenly(std::move(fitted.problem.observations), most_shown);
  version.fit = std::make_shared<const Fit>(std::move(fitted));
  version.report = std::move(reported);
  version.inspection = inspection_of(session, looks, version);
}

FitOptions options_of(const ModelSettings& settings, bool has_joints) {
  FitOptions options;
  options.objective = settings.objective;
  options.fix_markers = settings.fix_markers;
  options.effects = settings.held;
  options.estimated = settings.estimated;
  // As a diagnosis fits: what the views show of a robot with joints is linear about pixels that count alike.
  if (has_joints || !options.estimated.empty()) options.smallest_step = 1e-9;
  return options;
}

/// Effects of another robot cannot be placed in this one.
void check_places(const Session& session, const ModelSettings& settings) {
  const Chain chain = make_chain(session);
  for (const auto* terms : {&settings.estimated, &settings.held})
    for (const EffectTerm& term : *terms) {
      const Effect& effect = term_effect(term);
      const std::vector<int> places = effect_places(effect, chain);
      if (std::find(places.begin(), places.end(), term.place) == places.end())
        throw InputError(
            message("The model has the effect {} at a place that this robot does not have; untick it.", effect.title));
    }
}

}  // namespace

ModelSettings with_fitted_values(const Fit& fit, ModelSettings settings) {
  for (std::size_t t = 0; t < settings.estimated.size(); ++t)
    settings.estimated[t] = fit.effects[settings.held.size() + t].term;
  return settings;
}

std::shared_ptr<ModelVersion> build_version(const Session& session, const Diagnosis& d, const ModelSettings& settings,
                                            std::int64_t revision, QString cause, const SecondLooks& looks) {
  auto version = std::make_shared<ModelVersion>();
  version->revision = revision;
  version->cause = std::move(cause);
  version->settings = settings;
  version->options = d.model_options;
  version->wrong_points = d.model.wrong;
  version->lone = d.model.lone;
  tell(session, looks, d.model.fit, std::make_shared<FitReport>(d.report), *version);
  return version;
}

ModelVersionPointer inspected_again(const Session& session, const ModelVersion& before, std::int64_t revision,
                                    const SecondLooks& looks) {
  auto version = std::make_shared<ModelVersion>(before);
  version->revision = revision;
  version->inspection = inspection_of(session, looks, before);
  return version;
}

ModelVersionPointer doubted(const Session& session, const ModelVersion& before,
                            const ModelUncertainty& model_uncertainty) {
  auto version = std::make_shared<ModelVersion>(before);
  version->prediction.model_uncertainty = model_uncertainty;
  if (!before.hands.empty()) return version;  // what is doubted is no part of a collection's calibration
  auto calibration = std::make_shared<Calibration>(*before.calibration);
  set_model_uncertainty(session.robot, list_terms(*before.fit), model_uncertainty, *calibration);
  version->calibration = std::move(calibration);
  return version;
}

ModelVersionPointer make_version(const Session& session, const ModelSettings& settings, std::int64_t revision,
                                 QString cause, const SecondLooks& looks, const std::function<bool()>& goes_on) {
  auto version = std::make_shared<ModelVersion>();
  version->revision = revision;
  version->cause = std::move(cause);
  version->settings = settings;
  version->options = options_of(settings, !session.robot.is_of_poses);
  // Of the version itself nothing may hold on to the one who asked.
  const auto asking = [&](FitOptions options) {
    if (goes_on) options.on_iteration = [&](int, double, const Unknowns&) { return goes_on(); };
    return options;
  };
  const auto stop_here = [&] {
    if (goes_on && !goes_on()) throw InputError("The fit was stopped.");
  };
  try {
    check_places(session, settings);
    CleanFit clean = fit_without_outliers(session, asking(version->options));
    stop_here();
    version->wrong_points = clean.wrong;
    version->lone = clean.lone;
    version->options.estimated = with_fitted_values(clean.fit, settings).estimated;
    if (settings.has_effects()) version->options.start = estimate(clean.fit);
    auto reported = std::make_shared<FitReport>(report(clean.session, clean.fit, asking(version->options)));
    stop_here();
    clean.session = {};  // of a long one every copy counts
    tell(session, looks, std::move(clean.fit), std::move(reported), *version);
  } catch (const InputError& error) {
    version->refusal = translated_error(error);
  }
  return version;
}

}  // namespace handsight::app
