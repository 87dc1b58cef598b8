// SPDX-License-Identifier: Apache-2.0
// Touches of a session's fixtures by a probe with known truth. Internal to simulated_session.cpp.
#pragma once

#include <functional>
#include <optional>

#include "effects/observation_state.h"
#include "simulation/simulation_options.h"

namespace handsight {

/// Where a marker truly is in a fixture's frame (m); marker -1: the TCP.
using TouchedPlace = std::function<Vector3(const ObservationState& c, int fixture, int marker)>;

struct TouchSimulation {
  const Session& like;
  const Chain& chain;
  const SimulationOptions& options;
  TouchedPlace place;
  std::function<Eigen::VectorXd()> posture;  // one from which a search may begin
};

/// m, of one reading at this fixture.
double touch_sigma(const Session& like, const SimulationOptions& options, std::size_t fixture);

/// The observations: fixture after fixture, as many touches of each as of any other. What a reading errs is where the
/// tip truly stands: a socket reads nothing. Gauges show up to 5 mm, a length one of 0.3, 0.4 and 0.5 m within 1 mm.
/// InputError names a fixture that the robot does not reach.
std::vector<Observation> simulated_touches(const TouchSimulation& simulation);

/// What is read in postures that are given, which touch what their part says.
void read_touches(const TouchSimulation& simulation, std::vector<Observation>& given);

/// The last of `given`, whose part says what it touches and whose posture is about right, in the nearest posture in
/// which the tip truly touches within the noise; a gauge or a length is read where it stands. Nothing where the tip
/// does not come there.
std::optional<Observation> next_touch(const TouchSimulation& simulation, const std::vector<Observation>& given);

/// How sure the session says that it is: of readings, and of distances, which are measured anew.
void declare_touches(const SimulationOptions& options, Session& session);

}  // namespace handsight
