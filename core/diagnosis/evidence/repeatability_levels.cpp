// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/repeatability_levels.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/threads.h"

namespace handsight {
namespace {

constexpr Repeatability worst_repeatability{30e-3, 10e-3};
constexpr double clearly_likelier = 5;  // ln: what another assumption must bring
constexpr int most_rounds = 20;
constexpr double settled_share = 1e-2;  // of a variance, from round to round
constexpr double negligible = 1e-12;    // (1 urad)^2, (1 um)^2

/// The white noise (in units of its variance), the joints' scatter (rad^2) and the place's (m^2).
using Variances = Eigen::Vector3d;

/// Of the body's motion, or of what of it is seen.
using Covariance = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

/// One observation's covariance for variances of 1: of the joints and of the place.
struct Shares {
  Covariance joints, place;
  Eigen::VectorXd error;
};

std::vector<Shares> shares_of(const LinearModel& model) {
  std::vector<Shares> all;
  for (const LinearObservation& o : model.observations) {
    const auto by_place = o.by_body.leftCols<3>();
    all.push_back({o.by_joints * o.by_joints.transpose(), by_place * by_place.transpose(),
                   model.external_error.segment(o.first, o.count)});
  }
  return all;
}

/// By the variances, summed over the observations.
struct Likelihood {
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();      // e^T V^-1 K V^-1 e, for each share K of the covariance V
  Eigen::Vector3d traces = Eigen::Vector3d::Zero();       // tr(V^-1 K), what they are expected to be
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  // tr(V^-1 K V^-1 L)
};

Likelihood likelihood_of(std::span<const Shares> some, const Variances& v) {
  Likelihood sum;
  for (const Shares& s : some) {
    Covariance covariance = v[1] * s.joints + v[2] * s.place;
    covariance.diagonal().array() += v[0];
    const Eigen::LLT<Covariance> llt(covariance);
    const std::array<Covariance, 3> by{llt.solve(Covariance::Identity(covariance.rows(), covariance.cols())),
                                       llt.solve(s.joints), llt.solve(s.place)};
    const Eigen::VectorXd w = llt.solve(s.error);
    sum.squares += Eigen::Vector3d(w.squaredNorm(), w.dot(s.joints * w), w.dot(s.place * w));
    for (int k = 0; k < 3; ++k) {
      sum.traces[k] += by[k].trace();
      for (int l = 0; l < 3; ++l) sum.information(k, l) += by[k].cwiseProduct(by[l].transpose()).sum();
    }
  }
  return sum;
}

/// In parts, as many however many threads there are: sums then are the same bit by bit.
Likelihood likelihood(const std::vector<Shares>& all, const Variances& v) {
  constexpr std::size_t parts = 8, worth_threads = 100;
  std::array<Likelihood, parts> sums;
  each_part(parts, all.size() >= worth_threads, [&](int i) {
    const auto part = static_cast<std::size_t>(i);
    const std::size_t first = all.size() * part / parts, end = all.size() * (part + 1) / parts;
    sums[part] = likelihood_of(std::span(all).subspan(first, end - first), v);
  });
  Likelihood sum;
  for (const Likelihood& part : sums) {
    sum.squares += part.squares;
    sum.traces += part.traces;
    sum.information += part.information;
  }
  return sum;
}

/// A step of Fisher's scoring from `v` on. No variance falls below a tenth or grows beyond ten times of what it was;
/// one that moves nothing is 0, and one that has come to nothing stays, so that the others do not step to make up for
/// it.
Variances scored(const Likelihood& at, const Variances& v, bool with_noise) {
  Variances next = v;
  std::vector<int> free;
  for (int k = with_noise ? 0 : 1; k < 3; ++k) {
    const bool is_gone = v[k] <= negligible && at.squares[k] < at.traces[k];
    if (!(at.information(k, k) > 0))
      next[k] = 0;
    else if (!is_gone)
      free.push_back(k);
  }
  Eigen::MatrixXd information = at.information(free, free);
  information.diagonal() *= 1 + 1e-9;
  const Eigen::VectorXd step = information.ldlt().solve((at.squares - at.traces)(free));
  for (std::size_t i = 0; i < free.size(); ++i) {
    const double before = v[free[i]];
    next[free[i]] = std::clamp(before + step[static_cast<Eigen::Index>(i)], 0.1 * before, 10 * before);
  }
  return next;
}

std::vector<Repeatability> usual_levels() { return {{0, 0}, {1e-4, 0}, {3e-4, 0}, {1e-3, 0}, {3e-3, 0}}; }

std::vector<Repeatability> list_parts(const Repeatability& s) {
  std::vector<Repeatability> parts;
  for (const double part : {0.0, 0.1, 0.3, 0.6, 1.0}) parts.push_back({part * s.joints, part * s.place});
  return parts;
}

}  // namespace

Repeatability likely_repeatability(const LinearModel& model, const Repeatability& start, const NoiseKnowledge& noise,
                                   bool with_place) {
  const std::vector<Shares> all = shares_of(model);
  Variances v(1, std::pow(std::max(start.joints, 1e-4), 2), 0);
  if (with_place) v[2] = std::pow(std::max(start.place, 1e-4), 2);
  for (int round = 0; round < most_rounds; ++round) {
    const Variances before = v;
    v = scored(likelihood(all, v), v, !noise.known);
    const bool is_settled =
        ((v - before).array().abs() <= settled_share * before.array() || before.array() <= negligible).all();
    if (is_settled) break;
  }
  v /= v[0];
  const auto sigma = [](double variance, double most) {
    return variance <= negligible ? 0 : std::min(std::sqrt(variance), most);
  };
  return {sigma(v[1], worst_repeatability.joints), sigma(v[2], worst_repeatability.place)};
}

std::vector<Repeatability> repeatability_levels(const LinearModel& model, const NoiseKnowledge& noise) {
  const auto evidence = [&](const Repeatability& s) { return BaseEvidence(model, s, noise).ln_with(model.prior); };
  std::vector<Repeatability> levels = usual_levels();
  Repeatability best;
  double top = -1e300;
  for (const Repeatability& level : levels)
    if (const double e = evidence(level); e > top) {
      top = e;
      best = level;
    }
  for (const bool with_place : {false, true}) {
    if (with_place && !noise.known) continue;
    const Repeatability likely = likely_repeatability(model, best, noise, with_place);
    const double e = evidence(likely);
    if (e <= top + clearly_likelier) continue;
    top = e;
    best = likely;
    levels = list_parts(likely);
  }
  return levels;
}

Message repeatability_text(const Repeatability& s) {
  Message text;
  if (s.joints > 0) text = message("joints that repeat to {:.2g} mrad", 1e3 * s.joints);
  if (!(s.place >= least_reported_place)) return text;
  const Message place = message("a hand whose place scatters by {:.2g} mm", 1e3 * s.place);
  return text.empty() ? place : message("{} and {}", text, place);
}

}  // namespace handsight
