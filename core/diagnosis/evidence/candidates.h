// SPDX-License-Identifier: Apache-2.0
// Everything of the catalogue that a model may lack, as columns beside the model's own.
#pragma once

#include <set>
#include <string>

#include "estimation/problem/problem.h"

namespace handsight {

/// One effect at one place, with one set of choices: the smallest thing that can be added to a model.
struct CandidateUnit {
  EffectTerm term;         // all numbers 0, choices set
  Eigen::Index first = 0;  // candidate column
  Eigen::Index count = 0;
};

struct CandidateEffect {
  const Effect* effect = nullptr;
  std::vector<CandidateUnit> units;
  std::vector<double> sizes = {};               // plausible, per parameter
  std::shared_ptr<const Effect> own = nullptr;  // keeps `effect` where it is one by formula
};

struct Candidates {
  std::vector<CandidateEffect> effects;
  Problem problem;  // the model's effect columns, then the candidates'
  Eigen::Index base_effects = 0;
};

/// All units that are not in the model yet, in the order of the catalogue. Observations at which something may have
/// slipped are thinned to `most_orders`, evenly.
Candidates all_candidates(const Problem& model, int most_orders = 24);

/// Those of some effects of the catalogue alone.
Candidates candidates_of(const Problem& model, const std::set<std::string>& effects);

/// These terms alone, each a unit of its own; their choices count, their numbers do not.
Candidates list_candidates(const Problem& model, const std::vector<EffectTerm>& terms);

/// All choices of a term's effect at its place alone, as `all_candidates` offers them.
Candidates choices_at_place(const Problem& model, const EffectTerm& term, int most_orders = 24);

/// The units of one effect and place alone, at these orders.
Candidates candidates_at_orders(const Problem& model, const EffectTerm& term, const std::vector<double>& orders);

}  // namespace handsight
