// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/exchanged_factors.h"

#include <algorithm>

#include "diagnosis/evidence/scaled_score.h"

namespace handsight {
namespace {

using ScaleValues = std::array<double, prior_scales.size()>;

/// The logarithms of one choice's Bayes factors, scale by scale.
struct OneChoice {
  ScaleValues values{};
  double largest = 0;  // of its estimate at the largest usual scale, prior sigmas

  /// False where the scale must be asked.
  bool follows(std::size_t scale, Eigen::Index numbers) {
    const auto wide = beyond_usual(scale, values[largest_usual], largest, numbers);
    if (wide) values[scale] = *wide;
    return wide.has_value();
  }
};

struct OfExchange {
  OneChoice without;
  std::vector<OneChoice> instead;
};

double largest_of(const Eigen::VectorXd& values) { return values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0; }

/// The chosen parameters at one scale: M = I + s^2 A, its inverse, and what that makes of the others' columns.
struct ChosenNumbers {
  double scale = 1;
  Eigen::MatrixXd inverse;     // of M
  Eigen::MatrixXd by_inverse;  // M^-1 A of the chosen rows, all columns
  Eigen::VectorXd value;       // M^-1 s b
  double gained = 0, ln_volume = 0;
};

ChosenNumbers chosen_at(double scale, const Score& own, const Eigen::MatrixXd& shared) {
  Eigen::MatrixXd m = scale * scale * own.information;
  m.diagonal().array() += 1;
  const Eigen::LLT<Eigen::MatrixXd> llt(m);
  ChosenNumbers c{scale,
                  llt.solve(Eigen::MatrixXd::Identity(m.rows(), m.cols())),
                  llt.solve(shared),
                  llt.solve(scale * own.gradient),
                  0,
                  ln_determinant(llt)};
  c.gained = scale * own.gradient.dot(c.value);
  return c;
}

class Exchanging {
 public:
  Exchanging(const Score& all, std::span<const Eigen::Index> chosen, const WhitenedModel& w,
             const NoiseKnowledge& noise)
      : all_(all), w_(w), noise_(noise), own_(take_part(all, chosen)), shared_(chosen.size(), all.gradient.size()) {
    for (std::size_t i = 0; i < chosen.size(); ++i)
      shared_.row(static_cast<Eigen::Index>(i)) = all.information.row(chosen[i]);
  }

  std::vector<OfExchange> factors(std::span<const NumberExchange> exchanges) const {
    std::vector<OfExchange> all;
    for (const NumberExchange& e : exchanges) all.push_back({{}, std::vector<OneChoice>(e.coming.size())});
    for (std::size_t scale = 0; scale < prior_scales.size(); ++scale) {
      std::optional<ChosenNumbers> chosen;
      for (std::size_t e = 0; e < exchanges.size(); ++e)
        if (must_ask(scale, exchanges[e], all[e])) {
          if (!chosen) chosen = chosen_at(prior_scales[scale], own_, shared_);
          ask(scale, *chosen, exchanges[e], all[e]);
        }
    }
    return all;
  }

 private:
  bool must_ask(std::size_t scale, const NumberExchange& exchange, OfExchange& of) const {
    const Eigen::Index fewer = own_.gradient.size() - exchange.gone.count;
    bool any = !of.without.follows(scale, fewer);
    for (std::size_t i = 0; i < of.instead.size(); ++i)
      any = !of.instead[i].follows(scale, fewer + exchange.coming[i].count) || any;
    return any;
  }

  /// M^-1 without the group u is P - P_u P_uu^-1 P_u^T, with nothing in the rows of the group.
  void ask(std::size_t scale, const ChosenNumbers& c, const NumberExchange& exchange, OfExchange& of) const {
    const auto [u, count] = exchange.gone;
    const Eigen::LLT<Eigen::MatrixXd> group(c.inverse.block(u, u, count, count));
    const auto columns = c.inverse.middleCols(u, count);
    const Eigen::VectorXd taken = group.solve(c.value.segment(u, count));
    const Eigen::VectorXd value = c.value - columns * taken;
    const double gained = c.gained - c.value.segment(u, count).dot(taken);
    const double ln_volume = c.ln_volume + ln_determinant(group);
    set(scale, gained, ln_volume, c.scale * largest_of(value), of.without);
    const double s2 = c.scale * c.scale;
    for (std::size_t i = 0; i < of.instead.size(); ++i) {
      if (scale > largest_usual && of.instead[i].largest <= largest_usual_scale) continue;
      const auto [v, more] = exchange.coming[i];
      const auto coming = shared_.middleCols(v, more);
      const auto of_group = c.by_inverse.block(u, v, count, more);
      // M^-1 A_v without the group.
      const Eigen::MatrixXd solved = c.by_inverse.middleCols(v, more) - columns * group.solve(of_group);
      Eigen::MatrixXd rest = s2 * (all_.information.block(v, v, more, more) - s2 * coming.transpose() * solved);
      rest.diagonal().array() += 1;
      const Eigen::LLT<Eigen::MatrixXd> llt(rest);
      const Eigen::VectorXd right = c.scale * all_.gradient.segment(v, more) - s2 * coming.transpose() * value;
      const Eigen::VectorXd here = llt.solve(right);
      const double largest = std::max(largest_of(here), largest_of(value - s2 * solved * here));
      set(scale, gained + right.dot(here), ln_volume + ln_determinant(llt), c.scale * largest, of.instead[i]);
    }
  }

  void set(std::size_t scale, double gained, double ln_volume, double largest, OneChoice& one) const {
    if (scale > largest_usual && one.largest <= largest_usual_scale) return;
    one.values[scale] = ln_worth(gained, w_, noise_) - 0.5 * ln_volume;
    if (scale == largest_usual) one.largest = largest;
  }

  const Score& all_;
  const WhitenedModel& w_;
  const NoiseKnowledge& noise_;
  Score own_;
  Eigen::MatrixXd shared_;
};

}  // namespace

std::vector<ExchangedFactors> exchanged_factors(const Score& all, std::span<const Eigen::Index> chosen,
                                                std::span<const NumberExchange> exchanges, const WhitenedModel& w,
                                                const NoiseKnowledge& noise) {
  std::vector<ExchangedFactors> factors;
  if (exchanges.empty()) return factors;
  for (const OfExchange& one : Exchanging(all, chosen, w, noise).factors(exchanges)) {
    factors.push_back({ln_over_scales(one.without.values), {}});
    for (const OneChoice& instead : one.instead) factors.back().instead.push_back(ln_over_scales(instead.values));
  }
  return factors;
}

}  // namespace handsight
