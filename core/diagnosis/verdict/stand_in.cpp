// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/stand_in.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/verdict/finding.h"

namespace handsight {
namespace {

constexpr double steepest_bend = 3 * M_PI / 180;
constexpr double longest_misprint = 3;  // of a target's length: four times as large as it was typed

/// What is distal of a joint, stretched out across gravity: no posture has a larger moment (N m).
double find_heaviest_load(const Robot& robot, const Vector3& gravity, std::size_t joint) {
  std::vector<double> reach(robot.links.size(), -1);  // m, from the joint; -1: not distal
  reach[static_cast<std::size_t>(robot.joints[joint].child_link)] = 0;
  double load = 0;
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    if (const int parent = robot.links[l].parent_joint; parent >= 0 && parent != static_cast<int>(joint)) {
      const Joint& j = robot.joints[static_cast<std::size_t>(parent)];
      const double before = reach[static_cast<std::size_t>(j.parent_link)];
      const double travel = j.kind == JointKind::prismatic ? std::min(1.0, std::max(-j.lower, j.upper)) : 0;
      if (before >= 0)
        reach[l] = before + j.parent_from_joint.translation.norm() + j.joint_from_child.translation.norm() + travel;
    }
    if (reach[l] >= 0) load += robot.links[l].mass * (reach[l] + robot.links[l].center_of_mass.norm());
  }
  return load * gravity.norm();
}

bool is_spring(const Effect& effect, std::size_t parameter) {
  return effect.scope == EffectScope::joint && effect.parameters[parameter].unit == "rad/(N m)";
}

bool is_estimated(const FittedEffect& effect) {
  return std::any_of(effect.sigmas.begin(), effect.sigmas.end(), [](double s) { return s > 0; });
}

}  // namespace

double find_largest_built(const EffectTerm& term, std::size_t parameter, const Chain& chain) {
  const Effect& effect = term_effect(term);
  if (effect.id == "target_scale") return longest_misprint;
  const double usual = largest_built * prior_sigma(effect.parameters[parameter], chain);
  if (!is_spring(effect, parameter) || term.place < 0) return usual;
  const double load = find_heaviest_load(chain.robot, chain.gravity, static_cast<std::size_t>(term.place));
  return load > 0 ? std::max(usual, steepest_bend / load) : usual;
}

bool is_plausible(const std::vector<EffectTerm>& terms, const Chain& chain) {
  for (const EffectTerm& term : terms) {
    const Effect& effect = term_effect(term);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (!effect.parameters[p].is_choice &&
          std::abs(term.values[p]) > largest_plausible * prior_sigma(effect.parameters[p], chain))
        return false;
  }
  return true;
}

bool is_too_large(const EffectTerm& term, const Chain& chain) {
  const Effect& effect = term_effect(term);
  for (std::size_t p = 0; p < effect.parameters.size(); ++p)
    if (is_free(effect, term, p) && std::abs(term.values[p]) > find_largest_built(term, p, chain)) return true;
  return false;
}

std::vector<StandIn> stand_ins(const Fit& fit) {
  std::vector<StandIn> list;
  if (!fit.problem.source) return list;
  const Chain& chain = fit.problem.source->chain;
  for (const FittedEffect& f : fit.effects) {
    if (!is_estimated(f) || is_small(f.term) || term_effect(f.term).is_unnamed()) continue;
    const bool back = pushes_back({f.term}, {f.sigmas});
    if (!back && !is_too_large(f.term, chain)) continue;
    auto same = std::find_if(list.begin(), list.end(), [&](const StandIn& s) { return s.id == f.term.id; });
    if (same == list.end()) same = list.insert(list.end(), StandIn{.id = f.term.id});
    const std::string place = place_name(term_effect(f.term), f.term.place, chain.robot);
    if (!place.empty()) same->where.push_back(place);
    same->pushes_back = same->pushes_back || back;
  }
  for (const FittedEffect& f : fit.effects)
    for (StandIn& s : list)
      if (s.id == f.term.id && is_estimated(f) && !is_small(f.term) && !pushes_back({f.term}, {f.sigmas}) &&
          !is_too_large(f.term, chain))
        s.is_everywhere = false;
  return list;
}

}  // namespace handsight
