// SPDX-License-Identifier: Apache-2.0
// The known markers among all corners of a stereo pair by the sides between them alone: nothing is known of where the
// body is.
#pragma once

#include <vector>

#include "vision/markers/following_observation.h"

namespace handsight {

/// One way to see the body in a stereo pair.
struct BodyCandidate {
  std::vector<MatchedMarker> markers;  // three or more, by marker
  Rigid sensor_from_body;              // laid onto their triangulated points
  double misfit = 0;                   // chi-squared of the markers on the body, and how unlike their corners look
  double sigma = 0;                    // m, of one point of it: the worst of its markers
  double turn_sigma = 0;               // rad: how well its rotation is known
};

/// Every assignment of corner pairs to three or more markers (all known ones, where they are no more than three) whose
/// sides agree within 3 sigma, the best first and at most `most`. Empty where fewer than three markers are known.
std::vector<BodyCandidate> body_candidates(const StereoRig& rig, const std::vector<Corner>& left,
                                           const std::vector<Corner>& right, const KnownMarkers& known,
                                           const MatchOptions& options = {}, std::size_t most = 60);

}  // namespace handsight
