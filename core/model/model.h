// SPDX-License-Identifier: Apache-2.0
// A model of the robot and its sensors: which effects it has, where, with which values, and what a fit may move. Plain
// names and numbers; the engine's terms are made from it for one session.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "effects/effect.h"
#include "session/session.h"

namespace handsight {

/// One effect of the catalogue, or of the session's own effects, at one place.
struct ModelEffect {
  std::string id;              ///< "joint_offset", "joint_elasticity", ...: `handsight-cli effects` lists them
  std::string place;           ///< "arm_2", "right", "marker 2", "tag 7": where it sits; empty: in the whole session
  std::vector<double> values;  ///< one a parameter, in its unit (rad, m, rad/(N m), ...); empty: all 0
  bool is_estimated = true;    ///< by a fit, which starts at the values; false: the values are held
  std::vector<bool> held;      ///< one a parameter, true: stays while others are estimated; empty: none does
  /// Of an effect by formula that the session does not define: a curve that the program has found. Null: there is none.
  std::shared_ptr<const EffectDefinition> formula = nullptr;
};

/// What is believed of a robot, beside its description. Without effects: the robot as it is described.
struct Model {
  std::vector<ModelEffect> effects;
};

/// The same as the engine's terms, places as indices.
struct ModelTerms {
  std::vector<EffectTerm> held, estimated;
};

/// InputError where an effect is not known, has no such place in this session, has not one value for each of its
/// parameters, or one that is not finite.
ModelTerms list_terms(const Model& model, const Session& session);

/// The model that has these terms; places by the names of `robot`.
Model make_model(const ModelTerms& terms, const Robot& robot);

}  // namespace handsight
