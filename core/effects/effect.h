// SPDX-License-Identifier: Apache-2.0
// A physical effect: a named cause of error with few parameters that are zero when it is absent. Each effect
// describes itself once, in its own file; panel, file, solver, report, docs and tests read that description.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "effects/observation_state.h"
#include "session/effect_definition.h"

namespace handsight {

/// "hand_x" ... : the session's sites of six motions, by the prefix hand, mount or body.
inline constexpr const char* motion_axes[] = {"x", "y", "z", "rx", "ry", "rz"};

/// The site of a formula that moves the angle of every joint that moves by itself, with its own q, velocity and so on.
inline constexpr const char* every_angle = "every_angle";

/// Where an effect may sit: an instance for every moving joint, for every mimic joint, for every marker, for cameras of
/// a rig, for every tag of a body of tags, for every part of a joined session, or one for the whole session.
enum class EffectScope { joint, mimic_joint, marker, camera, tag, part, session };

struct EffectParameter {
  std::string name;
  std::string unit;
  double sigma = 0;        // the prior sigma, one standard deviation: the prior's scale
  bool is_choice = false;  // a choice among alternatives (an observation, a form), not a number that a fit may move
  std::vector<double> choices = {};  // the alternatives; empty: the orders of all observations
  double share_of_focal = 0;         // > 0: `sigma` is for a usual camera; of a session it is this share of fx (px)
};

/// What the check with the real robot reads, so that the model can predict it (diagnosis/robot_check.h).
enum class CheckReads {
  number,        // a number of the effect itself, of the first parameter's unit: a mass, an angle, a shift
  drop,          // how much more the hand drops once a known mass hangs on it
  turn,          // how much further the joint turns between two marks than it reads
  two_sides,     // how far the hand moves between the two flanks, or the two directions of approach
  start_to_end,  // how far the hand has moved in the same pose once the session is over
  place,         // how far the hand is beside where the model has it
  epipolar,      // how far matched points lie off the epipolar line
  image,         // how far image points lie from where the calibration has them
};

struct Effect {
  std::string id;
  std::string title;
  std::string cause;       // what happens, in words
  std::string visibility;  // where it can be seen and where not
  std::string check;       // a cheap check with the real robot
  CheckReads check_reads = CheckReads::place;
  std::string source;
  EffectScope scope = EffectScope::joint;
  std::vector<EffectParameter> parameters;
  /// Adds to the sites of the chain what the effect does in one observation. `place` is the robot's joint, the
  /// marker, the camera, the tag's number or the part, -1 for the session; `values` has one number a parameter. Linear
  /// in the parameters that are no choices: the sites take up what is not.
  std::function<void(const ObservationState&, int place, std::span<const double> values, Sites& sites)> move;
  /// The same in words that programs in other languages can be written from: formulas of sites (own_effect.h), in the
  /// parameters' names. Where there is none the effect moves its sites by the same amount in all observations, or what
  /// it moves is no part of the arm. Set beside `move` (amount.h).
  std::function<std::vector<DefinedMove>(const Chain&, int place, std::span<const double> values)> formulas = {};
  std::shared_ptr<const EffectDefinition> definition;  // of an effect by formula; null: of the catalogue
  std::vector<std::string> cameras = {};  // of camera scope: by camera of the rig, its name; empty where it has none
  std::vector<int> tags = {};             // of tag scope: the numbers of the tags
  std::vector<std::string> parts = {};    // of part scope: what the parts of the joined session are called
  bool reads_torque = false;              // its formula reads gravity torques (ObservationState::torque)
  bool reads_place = false;               // its formula reads where the TCP is (ObservationState::tcp)

