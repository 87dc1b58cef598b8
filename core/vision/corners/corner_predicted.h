// SPDX-License-Identifier: Apache-2.0
// Corners that boards predict, looked for where they should be: in even light, and beside shadows' edges.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "vision/corners/corner_level_finds.h"

namespace handsight {

constexpr double near_shadow = 12;  // px, from a corner that may be lost beside it

/// px, within which a predicted corner must lie.
inline double reach_of(const PredictedCorner& predicted) { return std::clamp(0.25 * predicted.spacing, 1.5, 6.0); }

/// The shadow's edge beside a corner, if it runs through the disc that was fitted.
void add_if_seen(const CornerFit& fit, ShadowLines& lines);

/// A predicted corner, if it is there, beside one of the shadows' edges that may run near, of which some corner told
/// after the first `since`; with 0 beside any that makes the corners on both sides unlike, too.
std::optional<Found> look_in_shadow(const Lattice& lattice, const PredictedCorner& predicted, const Level& level,
                                    int since = 0);

/// Nothing changes where it is there already.
void take(const Found& found, Lattice& lattice, Level& level);

/// What stands where it was predicted, if it is a corner of the same board.
bool take_if_there(Lattice& lattice, const SaddleField& field, const PredictedCorner& predicted, Level& level);

/// Takes what the corners from number `first` on predict, until nothing more comes. What is new may be the neighbour
/// that others lacked to predict on its other side. What is not there, or where another lies, is missing.
void take_predicted(Lattice& lattice, const SaddleField& field, int first, Level& level);

/// What a sharp corner predicts is sharp too: where no saddle is near it is in no coarser image.
void keep_for_coarser(const Lattice& lattice, const SaddleField& field, std::vector<PredictedCorner>& missing);

}  // namespace handsight
