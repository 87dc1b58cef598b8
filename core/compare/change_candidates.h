// SPDX-License-Identifier: Apache-2.0
// What may change between two sessions of one robot. Internal to comparison.cpp.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "estimation/problem/problem.h"

namespace handsight {

/// One alternative: terms that change together.
struct ChangeUnit {
  std::string group;  // what people call it: "lens" for intrinsics and distortion alike
  std::vector<EffectTerm> terms;
  std::string where;
};

/// All that the second side's measurements can show.
std::vector<ChangeUnit> change_units(const Problem& problem);

/// How much rarer a change of that group is than the others, before anything is measured: springs do not change in
/// weeks.
double ln_prior_odds(const std::string& group);

/// The units of the terms' numbers in their order, choices left out.
std::vector<std::string> list_number_units(const std::vector<EffectTerm>& terms, const Robot& robot);

/// "The camera mount turned by 0.12 +- 0.01 degrees and moved by 1.3 mm".
Message change_text(const ChangeUnit& unit, const std::vector<EffectTerm>& values, const Eigen::VectorXd& sigma,
                    const Chain& chain);

}  // namespace handsight
