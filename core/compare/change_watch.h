// SPDX-License-Identifier: Apache-2.0
// Watches a calibrated robot: has anything changed? May be asked after every observation, for ever.
#pragma once

#include <memory>

#include "base/message.h"
#include "compare/comparison_result.h"
#include "correct/calibrated_robot.h"

namespace handsight {

/// By how much something would have changed if it alone had.
struct WatchedChange {
  std::string what, where;  // as in WatchStep
  std::vector<EffectTerm> terms;
  Eigen::VectorXd sigma;
};

/// What is said after one more observation.
struct WatchStep {
  double ln_e_value = 0;  // ln of the e-value: evidence that something has changed, at some time so far
  bool changed = false;   // an e-value of 1000 or more has been reached, now or before
  std::string what;       // id of the likeliest change, as compare names it
  std::string where;      // joint or marker; empty: it has no place
  std::vector<std::string> indistinguishable_from;  // other ids that explain it nearly as well (odds below 20)
  std::vector<EffectTerm> terms;                    // with its size
  Eigen::VectorXd sigma;                            // of the numbers that are no choices, in their order
  Message text;                                     // "The camera turned by ... on its mount"
  std::vector<WatchedChange> each;                  // of all changes, from when the likeliest may have come
};

struct WatchOptions {
  double chance = 1e-3;     // of ever saying that something has changed where nothing has
  std::size_t window = 60;  // observations back to which a change may have come (and the very first one)
};

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

  struct Parts;

 private:
  std::unique_ptr<Parts> parts_;
};

/// Places in `positions` of those poses, at most `count`, that would show best what is most likely to move: the
/// sensor's mount, the body on the hand, the zeros of the joints (one after another, that which adds most to the
/// information).
std::vector<std::size_t> telling_poses(const CalibratedRobot& before, const Session& session,
                                       const std::vector<Eigen::VectorXd>& positions, int count);

}  // namespace handsight
