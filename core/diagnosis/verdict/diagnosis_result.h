// SPDX-License-Identifier: Apache-2.0
// What a diagnosis finds.
#pragma once

#include "base/message.h"
#include "diagnosis/attribution/error_attribution.h"
#include "diagnosis/outliers/snooping.h"
#include "diagnosis/ranking/ranking.h"
#include "diagnosis/residuals/patterns.h"
#include "estimation/report/fit_report.h"

namespace handsight {

enum class Verdict { too_few_observations, adequate, missing_effect, ambiguous, unexplained };
const char* verdict_text(Verdict verdict);

/// Where a fit stood after an iteration.
struct FitIteration {
  double cost = 0;  // squares, px^2 or m^2
  Unknowns unknowns;
};

/// What a check with the real robot is predicted to read, on top of the model as it is (robot_check.h).
struct CheckPrediction {
  Message before, after;                    // the sentence round the number
  double value = 0, sigma = 0;              // in `unit`
  std::string unit;                         // as in the catalogue: m, rad, kg, px, 1
  std::optional<std::int64_t> observation;  // whose pose is to be taken
};

/// Something of the catalogue, or an unnamed curve, that may be missing.
struct DiagnosisCandidate {
  std::string id;                  // of an effect; empty: unnamed
  std::vector<std::string> where;  // joints, markers, "observation 37"; of an unnamed curve the joint that it follows
  std::vector<EffectTerm> terms;   // with values: of the full fit where there was one, else linear
  std::vector<std::vector<double>> sigmas;
  Eigen::MatrixXd covariance;          // of the terms' numbers that are no choices, in their order
  std::vector<FitIteration> path;      // of the full fit, from the linear estimate on
  std::optional<FitOptions> full_fit;  // after the full fit: the model with these terms, at its answer
  double ln_bayes_factor = 0;          // prior odds against what is rare or has no name included
  Message held_back;                   // why what would pass otherwise does not: slips are rare (rare_causes.h)
  double p_value = 1;
  Repeatability repeatability;  // at which the evidence is largest
  bool refitted = false;
  bool plausible = true;   // every number within three of its prior sigmas
  bool too_large = false;  // a number is larger than robots are built (stand_in.h)
  double visibility = 0;
  std::optional<double> predicted_held_out;  // px, or m with a tracker
  std::optional<ErrorSummary> held_out;      // after the full fit
  std::optional<double> explained;           // share of the excess over the noise
  std::optional<double> ln_of_small;  // what small deviations at each joint add to ln_bayes_factor, where it was asked
  std::vector<std::string> indistinguishable_from;
  std::optional<CheckPrediction> check;  // of the candidates that pass the threshold
  std::string explanation;
  std::optional<RankedEmpiricalError> unnamed;  // `terms` then hold the curve, where it could be written and fitted
};

struct DiagnosisPattern {
  ResidualSeries residual;
  Variable against;
  double strength = 0;
  double p_value = 1;
};

/// Long sessions are judged by a sample of their observations, and the judgement is tried on the others.
struct SampleCheck {
  int taken = 0, all = 0;  // used observations
  ErrorSummary others;     // what the model leaves of those that were not taken
};

struct Diagnosis {
  Verdict verdict = Verdict::adequate;
  Message reason;
  CleanFit model;            // the model as it is, without wrong points
  FitOptions model_options;  // that give it again
  FitReport report;
  std::optional<double> noise;  // px or m
  double threshold = 0;
  Repeatability repeatability;  // that suits the model as it is
  std::optional<double> lack_of_fit_p;
  std::optional<double> excess;                // chi-squared over what noise leaves, external residuals
  std::optional<double> beyond_repeatability;  // times: what is left by what noise and usual scatter leave (judging.h)
  double ln_against_usual_repeatability = 0;   // of the Bayes factor for robots that repeat worse than is usual
  std::vector<DiagnosisCandidate> candidates;  // named and unnamed, best first
  std::vector<DiagnosisPattern> patterns;      // those that are no chance, most structured first
  std::vector<std::string> invisible;          // effects that these poses could not show
  ErrorAttribution attribution;                // of all observations together, wrong points included
  std::vector<ObservationAttribution> observations;  // of each, in order of time
  std::optional<SampleCheck> sample;                 // `model` and all that goes with it are then of a sample
  bool stopped = false;
};

/// The number by which models are compared: px, or m with a tracker.
double held_out_error(const Diagnosis& model);

/// FitReport::held_out_region of a model, worked out where it has not been yet.
ErrorSummary region_error(const Diagnosis& model);

/// Are these terms of one named effect? Their places as a user reads them.
std::vector<std::string> list_places(const std::vector<EffectTerm>& terms, const Session& session);
std::vector<std::string> list_places(const std::vector<EffectTerm>& terms, const Chain& chain);

}  // namespace handsight
