// SPDX-License-Identifier: Apache-2.0
// What a fit says to its user: residuals of every observation, what was not used and why, the held-out error.
#pragma once

#include "base/message.h"
#include "estimation/fit/fit.h"
#include "estimation/report/residuals.h"

namespace handsight {

/// Thesis (4.51), and the covariance that the noise of the images alone gives it.
struct TcpDeviation {
  Rigid tcp_from_tcp_est;
  Matrix6 unit_covariance = Matrix6::Zero();  // of translation and rotation vector in TCP axes, noise 1 px (1 m)
};

struct ObservationReport {
  std::int64_t id = 0;
  int index = 0;                          // into Session::observations
  std::optional<double> rms_pixel;        // of its image coordinates
  std::optional<double> rms_m;            // of the lengths of its markers' 3D residuals
  std::optional<TcpDeviation> deviation;  // nothing where it does not show three markers
  bool outlier = false;                   // stands out of the other observations, p < 1e-4
};

struct Unused {
  std::int64_t id = 0;
  Message reason;
};

struct FitReport {
  int observations = 0;
  int used = 0;
  std::vector<Unused> rejected;  // rejected, excluded, or without markers
  ErrorSummary fitted;
  /// What the noise alone makes of the 3D residuals' lengths, rms, m; absent where no marker is seen as a point or the
  /// noise is unknown. Cameras see depth badly: of a small error in metres this is often the greater part.
  std::optional<double> rms_of_noise_m;
  std::optional<double> noise_of_hand_m;  // what the noise alone makes of ErrorSummary::hand_m
  ErrorSummary held_out;         // five folds over observations: floor(rank by time / 4) mod 5, repeated poses together
  ErrorSummary held_out_region;  // five regions (regions.h), each predicted from the others; where asked for
  /// Of a joined session, where asked for (part_report.h): every part predicted by a robot learned from the others; in
  /// units of its own sensor part by part.
  ErrorSummary held_out_session;
  std::vector<ErrorSummary> held_out_sessions;
  std::vector<ObservationReport> per_observation;  // of the used, in order of time
  std::vector<std::optional<Residuals>>
      held_out_residuals;  // the same of `held_out`, where the session is a joined one
};

/// `options` must be those of the fit. Held-out errors need observations in two folds at least; else they are absent.
FitReport report(const Session& session, const Fit& fit, const FitOptions& options = {});

/// FitReport::held_out_region: the error where the robot has not been measured. Absent where the poses make fewer than
/// two regions.
ErrorSummary held_out_by_region(const Session& session, const Fit& fit, const FitOptions& options = {});

/// What a fit leaves of observations that it has not seen: a part of the same session (session/sample.h), or another of
/// the same robot, sensors and hand. Fitted errors; no folds.
ErrorSummary error_on(const Session& others, const Fit& fit);

/// The mean square of the coordinates (px^2, m^2) of each observation of the fit, in order of time; and of each used
/// one of another session, as `error_on`.
std::vector<double> mean_squares(const Fit& fit);
std::vector<double> mean_squares_on(const Session& others, const Fit& fit);

/// The mean square of each used observation's coordinates (px^2, m^2), in order of time, where the block of `blocks`
/// blocks of neighbours in time in which it lies is left out of the fit. An image fit.
std::vector<double> held_out_in_blocks(const Session& session, const Fit& fit, const FitOptions& options, int blocks);

/// The fold of an observation among the used ones, by its rank in time.
inline int fold_of(int rank) { return rank / 4 % 5; }

/// Where the TCP would have to be for the body to be where this observation saw it.
std::optional<TcpDeviation> tcp_deviation(const Problem& images, const ProblemObservation& observation,
                                          const Unknowns& unknowns);

/// Where a target of one piece lies in the TCP's frame: its own frame (targets/target.h) by its markers as the fit has
/// them, as large and as bent as its effects make it. Nothing for markers, tags without a common frame, and sensors of
/// poses, whose body is the target's frame.
std::optional<Rigid> tcp_from_target(const Session& session, const Fit& fit);

}  // namespace handsight
