// SPDX-License-Identifier: Apache-2.0
// Watches a calibrated robot: has anything changed? May be asked after every observation, for ever.
#pragma once

#include <memory>

#include "compare/watch_step.h"
#include "correct/calibrated_robot.h"

namespace handsight {

struct WatchParts;

/// A sequential test by an e-process: the ratio of the likelihoods of all that was measured, with a change (one of
/// those that compare knows, of any prior sigma, from any observation on) and without one, mean over the changes and
/// the times at which they may have come, of which the beginnings of rounds (until a pose is taken again) have half of
/// the weight, and rounds by about 1 / (k ln(k)^2). Where nothing has changed its expectation is never above 1, so that
/// it ever reaches 1000 with a chance of 1e-3 at most (Ville 1939; Shafer, Shen, Vereshchagin and Vovk 2011). What the
/// calibration is unsure of is unknown on both sides. What it leaves from pose to pose is a motion of its own for each
/// pose, and half of the noise (more where the calibration has left more) an offset of each of its coordinates, both
/// the same whenever that pose is taken again (within 5e-3 rad, m): errors of shape and lenses are no change, however
/// often they are measured.
class ChangeWatch {
 public:
  explicit ChangeWatch(CalibratedRobot before, WatchOptions options = {});
  ~ChangeWatch();
  ChangeWatch(ChangeWatch&&) noexcept;
  ChangeWatch& operator=(ChangeWatch&&) noexcept;

  /// One observation of a session of the same robot. Nothing where it shows nothing that can be used. InputError where
  /// the session is not of this robot.
  std::optional<WatchStep> add(const Session& session, const Observation& observation);

 private:
  std::unique_ptr<WatchParts> parts_;
};

/// Places in `positions` of those poses, at most `count`, that would show best what is most likely to move: the
/// sensor's mount, the body on the hand, the zeros of the joints (one after another, that which adds most to the
/// information).
std::vector<std::size_t> telling_poses(const CalibratedRobot& before, const Session& session,
                                       const std::vector<Eigen::VectorXd>& positions, int count);

}  // namespace handsight
