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

std::vector<Shown> shown_by(const LinearModel& model) {
  std::vector<Shown> all;
  for (const LinearObservation& o : model.observations) {
    Shown one{{}, model.external_error.segment(o.first, o.count)};
    one.by_motions.resize(o.count, o.by_joints.cols() + 3);
    one.by_motions << o.by_joints, o.by_body.leftCols<3>();
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

Repeatability repeatability_of(const Variances& v) {
  const auto sigma = [](double variance, double most) {
    return variance <= negligible ? 0 : std::min(std::sqrt(variance), most);
  };
  const Eigen::Index joints = v.size() - 2;
  Repeatability r{0, sigma(v[1 + joints], worst_repeatability.place)};
  double squares = 0;
  for (Eigen::Index j = 0; j < joints; ++j) {
    r.of_joint.push_back(sigma(v[1 + j], worst_repeatability.joints));
    squares += r.of_joint.back() * r.of_joint.back();
  }
  if (joints > 0) r.joints = std::sqrt(squares / static_cast<double>(joints));
  for (double& one : r.of_joint) one = r.joints > 0 ? one / r.joints : 1;
  if (joints < 2 || r.joints == 0) r.of_joint.clear();
  return r;
}

std::vector<Repeatability> usual_levels() { return {{0, 0}, {1e-4, 0}, {3e-4, 0}, {1e-3, 0}, {3e-3, 0}}; }

std::vector<Repeatability> list_parts(const Repeatability& s) {
  std::vector<Repeatability> parts;
  for (const double part : {0.0, 0.1, 0.3, 0.6, 1.0}) parts.push_back({part * s.joints, part * s.place, s.of_joint});
  return parts;
}

}  // namespace

Repeatability likely_repeatability(const LinearModel& model, const Repeatability& start, const NoiseKnowledge& noise,
                                   Scattering scattering) {
  const std::vector<Shown> all = shown_by(model);
  const Eigen::Index joints = all.empty() ? 0 : all.front().by_motions.cols() - 3;
  const bool each = scattering == Scattering::each_joint_and_place;
  const Eigen::Index count = each ? joints : 1;
  Groups groups;
  for (Eigen::Index j = 0; j < joints; ++j) groups.push_back(each ? 1 + j : 1);
  groups.insert(groups.end(), 3, 1 + count);
  Variances v = Variances::Zero(2 + count);
  v[0] = 1;
  v.segment(1, count).setConstant(std::pow(std::max(start.joints, 1e-4), 2));
  if (scattering != Scattering::joints) v[1 + count] = std::pow(std::max(start.place, 1e-4), 2);
  for (int round = 0; round < most_rounds; ++round) {
    const Variances before = v;
    v = scored(likelihood(all, groups, v), v, !noise.known);
    const bool is_settled =
        ((v - before).array().abs() <= settled_share * before.array() || before.array() <= negligible).all();
    if (is_settled) break;
  }
  v /= v[0];
  return repeatability_of(v);
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
  const auto observations = static_cast<double>(model.observations.size());
  for (const Scattering scattering :
       {Scattering::joints, Scattering::joints_and_place, Scattering::each_joint_and_place}) {
    if (scattering != Scattering::joints && !noise.known) continue;
    const Repeatability likely = likely_repeatability(model, best, noise, scattering);
    // Schwarz's price of a number: joints that differ have one each.
    const auto more = static_cast<double>(std::max<std::size_t>(likely.of_joint.size(), 1) - 1);
    const double e = evidence(likely) - 0.5 * more * std::log(observations);
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
