// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/planning/planning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "diagnosis/planning/model_discrimination.h"
#include "diagnosis/planning/touch_pool.h"
#include "diagnosis/ranking/refitting.h"
#include "estimation/fit/touch_unknown.h"
#include "estimation/fit/undetermined.h"

namespace handsight {
namespace {

constexpr double metres_per_radian = 0.3;      // a sliding joint's way beside a turning one's
constexpr double least_distance_rad = 0.15;    // a joint, in the mean square: from what was taken, from each other
constexpr double least_distance_share = 0.05;  // ... but no more than this share of what the joints allow
constexpr double ln_20 = 2.995732273553991;
constexpr double no_difference = 0.01;     // nats a pose: less is no more than rounding and priors
constexpr double most_work = 2.5e9;        // products, for all steps over the pool
constexpr int most_touches = 600;          // in the pool: each is a search
constexpr std::size_t kept_in_pool = 500;  // after the first step, where steps are dear

double noise_to_reckon(const Session& session, const Fit& f) {
  const double unknown = session.is_tracker() ? 2e-4 : 0.2;
  if (!f.noise || !(*f.noise > 0)) return f.residual_rms > 0 ? f.residual_rms : unknown;
  return f.covariance_kind == CovarianceKind::repeatability ? std::max(*f.noise, f.residual_rms) : *f.noise;
}

bool are_same(const std::vector<EffectTerm>& a, const std::vector<EffectTerm>& b) {
  return std::is_permutation(a.begin(), a.end(), b.begin(), b.end(), [](const EffectTerm& x, const EffectTerm& y) {
    return x.id == y.id && x.place == y.place;
  });
}

class Planner {
 public:
  Planner(const Session& session, const PlanOptions& options) : session_(session), options_(options) {}

  Plan run() {
    refuse_bad_options();
    fit_models();
    Plan plan;
    plan.noise = noise_;
    plan.rotation_is_observed = base_.rotation_is_observed;
    judge_.emplace(session_, base_);
    for (const Fit* f : fits()) models_.emplace_back(*f, noise_);
    if (options_.between)
      suspicions_ = {ModelDiscrimination(models_[1], models_[2]), ModelDiscrimination(models_[2], models_[1])};
    fill_pool();
    before_ = session_.observations.back().position;
    look_at_pool();
    keep([&](std::size_t i) { return is_shown(i) && (!options_.may_take || options_.may_take(pool_[i])); });
    plan.pool = pool_.size();
    plan.sigma_before = known_so_far();
    plan.never_moved = never_moved(base_);
    for (int step = 0; step < options_.count; ++step)
      if (!add_best(step, plan)) break;
    judge_the_rivals(plan);
    add_notes(plan);
    return plan;
  }

 private:
  void refuse_bad_options() const {
    if (options_.count < 1 || options_.count > most_planned_poses)
      throw InputError(message("The number of poses to plan is {}; expected 1 to {} (--count).", options_.count,
                               most_planned_poses));
    if (!options_.between) return;
    const CompetingEffects& r = *options_.between;
    if (are_same(r.first, r.second))
      throw InputError(
          message("\"{}\" and \"{}\" are the same effect at the same places; give two that differ "
                  "(--between a,b).",
                  r.first_name, r.second_name));
    for (const auto* rival : {&r.first, &r.second})
      for (const EffectTerm& t : *rival)
        for (const auto* model : {&options_.effects, &options_.estimated})
          for (const EffectTerm& m : *model)
            if (m.id == t.id && m.place == t.place)
              throw InputError(
                  message("The effect \"{}\" is to be told from another (--between) and is in the "
                          "model already (--effects); leave it out of one of them.",
                          rival == &r.first ? r.first_name : r.second_name));
  }

  void fit_models() {
    FitOptions o;
    o.effects = options_.effects;
    o.estimated = options_.estimated;
    const CleanFit clean = clean_fit(session_, o);
    base_ = clean.fit;
    noise_ = noise_to_reckon(session_, base_);
    if (!options_.between) return;
    o.start = estimate(base_);
    const std::size_t model_terms = o.estimated.size();
    for (auto [terms, fitted] : {std::pair{&options_.between->first, &first_}, {&options_.between->second, &second_}}) {
      o.estimated.resize(model_terms);
      o.estimated.insert(o.estimated.end(), terms->begin(), terms->end());
      *fitted = fit(clean.session, o);
    }
    noise_ = std::min({noise_, noise_to_reckon(session_, first_), noise_to_reckon(session_, second_)});
  }

  std::vector<const Fit*> fits() const {
    if (!options_.between) return {&base_};
    return {&base_, &first_, &second_};
  }

  int affordable_pool() const {
    double work = 0;
    for (const Fit* f : fits()) {
      const double rows = (session_.is_tracker() ? 3.0 : 4.0) * f->problem.marker_count;
      const auto columns = static_cast<double>(f->problem.columns());
      work += rows * columns * (0.5 * columns + rows);
    }
    return std::clamp(static_cast<int>(most_work / (options_.count * work)), std::min(100, options_.pool),
                      options_.pool);
  }

