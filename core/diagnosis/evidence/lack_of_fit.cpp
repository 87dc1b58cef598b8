// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/lack_of_fit.h"

namespace handsight {

std::optional<NoiseTest> lack_of_fit(const Fit& f) {
  if (!f.noise || !(*f.noise > 0)) return std::nullopt;
  const bool is_estimated = f.noise_estimate && f.noise_estimate->sigma > 0;
  const double noise = is_estimated ? f.noise_estimate->sigma : *f.noise;
  return noise_test(f.solution.normal.data_cost() / (noise * noise), f.rows - f.unknowns,
                    is_estimated ? f.noise_estimate->degrees : 0);
}

}  // namespace handsight
