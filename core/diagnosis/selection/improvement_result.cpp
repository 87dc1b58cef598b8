// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/improvement_result.h"

#include <algorithm>
#include <iterator>

namespace handsight {

ChangedNames changed_names(const std::vector<EffectTerm>& before, const std::vector<EffectTerm>& after) {
  const auto ids = [](const std::vector<EffectTerm>& terms) {
    std::set<std::string> all;
    for (const EffectTerm& t : terms) all.insert(t.id);
    return all;
  };
  const auto only_in = [](const std::set<std::string>& one, const std::set<std::string>& other) {
    std::vector<std::string> left;
    std::set_difference(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(left));
    return left;
  };
  const std::set<std::string> was = ids(before), is = ids(after);
  return {only_in(was, is), only_in(is, was)};
}

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
