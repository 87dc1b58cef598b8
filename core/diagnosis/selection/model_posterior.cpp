// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/model_posterior.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <random>

#include "diagnosis/evidence/exchanged_factors.h"

namespace handsight {
namespace {

constexpr double open_until = 7;    // ln: what is a thousand times less likely is not looked at
constexpr double least_shown = 30;  // chi-squared of the prior sigma: of what shows less nothing is known
constexpr int steps = 600;          // of the walk

class Neighbours {
 public:
  Neighbours(const ModelSpace& all, const Score& score, const WhitenedModel& whitened,
             const std::map<std::size_t, Eigen::Index>& first_number)
      : all_(all), score_(score), whitened_(whitened), first_number_(first_number) {}

  std::vector<Eigen::Index> list_numbers(const Chosen& chosen) const {
    std::vector<Eigen::Index> numbers;
    for (const std::size_t u : chosen)
      for (Eigen::Index i = 0; i < all_.units()[u].count; ++i) numbers.push_back(first_number_.at(u) + i);
    return numbers;
  }

  double ln_factor(const Chosen& chosen) const {
    return ln_bayes_factor(take_part(score_, list_numbers(chosen)), whitened_, all_.by().knowledge);
  }

  /// ln of the Bayes factors of a choice with each of these units beside it.
  std::vector<double> ln_factors_beside(const Chosen& chosen, const Chosen& coming) const {
    std::vector<ParameterGroup> groups;
    for (const std::size_t u : coming) groups.push_back({first_number_.at(u), all_.units()[u].count});
    return ln_bayes_factors_beside(score_, list_numbers(chosen), groups, whitened_, all_.by().knowledge);
  }

  /// Of a choice without each of its units, and with each of these in its place; one list a unit of the choice.
  std::vector<ExchangedFactors> exchanged(const Chosen& chosen, const std::vector<Chosen>& instead) const {
    std::vector<NumberExchange> exchanges;
    Eigen::Index first = 0;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const Eigen::Index count = all_.units()[chosen[i]].count;
      exchanges.push_back({{first, count}, {}});
      first += count;
      for (const std::size_t u : instead[i])
        exchanges.back().coming.push_back({first_number_.at(u), all_.units()[u].count});
    }
    return exchanged_factors(score_, list_numbers(chosen), exchanges, whitened_, all_.by().knowledge);
  }

 private:
  const ModelSpace& all_;
  const Score& score_;
  const WhitenedModel& whitened_;
  const std::map<std::size_t, Eigen::Index>& first_number_;
};

}  // namespace

OpenUnits open_units(const ModelSpace& all, const std::function<bool()>& goes_on) {
  std::map<std::size_t, Eigen::Index> first_number;
  for (std::size_t u = 0; u < all.units().size(); ++u) first_number[u] = all.units()[u].first;
  const Neighbours near(all, all.score(), all.whitened(), first_number);
  const Chosen present = all.present();
  const double least = near.ln_factor(present) - all.compute_cost(present) - open_until;
  std::set<std::size_t> open;
  OpenUnits units;
  const auto shows = [&](std::size_t u) {
    const Eigen::Index first = all.units()[u].first, count = all.units()[u].count;
    return all.units()[u].is_present ||
           all.score().information.block(first, first, count, count).trace() >= least_shown;
  };
  const auto that_may_come = [&](const Chosen& chosen, const std::optional<std::size_t>& in_place_of) {
    Chosen coming;
    for (std::size_t u = 0; u < all.units().size(); ++u)
      if (u != in_place_of && shows(u) && all.can_come(u, chosen)) coming.push_back(u);
    return coming;
  };
  const auto is_likely = [&](double factor, const Chosen& chosen) {
    return factor - all.compute_cost(chosen) >= least;
  };
  const Chosen further = that_may_come(present, std::nullopt);
  const std::vector<double> factors = near.ln_factors_beside(present, further);
  for (std::size_t i = 0; i < further.size(); ++i)
    if (is_likely(factors[i], with_unit(present, further[i]))) open.insert(further[i]);
  std::vector<Chosen> instead;
  for (std::size_t i = 0; i < present.size(); ++i)
    instead.push_back(that_may_come(without_unit(present, i), present[i]));
  const std::vector<ExchangedFactors> exchanged =
      goes_on() ? near.exchanged(present, instead) : std::vector<ExchangedFactors>{};
  for (std::size_t i = 0; i < exchanged.size() && goes_on(); ++i) {
    const Chosen fewer = without_unit(present, i);
    if (is_likely(exchanged[i].without, fewer)) open.insert(present[i]);
    for (std::size_t k = 0; k < instead[i].size(); ++k) {
      const std::size_t other = instead[i][k];
      if (!is_likely(exchanged[i].instead[k], with_unit(fewer, other))) continue;
      open.insert({other, present[i]});
      units.instead[present[i]].push_back(other);
      units.instead[other].push_back(present[i]);
    }
  }
  units.open.assign(open.begin(), open.end());
  for (const std::size_t u : present)
    if (!open.contains(u)) units.fixed.push_back(u);
  return units;
}

