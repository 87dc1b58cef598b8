// SPDX-License-Identifier: Apache-2.0
// Bodies of markers, targets of pose sensors and probes on a simulated hand. Internal to simulated_session.cpp.
#pragma once

#include "chain/chain.h"
#include "simulation/poses.h"

namespace handsight {

/// Markers on a slightly bent plane, spread round its middle; a longest side of about `size` (m), no two too near.
ShownBody random_body(int count, double size, Random random);

/// The markers given (m, TCP frame); the normal of a flat body, so that it looks to the sensor in most of the session's
/// observations.
ShownBody given_body(const Session& like, const Chain& chain, const std::vector<Vector3>& markers);

/// A target of a pose sensor somewhere on the hand, turned anyhow; its points are those of its poses.
ShownBody random_target(const Session& like, Random random);

/// A probe's tips, some 15 cm before the TCP.
ShownBody random_probe(int count, Random random);

}  // namespace handsight
