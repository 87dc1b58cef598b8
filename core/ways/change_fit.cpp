// SPDX-License-Identifier: Apache-2.0
#include "ways/change_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "diagnosis/candidates.h"
#include "diagnosis/evidence.h"
#include "ways/change_rows.h"

namespace handsight {
namespace {

constexpr double least_visible = 1e-2;  // chi-squared of a plausible size below which a change cannot be seen at all
constexpr std::size_t most_refitted = 8;
constexpr int most_iterations = 8;

/// The shared unknowns and how one change of the second side is added to them.
class Comparer {
 public:
  Comparer(const ComparedSides& sides, const std::vector<EffectTerm>& held)
      : sides_(sides), after_(sides.after), body_(sides.known), held_(held), scatter_(sides.scatter) {
    units_ = change_units(after_.problem);
    base_effects_ = after_.problem.effect_count();
    state_ = {sides.start, Eigen::VectorXd::Zero(base_columns())};
  }

  RankedChanges rank() {
    fit_nothing();
    const std::vector<std::size_t> best = rank_linearly();
    refit(best);
    return {grouped(), threshold_, scatter_};
  }

 private:
  /// One unit of the second side with what was found of it.
  struct Found {
    std::vector<EffectTerm> terms;
    Eigen::VectorXd sigma;
    double ln_bayes_factor = 0, explained = 0, visible = 0;
    bool is_refitted = false;
  };

  /// The shared unknowns, and how far they went from their start by the base's columns (read where they have a prior).
  struct State {
    Unknowns unknowns;
    Eigen::VectorXd moved;
  };

  Eigen::Index base_columns() const {
    return body_ ? 6 + after_.problem.columns() - after_.problem.mount_column() : after_.problem.columns();
  }

  /// The second side's problem with these terms as its changes, standing at values of the base's effects and theirs.
  Problem changed(const std::vector<EffectTerm>& terms, const Unknowns& u) const {
    Problem with_held = after_.problem;
    for (const EffectTerm& t : held_) with_held.terms.push_back(t);
    Candidates c = candidates_of(with_held, terms);
    Eigen::VectorXd values(c.problem.effect_count());
    values.head(base_effects_) = u.effects.head(base_effects_);
    Eigen::Index next = base_effects_;
    for (const EffectTerm& t : terms)
      for (std::size_t p = 0; p < t.values.size(); ++p)
        if (!effect_of(t).parameters[p].is_choice) values[next++] = t.values[p];
    set_effects(c.problem, values);
    return std::move(c.problem);
  }

  /// Rows of both sides with these changes' columns behind the shared ones.
  ChangeRows rows_with(const std::vector<EffectTerm>& terms, const Unknowns& u) {
    const Problem problem = changed(terms, u);
    const Eigen::Index shared = after_.problem.columns(), columns = shared + problem.effect_count() - base_effects_;
    Unknowns here = u;
    here.effects = effect_values(problem);
    sizes_.resize(columns - shared);
    for (Eigen::Index c = 0; c < sizes_.size(); ++c)
      sizes_[c] = problem.columns_of_effects[static_cast<std::size_t>(base_effects_ + c)].sigma;
    ChangeRows rows = change_rows(problem, here, base_effects_, shared, columns, after_.weight);
    if (sides_.before) {
      Problem first = sides_.before->problem;
      if (base_effects_ > 0) set_effects(first, u.effects.head(base_effects_));
      Unknowns there = u;
      there.effects = effect_values(first);
      rows.add(change_rows(first, there, base_effects_, shared, columns, sides_.before->weight));
    }
    return body_ ? with_rigid_markers(rows, u.markers_in_tcp) : rows;
  }

