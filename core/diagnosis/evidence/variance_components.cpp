// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/variance_components.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/threads.h"

namespace handsight {
namespace {

constexpr Repeatability worst_repeatability{30e-3, 10e-3};
constexpr int most_rounds = 20;
constexpr double settled_share = 1e-2;  // of a variance, from round to round
constexpr double negligible = 1e-12;    // (1 urad)^2, (1 um)^2

/// Of the body's motion, or of what of it is seen.
using Covariance = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

/// The white noise's (in units of its variance), the joints' (rad^2; one for all or one each) and the place's (m^2).
using Variances = Eigen::VectorXd;

/// Which of the variances a motion's size has: the columns of the joints, then of the place.
using Groups = std::vector<Eigen::Index>;

using Motions = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, Eigen::Dynamic>;

/// What one observation sees of motions of 1.
struct Shown {
  Motions by_motions;
  Eigen::VectorXd error;
};

/// Parts of a joined session may have fewer joints than others: those that they have not show nothing.
std::vector<Shown> shown_by(const LinearModel& model) {
  Eigen::Index joints = 0;
  for (const LinearObservation& o : model.observations) joints = std::max(joints, o.by_joints.cols());
  std::vector<Shown> all;
  for (const LinearObservation& o : model.observations) {
    Shown one{Motions::Zero(o.count, joints + 3), model.external_error.segment(o.first, o.count)};
    one.by_motions.leftCols(o.by_joints.cols()) = o.by_joints;
    one.by_motions.rightCols<3>() = o.by_body.leftCols<3>();
    all.push_back(std::move(one));
  }
  return all;
}

/// By the noise's variance and one for each motion (its share K of the covariance V is b b^T of its column b), summed
/// over the observations; or by the variances of their groups, the noise's first.
struct Likelihood {
  Eigen::VectorXd squares;      // e^T V^-1 K V^-1 e
  Eigen::VectorXd traces;       // tr(V^-1 K), what they are expected to be
  Eigen::MatrixXd information;  // tr(V^-1 K V^-1 L)

