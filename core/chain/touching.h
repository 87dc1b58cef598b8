// SPDX-License-Identifier: Apache-2.0
// Postures in which a probe's tip touches a fixture.
#pragma once

#include <functional>

#include "session/fixtures/fixture_kind.h"

namespace handsight {

/// Where a tip is in the fixture's frame (m) in a posture (rad or m, in the order of the session's joints).
using TipInFixture = std::function<Vector3(const Eigen::VectorXd& position)>;

/// The posture near `start`, within these limits, in which the fixture holds `wanted` of the tip (held_by), to 1e-11 m;
/// nothing where the search gets stuck.
std::optional<Eigen::VectorXd> touching_posture(const TipInFixture& tip, const FixtureKind& kind,
                                                const Eigen::VectorXd& wanted, const Eigen::VectorXd& start,
                                                const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

}  // namespace handsight