  /// Adds what is known beforehand: the effects' plausible sizes, the changes' at three times theirs, the body.
  void add_priors(ScatteredNormal& n, const State& s, const Eigen::VectorXd& change, double change_scale) const {
    const Eigen::Index base = base_columns(), changes = n.gradient.size() - base;
    const Eigen::Index effects = base - base_effects_;
    for (Eigen::Index c = 0; c < base_effects_ && !body_; ++c) {
      const double value = s.unknowns.effects[c] / after_.problem.columns_of_effects[static_cast<std::size_t>(c)].sigma;
      n.information(effects + c, effects + c) += 1;
      n.gradient[effects + c] -= value;
      n.squares += value * value;
    }
    for (Eigen::Index c = 0; c < changes; ++c) {
      const double value = change[c] / change_scale;
      n.information(base + c, base + c) += 1 / (change_scale * change_scale);
      n.gradient[base + c] -= value / change_scale;
      n.squares += value * value;
    }
    if (body_) {
      n.information.topLeftCorner(base, base) += *body_;
      n.gradient.head(base) -= *body_ * s.moved;
      n.squares += s.moved.dot(*body_ * s.moved);
    }
    for (Eigen::Index i = 0; i < n.gradient.size(); ++i) n.information(i, i) += 1e-12 * n.information(i, i) + 1e-12;
  }

  /// Where the shared unknowns go by a step of the base's columns.
  State moved_by(const State& from, const Eigen::VectorXd& step) const {
    State to{from.unknowns, from.moved + step};
    Unknowns& next = to.unknowns;
    Eigen::Index at = 0;
    if (body_) {
      const Rigid motion = small_motion<double>(Vector6(step.head<6>()));
      for (Vector3& m : next.markers_in_tcp) m = motion * m;
      at = 6;
    } else {
      for (Vector3& m : next.markers_in_tcp) {
        m += step.segment<3>(at);
        at += 3;
      }
    }
    if (after_.problem.mount_is_estimated) {
      next.mount_from_sensor = from.unknowns.mount_from_sensor * small_motion<double>(Vector6(step.segment<6>(at)));
      at += 6;
    }
    for (Eigen::Index c = 0; c < base_effects_; ++c)
      next.effects[c] += step[at + c] * after_.problem.columns_of_effects[static_cast<std::size_t>(c)].sigma;
    return to;
  }

  struct Refitted {
    State state;
    std::vector<EffectTerm> terms;
    Eigen::VectorXd change;  // in plausible sizes
    Eigen::MatrixXd information;
    double squares = 0;
  };

  /// Gauss-Newton over the shared unknowns and one unit's numbers.
  Refitted fitted(std::vector<EffectTerm> terms) {
    Refitted r{state_, std::move(terms), {}, {}, 0};
    for (int i = 0; i < most_iterations; ++i) {
      const ChangeRows rows = rows_with(r.terms, r.state.unknowns);
      if (r.change.size() != sizes_.size()) r.change = change_of(r.terms);
      ScatteredNormal n = scattered(rows, scatter_);
      add_priors(n, r.state, r.change, 3);
      const Eigen::VectorXd step = n.information.ldlt().solve(n.gradient);
      r.information = n.information;
      r.squares = n.squares - n.gradient.dot(step);
      const Eigen::Index base = base_columns();
      r.state = moved_by(r.state, step.head(base));
      r.change += step.tail(step.size() - base);
      r.terms = with_change(r.terms, r.change);
      if (n.gradient.dot(step) < 1e-4) break;
    }
    return r;
  }

  Eigen::VectorXd change_of(const std::vector<EffectTerm>& terms) const {
    Eigen::VectorXd change(sizes_.size());
    Eigen::Index c = 0;
    for (const EffectTerm& t : terms)
      for (std::size_t p = 0; p < t.values.size(); ++p)
        if (!effect_of(t).parameters[p].is_choice) change[c] = t.values[p] / sizes_[c], ++c;
    return change;
  }

  std::vector<EffectTerm> with_change(std::vector<EffectTerm> terms, const Eigen::VectorXd& change) const {
    Eigen::Index c = 0;
    for (EffectTerm& t : terms)
      for (std::size_t p = 0; p < t.values.size(); ++p)
        if (!effect_of(t).parameters[p].is_choice) t.values[p] = change[c] * sizes_[c], ++c;
    return terms;
  }

