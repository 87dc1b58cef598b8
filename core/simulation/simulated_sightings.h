// SPDX-License-Identifier: Apache-2.0
// What a simulated sensor measures of markers whose places are known. Internal to simulated_session.cpp.
#pragma once

#include "simulation/random.h"
#include "simulation/simulated_truth.h"
#include "simulation/simulation_options.h"

namespace handsight {

/// What cameras or tracker see in observation `k`; every point is off by `shift` (m) in the sensor's frame.
std::vector<Sighting> sightings_of(const SimulatedSession& simulated, std::size_t k, const Vector3& shift,
                                   double most_turned, Random random);

/// What a pose sensor says in all observations.
void measure_poses(const Session& like, const SimulationOptions& options, SimulatedSession& simulated);

/// Some markers taken out of observation `k`, some of the other image points put where the detector took another corner
/// for the marker's.
void spoil_sightings(const SimulationOptions& options, std::size_t k, SimulatedSession& simulated);

}  // namespace handsight