  void fill_pool() {
    if (!session_.is_touch()) {
      pool_ = pose_pool(session_, *judge_, affordable_pool(), options_.seed);
      return;
    }
    TouchPool touches = touch_pool(session_, base_, *judge_, std::min(affordable_pool(), most_touches), options_.seed);
    pool_ = std::move(touches.poses);
    fixtures_ = std::move(touches.fixtures);
  }

  void look_at_pool() {
    for (ExpectedPoses& m : models_)
      if (fixtures_.empty())
        m.look_at(pool_, before_, *judge_);
      else
        m.look_at(pool_, session_, fixtures_, before_, *judge_);
    rows_.resize(pool_.size());
    std::iota(rows_.begin(), rows_.end(), std::size_t{0});
  }

  bool is_shown(std::size_t i) const {
    return std::all_of(models_.begin(), models_.end(),
                       [&](const ExpectedPoses& m) { return m.rows(rows_[i]).is_shown; });
  }

  const ExpectedRows& rows(std::size_t model, std::size_t i) const { return models_[model].rows(rows_[i]); }

  /// Of the model; where one of two effects is true, as the one that knows less says.
  Vector6 sigma_of_body() const {
    if (!options_.between) return models_[0].sigma_of_body();
    return models_[1].sigma_of_body().cwiseMax(models_[2].sigma_of_body());
  }

  template <class Wanted>
  void keep(const Wanted& wanted) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < pool_.size(); ++i) {
      if (!wanted(i)) continue;
      pool_[next] = pool_[i];
      if (!fixtures_.empty()) fixtures_[next] = fixtures_[i];
      rows_[next++] = rows_[i];
    }
    pool_.resize(next);
    if (!fixtures_.empty()) fixtures_.resize(next);
    rows_.resize(next);
  }

