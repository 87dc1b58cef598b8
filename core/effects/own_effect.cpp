// SPDX-License-Identifier: Apache-2.0
#include "effects/own_effect.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/text.h"
#include "effects/formula.h"
#include "effects/part_effects.h"
#include "effects/rig_effects.h"
#include "effects/target_effects.h"

namespace handsight {
namespace {

enum class Slot { angle, compliance, bend, before, after, marker, hand, mount, body, gravity, camera };

struct Place {
  Slot slot = Slot::angle;
  int index = 0;   // of the axis, or of the camera's number
  int camera = 0;  // of the rig
};

struct NamedPlace {
  std::string name;
  Place place;
};

std::vector<NamedPlace> sites_of_scope(const std::string& scope, const Rig& rig) {
  std::vector<NamedPlace> all;
  const auto six = [&](const std::string& prefix, Slot slot) {
    for (int i = 0; i < 6; ++i) all.push_back({prefix + "_" + motion_axes[i], {slot, i}});
  };
  if (scope == "joint") {
    all = {{"angle", {Slot::angle, 0}}, {"compliance", {Slot::compliance, 0}}, {"bend_compliance", {Slot::bend, 0}}};
    six("before", Slot::before);
    six("after", Slot::after);
  } else if (scope == "marker") {
    for (int i = 0; i < 3; ++i) all.push_back({motion_axes[i], {Slot::marker, i}});
  } else {
    six("hand", Slot::hand);
    six("mount", Slot::mount);
    six("body", Slot::body);
    all.push_back({"gravity_rx", {Slot::gravity, 0}});
    all.push_back({"gravity_ry", {Slot::gravity, 1}});
    for (int c = 0; c < rig.count(); ++c) {
      int i = 0;
      for (const CameraNumber& number : camera_numbers(rig.at(c).camera))
        all.push_back({rig.at(c).name + "_" + number.name, {Slot::camera, i++, c}});
    }
  }
  return all;
}

void add_to(Place p, int place, double amount, const ObservationState& c, Sites& sites) {
  switch (p.slot) {
    case Slot::angle:
      sites.robot.joints[static_cast<std::size_t>(place)].angle += amount;
      break;
    case Slot::compliance:
      sites.robot.joints[static_cast<std::size_t>(place)].compliance += amount;
      break;
    case Slot::bend:
      sites.robot.joints[static_cast<std::size_t>(place)].lateral_compliance += amount;
      break;
    case Slot::before:
      sites.robot.joints[static_cast<std::size_t>(place)].frame[p.index] += amount;
      break;
    case Slot::after:
      sites.robot.joints[static_cast<std::size_t>(place)].after[p.index] += amount;
      break;
    case Slot::marker:
      if (place < c.chain->marker_count) sites.markers[static_cast<std::size_t>(place)][p.index] += amount;
      break;
    case Slot::hand:
      sites.hand[p.index] += amount;
      break;
    case Slot::mount:
      sites.drift[p.index] += amount;
      break;
    case Slot::body:
      sites.body[p.index] += amount;
      break;
    case Slot::gravity:
      (p.index == 0 ? sites.robot.tilt_x : sites.robot.tilt_y) += amount;
      break;
    case Slot::camera:
      sites.cameras[static_cast<std::size_t>(p.camera)].numbers[p.index] += amount;
      break;
  }
}

/// What a formula may name, in the order of its numbers: parameters, the own joint's four, the session's three, the
/// TCP's place, then q_NAME and tau_NAME of every joint that moves.
struct Names {
  std::vector<std::string> all;
  std::size_t parameters = 0;
  std::vector<int> joints;  // of q_NAME and tau_NAME

