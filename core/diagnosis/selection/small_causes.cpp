// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/small_causes.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace handsight {
namespace {

constexpr std::array<double, 4> small_sizes{0.03, 0.1, 0.3, 1};  // of the prior sigmas
constexpr std::size_t fewest_places = 2;

/// What zeroing, machining, gears and encoders leave at each joint of every robot: whether a little of it shows is as
/// likely as not.
const std::set<std::string> of_every_robot{"joint_offset", "link_geometry", "joint_elasticity", "encoder_eccentricity"};
const double cost_of_a_size = std::log(static_cast<double>(small_sizes.size()));  // any, before the measurements
constexpr double none = -std::numeric_limits<double>::infinity();

using Numbers = std::vector<Eigen::Index>;

/// What the measurements say of all numbers beside those that are in already.
struct Beside {
  Score score;
  double residual_squares = 0, ln_volume = 0;
};

/// Of some numbers at one size: how the residuals shrink, and ln of the volume that their prior wastes.
struct Gain {
  Eigen::LLT<Eigen::MatrixXd> llt;
  double squares = 0, ln_volume = 0;
};

Gain gain_by(const Score& all, const Numbers& numbers, double size) {
  const Score own = take_part(all, numbers);
  Eigen::MatrixXd information = own.information;
  information.diagonal().array() += 1 / (size * size);
  Gain gain;
  gain.llt.compute(information);
  gain.squares = gain.llt.matrixL().solve(own.gradient).squaredNorm();
  const double ln_determinant = 2 * Eigen::MatrixXd(gain.llt.matrixL()).diagonal().array().log().sum();
  gain.ln_volume = ln_determinant + 2 * static_cast<double>(numbers.size()) * std::log(size);
  return gain;
}

Beside with(const Beside& before, const Numbers& numbers, double size) {
  if (numbers.empty()) return before;
  const Gain gain = gain_by(before.score, numbers, size);
  Eigen::MatrixXd shared = before.score.information(numbers, Eigen::all);
  gain.llt.matrixL().solveInPlace(shared);
  Eigen::VectorXd gradient = before.score.gradient(numbers);
  gain.llt.matrixL().solveInPlace(gradient);
  Beside after = before;
  after.score.information -= shared.transpose() * shared;
  after.score.gradient -= shared.transpose() * gradient;
  after.residual_squares -= gain.squares;
  after.ln_volume += gain.ln_volume;
  return after;
}

Chosen without_name(const ModelSpace& all, Chosen chosen, std::size_t name) {
  std::erase_if(chosen, [&](std::size_t u) { return all.units()[u].name == name; });
  return chosen;
}

/// Names that are spread over their places, one after another, beside a choice of units or some of them.
class Spreading {
 public:
  Spreading(const ModelSpace& all, const Chosen& most)
      : all_(all),
        place_of_(static_cast<std::size_t>(all.score().gradient.size()), -1),
        scale_(
            linear_estimate(take_part(all.score(), all.list_numbers(most)), all.whitened(), all.by().knowledge).scale) {
    Chosen used;
    for (std::size_t u = 0; u < all.units().size(); ++u)
      if (is_in(most, u) || can_spread(u)) used.push_back(u);
    const Numbers numbers = all.list_numbers(used);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      place_of_[static_cast<std::size_t>(numbers[i])] = static_cast<Eigen::Index>(i);
    score_ = take_part(all.score(), numbers);
  }

  /// ln of the evidence of a choice less what it costs, with nothing beside it.
  double worth(const Chosen& chosen) const { return worth(beside(chosen), chosen, 0); }

  /// All that was asked about on the way to the likeliest.
  struct Sum {
    double ln = none;
    std::vector<std::string> likeliest;  // names
  };

