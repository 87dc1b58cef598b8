// SPDX-License-Identifier: Apache-2.0
// Observations that the fit has not seen, predicted against measured: the honest test of what is exported.
#pragma once

#include <vector>

#include "diagnosis/attribution/inspection.h"

namespace handsight {

struct FreshPose {
  std::int64_t id = 0;
  double distance = 0;  // m, of the hand from where the model predicts it, as Inspect tells it (InspectionRow::hand_m);
                        // without cameras of TCPest from TCP
  double allowed = 0;   // m, how far the 95 % ellipsoid reaches in that direction: of the same distance
  bool is_hit = false;
  bool is_known_bad = false;  // its measurement is wrong, or it was rejected for being off: no test of the model
};

/// Every observation whose hand was seen and that is not part of the fit, against the ellipsoid in which 95 % of new
/// poses lie if they are like the n that were fitted: with S the second moments of tcp_from_tcp_est's translation over
/// these, d' S^-1 d <= 3 n / (n - 2) F(3, n - 2; 0.95) (Hotelling). Empty with fewer than 8 fitted.
std::vector<FreshPose> fresh_poses(const Inspection& inspection);

}  // namespace handsight
