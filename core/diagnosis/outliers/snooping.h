// SPDX-License-Identifier: Apache-2.0
// Single wrong points, found while whole poses may be wrong for reasons of the robot: data snooping with the joints'
// errors as random effects (Baarda 1968; docs/method.md, "Wrong points").
#pragma once

#include "diagnosis/outliers/lone_observations.h"
#include "estimation/fit/fit.h"

namespace handsight {

/// What saw a point: a camera of the rig (its number), or the tracker.
constexpr int by_tracker = -1;

/// One measured point that was left out.
struct WrongPoint {
  std::int64_t id = 0;  // of the observation
  int index = 0;        // into Session::observations
  int marker = 0;
  int camera = 0;       // of the rig; by_tracker
  double distance = 0;  // px or m: how far it is from where the rest of the observation puts it
};

inline constexpr double wrong_by_chance = 1e-5;  // share of right points that are called wrong

/// Measured points of a session: a camera's view of a marker, or a tracker's point.
std::size_t point_count(const Session& session);

/// A fit without the points that are wrong with p < 1e-5 each, whatever the robot does; a point is only tested where
/// the observation has more coordinates than a body has motions. None is where the fit has no answer and two rounds
/// without wrong points bring it no nearer to one: then it is no few points that are wrong.
struct CleanFit {
  Session session;  // without the wrong points
  Fit fit;
  std::vector<WrongPoint> wrong;
  std::vector<LoneObservation> lone = {};  // left out whole, by fit_without_outliers; excluded in `session`
};

CleanFit clean_fit(const Session& session, const FitOptions& options);

}  // namespace handsight
