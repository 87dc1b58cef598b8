// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "estimation/column_products.h"

namespace handsight {
namespace {

constexpr auto& scales = plausible_scales;

double ln_determinant(const Eigen::LLT<Eigen::MatrixXd>& llt) {
  return 2 * llt.matrixLLT().diagonal().array().log().sum();
}

/// What squares gained are worth: half of them where sigma is known, else by the share of all squares.
double ln_worth(double gained, const WhitenedModel& w, const NoiseKnowledge& noise) {
  if (noise.known) return 0.5 * gained;
  const double left = std::max(1 - gained / w.residual_squares, 1e-12);
  return -0.5 * noise.degrees * std::log(left);
}

struct ScaledScore {
  double ln_bayes_factor = 0;
  Eigen::LLT<Eigen::MatrixXd> llt;  // of I + s^2 A
};

ScaledScore at_scale(const Score& score, double scale, const WhitenedModel& w, const NoiseKnowledge& noise) {
  ScaledScore s;
  Eigen::MatrixXd m = scale * scale * score.information;
  m.diagonal().array() += 1;
  s.llt.compute(m);
  const double gained = scale * scale * score.gradient.dot(s.llt.solve(score.gradient));
  s.ln_bayes_factor = ln_worth(gained, w, noise) - 0.5 * ln_determinant(s.llt);
  return s;
}

double ln_bayes_factor_of_one(double a, double b, const WhitenedModel& w, const NoiseKnowledge& noise) {
  std::array<double, scales.size()> values{};
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const double s2 = scales[i] * scales[i];
    values[i] = ln_worth(s2 * b * b / (1 + s2 * a), w, noise) - 0.5 * std::log1p(s2 * a);
  }
  return ln_mean_exp(values);
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

}  // namespace

double ln_mean_exp(std::span<const double> x) {
  if (x.empty()) return 0;
  const double largest = *std::max_element(x.begin(), x.end());
  double sum = 0;
  for (const double v : x) sum += std::exp(v - largest);
  return largest + std::log(sum / static_cast<double>(x.size()));
}

WhitenedModel whiten(const LinearModel& model, const Scatter& scatter, const NoiseKnowledge& noise) {
  WhitenedModel w;
  w.model = &model;
  w.scatter = scatter;
  w.external = model.external;
  w.external_error = model.external_error;
  double ln_volume = 0;
  for (const LinearObservation& o : model.observations) {
    if (!scatter.is_any()) {
      w.whiteners.push_back(Eigen::MatrixXd::Identity(o.count, o.count));
      continue;
    }
    const auto by_place = o.by_body.leftCols<3>();
    Eigen::MatrixXd v = std::pow(scatter.joints, 2) * o.by_joints * o.by_joints.transpose() +
                        std::pow(scatter.place, 2) * by_place * by_place.transpose();
    v.diagonal().array() += 1;
    const Eigen::LLT<Eigen::MatrixXd> llt(v);
    w.whiteners.push_back(llt.matrixL().solve(Eigen::MatrixXd::Identity(o.count, o.count)));
    ln_volume += ln_determinant(llt);
    whiten_rows(w.whiteners.back(), o.first, w.external);
    w.external_error.segment(o.first, o.count) = w.whiteners.back() * model.external_error.segment(o.first, o.count);
  }
  const Eigen::Index base = model.base, last = model.internal.cols() - 1;
  const auto by_base = w.external.leftCols(base);
  Eigen::MatrixXd information = model.internal.topLeftCorner(base, base);
  information += column_products(by_base);
  information.diagonal() += model.prior_precision;
  // What the measurements do not determine (an unseen marker, a gauge) is held by a trace of a prior.
  for (Eigen::Index i = 0; i < base; ++i) information(i, i) += information(i, i) > 0 ? 1e-10 * information(i, i) : 1.0;
  w.base.compute(information);
  Eigen::MatrixXd shared = column_products(by_base, w.external.rightCols(model.candidates()));
  for (Eigen::Index c = 0; c < model.candidates(); ++c)
    if (const Eigen::Index i = model.internal_of[static_cast<std::size_t>(c)]; i >= 0)
      shared.col(c) += model.internal.col(i).head(base);
  if (shared.cols() > 0) w.base.matrixL().solveInPlace(shared);
  w.shared = std::move(shared);
  w.base_gradient = w.base.matrixL().solve(by_base.transpose() * w.external_error +
                                           model.internal.col(last).head(base) + model.prior_gradient);
  w.residual_squares =
      w.external_error.squaredNorm() + model.internal(last, last) + model.prior_cost - w.base_gradient.squaredNorm();
  w.ln_evidence = -0.5 * ln_volume - 0.5 * ln_determinant(w.base) -
                  (noise.known ? 0.5 * w.residual_squares : 0.5 * noise.degrees * std::log(w.residual_squares));
  return w;
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

Score part_of(const Score& whole, std::span<const Eigen::Index> parameters) {
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

double ln_bayes_factor(const Score& score, const WhitenedModel& w, const NoiseKnowledge& noise) {
  if (score.gradient.size() == 0) return 0;
  if (score.gradient.size() == 1) return ln_bayes_factor_of_one(score.information(0, 0), score.gradient[0], w, noise);
  std::array<double, scales.size()> values{};
  for (std::size_t i = 0; i < scales.size(); ++i) values[i] = at_scale(score, scales[i], w, noise).ln_bayes_factor;
  return ln_mean_exp(values);
}

LinearEstimate linear_estimate(const Score& score, const WhitenedModel& w, const NoiseKnowledge& noise) {
  LinearEstimate best;
  double best_factor = -1e300;
  for (const double scale : scales) {
    const ScaledScore s = at_scale(score, scale, w, noise);
    if (s.ln_bayes_factor <= best_factor) continue;
    best_factor = s.ln_bayes_factor;
    best.scale = scale;
    best.covariance =
        scale * scale * s.llt.solve(Eigen::MatrixXd::Identity(score.gradient.size(), score.gradient.size()));
    best.value = best.covariance * score.gradient;
  }
  return best;
}

}  // namespace handsight
