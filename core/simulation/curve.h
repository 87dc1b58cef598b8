// SPDX-License-Identifier: Apache-2.0
// A deviation of one joint's angle that no effect of the catalogue describes, to hide in a simulated session.
#pragma once

#include <string>
#include <vector>

#include "effects/effect.h"

namespace handsight {

/// The joint stands at q + size sin(order q) (or cos), q its sensor angle.
struct Curve {
  int joint = -1;   // index into robot.joints
  double size = 0;  // rad; m of a prismatic joint
  bool cosine = false;
  double order = 1;  // per rad; need not be whole
};

/// Parses "arm_3: 0.0015*sin(3q)". Throws InputError where it is not understood or the robot has no such moving joint.
Curve parse_curve(const std::string& text, const Robot& robot);

/// The sites as effects and curves move them in one observation.
Sites moved_sites(const ObservationState& states, const std::vector<EffectTerm>& terms,
                  const std::vector<Curve>& curves);

/// "0.0015*sin(3q)": what parse_curve reads after the joint's name, bit for bit.
std::string curve_formula(const Curve& curve);

}  // namespace handsight
