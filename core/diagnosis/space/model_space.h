// SPDX-License-Identifier: Apache-2.0
// All that the catalogue could put in the place of a model's names, and what the measurements say of it together, to
// first order about the model's answer: the evidence of any choice follows from sums that are made once.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/evidence.h"
#include "diagnosis/evidence/noise_model.h"

namespace handsight {

/// An effect at one place.
struct ModelSpaceUnit {
  EffectTerm term;                    // at the model's answer
  std::size_t name = 0;               // into ModelSpace::names
  Eigen::Index first = 0, count = 0;  // numbers among those of all units
  bool is_present = false;            // in the model
};

struct ModelSpaceEffect {
  std::string id;
  double cost = 0;  // ln of the odds against it, without its places
  int places = 0;   // at which it could sit
};

/// Places in a list of units, in order.
using Chosen = std::vector<std::size_t>;

class ModelSpace {
 public:
  /// In the place of the fit's terms from `first` on. A name costs ln odds of `cost_of_a_name`, a curve and a slip
  /// those against them too. Without a `repeatability` of the robot it is the likeliest for the fit.
  ModelSpace(const Fit& fit, std::size_t first, double cost_of_a_name,
             const std::optional<Repeatability>& repeatability = {});
  /// Of these candidates alone beside the terms that are there.
  ModelSpace(const Fit& fit, const Candidates& others, std::size_t first, double cost_of_a_name,
             const std::optional<Repeatability>& repeatability = {});

  const std::vector<ModelSpaceUnit>& units() const { return units_; }  // of one name together
  const std::vector<ModelSpaceEffect>& names() const { return names_; }
  const NoiseModel& by() const { return by_; }
  Eigen::Index base() const { return base_; }  // effect numbers of the terms before
  Chosen present() const;
  std::set<std::string> list_names(const Chosen& chosen) const;

  /// Of all units' numbers in prior sigmas, with all of them at 0.
  const Score& score() const { return score_; }
  /// What the evidence of a score needs to know of its model, whose rows are gone.
  const WhitenedModel& whitened() const { return whitened_; }
  double plausible(Eigen::Index number) const { return sizes_[static_cast<std::size_t>(number)]; }
  std::vector<Eigen::Index> list_numbers(const Chosen& chosen) const;
  /// By how much the model's own unknowns (columns of its problem before the units') move when the units' numbers move
  /// by one prior sigma each.
  Eigen::MatrixXd base_by_numbers() const;

  /// ln of the odds against so many names, and of the ways in which they could have sat at so many places.
  double compute_cost(const Chosen& chosen) const;
  /// ln of their evidence against none, less what they cost.
  double worth(const Chosen& chosen) const;
  /// Not what is in already, nor another form of it at the same place.
  bool can_come(std::size_t unit, const Chosen& chosen) const;
  /// Their terms at the estimate to first order.
  std::vector<EffectTerm> list_terms(const Chosen& chosen) const;

 private:
  std::size_t display_name(const EffectTerm& term, double cost);
  void list_units(const Problem& model, std::size_t first_term, const Candidates& others, double cost);
  void widen(const Eigen::VectorXd& value);
  void move_to_zero(Eigen::VectorXd value);

  NoiseModel by_;
  Eigen::Index base_ = 0;
  std::vector<ModelSpaceEffect> names_;
  std::vector<ModelSpaceUnit> units_;
  std::vector<double> sizes_;       // plausible, by number; of what is clearly larger a third of what it is
  std::vector<double> base_sizes_;  // of the base's columns: what their unit is, m, rad or the effect's own
  WhitenedModel whitened_;
  Score score_;
};

/// What follows time, and what scales the measurements themselves (the target's size where a sensor tells its poses),
/// is judged otherwise than by what is left (prior_odds.h, full_fits.cpp).
bool is_judged_elsewhere(const EffectTerm& term, const Problem& model);

/// Has it one form at each of its places?
bool has_one_form(const CandidateEffect& effect);

/// With one unit more.
Chosen with_unit(Chosen chosen, std::size_t unit);
/// Without the i-th.
Chosen without_unit(Chosen chosen, std::size_t i);

}  // namespace handsight
