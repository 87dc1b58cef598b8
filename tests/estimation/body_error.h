// SPDX-License-Identifier: Apache-2.0
// How far a fit's TCP->Body is from the truth of a simulated session.
#pragma once

#include "chain/body_frame.h"
#include "estimation/fit/fit.h"
#include "simulation/simulated_session.h"

namespace handsight {

/// As a small motion (m, rad) in the body's true frame.
inline Vector6 body_error(const SimulatedSession& s, const Fit& f) {
  return small_motion_between(body_frame(f.sides, s.markers_in_tcp).tcp_from_body, f.tcp_from_body);
}

}  // namespace handsight
