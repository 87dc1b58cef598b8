// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/evidence.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/threads.h"
#include "diagnosis/evidence/scaled_score.h"
#include "estimation/problem/column_products.h"

namespace handsight {

static constexpr auto& scales = prior_scales;
static_assert(scales[largest_usual] == largest_usual_scale);

double ln_determinant(const Eigen::LLT<Eigen::MatrixXd>& llt) {
  return 2 * llt.matrixLLT().diagonal().array().log().sum();
}

double ln_worth(double gained, const WhitenedModel& w, const NoiseKnowledge& noise) {
  if (noise.known) return 0.5 * gained;
  const double left = std::max(1 - gained / w.residual_squares, 1e-12);
  return -0.5 * noise.degrees * std::log(left);
}

std::optional<double> beyond_usual(std::size_t scale, double at_largest_usual, double largest, Eigen::Index numbers) {
  if (scale <= largest_usual || largest > largest_usual_scale) return std::nullopt;
  return at_largest_usual - static_cast<double>(numbers) * std::log(scales[scale] / largest_usual_scale);
}

namespace {

struct ScaledScore {
  double ln_bayes_factor = 0;
  double largest = 0;               // of the estimate's numbers, prior sigmas
  Eigen::LLT<Eigen::MatrixXd> llt;  // of I + s^2 A
};

ScaledScore at_scale(const Score& score, double scale, const WhitenedModel& w, const NoiseKnowledge& noise) {
  ScaledScore s;
  Eigen::MatrixXd m = scale * scale * score.information;
  m.diagonal().array() += 1;
  s.llt.compute(m);
  const Eigen::VectorXd value = scale * scale * s.llt.solve(score.gradient);
  const double gained = score.gradient.dot(value);
  s.largest = value.size() > 0 ? value.cwiseAbs().maxCoeff() : 0;
  s.ln_bayes_factor = ln_worth(gained, w, noise) - 0.5 * ln_determinant(s.llt);
  return s;
}

double ln_bayes_factor_of_one(double a, double b, const WhitenedModel& w, const NoiseKnowledge& noise) {
  std::array<double, scales.size()> values{};
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const double s2 = scales[i] * scales[i];
    values[i] = ln_worth(s2 * b * b / (1 + s2 * a), w, noise) - 0.5 * std::log1p(s2 * a);
  }
  return ln_over_scales(values);
}

/// Rows from `first` on, multiplied by `whitener`; usually the six of a body's motion, whose products cost less.
void whiten_rows(const Eigen::MatrixXd& whitener, Eigen::Index first, Eigen::MatrixXd& rows) {
  if (whitener.rows() != 6) {
    rows.middleRows(first, whitener.rows()) = whitener * rows.middleRows(first, whitener.rows());
    return;
  }
  const Matrix6 fixed = whitener;
  for (Eigen::Index c = 0; c < rows.cols(); ++c) rows.col(c).segment<6>(first) = fixed * rows.col(c).segment<6>(first);
}

/// The external rows for a scatter.
struct WhitenedRows {
  std::vector<Eigen::MatrixXd> whiteners;
  Eigen::MatrixXd external;
  Eigen::VectorXd error;
  double ln_volume = 0;  // ln of the covariances' determinants
};

/// Adds to `rows` what is observation `i`'s.
double whiten_observation(const LinearModel& model, std::size_t i, const Repeatability& repeatability,
                          WhitenedRows& rows) {
  const LinearObservation& o = model.observations[i];
  const auto by_place = o.by_body.leftCols<3>();
  Eigen::MatrixXd by_joints = repeatability.joints * o.by_joints;
  for (Eigen::Index j = 0; j < by_joints.cols() && !repeatability.of_joint.empty(); ++j)
    by_joints.col(j) *= repeatability.of_joint[static_cast<std::size_t>(j)];
  Eigen::MatrixXd v =
      by_joints * by_joints.transpose() + std::pow(repeatability.place, 2) * by_place * by_place.transpose();
  v.diagonal().array() += 1;
  const Eigen::LLT<Eigen::MatrixXd> llt(v);
  rows.whiteners[i] = llt.matrixL().solve(Eigen::MatrixXd::Identity(o.count, o.count));
  whiten_rows(rows.whiteners[i], o.first, rows.external);
  rows.error.segment(o.first, o.count) = rows.whiteners[i] * model.external_error.segment(o.first, o.count);
  return ln_determinant(llt);
}

/// `rows.external` holds the model's external rows, or the base's columns of them, and leaves them whitened.
void whiten_all(const LinearModel& model, const Repeatability& repeatability, WhitenedRows& rows) {
  constexpr std::size_t of_a_part = 32;
  rows.error = model.external_error;
  rows.whiteners.clear();
  for (const LinearObservation& o : model.observations)
    rows.whiteners.emplace_back(Eigen::MatrixXd::Identity(o.count, o.count));
  if (!repeatability.is_any()) return;
  const std::size_t count = model.observations.size(), parts = (count + of_a_part - 1) / of_a_part;
  std::vector<double> ln_volumes(count);
  each_part(static_cast<int>(parts), parts >= 3, [&](int part) {
    const std::size_t first = static_cast<std::size_t>(part) * of_a_part;
    for (std::size_t i = first; i < std::min(first + of_a_part, count); ++i)
      ln_volumes[i] = whiten_observation(model, i, repeatability, rows);
  });
  for (const double ln_volume : ln_volumes) rows.ln_volume += ln_volume;
}

BaseSums sums_of(const LinearModel& model, const WhitenedRows& rows) {
  const Eigen::Index base = model.base, last = model.internal.cols() - 1;
  const auto by_base = rows.external.leftCols(base);
  return {model.internal.topLeftCorner(base, base) + column_products(by_base),
          model.internal.col(last).head(base) + by_base.transpose() * rows.error,
          model.internal(last, last) + rows.error.squaredNorm(), rows.ln_volume};
}

/// The base at its own best step.
struct SettledBase {
  Eigen::LLT<Eigen::MatrixXd> llt;
  Eigen::VectorXd gradient;
  double residual_squares = 0, ln_evidence = 0;
};

SettledBase settled(const BaseSums& sums, const BasePrior& prior, const NoiseKnowledge& noise) {
  SettledBase s;
  Eigen::MatrixXd information = sums.information;
  information.diagonal() += prior.precision;
  // What the measurements do not determine (an unseen marker, a gauge) is held by a trace of a prior.
  for (Eigen::Index i = 0; i < information.cols(); ++i)
    information(i, i) += information(i, i) > 0 ? 1e-10 * information(i, i) : 1.0;
  s.llt.compute(information);
  s.gradient = s.llt.matrixL().solve(sums.gradient + prior.gradient);
  s.residual_squares = sums.squares + prior.cost - s.gradient.squaredNorm();
  s.ln_evidence = -0.5 * sums.ln_volume - 0.5 * ln_determinant(s.llt) -
                  (noise.known ? 0.5 * s.residual_squares : 0.5 * noise.degrees * std::log(s.residual_squares));
  return s;
}

}  // namespace

