// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/repeatability_levels.h"

#include <algorithm>

#include "diagnosis/evidence/variance_components.h"

namespace handsight {
namespace {

constexpr double clearly_likelier = 5;    // ln: what another assumption must bring
constexpr double most_of_a_joint = 1e-3;  // rad, three times what is usual: beyond it causes are missing, whose shares
                                          // by joint tell nothing of how each repeats

std::vector<Repeatability> usual_levels() { return {{0, 0}, {1e-4, 0}, {3e-4, 0}, {1e-3, 0}, {3e-3, 0}}; }

std::vector<Repeatability> list_parts(const Repeatability& s) {
  std::vector<Repeatability> parts{{}};  // none at all first
  for (const double part : {0.1, 0.3, 0.6, 1.0}) parts.push_back({part * s.joints, part * s.place, s.of_joint});
  return parts;
}

}  // namespace

std::vector<Repeatability> repeatability_levels(const LinearModel& model, const NoiseKnowledge& noise) {
  std::vector<Repeatability> levels = usual_levels();
  Repeatability best;
  double top = -1e300;
  const auto take = [&](const Repeatability& level, double price) {
    const double evidence = ln_evidence_of_base(model, level, noise) - price;
    if (evidence <= top) return false;
    top = evidence;
    best = level;
    return true;
  };
  for (const Repeatability& level : levels) take(level, 0);
  for (const bool with_place : {false, true})
    if (!with_place || noise.known)
      if (take(likely_repeatability(model, best, noise, with_place), clearly_likelier)) {
        levels = list_parts(best);
        top += clearly_likelier;
      }
  if (!noise.known || best.joints > most_of_a_joint) return levels;
  if (const auto uneven = likely_of_each_joint(model, best))
    if (take(uneven->repeatability, clearly_likelier + uneven->ln_price)) levels = list_parts(best);
  return levels;
}

Message repeatability_text(const Repeatability& s, const std::vector<std::string>& joints) {
  Message text;
  if (s.joints > 0) text = message("joints that repeat to {:.2g} mrad", 1e3 * s.joints);
  if (s.joints > 0 && !s.of_joint.empty() && s.of_joint.size() == joints.size()) {
    const auto worst = std::ranges::max_element(s.of_joint);
    text += message(" ({} to {:.2g} mrad)", joints[static_cast<std::size_t>(worst - s.of_joint.begin())],
                    1e3 * s.joints * *worst);
  }
  if (!(s.place >= least_reported_place)) return text;
  const Message place = message("a hand whose place scatters by {:.2g} mm", 1e3 * s.place);
  return text.empty() ? place : message("{} and {}", text, place);
}

}  // namespace handsight