  std::size_t own() const { return parameters; }
  std::size_t session() const { return parameters + 4; }
  std::size_t tcp() const { return parameters + 7; }
  std::size_t joint(std::size_t i) const { return parameters + 10 + 2 * i; }
};

Names list_names(const EffectDefinition& d, const Robot& robot) {
  Names names;
  for (const DefinedParameter& p : d.parameters) names.all.push_back(p.name);
  names.parameters = names.all.size();
  for (const char* name : {"q", "tau", "velocity", "approach", "time", "seconds", "order", "tcp_x", "tcp_y", "tcp_z"})
    names.all.push_back(name);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    if (!robot.joints[j].moves()) continue;
    names.joints.push_back(static_cast<int>(j));
    names.all.push_back("q_" + formula_name(robot.joints[j].name));
    names.all.push_back("tau_" + formula_name(robot.joints[j].name));
  }
  return names;
}

struct CompiledMove {
  Place place;
  Formula formula;
};

struct Compiled {
  Names names;
  std::vector<CompiledMove> moves;
  bool reads_torque = false, reads_place = false;
};

Message where(const EffectDefinition& d, int line) {
  if (d.file.empty()) return message("Effect \"{}\"", d.id);
  return message("{}, line {}, effect \"{}\"", d.file, line > 0 ? line : d.line, d.id);
}

/// The numbers of one observation; parameters are left at 0.
std::vector<double> numbers_at(const Compiled& own, const ObservationState& c, int place) {
  std::vector<double> numbers(own.names.all.size(), 0.0);
  const auto set = [&](std::size_t at, double value) { numbers[at] = value; };
  Eigen::VectorXd torque;
  if (own.reads_torque) torque = c.torque.size() > 0 ? c.torque : nominal_torques(*c.chain, c.sensor);
  if (place >= 0 && place < c.sensor.size()) {
    set(own.names.own(), c.sensor[place]);
    if (own.reads_torque) set(own.names.own() + 1, torque[place]);
    set(own.names.own() + 2, c.velocity[place]);
    set(own.names.own() + 3, c.approach[place]);
  }
  set(own.names.session(), c.duration > 0 ? c.elapsed / c.duration : 0);
  set(own.names.session() + 1, c.elapsed);
  set(own.names.session() + 2, c.order);
  if (own.reads_place) {
    const Vector3 tcp = c.tcp ? *c.tcp : nominal_tcp(*c.chain, c.sensor);
    for (std::size_t i = 0; i < 3; ++i) set(own.names.tcp() + i, tcp[static_cast<Eigen::Index>(i)]);
  }
  for (std::size_t i = 0; i < own.names.joints.size(); ++i) {
    set(own.names.joint(i), c.sensor[own.names.joints[i]]);
    if (own.reads_torque) set(own.names.joint(i) + 1, torque[own.names.joints[i]]);
  }
  return numbers;
}

void move_by_formula(const Compiled& own, const ObservationState& c, int place, std::span<const double> values,
                     Sites& sites) {
  std::vector<double> numbers = numbers_at(own, c, place);
  std::copy(values.begin(), values.end(), numbers.begin());
  const auto is_there = [&](std::size_t used) { return used < own.names.parameters && numbers[used] != 0; };
  for (const CompiledMove& m : own.moves) {
    // Every part has a parameter as a factor, and to evaluate a formula is dear: a fit asks for one parameter at a
    // time.
    const std::vector<std::size_t>& used = m.formula.used();
    if (std::any_of(used.begin(), used.end(), is_there)) add_to(m.place, place, m.formula.value(numbers), c, sites);
  }
}

bool near(double a, double b, double size) { return std::abs(a - b) <= 1e-9 * (size + std::abs(a) + std::abs(b)); }

/// f(0) = 0, f(2 a) = 2 f(a) in each parameter, and the parameters add, wherever the variables stand.
void check_linear(const EffectDefinition& d, const DefinedMove& m, const Formula& formula, const Names& names) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  for (int draw = 0; draw < 20; ++draw) {
    std::vector<double> numbers(names.all.size());
    for (double& x : numbers) x = uniform(random);
    if (draw % 2) std::for_each(numbers.begin(), numbers.end(), [](double& x) { x = std::abs(x); });
    std::fill_n(numbers.begin(), names.parameters, 0.0);
    const double none = formula.value(numbers);
    if (!std::isfinite(none)) continue;
    if (none != 0)
      throw InputError(
          message("{}: {} has a part without any parameter; expected every part to be in proportion "
                  "to one, so that the effect is absent when all are 0.",
                  where(d, m.line), in_quotes(m.formula, 120)));
    std::vector<double> all = numbers;
    double sum = 0, size = 0;
    for (std::size_t p = 0; p < names.parameters; ++p) {
      std::vector<double> one = numbers, two = numbers;
      all[p] = one[p] = uniform(random);
      two[p] = -2 * one[p];
      const double once = formula.value(one), twice = formula.value(two);
      sum += once;
      size += std::abs(once);
      if (!near(twice, -2 * once, 1e-300))
        throw InputError(
            message("{}: {} is not linear in the parameter \"{}\"; expected it as a factor, outside "
                    "of functions and powers.",
                    where(d, m.line), in_quotes(m.formula, 120), d.parameters[p].name));
    }
    if (!near(formula.value(all), sum, size))
      throw InputError(
          message("{}: in {} parameters are multiplied with each other; expected a sum in which each "
                  "part has one parameter.",
                  where(d, m.line), in_quotes(m.formula, 120)));
  }
}

CompiledMove compile(const EffectDefinition& d, const DefinedMove& m, const Names& names, const Rig& rig) {
  const std::vector<NamedPlace> sites = sites_of_scope(d.scope, rig);
  const auto site = std::find_if(sites.begin(), sites.end(), [&](const NamedPlace& s) { return s.name == m.site; });
  if (site == sites.end()) {
    std::string known;
    for (const NamedPlace& s : sites) known += (known.empty() ? "" : " ") + s.name;
    throw InputError(message("{}: scope {} has no site {}; expected one of {}.", where(d, m.line), d.scope,
                             in_quotes(m.site), known));
  }
  CompiledMove move{site->place, Formula(m.formula, names.all, where(d, m.line))};
  for (const std::size_t used : move.formula.used()) {
    if (site->place.slot == Slot::camera && used >= names.parameters)
      throw InputError(
          message("{}: the cameras' numbers are the same in all observations; {} names the variable "
                  "\"{}\", expected parameters and numbers alone.",
                  where(d, m.line), in_quotes(m.formula, 120), names.all[used]));
    if (d.scope != "joint" && used >= names.own() && used < names.session())
      throw InputError(
          message("{}: scope {} has no joint of its own; write {}_NAME with a joint's name in place "
                  "of \"{}\".",
                  where(d, m.line), d.scope, names.all[used], names.all[used]));
  }
  check_linear(d, m, move.formula, names);
  return move;
}