double ln_mean_exp(std::span<const double> x) {
  if (x.empty()) return 0;
  const double largest = *std::max_element(x.begin(), x.end());
  double sum = 0;
  for (const double v : x) sum += std::exp(v - largest);
  return largest + std::log(sum / static_cast<double>(x.size()));
}

double ln_over_scales(std::span<const double> x) {
  std::array<double, scales.size()> weighed{};
  for (std::size_t i = 0; i < scales.size(); ++i) weighed[i] = x[i] + std::log(scale_shares[i]);
  return ln_mean_exp(weighed) + std::log(static_cast<double>(scales.size()));
}

WhitenedModel whiten(const LinearModel& model, const Repeatability& repeatability, const NoiseKnowledge& noise) {
  WhitenedModel w;
  whiten(model, repeatability, noise, w);
  return w;
}

void whiten(const LinearModel& model, const Repeatability& repeatability, const NoiseKnowledge& noise,
            WhitenedModel& w) {
  w.model = &model;
  w.repeatability = repeatability;
  WhitenedRows rows{std::move(w.whiteners), std::move(w.external), std::move(w.external_error)};
  rows.external = model.external;
  whiten_all(model, repeatability, rows);
  const auto by_base = rows.external.leftCols(model.base);
  const SettledBase base = settled(sums_of(model, rows), model.prior, noise);
  Eigen::MatrixXd shared = column_products(by_base, rows.external.rightCols(model.candidates()));
  for (Eigen::Index c = 0; c < model.candidates(); ++c)
    if (const Eigen::Index i = model.internal_of[static_cast<std::size_t>(c)]; i >= 0)
      shared.col(c) += model.internal.col(i).head(model.base);
  if (shared.cols() > 0) base.llt.matrixL().solveInPlace(shared);
  w.whiteners = std::move(rows.whiteners);
  w.external = std::move(rows.external);
  w.external_error = std::move(rows.error);
  w.base = base.llt;
  w.shared = std::move(shared);
  w.base_gradient = base.gradient;
  w.residual_squares = base.residual_squares;
  w.ln_evidence = base.ln_evidence;
}