  explicit Likelihood(Eigen::Index variances = 0)
      : squares(Eigen::VectorXd::Zero(variances)),
        traces(Eigen::VectorXd::Zero(variances)),
        information(Eigen::MatrixXd::Zero(variances, variances)) {}
};

Likelihood likelihood_by_motions(std::span<const Shown> some, double noise, const Eigen::VectorXd& of_motions) {
  const Eigen::Index motions = of_motions.size();
  Likelihood sum(1 + motions);
  Motions weighted, solved;
  Eigen::MatrixXd between(motions, motions);
  for (const Shown& s : some) {
    weighted = s.by_motions * of_motions.asDiagonal();
    Covariance covariance = weighted.lazyProduct(s.by_motions.transpose());
    covariance.diagonal().array() += noise;
    const Covariance inverse =
        Eigen::LLT<Covariance>(covariance).solve(Covariance::Identity(covariance.rows(), covariance.cols()));
    solved = inverse.lazyProduct(s.by_motions);
    between.noalias() = s.by_motions.transpose().lazyProduct(solved);
    sum.squares[0] += (inverse * s.error).squaredNorm();
    sum.squares.tail(motions).array() += (solved.transpose() * s.error).array().square();
    sum.traces[0] += inverse.trace();
    sum.traces.tail(motions) += between.diagonal();
    sum.information(0, 0) += inverse.squaredNorm();
    sum.information.row(0).tail(motions) += solved.colwise().squaredNorm();
    sum.information.bottomRightCorner(motions, motions).array() += between.array().square();
  }
  sum.information.col(0) = sum.information.row(0).transpose();
  return sum;
}

Likelihood in_groups(const Likelihood& by_motions, const Groups& groups, Eigen::Index variances) {
  Eigen::MatrixXd belongs = Eigen::MatrixXd::Zero(by_motions.squares.size(), variances);
  belongs(0, 0) = 1;
  for (std::size_t m = 0; m < groups.size(); ++m) belongs(static_cast<Eigen::Index>(m) + 1, groups[m]) = 1;
  Likelihood sum;
  sum.squares = belongs.transpose() * by_motions.squares;
  sum.traces = belongs.transpose() * by_motions.traces;
  sum.information = belongs.transpose() * by_motions.information * belongs;
  return sum;
}

/// In parts, as many however many threads there are: sums then are the same bit by bit.
Likelihood likelihood(const std::vector<Shown>& all, const Groups& groups, const Variances& v) {
  constexpr std::size_t parts = 8, worth_threads = 100;
  const Eigen::VectorXd of_motions = v(groups);
  std::array<Likelihood, parts> sums;
  each_part(parts, all.size() >= worth_threads, [&](int i) {
    const auto part = static_cast<std::size_t>(i);
    const std::size_t first = all.size() * part / parts, end = all.size() * (part + 1) / parts;
    sums[part] = likelihood_by_motions(std::span(all).subspan(first, end - first), v[0], of_motions);
  });
  Likelihood sum(1 + of_motions.size());
  for (const Likelihood& part : sums) {
    sum.squares += part.squares;
    sum.traces += part.traces;
    sum.information += part.information;
  }
  return in_groups(sum, groups, v.size());
}

/// A step of Fisher's scoring from `v` on. No variance falls below a tenth or grows beyond ten times of what it was;
/// one that moves nothing is 0, and one that has come to nothing stays, so that the others do not step to make up for
/// it.
Variances scored(const Likelihood& at, const Variances& v, bool with_noise) {
  Variances next = v;
  std::vector<Eigen::Index> free;
  for (Eigen::Index k = with_noise ? 0 : 1; k < v.size(); ++k) {
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

double sigma_of(double variance, double most) {
  return variance <= negligible ? 0 : std::min(std::sqrt(variance), most);
}

bool is_settled(const Variances& v, const Variances& before) {
  return ((v - before).array().abs() <= settled_share * before.array() || before.array() <= negligible).all();
}

/// Joints' variances as logarithms, each a normal distribution about their mean with this sigma: most repeat within a
/// factor of three of each other (e to the half of it), and what no measurement tells is as the others.
constexpr double sigma_of_ln = 2;

/// Takes the mean out of what the joints have; the noise (first) and the place (last) are none.
Eigen::MatrixXd about_their_mean(Eigen::Index variances) {
  Eigen::MatrixXd centred = Eigen::MatrixXd::Zero(variances, variances);
  const Eigen::Index joints = variances - 2;
  centred.block(1, 1, joints, joints).diagonal().setOnes();
  centred.block(1, 1, joints, joints).array() -= 1 / static_cast<double>(joints);
  return centred;
}

/// A step of Fisher's scoring over the logarithms, with the prior of the joints', and what it promises (ln). The noise
/// is known.
double score_each(const Likelihood& at, Variances& v) {
  constexpr double most_step = 2.3;  // tenfold
  const Eigen::MatrixXd prior = about_their_mean(v.size()) / (sigma_of_ln * sigma_of_ln);
  const Eigen::VectorXd ln = v.array().max(1e-300).log();
  Eigen::MatrixXd information = 0.5 * v.asDiagonal() * at.information * v.asDiagonal() + prior;
  Eigen::VectorXd gradient = 0.5 * v.cwiseProduct(at.squares - at.traces) - prior * ln;
  information.diagonal().array() += 1e-9;
  std::vector<Eigen::Index> free;
  for (Eigen::Index k = 1; k < v.size(); ++k)
    if (v[k] > negligible) free.push_back(k);
  const Eigen::MatrixXd of_free = information(free, free);
  const Eigen::VectorXd step = of_free.ldlt().solve(gradient(free).eval());
  for (std::size_t i = 0; i < free.size(); ++i)
    v[free[i]] *= std::exp(std::clamp(step[static_cast<Eigen::Index>(i)], -most_step, most_step));
  return 0.5 * step.dot(gradient(free));
}

/// ln of what the prior and what was learned of the logarithms take off the evidence (Laplace's approximation).
double price_of(const Likelihood& at, const Variances& v) {
  const Eigen::MatrixXd centred = about_their_mean(v.size());
  const Eigen::VectorXd apart = centred * v.array().max(1e-300).log().matrix() / sigma_of_ln;
  Eigen::MatrixXd learned = 0.5 * v.asDiagonal() * at.information * v.asDiagonal();
  learned = sigma_of_ln * sigma_of_ln * centred * learned * centred;
  learned.diagonal().array() += 1;
  const Eigen::LLT<Eigen::MatrixXd> llt(learned);
  return 0.5 * apart.squaredNorm() + llt.matrixLLT().diagonal().array().log().sum();
}

}  // namespace

Repeatability likely_repeatability(const LinearModel& model, const Repeatability& start, const NoiseKnowledge& noise,
                                   bool with_place) {
  const std::vector<Shown> all = shown_by(model);
  Groups groups(all.empty() ? 0 : static_cast<std::size_t>(all.front().by_motions.cols() - 3), 1);
  groups.insert(groups.end(), 3, 2);
  Variances v = Variances::Zero(3);
  v[0] = 1;
  v[1] = std::pow(std::max(start.joints, 1e-4), 2);
  if (with_place) v[2] = std::pow(std::max(start.place, 1e-4), 2);
  for (int round = 0; round < most_rounds; ++round) {
    const Variances before = v;
    v = scored(likelihood(all, groups, v), v, !noise.known);
    if (is_settled(v, before)) break;
  }
  v /= v[0];
  return {sigma_of(v[1], worst_repeatability.joints), sigma_of(v[2], worst_repeatability.place)};
}

std::optional<UnevenRepeatability> likely_of_each_joint(const LinearModel& model, const Repeatability& even) {
  const std::vector<Shown> all = shown_by(model);
  const Eigen::Index joints = all.empty() ? 0 : all.front().by_motions.cols() - 3;
  if (joints < 2 || even.joints <= 0) return std::nullopt;
  Groups groups;
  for (Eigen::Index j = 0; j < joints; ++j) groups.push_back(1 + j);
  groups.insert(groups.end(), 3, 1 + joints);
  Variances v(2 + joints);
  v[0] = 1;
  v.segment(1, joints).setConstant(even.joints * even.joints);
  v[1 + joints] = even.place * even.place;
  constexpr double next_to_nothing = 0.02;  // ln
  Likelihood at = likelihood(all, groups, v);
  for (int round = 0; round < most_rounds && score_each(at, v) > next_to_nothing; ++round)
    at = likelihood(all, groups, v);
  UnevenRepeatability uneven;
  uneven.ln_price = price_of(at, v);
  Repeatability& r = uneven.repeatability;
  r.place = sigma_of(v[1 + joints], worst_repeatability.place);
  r.joints = std::min(std::sqrt(v.segment(1, joints).mean()), worst_repeatability.joints);
  for (Eigen::Index j = 0; j < joints; ++j)
    r.of_joint.push_back(sigma_of(v[1 + j], worst_repeatability.joints) / r.joints);
  return uneven;
}

}  // namespace handsight
