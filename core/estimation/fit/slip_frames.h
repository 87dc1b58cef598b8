// SPDX-License-Identifier: Apache-2.0
// Slips, and what else moves the body or its markers on the hand, are measured in the body's frame, which itself
// follows from the markers that a fit finds.
#pragma once

#include "estimation/fit/fit_options.h"
#include "estimation/fit/fit_result.h"
#include "session/session.h"

namespace handsight {

/// The sides that the body's frame is laid through: those asked for; as the body's shape is described; else by the
/// markers as they are estimated.
BodySides make_sides(const FitOptions& options, const Problem& problem, const Unknowns& unknowns);

/// Does an effect of the problem move the body or its markers, in the body's own frame?
bool has_slip(const Problem& problem);

/// The first frames, by the markers of the start. The observations are to be placed anew after it.
void start_slip_frames(const FitOptions& options, const Unknowns& start, Problem& images);

/// Renews the frames and minimises again until they stay. `images` may be the problem of `fit` itself.
void settle_slip_frames(const Session& session, const FitOptions& options, Problem& images, Fit& fit);

}  // namespace handsight
