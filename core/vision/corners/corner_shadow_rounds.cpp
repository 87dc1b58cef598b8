// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_shadow_rounds.h"

#include <array>
#include <cmath>
#include <vector>

#include "vision/corners/corner_predicted.h"

namespace handsight {
namespace {

constexpr double unsure_px = 0.1;               // px an axis, of a position
constexpr double right_line = 2;                // px, between the shadow's edge that was fitted and where it should run
constexpr double worse_noise = 1.2;             // times, that a fit with the shadow may leave where it is the surer one
constexpr double much_left = 0.1, noisier = 2;  // half contrasts; times the image's noise, squared
constexpr double unequal = 1.4, off_step = 0.4;  // times, of neighbours' distances; of a step, what it may be off
constexpr int shadow_rounds = 4;

// A corner where it was found; `with_others`: where its neighbours predict it before, between two of them and as far
// from one as the next is on its other side. Nothing where it has none.
std::vector<PredictedCorner> predicted_again(const Lattice& lattice, int number, double blur, bool with_others) {
  const Eigen::Vector2d& here = lattice.position(number);
  const std::array<int, 4> near = lattice.neighbours(number);
  std::vector<PredictedCorner> all;
  for (const int place : {0, 2}) {
    if (!with_others || near[place] < 0 || near[place + 1] < 0) continue;
    const Eigen::Vector2d &one = lattice.position(near[place]), &other = lattice.position(near[place + 1]);
    const double to_one = (one - here).norm(), to_other = (other - here).norm();
    if (to_one < unequal * to_other && to_other < unequal * to_one)
      all.push_back({0.5 * (one + other), 0.5 * (one - other).norm(), near[place], blur});
  }
  for (const int one : near) {
    if (!with_others || one < 0) continue;
    const Eigen::Vector2d step = here - lattice.position(one);
    for (const int next : lattice.neighbours(one)) {
      if (next < 0) continue;
      const Eigen::Vector2d as_far = lattice.position(one) - lattice.position(next);
      if ((as_far - step).norm() < off_step * as_far.norm())
        all.push_back({lattice.position(one) + as_far, as_far.norm(), one, blur});
    }
  }
  for (const int one : near)
    if (one >= 0) return all.push_back({here, 0, one, blur}), all;
  return all;
}

// Whether a corner that was fitted beside a shadow's edge may be believed where another edge is known to run there.
bool is_beside(const CornerModel& model, const ShadowEdge& edge) {
  return has_shadow(model) && std::abs(model.shadow.distance - std::abs(edge.distance)) < right_line;
}

// Whether a corner may lie elsewhere: far off, where it leaves more than noise or is badly known, or near, where a
// shadow's edge is known to run through its disc of which its fit knows nothing.
enum class ModelUncertainty { none, near, far };
ModelUncertainty warn_about(const Level& level, const Found& found) {
  const double allowed = much_left * found.fit.model.half_contrast, noise = level.sight.noise;
  const bool leaves_much = found.fit.noise * found.fit.noise > noisier * noise * noise + allowed * allowed;
  const auto shadows = level.shadows.near(found.fit.model.position, near_shadow);
  if (shadows.empty() || is_beside(found.fit.model, shadows.front().edge)) return ModelUncertainty::none;
  if (leaves_much || found.corner.covariance.trace() > 2 * unsure_px * unsure_px) return ModelUncertainty::far;
  const bool runs_through = std::abs(shadows.front().edge.distance) < found.fit.radius;
  return shadows.front().is_certain && runs_through ? ModelUncertainty::near : ModelUncertainty::none;
}

// Puts what was fitted beside a shadow in the place of the corner with this number, if it leaves less or is the surer.
bool take_instead(const Found& again, int number, int first, Lattice& lattice, Level& level) {
  Found& found = level.found[static_cast<std::size_t>(number - first)];
  const bool is_surer = again.corner.covariance.trace() < found.corner.covariance.trace();
  if (again.fit.noise > (is_surer ? worse_noise : 1) * found.fit.noise) return false;
  const double log_odds = found.suspect.log_odds;
  found = again, found.suspect.log_odds = log_odds;
  lattice.replace(number, found.suspect), add_if_seen(found.fit, level.shadows);
  return true;
}

// Corners that were taken although a shadow's edge runs there of which their fit knows nothing: with it they lie
// elsewhere. Numbers of the lattice begin at `first` with those of this level.
void look_again_in_shadow(Lattice& lattice, int first, int since, Level& level) {
  for (int number = first; number < lattice.size(); ++number) {
    const Found& found = level.found[static_cast<std::size_t>(number - first)];
    const ModelUncertainty model_uncertainty = warn_about(level, found);
    if (model_uncertainty == ModelUncertainty::none) continue;
    for (const PredictedCorner& predicted :
         predicted_again(lattice, number, found.fit.model.blur, model_uncertainty == ModelUncertainty::far)) {
      const auto again = look_in_shadow(lattice, predicted, level, since);
      if (again && take_instead(*again, number, first, lattice, level)) break;
    }
  }
}

// What is missing beside the shadows' edges that are known by now, and what that predicts in turn.
void take_missing_in_shadow(Lattice& lattice, const SaddleField& field, int first, int since, Level& level) {
  const int known = lattice.size();
  const std::size_t count = level.missing.size();
  for (std::size_t i = 0; i < count; ++i) {
    const PredictedCorner predicted = level.missing[i];
    if (level.shadows.near(predicted.position, near_shadow, since).empty()) continue;
    const int there = lattice.nearest(predicted.position, reach_of(predicted));
    const auto is_right = [&] {
      return there < first ||
             warn_about(level, level.found[static_cast<std::size_t>(there - first)]) != ModelUncertainty::far;
    };
    if (there >= 0 && is_right()) continue;
    const auto found = look_in_shadow(lattice, predicted, level, since);
    if (!found) continue;
    if (there >= 0)
      take_instead(*found, there, first, lattice, level);
    else
      take(*found, lattice, level);
  }
  if (lattice.size() > known) take_predicted(lattice, field, known, level);
}

}  // namespace

void settle_shadows(Lattice& lattice, const SaddleField& field, int first, Level& level) {
  int since = 0;
  for (int round = 0; round < shadow_rounds && level.shadows.size() > since; ++round) {
    const int before = level.shadows.size();
    look_again_in_shadow(lattice, first, since, level);
    take_missing_in_shadow(lattice, field, first, since, level);
    since = before;
  }
}

}  // namespace handsight
