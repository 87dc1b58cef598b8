// SPDX-License-Identifier: Apache-2.0
#include "effects/amount.h"

#include "effects/own_effect.h"

namespace handsight {

JointReading<Symbol> own_joint() { return {Symbol("q"), Symbol("velocity"), Symbol("approach")}; }

JointReading<Symbol> named_joint(const Chain& chain, int joint) {
  const std::string name = formula_name(chain.robot.joints[static_cast<std::size_t>(joint)].name);
  return {Symbol("q_" + name), Symbol("velocity_" + name), Symbol("approach_" + name)};
}

std::vector<Symbol> parameter_symbols(const Effect& effect) {
  check(!effect.parameters.empty(), "{} has no parameters yet", effect.id);
  std::vector<Symbol> symbols;
  for (const EffectParameter& p : effect.parameters) symbols.emplace_back(p.name);
  return symbols;
}

}  // namespace handsight
