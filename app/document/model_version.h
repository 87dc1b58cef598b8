// SPDX-License-Identifier: GPL-3.0-or-later
// One fit of the document's model with what it says; read-only once made.
#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <unordered_map>

#include "diagnosis/attribution/inspection.h"
#include "diagnosis/selection/bill.h"
#include "diagnosis/story/story.h"
#include "diagnosis/verdict/diagnosis.h"
#include "document/edit.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/part_report.h"
#include "estimation/report/prediction.h"
#include "session/calibration.h"

namespace handsight::app {

/// Of longer sessions so many observations are shown, evenly over the session, as many as a diagnosis goes by.
inline constexpr int most_shown = 3000;

/// Of a collection: one session's hand, with what all sessions tell of the robot.
struct HandModel {
  std::shared_ptr<const Session> session;  // by itself
  Rigid tcp_from_body;
  Vector6 sigma;               // origin_sigma
  PredictionModel prediction;  // for the session's joints
};

struct ModelVersion {
  std::int64_t revision = 0;  // of the document's state that was fitted
  QString cause;              // the action that led to it
  ModelSettings settings;
  FitOptions options;
  std::shared_ptr<const Fit> fit;  // null: nothing could be fitted, and `refusal` says why; its problem holds no more
                                   // than `most_shown` of the observations
  std::shared_ptr<const FitReport> report;         // null with the fit
  std::shared_ptr<const Inspection> inspection;    // null with the fit
  std::shared_ptr<const Calibration> calibration;  // what would be exported; null with the fit
  std::vector<PartReport> parts;                   // of a collection: session by session
  std::vector<HandModel> hands;                    // likewise
  std::vector<BillRow> bill;                       // without its probabilities of inclusion
  PredictionModel prediction;                      // where the TCP really is in other poses
  std::vector<WrongPoint> wrong_points;            // left out of the fit
  std::vector<LoneObservation> lone;               // likewise, as a whole
  QString refusal;
  std::unordered_map<std::int64_t, int> find_row;  // observation id -> FitReport::per_observation

  /// The report of an observation, null where it was not used.
  const ObservationReport* of(std::int64_t id) const {
    const auto found = find_row.find(id);
    return found == find_row.end() ? nullptr : &report->per_observation[static_cast<std::size_t>(found->second)];
  }
};
using ModelVersionPointer = std::shared_ptr<const ModelVersion>;

/// As the story tells it (story.h).
using ErrorAndNoise = StoryError;
ErrorAndNoise error_and_noise(const ModelVersion& version);

/// Standard deviations of tcp_from_body: of the body's origin (m), and of the rotations about the TCP's axes (rad); NaN
/// where these poses do not determine it.
Vector6 origin_sigma(const Fit& fit);

/// Of a model's terms, those that the settings estimate and those that they hold, at the values of the fit.
ModelSettings with_fitted_values(const Fit& fit, ModelSettings settings);

/// The version that a diagnosis has fitted already: of these settings, without its wrong points.
std::shared_ptr<ModelVersion> build_version(const Session& session, const Diagnosis& diagnosis,
                                            const ModelSettings& settings, std::int64_t revision, QString cause,
                                            const SecondLooks& looks = {});

/// The same fit, held against observations that a second look found.
ModelVersionPointer inspected_again(const Session& session, const ModelVersion& version, std::int64_t revision,
                                    const SecondLooks& looks);

/// The same fit, whose predictions and calibration allow for what is doubted of its effects.
ModelVersionPointer doubted(const Session& session, const ModelVersion& version,
                            const ModelUncertainty& model_uncertainty);

/// Do two versions hold the same fit?
inline bool same_fit(const ModelVersion& a, const ModelVersion& b) { return a.fit && a.fit == b.fit; }

/// Fits a session and reports; a refusal of the fit becomes the version's sentence. Where `goes_on` answers no the fit
/// ends as soon as it can, and what comes back is worth nothing.
ModelVersionPointer make_version(const Session& session, const ModelSettings& settings, std::int64_t revision,
                                 QString cause, const SecondLooks& looks = {},
                                 const std::function<bool()>& goes_on = {});

}  // namespace handsight::app