bool is_torque(const std::string& name) { return name == "tau" || name.starts_with("tau_"); }

Compiled compile(const EffectDefinition& d, const Robot& robot, const Rig& rig) {
  Compiled own{list_names(d, robot), {}};
  const Names& names = own.names;
  for (std::size_t p = 0; p < names.parameters; ++p)
    if (std::count(names.all.begin(), names.all.end(), names.all[p]) > 1)
      throw InputError(message("{}: the parameter \"{}\" has the name of a variable; expected another name.",
                               where(d, 0), names.all[p]));
  std::vector<char> used(names.all.size(), 0);
  for (const DefinedMove& m : d.moves) {
    own.moves.push_back(compile(d, m, names, rig));
    for (const std::size_t u : own.moves.back().formula.used()) {
      used[u] = 1;
      own.reads_torque = own.reads_torque || (u >= names.parameters && is_torque(names.all[u]));
      own.reads_place = own.reads_place || (u >= names.tcp() && u < names.joint(0));
    }
  }
  for (std::size_t p = 0; p < names.parameters; ++p)
    if (!used[p])
      throw InputError(message("{}: no formula names the parameter \"{}\"; expected it in one of <moves>.", where(d, 0),
                               names.all[p]));
  return own;
}

EffectScope scope_of(const std::string& scope) {
  return scope == "joint" ? EffectScope::joint : scope == "marker" ? EffectScope::marker : EffectScope::session;
}

void check_finite(const Effect& effect, const Session& session, const std::vector<ObservationState>& all) {
  for (const int place : effect_places(effect, *all.front().chain))
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::vector<double> sizes;
      for (const EffectParameter& p : effect.parameters) sizes.push_back(p.sigma);
      Sites sites = unmoved_sites(*all[i].chain);
      effect.move(all[i], place, sizes, sites);
      if (!is_finite(sites))
        throw InputError(message(
            "{}: the formula is not a finite number at observation {}{}; expected one that is finite everywhere.",
            where(*effect.definition, 0), session.observations[i].id,
            place >= 0 ? " (" + place_name(effect, place, session.robot) + ")" : std::string()));
    }
}

}  // namespace

std::string formula_name(const std::string& name) {
  std::string text = name;
  for (char& c : text)
    if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_')) c = '_';
  return text;
}

std::shared_ptr<const Effect> own_effect(const EffectDefinition& d, const Robot& robot, const Rig& rig) {
  const auto own = std::make_shared<const Compiled>(compile(d, robot, rig));
  auto effect = std::make_shared<Effect>();
  effect->id = d.id;
  effect->title = d.title;
  effect->cause = d.cause;
  effect->visibility = d.visibility;
  effect->check = d.check;
  effect->source = d.source;
  effect->scope = scope_of(d.scope);
  for (const DefinedParameter& p : d.parameters) effect->parameters.push_back({p.name, p.unit, p.sigma});
  effect->definition = std::make_shared<const EffectDefinition>(d);
  effect->reads_torque = own->reads_torque;
  effect->reads_place = own->reads_place;
  effect->move = [own](const ObservationState& c, int place, std::span<const double> values, Sites& sites) {
    move_by_formula(*own, c, place, values, sites);
  };
  effect->formulas = [moves = d.moves](const Chain&, int, std::span<const double>) { return moves; };
  return effect;
}

OwnEffects list_own_effects(const Session& session, const Chain& chain) {
  OwnEffects all;
  if (chain.rig) all = rig_effects_of_parts(*chain.rig, chain.first_cameras);
  const OwnEffects of_parts = part_effects(chain);
  all.insert(all.end(), of_parts.begin(), of_parts.end());
  const OwnEffects of_target = target_effects(session, chain);
  all.insert(all.end(), of_target.begin(), of_target.end());
  if (session.effect_definitions.empty()) return all;
  const Rig cameras = chain.rig.value_or(make_rig(StereoRig{}));
  const std::vector<ObservationState> states = observation_states(session, chain);
  for (const EffectDefinition& d : session.effect_definitions) {
    if (find_effect(d.id))
      throw InputError(
          message("{}: the catalogue has an effect \"{}\" already; give it another id.", where(d, 0), d.id));
    all.push_back(own_effect(d, session.robot, cameras));
    if (!states.empty()) check_finite(*all.back(), session, states);
  }
  return all;
}

}  // namespace handsight