  /// With each of the names that make the choice likelier, one after another. `first` is there in any case, `never` in
  /// none.
  Sum sum(const Chosen& chosen, std::optional<std::size_t> first, std::optional<std::size_t> never) const {
    std::map<std::size_t, Numbers> open = list_open(chosen);
    if (never) open.erase(*never);
    Beside here = beside(chosen);
    double best = first ? none : worth(here, chosen, 0);
    Sum sum;
    for (int spread = 1; !open.empty(); ++spread) {
      std::optional<std::pair<std::size_t, double>> next;
      for (const auto& [name, numbers] : open) {
        if (first && spread == 1 && name != *first) continue;
        for (const double size : small_sizes) {
          const Gain gain = gain_by(here.score, numbers, size);
          const Beside there{{}, here.residual_squares - gain.squares, here.ln_volume + gain.ln_volume};
          const double worth_there = worth(there, chosen, spread);
          sum.ln = ln_sum(sum.ln, worth_there);
          if (worth_there <= best) continue;
          best = worth_there;
          next = {name, size};
        }
      }
      if (!next) break;
      here = with(here, open.at(next->first), next->second);
      open.erase(next->first);
      sum.likeliest.push_back(all_.names()[next->first].id);
    }
    return sum;
  }

 private:
  static double ln_sum(double a, double b) {
    const double larger = std::max(a, b), smaller = std::min(a, b);
    return smaller == none ? larger : larger + std::log1p(std::exp(smaller - larger));
  }

  Beside beside(const Chosen& chosen) const {
    return with({score_, all_.whitened().residual_squares, 0}, list_numbers(chosen), scale_);
  }

  /// Among those of score_.
  Numbers list_numbers(const Chosen& chosen) const {
    Numbers numbers = all_.list_numbers(chosen);
    for (Eigen::Index& number : numbers) number = place_of_[static_cast<std::size_t>(number)];
    return numbers;
  }

  static bool is_in(const Chosen& chosen, std::size_t unit) {
    return std::binary_search(chosen.begin(), chosen.end(), unit);
  }

  bool can_spread(std::size_t unit) const { return of_every_robot.contains(all_.names()[all_.units()[unit].name].id); }

  double worth(const Beside& at, const Chosen& chosen, int spread) const {
    const NoiseKnowledge& noise = all_.by().knowledge;
    const double before = all_.whitened().residual_squares, after = at.residual_squares;
    const double gained =
        noise.known ? 0.5 * (before - after) : 0.5 * noise.degrees * (std::log(before) - std::log(after));
    return gained - 0.5 * at.ln_volume - spread * cost_of_a_size - all_.compute_cost(chosen);
  }

  /// The numbers of each name that can be spread beside a choice.
  std::map<std::size_t, Numbers> list_open(const Chosen& chosen) const {
    std::map<std::size_t, Chosen> units;
    for (std::size_t u = 0; u < all_.units().size(); ++u) {
      if (!is_in(chosen, u) && can_spread(u) && all_.can_come(u, chosen)) units[all_.units()[u].name].push_back(u);
    }
    std::map<std::size_t, Numbers> open;
    for (const auto& [name, of_name] : units)
      if (of_name.size() >= fewest_places) open[name] = list_numbers(of_name);
    return open;
  }

  const ModelSpace& all_;
  std::vector<Eigen::Index> place_of_;  // of all numbers in score_; -1 of those that are neither chosen nor spread
  double scale_;                        // of the chosen units' numbers
  Score score_;
};

}  // namespace

std::vector<SmallCauses> find_small_causes(const ModelSpace& all, const Chosen& chosen) {
  constexpr double least_told = 1 / 21.0, largest_share = 0.95;
  std::vector<SmallCauses> causes(all.names().size());
  if (chosen.empty()) return causes;
  const Spreading spreading(all, chosen);
  const double alone = spreading.worth(chosen), beside = spreading.sum(chosen, std::nullopt, std::nullopt).ln;
  for (std::size_t name = 0; name < causes.size(); ++name) {
    const Chosen fewer = without_name(all, chosen, name);
    if (fewer.size() == chosen.size()) continue;
    Spreading::Sum instead = spreading.sum(fewer, std::nullopt, name);
    double others = 0;
    for (const double worth : {alone, beside, spreading.sum(fewer, name, std::nullopt).ln})
      others += std::exp(std::min(700.0, worth - instead.ln));
    const double share = 1 / (1 + others);
    causes[name].share = std::min(share, largest_share);
    if (share >= least_told) causes[name].names = std::move(instead.likeliest);
  }
  return causes;
}

double ln_standing(const std::vector<SmallCauses>& causes) {
  double ln = 0;
  for (const SmallCauses& of_name : causes) ln += std::log1p(-of_name.share);
  return ln;
}

}  // namespace handsight