  double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    const Chain& chain = base_.problem.source->chain;
    double squares = 0;
    for (Eigen::Index j = 0; j < a.size(); ++j) {
      const int joint = chain.joints[static_cast<std::size_t>(j)];
      const bool slides = chain.robot.joints[static_cast<std::size_t>(joint)].kind == JointKind::prismatic;
      squares += std::pow((a[j] - b[j]) / (slides ? metres_per_radian : 1.0), 2);
    }
    return std::sqrt(squares);
  }

  double least_distance() const {
    const double all_joints = least_distance_rad * std::sqrt(static_cast<double>(judge_->lower().size()));
    return std::min(all_joints, least_distance_share * distance(judge_->lower(), judge_->upper()));
  }

  /// Poses too near to this one leave the pool.
  void keep_away_from(const Eigen::VectorXd& position) {
    const double least = least_distance();
    keep([&](std::size_t i) { return distance(pool_[i], position) >= least; });
  }

  double information_gain(std::size_t i) const {
    const Eigen::MatrixXd w = models_[0].whitened(rows(0, i));
    Eigen::MatrixXd s = w.transpose() * w;
    s.diagonal().array() += 1;
    return Eigen::LLT<Eigen::MatrixXd>(s).matrixLLT().diagonal().array().log().sum();
  }

  Vector2 rival_gain(std::size_t i) const {
    return {suspicions_[0].expected(rows(1, i), rows(2, i)), suspicions_[1].expected(rows(2, i), rows(1, i))};
  }

  /// What makes a pose better than another. Neither of two effects may be forgotten for the other: the sum of
  /// logarithms of what is known for each.
  double worth(std::size_t i) const {
    if (!options_.between) return information_gain(i);
    const Vector2 g = rival_gain(i).cwiseMax(0);
    return std::log1p(total_[0] + g[0]) + std::log1p(total_[1] + g[1]);
  }

  bool add_best(int step, Plan& plan) {
    if (step == 0) {
      for (const Observation& o : session_.observations) keep_away_from(o.position);
    } else if (looks_anew_) {
      look_at_pool();
    }
    if (pool_.empty()) return false;
    std::vector<double> worths(pool_.size());
    for (std::size_t i = 0; i < pool_.size(); ++i) worths[i] = worth(i);
    const auto best = static_cast<std::size_t>(std::max_element(worths.begin(), worths.end()) - worths.begin());
    PlannedPose pose;
    pose.position = pool_[best];
    if (!fixtures_.empty()) pose.fixture = fixtures_[best];
    if (options_.between) {
      const Vector2 gain = rival_gain(best);
      total_ += gain;
      pose.gain = gain.mean();
      pose.ln_bayes_factor = total_;
    } else {
      pose.gain = information_gain(best);
    }
    const std::size_t taken = rows_[best];
    if (options_.between) {
      suspicions_[0].measure(models_[1].rows(taken), models_[2].rows(taken));
      suspicions_[1].measure(models_[2].rows(taken), models_[1].rows(taken));
    }
    for (ExpectedPoses& m : models_) m.measure(m.rows(taken));
    pose.sigma = sigma_of_body();
    before_ = pose.position;
    if (step == 0) prune(worths);
    keep_away_from(pose.position);
    plan.poses.push_back(std::move(pose));
    return true;
  }

  /// The best of the pool are enough where the other steps are dear.
  void prune(const std::vector<double>& worths) {
    looks_anew_ =
        std::any_of(models_.begin(), models_.end(), [](const ExpectedPoses& m) { return m.depends_on_approach(); });
    if ((!options_.between && !looks_anew_) || worths.size() <= kept_in_pool) return;
    std::vector<double> sorted = worths;
    std::nth_element(sorted.begin(), sorted.begin() + kept_in_pool, sorted.end(), std::greater<>());
    keep([&](std::size_t i) { return worths[i] >= sorted[kept_in_pool]; });
  }

  void judge_the_rivals(Plan& plan) const {
    if (!options_.between || plan.poses.empty()) return;
    const NoiseModel by{noise_model(base_).knowledge, noise_};
    const Eigen::Index model_columns = base_.problem.effect_count();
    plan.ln_bayes_factor_before =
        fit_evidence(first_, model_columns, by).ln_evidence - fit_evidence(second_, model_columns, by).ln_evidence;
    const CompetingEffects& r = *options_.between;
    const double total = total_.mean();
    plan.tells_apart = total >= no_difference * static_cast<double>(plan.poses.size());
    if (!plan.tells_apart) {
      plan.notes.push_back(message(
          "{} and {} cannot be told apart at any of the {} poses that this robot and these cameras allow: whatever one "
          "of them does, the other does too.",
          r.first_name, r.second_name, plan.pool));
    } else if (total < ln_20) {
      plan.notes.push_back(message(
          "These poses are not expected to settle it between {} and {}: the ln Bayes factor grows by {:.2f}, and 3 "
          "(odds of 20) is needed; plan more of them.",
          r.first_name, r.second_name, total));
    }
  }

  /// Where nothing is known no figure stands.
  Vector6 known_so_far() const {
    Vector6 sigma = sigma_of_body();
    const UndeterminedMotions unknown = undetermined_motions(body_covariance_at_origin(base_));
    for (int i = 0; i < 6; ++i)
      if (unknown.numbers[static_cast<std::size_t>(i)]) sigma[i] = std::numeric_limits<double>::quiet_NaN();
    return sigma;
  }

  void add_notes(Plan& plan) const {
    const std::vector<Message> unknown = unknown_texts(session_, base_);
    plan.notes.insert(plan.notes.begin(), unknown.begin(), unknown.end());
    if (static_cast<int>(plan.poses.size()) < options_.count)
      plan.notes.push_back(
          message("Only {} of {} poses lie {:.3f} rad or more away from the others and from those "
                  "that were taken.",
                  plan.poses.size(), options_.count, least_distance()));
    if (!base_.noise)
      plan.notes.push_back(message("The noise is neither declared nor to be estimated: {:.3g} {} is assumed.", noise_,
                                   session_.is_tracker() ? "m" : "px"));
    if (!options_.between && base_.covariance_kind == CovarianceKind::repeatability)
      plan.notes.push_back(
          "The model does not fit down to the noise, so what it leaves is reckoned as noise; find what is missing "
          "first (handsight-cli diagnose) and give it with --effects.");
    const bool velocity =
        std::any_of(models_.begin(), models_.end(), [](const ExpectedPoses& m) { return m.depends_on_velocity(); });
    if (velocity)
      plan.notes.push_back(
          "An effect of the model shows only while the joints move; these poses are at rest and cannot "
          "show it.");
    if (looks_anew_)
      plan.notes.push_back(
          "An effect depends on where a pose is approached from: drive to the poses in this order, each "
          "straight from the one before.");
  }

  const Session& session_;
  const PlanOptions& options_;
  Fit base_, first_, second_;
  double noise_ = 1;
  std::optional<PoseJudge> judge_;
  std::vector<ExpectedPoses> models_;            // the model; then it with the first and with the second effect
  std::vector<ModelDiscrimination> suspicions_;  // the first is true, the second is
  std::vector<Eigen::VectorXd> pool_;            // that are left
  std::vector<int> fixtures_;                    // per pose of the pool: what it touches; empty: nothing
  std::vector<std::size_t> rows_;                // per pose of the pool: its place among the models' rows
  Eigen::VectorXd before_;                       // the pose before the next
  Vector2 total_ = Vector2::Zero();              // ln Bayes factors expected so far
  bool looks_anew_ = false;                      // what a pose shows depends on the one before
};

}  // namespace

Plan plan(const Session& session, const PlanOptions& options) { return Planner(session, options).run(); }

}  // namespace handsight
