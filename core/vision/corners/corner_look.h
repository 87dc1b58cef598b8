// SPDX-License-Identifier: Apache-2.0
// One candidate looked at: quickly, or long, or where a board predicts a corner.
#pragma once

#include <functional>
#include <optional>

#include "vision/corners/corner_likelihood.h"
#include "vision/corners/corner_options.h"
#include "vision/corners/corner_structure.h"
#include "vision/image/image.h"

namespace handsight {

/// What is looked at. `noise`: grey levels, sigma of a pixel. `is_coarser`: at less than the whole resolution.
struct CornerSight {
  const Image& image;
  const DetectorOptions& options;
  double noise;
  bool is_coarser = false;
};

struct Found {
  Corner corner;
  FittedSaddle suspect;
  CornerFit fit;
  bool is_alone = false;         // no neighbour on a board, and not likely enough a corner for that
  double asymmetry = 0;          // grey levels^2, half the mean square difference of opposite points
  double model_uncertainty = 1;  // by how much asymmetry that noise does not explain enlarges the covariance
};

/// By how much more a position may be wrong than what noise of this variance (grey levels^2, of a pixel) does to the
/// fit.
double model_uncertainty_of(const CornerModel& model, double asymmetry, double variance);

/// What the first look at a candidate found; and whether a second one might tell more.
struct Look {
  std::optional<Found> found;
  bool was_fitted = false;    // in even light, where it is
  bool is_open = false;       // too asymmetric to be worth a fit yet
  bool is_postponed = false;  // open, or what made it none may be its centre, a shadow or its neighbours
};

/// Of a candidate whose ring may be of a cross. What cannot be a corner is cheap to see of most: nothing is fitted that
/// a cheap test speaks against.
Look quick_look(const CornerSight& sight, const CornerCandidate& candidate);

/// How to look at a candidate again.
struct SecondLook {
  bool was_fitted = false;  // where it is, in even light, in vain
  bool may_centre = true;   // by its symmetry
};

/// Where few saddles near are no corners: centred by its symmetry, with less asked of it, then beside a shadow.
std::optional<Found> long_look(const CornerSight& sight, const CornerCandidate& candidate, const SecondLook& look);

/// Beside a shadow only.
std::optional<Found> shadow_look(const CornerSight& sight, const CornerCandidate& candidate);

/// Where a corner must be within `reach` px, if at all: centred by its symmetry, then fitted, whatever cheap tests say.
std::optional<Found> sure_look(const CornerSight& sight, const Eigen::Vector2d& start, double reach, int steps = 3);

/// Whether what the circles show at a place goes on the board that predicted it.
using SuitsBoard = std::function<bool(const CrossStructure&, const Eigen::Vector2d& position)>;

/// The same where the board's colours and edges go on there, and beside a shadow where there is none in even light.
std::optional<Found> predicted_look(const CornerSight& sight, const Eigen::Vector2d& start, double reach,
                                    const SuitsBoard& suits);

/// Where a corner is expected and the next ones may be nearer than 4 px: a fit on a disc of 3 px, without circles. In a
/// coarser image, whose border is nearer, the window of its symmetry becomes as small as it must not to leave the
/// image.
std::optional<Found> small_look(const CornerSight& sight, const CornerModel& expected);

/// Where a corner and a shadow's edge beside it are expected; without one the edge is looked for.
std::optional<Found> shaded_look(const CornerSight& sight, const CornerModel& expected);

/// A fit from numbers that are known well, as from a coarser image; nothing where what comes out is another corner.
std::optional<Found> known_look(const CornerSight& sight, const CornerModel& known);

}  // namespace handsight