  /// A curve that the program has found: it is named by its formula, not by a name.
  bool is_unnamed() const { return definition && definition->unnamed; }
};

/// Effects of this session beside those of the catalogue: by formula (own_effect.h), and those of its cameras
/// (rig_effects.h), which stand in place of the catalogue's of the same id.
using OwnEffects = std::vector<std::shared_ptr<const Effect>>;

/// Effects of joint scope change their own joint's numbers and nothing else.
inline bool moves_one_joint(const Effect& e) {
  return e.scope == EffectScope::joint || e.scope == EffectScope::mimic_joint;
}

/// All effects that the program knows, each with a unique id.
const std::vector<Effect>& catalogue();

/// The effects of the catalogue that none of these stands in place of.
std::vector<const Effect*> catalogue_beside(const OwnEffects& own);

/// The effect of that id, null where there is none; own ones first.
const Effect* find_effect(const std::string& id);
const Effect* find_effect(const std::string& id, const OwnEffects& own);

/// One effect at one place with values for its parameters, in the order of Effect::parameters.
struct EffectTerm {
  std::string id;
  int place = -1;  // index into robot.joints, the marker, camera, tag's number or part; -1 for the session
  std::vector<double> values;
  std::vector<char> held =
      {};  // per parameter, not 0: where the term is estimated, this number stays; empty: none does
  std::shared_ptr<const Effect> own = nullptr;  // the effect where it is one of OwnEffects; null: that of the catalogue
  double size = 1;  // of its numbers where it is estimated: their prior sigmas, in usual ones
};

/// Is the term there a little, as at each joint of every robot? Then it is a part of the model, but no cause that is
/// told.
inline bool is_small(const EffectTerm& term) { return term.size < 1; }

/// What the term is a term of. Its id must be one of the catalogue where it is no own effect.
const Effect& term_effect(const EffectTerm& term);

/// A term of an effect, all numbers 0. `own`: the effect where it is one by formula.
EffectTerm term_of(const Effect& effect, int place, std::shared_ptr<const Effect> own = nullptr);

/// Does a fit that estimates the term move this number?
inline bool is_free(const Effect& effect, const EffectTerm& term, std::size_t parameter) {
  return !effect.parameters[parameter].is_choice && (parameter >= term.held.size() || term.held[parameter] == 0);
}

/// The places where an effect may sit in this chain and the measurement can depend on it: no joints beside the way from
/// the root to TCP and mount, but for those that load springs on it or that joints on it follow.
std::vector<int> effect_places(const Effect& effect, const Chain& chain);

/// The name of a place: a joint's or camera's name, "marker 2", "tag 7", or empty.
std::string place_name(const Effect& effect, int place, const Robot& robot);

/// The chain's sites, all zero, with room for every joint and marker.
Sites unmoved_sites(const Chain& chain);

/// Are all numbers finite?
bool is_finite(const Sites& sites);

/// How many markers there must be for these terms: one more than the highest that one of them sits at.
int count_markers(const std::vector<EffectTerm>& terms);

/// The sites as these terms move them in one observation; markers that the chain does not count have a place too.
Sites moved_sites(const ObservationState& states, const std::vector<EffectTerm>& terms);

/// The prior sigma of a parameter in this chain: EffectParameter::sigma, or what the cameras' focal length makes of
/// it.
double prior_sigma(const EffectParameter& parameter, const Chain& chain);

/// Parses `id` (everywhere it may sit) or `id:joint+joint` (numbers where it sits at markers or tags) into terms whose
/// numbers are all 0, to be estimated. InputError as below.
std::vector<EffectTerm> effect_terms(const std::string& text, const Chain& chain, const OwnEffects& own = {});

/// One number of a term list.
struct NumberPlace {
  std::size_t term = 0, parameter = 0;
};

/// Adds to the number that a name in a file means: `of` is a joint, a marker ("2" or "marker 2"), a tag, or empty for
/// the session scope. The term is made where it is missing. InputError names what is not known.
NumberPlace add_effect_number(const std::string& id, const std::string& of, const std::string& name, double value,
                              const Robot& robot, std::vector<EffectTerm>& terms, const OwnEffects& own = {});

/// Parses `id:joint.parameter=value` (joint scope), `id:7.parameter=value` with a marker's or tag's number, or
/// `id:parameter=value` into a term list, adding to a term that is there already. InputError names what is not known
/// and lists what is.
void add_effect_value(const std::string& text, const Robot& robot, std::vector<EffectTerm>& terms,
                      const OwnEffects& own = {});

}  // namespace handsight
