// SPDX-License-Identifier: Apache-2.0
// A score at one of the plausible scales.
#pragma once

#include <Eigen/Cholesky>
#include <cstddef>
#include <optional>

namespace handsight {

struct NoiseKnowledge;
struct WhitenedModel;

inline constexpr std::size_t largest_usual = 3;  // into prior_scales: largest_usual_scale

double ln_determinant(const Eigen::LLT<Eigen::MatrixXd>& llt);

/// What squares gained are worth: half of them where sigma is known, else by the share of all squares.
double ln_worth(double gained, const WhitenedModel& w, const NoiseKnowledge& noise);

/// Where an estimate fits into the largest usual scale, a wider one leaves it where it is and only costs its volume: so
/// much for each of its numbers. Nothing where the wider scale must be asked.
std::optional<double> beyond_usual(std::size_t scale, double at_largest_usual, double largest, Eigen::Index numbers);

}  // namespace handsight
