// SPDX-License-Identifier: Apache-2.0
#include "export/program_moves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/text.h"
#include "effects/own_effect.h"

namespace handsight {
namespace {

struct JointRead {
  std::string what;  // q or tau
  int joint;
};

/// What q_NAME and tau_NAME are of.
std::optional<JointRead> joint_read(const std::string& name, const Robot& robot) {
  for (const std::string what : {"q", "tau"}) {
    if (!name.starts_with(what + "_")) continue;
    for (std::size_t j = 0; j < robot.joints.size(); ++j)
      if (robot.joints[j].moves() && formula_name(robot.joints[j].name) == name.substr(what.size() + 1))
        return JointRead{what, static_cast<int>(j)};
  }
  return std::nullopt;
}

int number_of_axis(const std::string& site) {
  const std::string axis = site.substr(site.rfind('_') + 1);
  for (int i = 0; i < 6; ++i)
    if (axis == motion_axes[i]) return i;
  return -1;
}

/// The program's number that a site is; empty where it does not move the hand.
std::string target_of(const std::string& site, int joint) {
  const std::string at = fmt::format("joint[{}].", joint);
  if (site == "angle" || site == "compliance") return at + site;
  if (site == "bend_compliance") return at + "bend";
  if (site.starts_with("before_")) return at + fmt::format("before[{}]", number_of_axis(site));
  if (site.starts_with("after_")) return at + fmt::format("after[{}]", number_of_axis(site));
  if (site.starts_with("hand_")) return fmt::format("whole.hand[{}]", number_of_axis(site));
  if (site.starts_with("body_")) return fmt::format("whole.body[{}]", number_of_axis(site));
  if (site == "gravity_rx") return "whole.tilt[0]";
  if (site == "gravity_ry") return "whole.tilt[1]";
  return "";
}

class Writer {
 public:
  Writer(const CalibratedRobot& robot, const std::vector<int>& place, HandProgram& program)
      : robot_(robot), place_(place), program_(program) {}

  void add(const EffectTerm& term) {
    const Effect& effect = term_effect(term);
    const std::string where = place_name(effect, term.place, robot_.chain.robot);
    of_ = effect.id + (where.empty() ? "" : " of " + where);
    const std::size_t before = program_.moves.size();
    if (effect.formulas) {
      for (const DefinedMove& m : effect.formulas(robot_.chain, term.place, term.values)) add_formula(m, effect, term);
    } else {
      add_constants(effect, term);
    }
    if (program_.moves.size() == before)
      program_.left_out.push_back(of_ + " does not move the hand and is not part of this file.");
  }

 private:
  int locate(int joint) const { return joint >= 0 ? place_[static_cast<std::size_t>(joint)] : -1; }

  void push(const std::string& target, Expression amount) {
    program_.moves.push_back({target, std::move(amount), of_});
  }

  void add_formula(const DefinedMove& f, const Effect& effect, const EffectTerm& term) {
    if (effect.scope == EffectScope::marker || effect.scope == EffectScope::camera) return;
    if (f.site == every_angle) {
      for (std::size_t j = 0; j < place_.size(); ++j)
        if (place_[j] >= 0 && !robot_.chain.robot.joints[j].is_mimic())
          push(target_of("angle", place_[j]), formula(f, effect, term, static_cast<int>(j)));
      return;
    }
    const int at = locate(term.place);
    if (moves_one_joint(effect) && at < 0) return;  // of a joint that the hand does not depend on
    const std::string target = target_of(f.site, at);
    if (!target.empty()) push(target, formula(f, effect, term, term.place));
  }

  /// With the parameters' values in it, and variables as the program calls them.
  Expression formula(const DefinedMove& f, const Effect& effect, const EffectTerm& term, int joint) const {
    return with_names(parse_expression(f.formula), [&](const std::string& name) -> Expression {
      for (std::size_t p = 0; p < effect.parameters.size(); ++p)
        if (effect.parameters[p].name == name) return number_expression(term.values[p]);
      return variable(name, joint);
    });
  }

  Expression variable(const std::string& name, int own_joint) const {
    if (name == "time") return name_expression("share");
    if (name == "seconds" || name == "order") return name_expression(name);
    if (name.starts_with("tcp_")) return name_expression(fmt::format("tcp[{}]", number_of_axis(name)));
    const auto named = joint_read(name, robot_.chain.robot);
    const int at = locate(named ? named->joint : own_joint);
    check(at >= 0, "the formula of {} reads {}, which is no part of the program", of_, name);
    const std::string what = named ? named->what : name;
    return name_expression(fmt::format("{}[{}]", what == "tau" ? "torque" : what, at));
  }

