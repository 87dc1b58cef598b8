// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/second_moments.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "estimation/solvers/covariance_factor.h"

namespace handsight {
namespace {

constexpr double largest_of_others = 1;  // prior sigmas: more would be known of them

class Moments {
 public:
  Moments(const ModelSpace& all, const OpenUnits& units, const OpenScore& score)
      : all_(all),
        score_(score.score),
        whitened_(score.whitened),
        first_number_(score.first_number),
        is_present_(static_cast<std::size_t>(score.score.gradient.size())) {
    for (const std::size_t u : units.open)
      for (Eigen::Index i = 0; i < all.units()[u].count; ++i)
        is_present_[static_cast<std::size_t>(first_number_.at(u) + i)] = all.units()[u].is_present;
  }

  Eigen::MatrixXd of(const Weights& weights, const Chosen& model) const {
    const Eigen::Index count = score_.gradient.size();
    Eigen::VectorXd answer = Eigen::VectorXd::Zero(count);
    for (const auto& [share, state] : at_scales(model)) answer += share * state.mean;
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(count, count);
    for (const auto& [chosen, weight] : weights)
      for (const auto& [share, state] : at_scales(chosen)) {
        const Eigen::VectorXd away = state.mean - answer;
        sum += weight * share * (away * away.transpose() + state.added);
      }
    return sum;
  }

 private:
  struct State {
    Eigen::VectorXd mean;
    Eigen::MatrixXd added;  // covariance that comes with what the model does not have
  };

  /// The information of some numbers alone, others being 0.
  Eigen::MatrixXd information(const std::vector<Eigen::Index>& numbers, double scale) const {
    Eigen::MatrixXd information = score_.information(numbers, numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double size =
          is_present_[static_cast<std::size_t>(numbers[i])] ? scale : std::min(scale, largest_of_others);
      information(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) += std::pow(size, -2);
    }
    return information;
  }

  /// The covariance of kept and new numbers less that of the kept ones alone, by all of them in order: what the new
  /// ones vary by, and as these move the kept ones. The difference itself is one of nearly equal numbers.
  Eigen::MatrixXd added(const std::vector<Eigen::Index>& numbers, const Eigen::MatrixXd& information,
                        double scale) const {
    std::vector<Eigen::Index> kept, fresh;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      (is_present_[static_cast<std::size_t>(numbers[i])] ? kept : fresh).push_back(static_cast<Eigen::Index>(i));
    const auto count = static_cast<Eigen::Index>(fresh.size());
    Eigen::MatrixXd by_new = Eigen::MatrixXd::Zero(information.rows(), count);
    by_new(fresh, Eigen::all) = Eigen::MatrixXd::Identity(count, count);
    Eigen::MatrixXd left = information(fresh, fresh);
    if (!kept.empty()) {
      const Eigen::MatrixXd with_kept = information(kept, fresh);
      const Eigen::MatrixXd kept_by_new = Eigen::MatrixXd(information(kept, kept)).ldlt().solve(with_kept);
      by_new(kept, Eigen::all) = -kept_by_new;
      left -= with_kept.transpose() * kept_by_new;
    }
    const double least = std::pow(std::min(scale, largest_of_others), -2);  // their prior, whatever rounding has left
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(left);
    const Eigen::VectorXd sigmas = eigen.eigenvalues().cwiseMax(least).cwiseSqrt().cwiseInverse();
    return covariance_from(by_new * eigen.eigenvectors() * sigmas.asDiagonal());
  }

  std::vector<std::pair<double, State>> at_scales(const Chosen& chosen) const {
    std::vector<Eigen::Index> numbers;
    bool has_new = false;
    for (const std::size_t u : chosen)
      for (Eigen::Index i = 0; i < all_.units()[u].count; ++i) {
        numbers.push_back(first_number_.at(u) + i);
        has_new = has_new || !all_.units()[u].is_present;
      }
    std::vector<std::pair<double, State>> states;
    std::vector<double> ln_shares;
    const Score own = take_part(score_, numbers);
    for (const double scale : prior_scales) {
      State s{Eigen::VectorXd::Zero(score_.gradient.size()),
              Eigen::MatrixXd::Zero(score_.gradient.size(), score_.gradient.size())};
      if (!numbers.empty()) {
        const Eigen::MatrixXd known = information(numbers, scale);
        const Eigen::VectorXd best = known.llt().solve(own.gradient);
        s.mean(numbers) = best;
        if (has_new) s.added(numbers, numbers) = added(numbers, known, scale);
      }
      ln_shares.push_back(ln_factor(own, scale));
      states.emplace_back(0, std::move(s));
    }
    const double mean = ln_over_scales(ln_shares);
    for (std::size_t i = 0; i < states.size(); ++i) states[i].first = scale_shares[i] * std::exp(ln_shares[i] - mean);
    return states;
  }

  /// ln of the Bayes factor at one scale.
  double ln_factor(const Score& own, double scale) const {
    if (own.gradient.size() == 0) return 0;
    return ln_bayes_factor_at(own, scale, whitened_, all_.by().knowledge);
  }

  const ModelSpace& all_;
  const Score& score_;
  const WhitenedModel& whitened_;
  const std::map<std::size_t, Eigen::Index>& first_number_;
  std::vector<bool> is_present_;  // of the numbers: in the model
};

}  // namespace

Eigen::MatrixXd second_moments(const ModelSpace& all, const OpenUnits& units, const OpenScore& score,
                               const Weights& weights, const Chosen& model) {
  return Moments(all, units, score).of(weights, model);
}

}  // namespace handsight