OpenScore open_score(const ModelSpace& all, const OpenUnits& units) {
  OpenScore s;
  s.whitened = all.whitened();
  Eigen::Index count = 0;
  for (const std::size_t u : units.open) {
    s.first_number[u] = count;
    count += all.units()[u].count;
  }
  const std::vector<Eigen::Index> open = all.list_numbers(units.open), fixed = all.list_numbers(units.fixed);
  s.score = take_part(all.score(), open);
  s.fixed_by_open = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(fixed.size()), count);
  if (fixed.empty()) return s;
  const Score own = take_part(all.score(), fixed);
  Eigen::MatrixXd information = own.information;
  information.diagonal().array() += std::pow(largest_usual_scale, -2);
  const Eigen::LLT<Eigen::MatrixXd> llt(information);
  const Eigen::MatrixXd shared = all.score().information(fixed, open);
  s.fixed_by_open = -llt.solve(shared);
  s.score.information += shared.transpose() * s.fixed_by_open;
  s.score.gradient += s.fixed_by_open.transpose() * own.gradient;
  s.whitened.residual_squares -= own.gradient.dot(llt.solve(own.gradient));
  return s;
}

namespace {

class Walk {
 public:
  Walk(const ModelSpace& all, const OpenUnits& units, const OpenScore& score)
      : all_(all), units_(units), near_(all, score.score, score.whitened, score.first_number) {}

  Weights weights(const std::function<bool()>& goes_on) {
    std::mt19937_64 random(20261125);
    Chosen here;
    for (const std::size_t u : units_.open)
      if (all_.units()[u].is_present) here.push_back(u);
    Weights weights;
    for (int step = 0; step < steps && goes_on(); ++step) {
      const auto& [next, until] = beside(here);
      if (next.empty()) return {{here, 1.0}};
      weights[here] += 1 / until.back();
      const double at = until.back() * static_cast<double>(random() >> 11) * 0x1.0p-53;
      here = next[static_cast<std::size_t>(std::upper_bound(until.begin(), until.end() - 1, at) - until.begin())];
    }
    double total = 0;
    for (const auto& [chosen, weight] : weights) total += weight;
    for (auto& [chosen, weight] : weights) weight /= total;
    return weights;
  }

 private:
  struct Beside {
    std::vector<Chosen> choices;
    std::vector<double> until;  // sums of the square roots
  };

  double worth(const Chosen& chosen) { return near_.ln_factor(chosen) - compute_cost(chosen); }

  double compute_cost(const Chosen& open) const {
    Chosen chosen;
    std::merge(open.begin(), open.end(), units_.fixed.begin(), units_.fixed.end(), std::back_inserter(chosen));
    return all_.compute_cost(chosen);
  }

  void add_beside(const Chosen& chosen, const Chosen& coming, double here, Beside& beside) const {
    if (coming.empty()) return;
    const std::vector<double> factors = near_.ln_factors_beside(chosen, coming);
    for (std::size_t i = 0; i < coming.size(); ++i) {
      Chosen next = with_unit(chosen, coming[i]);
      add(std::move(next), factors[i], here, beside);
    }
  }

  void add(Chosen next, double factor, double here, Beside& beside) const {
    const double root = std::exp(0.5 * (factor - compute_cost(next) - here));
    beside.until.push_back(root + (beside.until.empty() ? 0 : beside.until.back()));
    beside.choices.push_back(std::move(next));
  }

  Chosen that_can_come(const Chosen& of, const Chosen& chosen) const {
    Chosen coming;
    std::copy_if(of.begin(), of.end(), std::back_inserter(coming),
                 [&](std::size_t u) { return all_.can_come(u, chosen) && all_.can_come(u, units_.fixed); });
    return coming;
  }

  const Beside& beside(const Chosen& chosen) {
    const auto [found, is_new] = known_.try_emplace(chosen);
    Beside& b = found->second;
    if (!is_new) return b;
    const double here = worth(chosen);
    add_beside(chosen, that_can_come(units_.open, chosen), here, b);
    std::vector<Chosen> fewer, instead;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      fewer.push_back(without_unit(chosen, i));
      const auto others = units_.instead.find(chosen[i]);
      instead.push_back(others == units_.instead.end() ? Chosen{} : that_can_come(others->second, fewer.back()));
    }
    const std::vector<ExchangedFactors> exchanged = near_.exchanged(chosen, instead);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      add(fewer[i], exchanged[i].without, here, b);
      for (std::size_t k = 0; k < instead[i].size(); ++k)
        add(with_unit(fewer[i], instead[i][k]), exchanged[i].instead[k], here, b);
    }
    return b;
  }

  const ModelSpace& all_;
  const OpenUnits& units_;
  Neighbours near_;
  std::map<Chosen, Beside> known_;
};

}  // namespace

Weights model_posterior(const ModelSpace& all, const OpenUnits& units, const OpenScore& score,
                        const std::function<bool()>& goes_on) {
  return Walk(all, units, score).weights(goes_on);
}

}  // namespace handsight