  /// Of an effect that moves its sites by the same amount everywhere: found by asking it twice.
  void add_constants(const Effect& effect, const EffectTerm& term) {
    const Sites a = asked(term, 0.3), b = asked(term, -0.8);
    Numbers first = list_numbers(a, effect), second = list_numbers(b, effect);
    if (first != second)
      throw InputError(
          message("The effect {} cannot be written into a file of this kind; export as yaml or csv.", effect.id));
    for (const auto& [target, amount] : first) push(target, number_expression(amount));
  }

  using Numbers = std::map<std::string, double>;

  Sites asked(const EffectTerm& term, double at) const {
    const auto count = static_cast<Eigen::Index>(robot_.chain.joints.size());
    ObservationState c = states_at(robot_.chain, Eigen::VectorXd::Constant(count, at));
    c.velocity.setConstant(at);
    c.approach.setConstant(at);
    c.elapsed = std::abs(at);
    c.order = static_cast<int>(100 * std::abs(at));
    return moved_sites(c, {term});
  }

  void take(Numbers& numbers, const std::string& target, double amount) const {
    if (amount != 0) numbers[target] = amount;
  }

  Numbers list_numbers(const Sites& s, const Effect& effect) const {
    Numbers n;
    for (std::size_t j = 0; j < s.robot.joints.size(); ++j) {
      if (place_[j] < 0) continue;
      const JointChange& c = s.robot.joints[j];
      const std::string at = fmt::format("joint[{}].", place_[j]);
      take(n, at + "angle", c.angle);
      take(n, at + "multiplier_error", c.multiplier_error);
      take(n, at + "share", c.share);
      take(n, at + "compliance", c.compliance);
      take(n, at + "bend", c.lateral_compliance);
      take(n, at + "gap", c.gap);
      for (int i = 0; i < 6; ++i) {
        take(n, at + fmt::format("before[{}]", i), c.frame[i]);
        take(n, at + fmt::format("after[{}]", i), c.after[i]);
      }
    }
    for (int i = 0; i < 6; ++i) {
      take(n, fmt::format("whole.hand[{}]", i), s.hand[i]);
      take(n, fmt::format("whole.body[{}]", i), s.body[i]);
    }
    take(n, "whole.tilt[0]", s.robot.tilt_x);
    take(n, "whole.tilt[1]", s.robot.tilt_y);
    for (int i = 0; i < 3; ++i) {
      take(n, fmt::format("whole.base[{}]", i), s.robot.base_compliance[i]);
      take(n, fmt::format("whole.payload_moment[{}]", i), s.robot.payload_moment[i]);
    }
    take(n, "whole.payload_mass", s.robot.payload_mass);
    check(s.robot.payload_link < 0 || s.robot.payload_link == robot_.chain.tcp_link,
          "{} hangs its payload elsewhere than at the TCP link", effect.id);
    return n;
  }

  const CalibratedRobot& robot_;
  const std::vector<int>& place_;
  HandProgram& program_;
  std::string of_;
};

bool bends(const Sites& s) {
  const auto joint = [](const JointChange& c) { return c.compliance != 0 || c.lateral_compliance != 0 || c.gap != 0; };
  return std::any_of(s.robot.joints.begin(), s.robot.joints.end(), joint) || !s.robot.base_compliance.isZero(0);
}

}  // namespace

bool bends(const CalibratedRobot& robot) {
  for (const EffectTerm& term : robot.model.effects) {
    const Effect& effect = term_effect(term);
    if (effect.formulas) {
      for (const DefinedMove& m : effect.formulas(robot.chain, term.place, term.values))
        if (m.site == "compliance" || m.site == "bend_compliance") return true;
      continue;
    }
    const auto count = static_cast<Eigen::Index>(robot.chain.joints.size());
    if (bends(moved_sites(states_at(robot.chain, Eigen::VectorXd::Constant(count, 0.3)), {term}))) return true;
  }
  return false;
}

std::vector<int> joints_read_by_name(const CalibratedRobot& robot) {
  std::vector<int> joints;
  for (const EffectTerm& term : robot.model.effects) {
    const Effect& effect = term_effect(term);
    if (!effect.formulas) continue;
    for (const DefinedMove& m : effect.formulas(robot.chain, term.place, term.values))
      with_names(parse_expression(m.formula), [&](const std::string& name) {
        if (const auto named = joint_read(name, robot.chain.robot)) joints.push_back(named->joint);
        return name_expression(name);
      });
  }
  return joints;
}

void add_moves(const CalibratedRobot& robot, const std::vector<int>& place, HandProgram& program) {
  Writer writer(robot, place, program);
  for (const EffectTerm& term : robot.model.effects) writer.add(term);
}

}  // namespace handsight
