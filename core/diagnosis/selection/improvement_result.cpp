// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/improvement_result.h"

namespace handsight {

ImprovementStep find_step(const Diagnosis& model) {
  ImprovementStep s;
  s.fitted = model.report.fitted;
  s.held_out = model.report.held_out;
  s.held_out_region = model.report.held_out_region;
  s.held_out_session = model.report.held_out_session;
  s.noise = model.noise;
  s.rms_of_noise_m = model.report.rms_of_noise_m;
  return s;
}

}  // namespace handsight
