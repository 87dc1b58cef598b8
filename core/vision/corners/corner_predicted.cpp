// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_predicted.h"

#include <cmath>

#include "vision/corners/corner_model.h"
#include "vision/corners/corner_structure.h"

namespace handsight {
namespace {

constexpr double same_px = 2;    // px: nearer ones are the same
constexpr double blurred = 1.5;  // px, of a corner that may have neighbours too blurred for this image

// Beyond a board's rim mostly nothing looks like a corner: there the small look, which knows what to look for, must do.
bool may_be_there(const CornerSight& sight, const SaddleField& field, const PredictedCorner& predicted) {
  if (field.has_near(predicted.position, reach_of(predicted))) return true;
  const Eigen::Vector2i pixel = (predicted.position.array() + 0.5).floor().cast<int>();
  const auto inside = [](int at, int size) { return at >= 3 && at + 3 < size; };
  return inside(pixel.x(), sight.image.width) && inside(pixel.y(), sight.image.height) &&
         may_be_cross(sight.image, pixel, sight.options.min_contrast, sight.noise);
}

// What a predicted corner looks like beside a shadow's edge.
CornerModel beside_shadow(const Lattice& lattice, const PredictedCorner& predicted, const ShadowEdge& edge) {
  CornerModel expected = lattice.expected(predicted);
  const double light = light_at(edge, lattice.position(predicted.witness) - expected.position);
  expected.level /= light, expected.half_contrast /= light;
  expected.shadow = edge;
  return expected;
}

}  // namespace

void add_if_seen(const CornerFit& fit, ShadowLines& lines) {
  if (has_shadow(fit.model) && fit.model.shadow.distance < fit.radius) lines.add(fit.model);
}

std::optional<Found> look_in_shadow(const Lattice& lattice, const PredictedCorner& predicted, const Level& level,
                                    int since) {
  const auto look = [&](const CornerModel& expected) {
    auto found = shaded_look(level.sight, expected);
    if (found && !lattice.suits(predicted.witness, found->suspect)) found.reset();
    return found;
  };
  for (const NearShadow& near : level.shadows.near(predicted.position, near_shadow, since))
    if (auto found = look(beside_shadow(lattice, predicted, near.edge))) return found;
  if (since > 0 || !lattice.light_changes_at(predicted)) return std::nullopt;
  return look(lattice.expected(predicted));
}

void take(const Found& found, Lattice& lattice, Level& level) {
  if (lattice.has_near(found.suspect.position, same_px)) return;
  lattice.add(found.suspect), level.found.push_back(found);
  add_if_seen(found.fit, level.shadows);
}

bool take_if_there(Lattice& lattice, const SaddleField& field, const PredictedCorner& predicted, Level& level) {
  const auto suits = [&](const CrossStructure& cross, const Eigen::Vector2d& position) {
    FittedSaddle seen;
    seen.position = position, seen.edges = cross.edges, seen.half_contrast = cross.half_contrast;
    return lattice.may_suit(predicted.witness, seen);
  };
  const auto is_right = [&](const std::optional<Found>& found) {
    return found && lattice.suits(predicted.witness, found->suspect);
  };
  std::optional<Found> found;
  if (may_be_there(level.sight, field, predicted))
    found = predicted_look(level.sight, predicted.position, reach_of(predicted), suits);
  if (!is_right(found)) found = small_look(level.sight, lattice.expected(predicted));
  if (!is_right(found)) found = look_in_shadow(lattice, predicted, level);
  if (!is_right(found)) return false;
  take(*found, lattice, level);
  return true;
}

void take_predicted(Lattice& lattice, const SaddleField& field, int first, Level& level) {
  const auto take_all_of = [&](int number) {
    for (const PredictedCorner& predicted : lattice.predicted_by(number)) {
      if (lattice.has_near(predicted.position, reach_of(predicted)) || !take_if_there(lattice, field, predicted, level))
        level.missing.push_back(predicted);
    }
  };
  const int known = lattice.size();
  for (int number = first; number < lattice.size(); ++number) {
    take_all_of(number);
    if (number < known) continue;
    for (const int neighbour : lattice.neighbours(number))
      if (neighbour >= first && neighbour < number) take_all_of(neighbour);
  }
}

void keep_for_coarser(const Lattice& lattice, const SaddleField& field, std::vector<PredictedCorner>& missing) {
  std::erase_if(missing, [&](const PredictedCorner& predicted) {
    const double reach = reach_of(predicted);
    return lattice.has_near(predicted.position, reach) ||
           !(predicted.blur > blurred || field.has_near(predicted.position, reach));
  });
}

}  // namespace handsight
