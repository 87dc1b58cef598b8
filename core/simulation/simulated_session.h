// SPDX-License-Identifier: Apache-2.0
// Sessions with known truth, from a robot and the cameras or the tracker of another session.
#pragma once

#include <string>
#include <vector>

#include "simulation/simulated_truth.h"
#include "simulation/simulation_options.h"

namespace handsight {

/// `like` gives robot, tcp, mount, cameras or tracker, joints and the number of markers; where its labelled
/// observations span a joint by more than 0.2 rad, poses are drawn from that span. Throws InputError where no visible
/// pose is found.
SimulatedSession simulate_session(const Session& like, const SimulationOptions& options);

/// The same in postures that are given, with their times and velocities; what one observation measures does not depend
/// on those after it, but for effects that follow the whole session's duration. Markers that no camera sees are left
/// out.
SimulatedSession simulate_at(const Session& like, const SimulationOptions& options,
                             const std::vector<Observation>& given);

/// One touch more by a robot with this truth: the last of `given`, whose part says what it touches and whose posture is
/// about right, in the nearest posture in which the tip truly touches within the noise; a gauge or a length is read
/// where it stands. Nothing where the tip does not come there. `like` is a session of touches.
std::optional<Observation> simulate_touch(const Session& like, const SimulationOptions& options,
                                          const std::vector<Observation>& given);

/// Parses "58:joint:arm_4=0.12", "75:marker:1=0.012" or "98:right_image:arm_2=0.05".
Disturbance parse_disturbance(const std::string& text, const Robot& robot);

/// Writes truth.xml: markers, tcp_from_body, mount, noise, effects, disturbances.
void write_truth(const SimulatedSession& simulated, const SimulationOptions& options,
                 const std::filesystem::path& file);

}  // namespace handsight
