// SPDX-License-Identifier: Apache-2.0
// Which choices of names are likely: what may go, come or stand in for each other in a model, and how likely each
// choice among it is.
#pragma once

#include <functional>
#include <map>

#include "diagnosis/space/model_space.h"

namespace handsight {

/// Units that are looked at, and those that surely stay.
struct OpenUnits {
  Chosen open, fixed;
  std::map<std::size_t, std::vector<std::size_t>> instead;  // of an open unit those that may stand in its place
};

/// Open is what may go, come, or stand in for something, with a choice no more than a thousand times less likely than
/// the model's; but nothing of which a prior sigma would hardly show.
OpenUnits open_units(const ModelSpace& all, const std::function<bool()>& goes_on);

/// The score of the open units' numbers with those of the fixed ones free beside them.
struct OpenScore {
  Score score;
  WhitenedModel whitened;
  std::map<std::size_t, Eigen::Index> first_number;  // of each open unit
  Eigen::MatrixXd fixed_by_open;                     // how the fixed numbers move with them; prior sigmas
};
OpenScore open_score(const ModelSpace& all, const OpenUnits& units);

/// The probability of each choice of open units; choices that are not in it are too unlikely.
using Weights = std::map<Chosen, double>;

/// A walk from choice to choice, each left for one beside it by the square root of how much likelier that is, and
/// counted by how long it would stay (Zanella 2020, Informed proposals for local MCMC in discrete spaces, section 5).
/// The same every time.
Weights model_posterior(const ModelSpace& all, const OpenUnits& units, const OpenScore& score,
                        const std::function<bool()>& goes_on);

}  // namespace handsight