BaseEvidence::BaseEvidence(const LinearModel& model, const Repeatability& repeatability, const NoiseKnowledge& noise)
    : noise_(noise) {
  WhitenedRows rows{{}, model.external.leftCols(model.base), {}};
  whiten_all(model, repeatability, rows);
  sums_ = sums_of(model, rows);
}

double BaseEvidence::ln_with(const BasePrior& prior) const { return settled(sums_, prior, noise_).ln_evidence; }

double BaseEvidence::squares_with(const BasePrior& prior) const {
  return settled(sums_, prior, noise_).residual_squares;
}

double ln_evidence_of_base(const LinearModel& model, const Repeatability& repeatability, const NoiseKnowledge& noise) {
  return BaseEvidence(model, repeatability, noise).ln_with(model.prior);
}

Score score(const WhitenedModel& w, Eigen::Index first, Eigen::Index count) {
  const LinearModel& m = *w.model;
  const auto columns = w.external.middleCols(m.base + first, count);
  const auto shared = w.shared.middleCols(first, count);
  Score s;
  s.information = column_products(columns) - column_products(shared);
  s.gradient = columns.transpose() * w.external_error - shared.transpose() * w.base_gradient;
  const Eigen::Index last = m.internal.cols() - 1;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index a = m.internal_of[static_cast<std::size_t>(first + i)];
    if (a < 0) continue;
    s.gradient[i] += m.internal(a, last);
    for (Eigen::Index j = 0; j < count; ++j)
      if (const Eigen::Index b = m.internal_of[static_cast<std::size_t>(first + j)]; b >= 0)
        s.information(i, j) += m.internal(a, b);
  }
  // Rounding of the projection must not pass for information.
  for (Eigen::Index i = 0; i < count; ++i) {
    const double raw = columns.col(i).squaredNorm();
    if (s.information(i, i) > 1e-9 * raw) continue;
    s.information.row(i).setZero();
    s.information.col(i).setZero();
    s.gradient[i] = 0;
  }
  return s;
}

Score take_part(const Score& whole, std::span<const Eigen::Index> parameters) {
  const auto count = static_cast<Eigen::Index>(parameters.size());
  Score part{Eigen::MatrixXd(count, count), Eigen::VectorXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    part.gradient[i] = whole.gradient[parameters[static_cast<std::size_t>(i)]];
    for (Eigen::Index j = 0; j < count; ++j)
      part.information(i, j) =
          whole.information(parameters[static_cast<std::size_t>(i)], parameters[static_cast<std::size_t>(j)]);
  }
  return part;
}

double ln_bayes_factor_at(const Score& score, double scale, const WhitenedModel& w, const NoiseKnowledge& noise) {
  return at_scale(score, scale, w, noise).ln_bayes_factor;
}

double ln_bayes_factor(const Score& score, const WhitenedModel& w, const NoiseKnowledge& noise) {
  if (score.gradient.size() == 0) return 0;
  if (score.gradient.size() == 1) return ln_bayes_factor_of_one(score.information(0, 0), score.gradient[0], w, noise);
  std::array<double, scales.size()> values{};
  double largest = 0;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    if (const auto wide = beyond_usual(i, values[largest_usual], largest, score.gradient.size())) {
      values[i] = *wide;
      continue;
    }
    const ScaledScore s = at_scale(score, scales[i], w, noise);
    values[i] = s.ln_bayes_factor;
    largest = s.largest;
  }
  return ln_over_scales(values);
}

