// SPDX-License-Identifier: Apache-2.0
// A simulated target: where it sits, and how it looks.
#pragma once

#include "simulation/poses.h"
#include "simulation/random.h"
#include "simulation/scene_parts.h"

namespace handsight {

/// The points of the session's target in the TCP frame: on the hand, turned anyhow, its face outward; where no joint
/// moves the TCP (a target on the table) lying where the camera that is moved looks down on it. Single tags lie beside
/// each other, a little out of one plane. `printed_off` (m): what every coordinate of a point is printed off by, sigma.
ShownBody shown_target(const Session& like, const SimulationOptions& options, double printed_off, Random random);

/// The few points that must be seen for the whole target to be: the outermost of every piece.
ShownBody outermost(const Session& like, const ShownBody& target);

/// The target's pieces as things of a scene, in the TCP frame: the sheets at where these points are (TCP frame, m), a
/// board behind each, and with `on_hand` the arm that carries it.
void add_target(const Session& session, const std::vector<Vector3>& points_in_tcp, bool on_hand, Scene& scene);

/// Moves the sheets and boards that add_target has put there.
void move_target(const Session& session, const std::vector<Vector3>& points_in_tcp, Scene& scene);

/// Does a joint move the TCP against the root?
bool tcp_is_moved(const Chain& chain);

}  // namespace handsight
