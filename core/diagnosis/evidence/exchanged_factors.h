// SPDX-License-Identifier: Apache-2.0
// Bayes factors of many choices that differ from one in a single exchange, from one factorisation.
#pragma once

#include "diagnosis/evidence/evidence.h"

namespace handsight {

/// A group of the chosen parameters goes, and one of these comes in its place.
struct NumberExchange {
  ParameterGroup gone;                 // places among the chosen ones
  std::vector<ParameterGroup> coming;  // parameters of the whole score; none of them is chosen
};

/// ln_bayes_factor() of a choice of parameters after an exchange: without the group that goes, and with each of those
/// that come instead.
struct ExchangedFactors {
  double without = 0;
  std::vector<double> instead;
};

/// Of k chosen parameters and n that may come, k^3 + k^2 n operations a scale, however many exchanges there are: the
/// inverse of the chosen ones' information gives that of all but a group by a correction of the group's rank.
std::vector<ExchangedFactors> exchanged_factors(const Score& all, std::span<const Eigen::Index> chosen,
                                                std::span<const NumberExchange> exchanges, const WhitenedModel& w,
                                                const NoiseKnowledge& noise);

}  // namespace handsight