FactorsWithout ln_bayes_factors_without(const Score& score, std::span<const ParameterGroup> groups,
                                        const WhitenedModel& w, const NoiseKnowledge& noise) {
  if (score.gradient.size() == 0) return {0, std::vector<double>(groups.size())};
  std::array<double, scales.size()> whole{};
  std::vector<std::array<double, scales.size()>> without(groups.size());
  const auto identity = Eigen::MatrixXd::Identity(score.gradient.size(), score.gradient.size());
  double largest = 0;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const Eigen::Index numbers = score.gradient.size();
    if (const auto wide = beyond_usual(i, whole[largest_usual], largest, numbers)) {
      whole[i] = *wide;
      for (std::size_t g = 0; g < groups.size(); ++g)
        without[g][i] = *beyond_usual(i, without[g][largest_usual], largest, numbers - groups[g].count);
      continue;
    }
    const ScaledScore s = at_scale(score, scales[i], w, noise);
    whole[i] = s.ln_bayes_factor;
    largest = s.largest;
    const Eigen::MatrixXd inverse = s.llt.solve(identity);
    const Eigen::VectorXd value = inverse * (scales[i] * score.gradient);
    const double gained = scales[i] * score.gradient.dot(value), ln_volume = ln_determinant(s.llt);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const Eigen::Index first = groups[g].first, count = groups[g].count;
      // Of a group the inverse has the inverse of what of its information the others do not share.
      const Eigen::LLT<Eigen::MatrixXd> own(inverse.block(first, first, count, count));
      const auto own_value = value.segment(first, count);
      without[g][i] =
          ln_worth(gained - own_value.dot(own.solve(own_value)), w, noise) - 0.5 * (ln_volume + ln_determinant(own));
    }
  }
  FactorsWithout factors{ln_over_scales(whole), {}};
  for (const auto& values : without) factors.without.push_back(ln_over_scales(values));
  return factors;
}

std::vector<double> ln_bayes_factors_beside(const Score& all, std::span<const Eigen::Index> chosen,
                                            std::span<const ParameterGroup> groups, const WhitenedModel& w,
                                            const NoiseKnowledge& noise) {
  const Score own = take_part(all, chosen);
  Eigen::MatrixXd shared(chosen.size(), all.gradient.size());
  for (std::size_t i = 0; i < chosen.size(); ++i)
    shared.row(static_cast<Eigen::Index>(i)) = all.information.row(chosen[i]);
  std::vector<std::array<double, scales.size()>> with(groups.size());
  std::vector<double> largest(groups.size(), 0.0);  // of each group's estimate beside the chosen ones, and of theirs
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const double scale = scales[i];
    std::size_t asked = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const auto wide = beyond_usual(i, with[g][largest_usual], largest[g], own.gradient.size() + groups[g].count);
      if (wide)
        with[g][i] = *wide;
      else
        ++asked;
    }
    if (asked == 0) continue;
    const ScaledScore s = at_scale(own, scale, w, noise);
    const Eigen::VectorXd gradient = s.llt.matrixL().solve(scale * own.gradient);
    const Eigen::MatrixXd by_own = s.llt.matrixL().solve(scale * scale * shared);
    const double ln_volume = ln_determinant(s.llt);
    const bool is_worth_it = static_cast<Eigen::Index>(groups.size()) * own.gradient.size() > 20000;
    each_part(static_cast<int>(groups.size()), is_worth_it, [&](int g) {
      const auto [first, count] = groups[static_cast<std::size_t>(g)];
      double& largest_here = largest[static_cast<std::size_t>(g)];
      if (i > largest_usual && largest_here <= largest_usual_scale) return;  // as above
      const auto columns = by_own.middleCols(first, count);
      Eigen::MatrixXd rest = scale * scale * all.information.block(first, first, count, count);
      rest.diagonal().array() += 1;
      rest -= columns.transpose() * columns;
      const Eigen::LLT<Eigen::MatrixXd> llt(rest);
      const Eigen::VectorXd step =
          llt.matrixL().solve(scale * all.gradient.segment(first, count) - columns.transpose() * gradient);
      if (i == largest_usual) {
        const Eigen::VectorXd group = llt.matrixU().solve(step);
        const Eigen::VectorXd beside = s.llt.matrixU().solve(gradient - columns * group);
        largest_here =
            scale * std::max(group.cwiseAbs().maxCoeff(), beside.size() > 0 ? beside.cwiseAbs().maxCoeff() : 0);
      }
      with[static_cast<std::size_t>(g)][i] =
          ln_worth(gradient.squaredNorm() + step.squaredNorm(), w, noise) - 0.5 * (ln_volume + ln_determinant(llt));
    });
  }
  std::vector<double> factors;
  for (const auto& values : with) factors.push_back(ln_over_scales(values));
  return factors;
}

LinearEstimate linear_estimate(const Score& score, const WhitenedModel& w, const NoiseKnowledge& noise) {
  LinearEstimate best;
  double best_factor = -1e300;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const double scale = scales[i];
    const ScaledScore s = at_scale(score, scale, w, noise);
    const double factor = s.ln_bayes_factor + std::log(scale_shares[i]);
    if (factor <= best_factor) continue;
    best_factor = factor;
    best.scale = scale;
    best.covariance =
        scale * scale * s.llt.solve(Eigen::MatrixXd::Identity(score.gradient.size(), score.gradient.size()));
    best.value = best.covariance * score.gradient;
  }
  return best;
}

}  // namespace handsight