  /// Shared unknowns alone, and the scatter that everything together cannot explain.
  void fit_nothing() {
    const Refitted none = fitted({});
    state_ = none.state;
    none_squares_ = none.squares;
    for (const ChangeUnit& unit : units_) all_terms_.insert(all_terms_.end(), unit.terms.begin(), unit.terms.end());
    linear_ = rows_with(all_terms_, state_.unknowns);
    if (!body_ && held_.empty()) {  // what a calibration says of the scatter stays
      ScatteredNormal n = scattered(linear_, Matrix6::Zero());
      add_priors(n, state_, Eigen::VectorXd::Zero(sizes_.size()), 3);
      scatter_ = scatter_left(linear_, n.information.ldlt().solve(n.gradient),
                              static_cast<int>(std::min<Eigen::Index>(n.gradient.size(), linear_.rows / 2)));
      none_squares_ = fitted({}).squares;
      rows_with(all_terms_, state_.unknowns);  // sizes of all again
    }
  }

  /// ln of the mean Bayes factor over plausible scales.
  static double evidence(const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient) {
    std::vector<double> factors;
    for (const double s : plausible_scales) {
      Eigen::MatrixXd m = s * s * information;
      m.diagonal().array() += 1;
      const Eigen::LLT<Eigen::MatrixXd> llt(m);
      factors.push_back(0.5 * s * s * gradient.dot(llt.solve(gradient)) -
                        llt.matrixLLT().diagonal().array().log().sum());
    }
    return ln_mean_exp(factors);
  }

  /// Of every unit by the linearised model; those worth a fit of their own, best first.
  std::vector<std::size_t> rank_linearly() {
    ScatteredNormal n = scattered(linear_, scatter_);
    add_priors(n, state_, Eigen::VectorXd::Zero(n.gradient.size() - base_columns()), 1e6);
    const Eigen::Index base = base_columns(), changes = n.gradient.size() - base;
    const Eigen::LDLT<Eigen::MatrixXd> shared(n.information.topLeftCorner(base, base));
    const Eigen::MatrixXd cross = n.information.topRightCorner(base, changes);
    information_ = n.information.bottomRightCorner(changes, changes) - cross.transpose() * shared.solve(cross);
    const Eigen::VectorXd gradient = n.gradient.tail(changes) - cross.transpose() * shared.solve(n.gradient.head(base));
    found_.assign(units_.size(), {});
    std::vector<std::size_t> order;
    Eigen::Index at = 0;
    columns_of_.clear();
    for (std::size_t u = 0; u < units_.size(); ++u) {
      Eigen::Index count = 0;
      for (const EffectTerm& t : units_[u].terms)
        for (const EffectParameter& p : effect_of(t).parameters) count += !p.is_choice;
      columns_of_.emplace_back(at, count);
      const Eigen::MatrixXd a = information_.block(at, at, count, count);
      Found& f = found_[u];
      f.visible = a.trace();
      f.terms = units_[u].terms;
      f.sigma = Eigen::VectorXd::Zero(count);
      f.ln_bayes_factor = f.visible < least_visible ? 0 : evidence(a, gradient.segment(at, count));
      if (f.visible >= least_visible) order.push_back(u);
      at += count;
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return found_[a].ln_bayes_factor > found_[b].ln_bayes_factor;
    });
    set_threshold();
    if (order.size() > most_refitted) order.resize(most_refitted);
    std::erase_if(order, [&](std::size_t u) { return found_[u].ln_bayes_factor < 0.3 * threshold_; });
    return order;
  }

