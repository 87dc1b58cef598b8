// SPDX-License-Identifier: Apache-2.0
// Small copies of a session, for many quick trials: few observations, few points of a board, and what cameras saw as
// points in the first camera's frame.
#pragma once

#include "blunders/hand_eye.h"
#include "session/session.h"

namespace handsight {

inline constexpr int most_sights = 30;
inline constexpr int farthest_shift = 3;  // places by which measurements may be paired off

/// The session with at most `most_sights` well spread observations that show something; those at most `farthest_shift`
/// places beside them stay too, showing nothing.
Session thinned_session(const Session& session);

/// The points of a board of one piece thinned out to some that are well spread; any other session as it is.
Session with_few_markers(const Session& session);

/// The session of cameras as one of a tracker in the first camera's frame: points seen by two cameras triangulated, of
/// targets four points that follow from the pose, where it has one. Sessions without cameras as they are.
Session as_point_session(const Session& session);

/// What a session without cameras shows, by the chain as it is. `point_count`: Session::marker_count.
std::vector<HandSight> list_sights(const Session& points);

/// hand_eye of such a session: its mount is known where it is not to be estimated.
std::optional<HandEye> solve_hand_eye(const Session& points);

}  // namespace handsight
