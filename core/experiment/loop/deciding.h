// SPDX-License-Identifier: Apache-2.0
// What a look saw becomes an observation of the session, decided as the online calibration does.
#pragma once

#include <memory>

#include "detection/target_finding.h"
#include "estimation/online/online.h"
#include "experiment/driver/driven_robot.h"

namespace handsight {

class Deciding {
 public:
  /// Takes the session's observations as they are: their decisions stay.
  explicit Deciding(const Session& session);

  /// Decides the observation as it stands in the session, and writes into it what was found. Observations of before
  /// that are decided now after all are written too. InputError where an image cannot be read.
  OnlineStep decide(Session& session, std::size_t place);

 private:
  OnlineStep find_step(const Session& session, const Observation& observation);

  std::unique_ptr<OnlineCalibration> online_;
  std::optional<TargetFinder> finder_;
};

/// An observation of this session: images are brought into its folder under the observation's number. DriverFault where
/// the driver saw something else than the session's sensor sees, or names images that are not there.
Observation make_observation(const Session& session, std::int64_t id, double time, const MoveAnswer& stood,
                             const LookAnswer& seen);

}  // namespace handsight