  /// What the best of all groups reaches once in 200 times by noise alone.
  void set_threshold() {
    const Eigen::MatrixXd symmetric = 0.5 * (information_ + information_.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
    const Eigen::MatrixXd root = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
    std::mt19937_64 random(20261122);
    std::normal_distribution<double> normal;
    std::vector<double> largest;
    for (int draw = 0; draw < 400; ++draw) {
      Eigen::VectorXd z(root.cols());
      for (double& x : z) x = normal(random);
      const Eigen::VectorXd gradient = root * z;
      std::map<std::string, std::vector<double>> factors;
      for (std::size_t u = 0; u < units_.size(); ++u) {
        const auto [first, count] = columns_of_[u];
        if (found_[u].visible >= least_visible)
          factors[units_[u].group].push_back(
              evidence(information_.block(first, first, count, count), gradient.segment(first, count)));
      }
      double best = 0;
      for (const auto& [group, all] : factors) best = std::max(best, ln_mean_exp(all));
      largest.push_back(best);
    }
    std::sort(largest.begin(), largest.end());
    const std::size_t tail = largest.size() * 9 / 10;
    double excess = 0;
    for (std::size_t i = tail; i < largest.size(); ++i)
      excess += (largest[i] - largest[tail]) / static_cast<double>(largest.size() - tail);
    threshold_ = std::max(4.0, largest[tail] + excess * std::log(0.1 / 0.005));
  }

  /// The best units fitted in full; the Bayes factor then by Laplace's approximation at their answer.
  void refit(const std::vector<std::size_t>& best) {
    for (const std::size_t u : best) {
      const Refitted r = fitted(units_[u].terms);
      const Eigen::Index base = base_columns(), count = r.change.size();
      const Eigen::MatrixXd covariance = r.information.ldlt()
                                             .solve(Eigen::MatrixXd::Identity(base + count, base + count))
                                             .bottomRightCorner(count, count);
      // Held at three plausible sizes while it was fitted; the prior of each scale is counted below.
      const double gained = none_squares_ - (r.squares - r.change.squaredNorm() / 9);
      const Eigen::MatrixXd information = covariance.ldlt().solve(Eigen::MatrixXd::Identity(count, count)) -
                                          Eigen::MatrixXd::Identity(count, count) / 9;
      std::vector<double> factors;
      for (const double s : plausible_scales) {
        Eigen::MatrixXd m = s * s * information;
        m.diagonal().array() += 1;
        factors.push_back(0.5 * (gained - r.change.squaredNorm() / (s * s)) -
                          0.5 * m.ldlt().vectorD().cwiseMax(1e-300).array().log().sum());
      }
      Found& f = found_[u];
      f.is_refitted = true;
      f.ln_bayes_factor = ln_mean_exp(factors);
      f.explained = gained;
      f.terms = r.terms;
      f.sigma = covariance.diagonal().cwiseMax(0).cwiseSqrt().cwiseProduct(sizes_);
    }
  }

  std::vector<Change> grouped() const {
    std::map<std::string, std::vector<double>> factors;
    std::map<std::string, std::size_t> best;
    for (std::size_t u = 0; u < units_.size(); ++u) {
      if (found_[u].visible < least_visible) continue;
      factors[units_[u].group].push_back(found_[u].ln_bayes_factor);
      const auto [place, is_new] = best.emplace(units_[u].group, u);
      if (!is_new && found_[u].ln_bayes_factor > found_[place->second].ln_bayes_factor) place->second = u;
    }
    std::vector<Change> changes;
    for (const auto& [group, u] : best) {
      Change c{group, {}, found_[u].terms, found_[u].sigma, ln_mean_exp(factors[group]), found_[u].explained};
      if (!units_[u].where.empty()) c.where = {units_[u].where};
      changes.push_back(std::move(c));
    }
    std::stable_sort(changes.begin(), changes.end(),
                     [](const Change& a, const Change& b) { return a.ln_bayes_factor > b.ln_bayes_factor; });
    return changes;
  }

  const ComparedSides& sides_;
  const ComparedSide& after_;
  const std::optional<Eigen::MatrixXd>& body_;  // the precision of the shared unknowns; the markers are rigid then
  State state_;
  std::vector<ChangeUnit> units_;
  Eigen::Index base_effects_ = 0;
  std::vector<EffectTerm> held_, all_terms_;
  std::vector<std::pair<Eigen::Index, Eigen::Index>> columns_of_;
  Eigen::VectorXd sizes_;
  ChangeRows linear_;
  Matrix6 scatter_;
  Eigen::MatrixXd information_;
  std::vector<Found> found_;
  double none_squares_ = 0, threshold_ = 0;
};

}  // namespace

RankedChanges ranked_changes(const ComparedSides& sides, const std::vector<EffectTerm>& held) {
  return Comparer(sides, held).rank();
}

}  // namespace handsight
