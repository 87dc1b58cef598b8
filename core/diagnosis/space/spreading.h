// SPDX-License-Identifier: Apache-2.0
// What is there a little at each joint, as in every robot: zeros, geometry, springs and eccentricities, all of a name
// at one size, which the evidence chooses.
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "diagnosis/space/model_space.h"

namespace handsight {

/// A name at each of its places that a choice leaves open.
struct SpreadName {
  std::size_t name = 0;  // of the space
  double size = 0;       // of its numbers, in prior sigmas
};

/// Ids of the effects that are there a little at each joint of every robot.
const std::set<std::string>& small_in_every_robot();

/// The largest size of what is only a little: all places of a name at its usual size are a name.
inline constexpr double largest_small = 0.3;

/// ln of the sizes that a spread name may have.
double ln_ways_of_size();

/// Names that are spread over their places, one after another, beside a choice of units or some of them, to first
/// order.
class Spreading {
 public:
  Spreading(const ModelSpace& all, const Chosen& most);

  /// ln of the evidence of a choice less what it costs, with nothing beside it.
  double worth(const Chosen& chosen) const;

  struct Sum {
    double ln = 0;  // of all that was asked about on the way to the likeliest
    std::vector<SpreadName> likeliest;
    double ln_of_likeliest = 0;
  };

  /// With each of the names that make the choice likelier, one after another. `first` is there in any case, `never` in
  /// none; sizes above `largest` are not tried.
  Sum sum(const Chosen& chosen, std::optional<std::size_t> first, std::optional<std::size_t> never,
          double largest = 1) const;

  /// The largest of the numbers of these names beside a choice, in prior sigmas.
  double estimate_largest(const Chosen& chosen, const std::vector<SpreadName>& spread) const;

 private:
  /// What the measurements say of all numbers beside those that are in already.
  struct Beside {
    Score score;
    double residual_squares = 0, ln_volume = 0;
  };
  using Numbers = std::vector<Eigen::Index>;

  static Beside with(const Beside& before, const Numbers& numbers, double size);
  Beside beside(const Chosen& chosen) const;
  Numbers list_numbers(const Chosen& chosen) const;
  double worth(const Beside& at, const Chosen& chosen, int spread) const;
  std::map<std::size_t, Numbers> list_open(const Chosen& chosen) const;

  const ModelSpace& all_;
  std::vector<Eigen::Index> place_of_;  // of all numbers in score_; -1 of those that are neither chosen nor spread
  double scale_;                        // of the chosen units' numbers
  Score score_;
};

/// Terms of the places that a choice leaves open, each with the prior size of its name.
std::vector<EffectTerm> list_terms(const ModelSpace& all, const Chosen& chosen, const std::vector<SpreadName>& spread);

}  // namespace handsight
