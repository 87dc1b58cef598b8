// SPDX-License-Identifier: Apache-2.0
#include "compare/change_candidates.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "effects/units.h"

namespace handsight {
namespace {

constexpr double degrees = 57.29577951308232;

struct Kind {
  const char *group, *effect;
  bool of_cameras;
};
constexpr Kind kinds[] = {{"camera_mount", "camera_mount", false},
                          {"stereo_rig", "stereo_rig", true},
                          {"lens", "camera_intrinsics", true},
                          {"lens", "lens_distortion", true},
                          {"body_slip", "body_slip", false},
                          {"marker_slip", "marker_slip", false},
                          {"joint_offset", "joint_offset", false},
                          {"payload", "payload", false},
                          {"joint_elasticity", "joint_elasticity", false}};

/// Sigma in two digits, and the value to the same place.
Message measured(double value, double sigma, const Message& unit) {
  if (!(sigma > 0)) return message("{:.3g} +- {:.2g} {}", value, sigma, unit);
  const int places = std::clamp(1 - static_cast<int>(std::floor(std::log10(sigma))), 0, 9);
  return message("{} +- {} {}", number(fmt::format("{:.{}f}", value, places)),
                 number(fmt::format("{:.{}f}", sigma, places)), unit);
}

/// A length and its sigma along it, of three numbers.
Message size_text(const std::vector<double>& v, const Eigen::VectorXd& sigma, std::size_t first, double unit,
                  const char* name) {
  const auto i = static_cast<Eigen::Index>(first);
  const Vector3 x(v[first], v[first + 1], v[first + 2]), s(sigma[i], sigma[i + 1], sigma[i + 2]);
  const double length = x.norm(), along = length > 0 ? x.cwiseProduct(s).norm() / length : s.norm();
  return measured(length * unit, along * unit, name);
}

}  // namespace

std::vector<ChangeUnit> change_units(const Problem& problem) {
  std::vector<ChangeUnit> units;
  const Chain& chain = problem.source->chain;
  for (const Kind& kind : kinds) {
    if (kind.of_cameras && !problem.rig) continue;
    // The cameras of a rig may have effects of their own in place of the catalogue's.
    const OwnEffects& own_effects = problem.source->own_effects;
    const auto found = std::find_if(own_effects.begin(), own_effects.end(),
                                    [&](const auto& e) { return e->id == kind.effect && !e->definition; });
    const std::shared_ptr<const Effect> own = found == own_effects.end() ? nullptr : *found;
    const Effect& effect = own ? *own : *find_effect(kind.effect);
    for (const int place : effect_places(effect, chain)) {
      if (effect.scope == EffectScope::marker && !problem.marker_is_seen[static_cast<std::size_t>(place)]) continue;
      EffectTerm term = term_of(effect, place, own);  // a slip of order 0 is there from the first observation on
      units.push_back({kind.group, {term}, place_name(effect, place, chain.robot)});
    }
  }
  return units;
}

std::vector<std::string> list_number_units(const std::vector<EffectTerm>& terms, const Robot& robot) {
  std::vector<std::string> units;
  for (const EffectTerm& t : terms)
    for (std::size_t p = 0; p < t.values.size(); ++p)
      if (!term_effect(t).parameters[p].is_choice) units.push_back(unit_at(term_effect(t), p, t.place, robot));
  return units;
}

double ln_prior_odds(const std::string& group) { return group == "joint_elasticity" ? std::log(0.1) : 0; }

Message change_text(const ChangeUnit& unit, const std::vector<EffectTerm>& terms, const Eigen::VectorXd& sigma,
                    const Chain& chain) {
  const std::vector<double>& v = terms.front().values;
  const std::string& id = unit.group;
  const char* const device = chain.rig ? "camera" : "tracker";
  if (id == "camera_mount" && chain.is_touch)
    return message("The fixture {} turned by {} and moved by {}", unit.where,
                   size_text(v, sigma, 3, degrees, "degrees"), size_text(v, sigma, 0, 1e3, "mm"));
  if (id == "body_slip" && chain.is_touch)
    return message("The probe slipped on the hand by {}", size_text(v, sigma, 0, 1e3, "mm"));
  if (id == "camera_mount")
    return message("The {} turned by {} and moved by {} on its mount", device,
                   size_text(v, sigma, 3, degrees, "degrees"), size_text(v, sigma, 0, 1e3, "mm"));
  if (id == "stereo_rig")
    return message("The cameras turned against each other by {} and moved by {}",
                   size_text(v, sigma, 3, degrees, "degrees"), size_text(v, sigma, 0, 1e3, "mm"));
  if (id == "body_slip")
    return message("The marker body slipped on the hand by {} and turned by {}", size_text(v, sigma, 0, 1e3, "mm"),
                   size_text(v, sigma, 3, degrees, "degrees"));
  if (id == "marker_slip")
    return message("Of the markers {} alone slipped, by {}", unit.where, size_text(v, sigma, 0, 1e3, "mm"));
  const std::string own_unit = unit_at(term_effect(terms.front()), 0, terms.front().place, chain.robot);
  if (id == "joint_offset") {
    const bool slides = own_unit == "m";
    const double scale = slides ? 1e3 : degrees;
    return message("Joint {} lost its zero: it stands {} further than it reads", unit.where,
                   measured(v[0] * scale, sigma[0] * scale, slides ? "mm" : "degrees"));
  }
  if (id == "payload") return message("The hand carries {} more than it did", measured(v[0], sigma[0], "kg"));
  if (id == "joint_elasticity") {
    const auto [name, scale] = readable_unit(own_unit, std::abs(v[0]));
    return message("Joint {} gives way by {} more than it did", unit.where,
                   measured(v[0] * scale, sigma[0] * scale, looked_up(name)));
  }
  return message("The cameras' lenses are not what they were ({})",
                 terms.front().id == "lens_distortion" ? "distortion" : "focal lengths or centres");
}

}  // namespace handsight
