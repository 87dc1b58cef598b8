// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/space/spreading.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace handsight {
namespace {

constexpr std::array<double, 4> small_sizes{0.03, 0.1, 0.3, 1};  // of the prior sigmas
constexpr std::size_t fewest_places = 2;

constexpr double none = -std::numeric_limits<double>::infinity();

/// Of some numbers at one size: how the residuals shrink, and ln of the volume that their prior wastes.
struct Gain {
  Eigen::LLT<Eigen::MatrixXd> llt;
  double squares = 0, ln_volume = 0;
};

Gain gain_by(const Score& all, const std::vector<Eigen::Index>& numbers, double size) {
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

double ln_sum(double a, double b) {
  const double larger = std::max(a, b), smaller = std::min(a, b);
  return smaller == none ? larger : larger + std::log1p(std::exp(smaller - larger));
}

bool is_in(const Chosen& chosen, std::size_t unit) { return std::binary_search(chosen.begin(), chosen.end(), unit); }

bool can_spread(const ModelSpace& all, std::size_t unit) {
  return small_in_every_robot().contains(all.names()[all.units()[unit].name].id);
}

/// The units of a name that a choice leaves open.
Chosen list_open_units(const ModelSpace& all, const Chosen& chosen, std::size_t name) {
  Chosen open;
  for (std::size_t u = 0; u < all.units().size(); ++u)
    if (all.units()[u].name == name && !is_in(chosen, u) && all.can_come(u, chosen)) open.push_back(u);
  return open;
}

}  // namespace

/// What zeroing, machining, gears and encoders leave at each joint: whether a little of it shows is as likely as not.
const std::set<std::string>& small_in_every_robot() {
  static const std::set<std::string> effects{"joint_offset", "link_geometry", "joint_elasticity",
                                             "encoder_eccentricity"};
  return effects;
}

double ln_ways_of_size() { return std::log(static_cast<double>(small_sizes.size())); }

Spreading::Spreading(const ModelSpace& all, const Chosen& most)
    : all_(all),
      place_of_(static_cast<std::size_t>(all.score().gradient.size()), -1),
      scale_(
          linear_estimate(take_part(all.score(), all.list_numbers(most)), all.whitened(), all.by().knowledge).scale) {
  Chosen used;
  for (std::size_t u = 0; u < all.units().size(); ++u)
    if (is_in(most, u) || can_spread(all, u)) used.push_back(u);
  const Numbers numbers = all.list_numbers(used);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    place_of_[static_cast<std::size_t>(numbers[i])] = static_cast<Eigen::Index>(i);
  score_ = take_part(all.score(), numbers);
}

double Spreading::worth(const Chosen& chosen) const { return worth(beside(chosen), chosen, 0); }

Spreading::Sum Spreading::sum(const Chosen& chosen, std::optional<std::size_t> first, std::optional<std::size_t> never,
                              double largest) const {
  std::map<std::size_t, Numbers> open = list_open(chosen);
  if (never) open.erase(*never);
  Beside here = beside(chosen);
  Sum sum;
  sum.ln = none;
  sum.ln_of_likeliest = first ? none : worth(here, chosen, 0);
  for (int spread = 1; !open.empty(); ++spread) {
    std::optional<SpreadName> next;
    for (const auto& [name, numbers] : open) {
      if (first && spread == 1 && name != *first) continue;
      for (const double size : small_sizes) {
        if (size > largest) continue;
        const Gain gain = gain_by(here.score, numbers, size);
        const Beside there{{}, here.residual_squares - gain.squares, here.ln_volume + gain.ln_volume};
        const double worth_there = worth(there, chosen, spread);
        sum.ln = ln_sum(sum.ln, worth_there);
        if (worth_there <= sum.ln_of_likeliest) continue;
        sum.ln_of_likeliest = worth_there;
        next = {name, size};
      }
    }
    if (!next) break;
    here = with(here, open.at(next->name), next->size);
    open.erase(next->name);
    sum.likeliest.push_back(*next);
  }
  return sum;
}

double Spreading::estimate_largest(const Chosen& chosen, const std::vector<SpreadName>& spread) const {
  Numbers numbers = list_numbers(chosen);
  const std::size_t before = numbers.size();
  std::vector<double> sizes(before, scale_);
  for (const SpreadName& s : spread) {
    const Numbers more = list_numbers(list_open_units(all_, chosen, s.name));
    numbers.insert(numbers.end(), more.begin(), more.end());
    sizes.resize(numbers.size(), s.size);
  }
  if (numbers.size() == before) return 0;
  Score own = take_part(score_, numbers);
  for (std::size_t i = 0; i < sizes.size(); ++i)
    own.information.diagonal()[static_cast<Eigen::Index>(i)] += 1 / (sizes[i] * sizes[i]);
  const Eigen::VectorXd values = own.information.ldlt().solve(own.gradient);
  return values.tail(static_cast<Eigen::Index>(numbers.size() - before)).cwiseAbs().maxCoeff();
}

Spreading::Beside Spreading::with(const Beside& before, const Numbers& numbers, double size) {
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

Spreading::Beside Spreading::beside(const Chosen& chosen) const {
  return with({score_, all_.whitened().residual_squares, 0}, list_numbers(chosen), scale_);
}

/// Among those of score_.
Spreading::Numbers Spreading::list_numbers(const Chosen& chosen) const {
  Numbers numbers = all_.list_numbers(chosen);
  for (Eigen::Index& number : numbers) number = place_of_[static_cast<std::size_t>(number)];
  return numbers;
}

double Spreading::worth(const Beside& at, const Chosen& chosen, int spread) const {
  const NoiseKnowledge& noise = all_.by().knowledge;
  const double before = all_.whitened().residual_squares, after = at.residual_squares;
  const double gained =
      noise.known ? 0.5 * (before - after) : 0.5 * noise.degrees * (std::log(before) - std::log(after));
  return gained - 0.5 * at.ln_volume - spread * ln_ways_of_size() - all_.compute_cost(chosen);
}

/// The numbers of each name that can be spread beside a choice.
std::map<std::size_t, Spreading::Numbers> Spreading::list_open(const Chosen& chosen) const {
  std::map<std::size_t, Numbers> open;
  for (std::size_t name = 0; name < all_.names().size(); ++name) {
    if (!small_in_every_robot().contains(all_.names()[name].id)) continue;
    const Chosen units = list_open_units(all_, chosen, name);
    if (units.size() >= fewest_places) open[name] = list_numbers(units);
  }
  return open;
}

std::vector<EffectTerm> list_terms(const ModelSpace& all, const Chosen& chosen, const std::vector<SpreadName>& spread) {
  std::vector<EffectTerm> terms;
  for (const SpreadName& s : spread)
    for (const std::size_t u : list_open_units(all, chosen, s.name)) {
      terms.push_back(all.units()[u].term);
      terms.back().size = s.size;
    }
  return terms;
}

}  // namespace handsight
