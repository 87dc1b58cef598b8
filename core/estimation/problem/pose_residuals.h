// SPDX-License-Identifier: Apache-2.0
// What measured poses leave, as places and turns.
#pragma once

#include "base/message.h"
#include "estimation/problem/problem.h"
#include "session/pose_points.h"

namespace handsight {

/// Measured - predicted of one observation of a pose sensor; nothing where it has no pose.
std::optional<PoseError> pose_residual(const Problem& problem, const ProblemObservation& observation,
                                       const Unknowns& unknowns);

/// Has the session a pose sensor whose two sigmas are not both told?
bool has_unknown_lever(const Session& session);

/// The lever (m) of the sigmas that the residuals have: the ratio of the rms of places to that of turns.
double seen_lever(const Problem& problem, const Unknowns& unknowns);

/// That the places of the target go together and its turns do not, by degrees; empty where both do, or neither. Where
/// their sigmas are not told the fit weighs such turns as nothing, and its error says nothing of them.
Message turn_misfit_text(const Problem& problem, const Unknowns& unknowns);

/// The session of a pose sensor with its poses shown at the lever of these unknowns, which a fit may have chosen itself
/// (has_unknown_lever); any other session as it is.
Session shown_as_fitted(const Session& session, const Unknowns& unknowns);

}  // namespace handsight
