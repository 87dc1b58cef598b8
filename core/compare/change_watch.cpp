// SPDX-License-Identifier: Apache-2.0
#include "compare/change_watch.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numbers>
#include <set>

#include "compare/calibrated_sides.h"
#include "compare/change_candidates.h"
#include "compare/change_evidence.h"
#include "compare/change_limits.h"
#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/evidence.h"

namespace handsight {
namespace {

constexpr double same_pose = 5e-3;         // rad (m)
constexpr double least_coordinate = 0.25;  // half of the noise: what shape and lenses are off by, at least

/// What observations of one pose say. Columns: the shared unknowns, the changes, six of the pose's own motion.
struct PoseSums {
  Eigen::MatrixXd information;  // J^T J
  Eigen::VectorXd gradient;     // J^T e
  Eigen::MatrixXd rows;         // J, each coordinate that can be measured a row
  Eigen::VectorXd error;        // e, likewise
  Eigen::VectorXd count;        // how often each was measured

  void add(const PoseSums& other, double sign = 1) {
    if (information.size() == 0) {
      *this = other;
      return;
    }
    information += sign * other.information;
    gradient += sign * other.gradient;
    rows += sign * other.rows;
    error += sign * other.error;
    count += sign * other.count;
  }

  /// Without what the changes do: the observation was made before them.
  PoseSums unchanged(Eigen::Index base) const {
    PoseSums sums = *this;
    const Eigen::Index changes = gradient.size() - 6 - base;
    sums.gradient.segment(base, changes).setZero();
    sums.rows.middleCols(base, changes).setZero();
    sums.information.middleCols(base, changes).setZero();
    sums.information.middleRows(base, changes).setZero();
    return sums;
  }
};

struct Normal {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;

  void add(const Normal& other, double sign) {
    information += sign * other.information;
    gradient += sign * other.gradient;
  }
};

/// What is the same at every visit of the pose taken out: an offset of each coordinate of this variance, and the pose's
/// own motion of this covariance.
Normal without_pose(const PoseSums& sums, double coordinate, const Matrix6& repeatability) {
  const Eigen::VectorXd share = coordinate / (1 + coordinate * sums.count.array());
  const Eigen::MatrixXd weighed = share.asDiagonal() * sums.rows;
  const Eigen::MatrixXd information = sums.information - sums.rows.transpose() * weighed;
  const Eigen::VectorXd gradient = sums.gradient - weighed.transpose() * sums.error;
  const Eigen::Index kept = gradient.size() - 6;
  Normal n{information.topLeftCorner(kept, kept), gradient.head(kept)};
  if (repeatability.isZero(0)) return n;
  const Matrix6 squares = information.bottomRightCorner<6, 6>();
  const Matrix6 m = (Matrix6::Identity() + repeatability * squares).partialPivLu().solve(repeatability);
  const Eigen::MatrixXd body = information.bottomLeftCorner(6, kept);
  n.information -= body.transpose() * m * body;
  n.gradient -= body.transpose() * (m * gradient.tail(6));
  return n;
}

/// Each coordinate in a row of its own, so that those of several visits add up.
PoseSums sums_of_rows(const ProblemObservation& o, const SingleRows& single, int a_marker, int markers) {
  const Eigen::Index columns = single.by_columns.cols(), all = static_cast<Eigen::Index>(a_marker) * markers;
  PoseSums sums{
      {}, {}, Eigen::MatrixXd::Zero(all, columns + 6), Eigen::VectorXd::Zero(all), Eigen::VectorXd::Zero(all)};
  Eigen::Index from = 0;
  const auto put = [&](Eigen::Index row, Eigen::Index count) {
    sums.rows.block(row, 0, count, columns) = single.by_columns.middleRows(from, count);
    sums.rows.block(row, columns, count, 6) = single.by_body.middleRows(from, count);
    sums.error.segment(row, count) = single.error.segment(from, count);
    sums.count.segment(row, count).setOnes();
    from += count;
  };
  for (const Sighting& s : o.sightings) {
    const Eigen::Index row = static_cast<Eigen::Index>(s.marker) * a_marker;
    if (s.in_cameras.empty()) put(row, row_count(s));
    for (const CameraPoint& p : s.in_cameras) put(row + 2 * p.camera, 2);
  }
  sums.information = sums.rows.transpose() * sums.rows;
  sums.gradient = sums.rows.transpose() * sums.error;
  return sums;
}

struct WatchedPose {
  Eigen::VectorXd position;
  Matrix6 repeatability = Matrix6::Zero();
  PoseSums unchanged;  // all its observations as if nothing had changed
  PoseSums changed;    // ... as if all were made after the change
};

struct Recent {
  std::size_t pose = 0, number = 0;
  double ln_weight = 0;  // of a change that comes just before it
  PoseSums sums;
};

/// Shares of 1 that fall as slowly as shares can: about 1 / (k ln(k)^2). Over all k they are 1 together.
double slow_share(std::size_t k) {
  const auto x = static_cast<double>(k) + std::numbers::e;
  return 1 / std::log(x) - 1 / std::log(x + 1);
}

/// Robots are hit and knocked between two rounds rather than within one: half of what a round weighs is its begin's. A
/// round ends where one of its poses is taken again.
class Rounds {
 public:
  /// ln of the weight of a change just before the next observation, which is of this pose. All weights together are no
  /// more than 1, however the poses come.
  double next_ln_weight(std::size_t pose) {
    if (!taken_.insert(pose).second) {
      taken_ = {pose};
      ++round_;
    }
    const std::size_t place = taken_.size() - 1;
    return std::log(slow_share(round_) * 0.5 * (place == 0 ? 1 : slow_share(place - 1)));
  }

 private:
  std::set<std::size_t> taken_;  // poses of this round
  std::size_t round_ = 0;
};

}  // namespace

struct ChangeWatch::Parts {
  CalibratedRobot before;
  WatchOptions options;
  std::vector<WatchedPose> poses;
  std::deque<Recent> recent;
  std::size_t count = 0;
  Rounds rounds;
  double ln_first_weight = 0;  // of a change before the very first observation
  bool has_changed = false;
  // Of the problem, the same for all observations.
  Eigen::Index base = 0;
  Eigen::MatrixXd known;
  std::vector<ChangeUnit> units;
  std::vector<Eigen::Index> first_of_unit;
  Eigen::VectorXd sizes;  // plausible, of the changes' columns
  std::optional<Chain> chain;
  double coordinate = 0;  // variance of what a coordinate is off by at every visit of a pose, in units of the noise

  /// One start of the change: what each unit's evidence is from there on.
  struct Start {
    double ln_weight = 0;
    Eigen::MatrixXd information;
    Eigen::VectorXd gradient;
    std::vector<double> evidence;  // by unit
    double ln_e_value = 0;
  };

  PoseSums sums_of(const Session& session, const Observation& observation, Matrix6& repeatability);
  std::size_t locate(const Eigen::VectorXd& position, const Matrix6& repeatability);
  Start start_at(double ln_weight, const Normal& normal) const;
  std::vector<Start> starts() const;
  std::map<std::string, double> by_group(const std::vector<double>& evidence) const;
  double mixture(const std::vector<double>& evidence) const;
  WatchedChange measure_size(std::size_t unit, const Start& start) const;
  WatchStep reported(const std::vector<Start>& starts) const;
};

PoseSums ChangeWatch::Parts::sums_of(const Session& session, const Observation& observation, Matrix6& repeatability) {
  Session one = session;
  one.observations = {observation};
  one.observations[0].decision = Decision::none;
  one = as_calibrated(before, one);
  if (!chain) chain = make_chain(one);
  ComparedSides sides = make_sides(before, one, *chain);
  repeatability = sides.repeatability;
  const Eigen::Index effects = sides.after.problem.effect_count();
  if (units.empty()) {
    for (std::size_t m = 0; m < sides.after.problem.marker_is_seen.size(); ++m)
      sides.after.problem.marker_is_seen[m] = 1;
    units = change_units(sides.after.problem);
  }
  std::vector<EffectTerm> terms;
  for (const ChangeUnit& unit : units) terms.insert(terms.end(), unit.terms.begin(), unit.terms.end());
  sides.after.problem.tcp_from_slip = before.model.tcp_from_body;
  Candidates candidates = list_candidates(sides.after.problem, terms);
  Problem& problem = candidates.problem;
  Eigen::VectorXd values = Eigen::VectorXd::Zero(problem.effect_count());
  values.head(effects) = sides.start.effects;
  set_effects(problem, values);
  const ChangeColumns columns{effects, nullptr, 0, problem.effect_count() - effects};
  SharedState state = make_start(sides);
  state.unknowns.effects = values;
  const ProblemObservation& o = problem.observations.front();
  const SingleRows single = single_rows(problem, o, state, columns, sides.after.weight);
  if (first_of_unit.empty()) {
    base = single.by_columns.cols() - columns.changes;
    known = *sides.known;
    sizes.resize(columns.changes);
    for (Eigen::Index c = 0; c < sizes.size(); ++c)
      sizes[c] = problem.columns_of_effects[static_cast<std::size_t>(effects + c)].sigma;
    Eigen::Index next = base;
    for (const ChangeUnit& unit : units) {
      first_of_unit.push_back(next);
      for (const EffectTerm& t : unit.terms)
        for (const EffectParameter& p : term_effect(t).parameters) next += p.is_choice ? 0 : 1;
    }
    first_of_unit.push_back(next);
    check(next == single.by_columns.cols(), "{} columns of changes, {} of their numbers", columns.changes, next - base);
    const double left = before.calibration.fit.chi2_per_dof.value_or(1) - 1;
    coordinate = std::max(least_coordinate, left);
  }
  return sums_of_rows(o, single, problem.rig ? 2 * problem.rig->count() : 3, problem.marker_count);
}

std::size_t ChangeWatch::Parts::locate(const Eigen::VectorXd& position, const Matrix6& repeatability) {
  for (std::size_t p = 0; p < poses.size(); ++p)
    if ((poses[p].position - position).cwiseAbs().maxCoeff() < same_pose) return p;
  poses.push_back({position, repeatability, {}, {}});
  return poses.size() - 1;
}

/// By group, the mean over its places, with what it is likely beforehand.
std::map<std::string, double> ChangeWatch::Parts::by_group(const std::vector<double>& evidence) const {
  std::map<std::string, std::vector<double>> groups;
  for (std::size_t u = 0; u < units.size(); ++u) groups[units[u].group].push_back(evidence[u]);
  std::map<std::string, double> ln_of;
  for (const auto& [group, all] : groups) ln_of[group] = ln_mean_exp(all) + ln_prior_odds(group);
  return ln_of;
}

/// The mean over the groups.
double ChangeWatch::Parts::mixture(const std::vector<double>& evidence) const {
  std::vector<double> of_groups;
  double weights = 0;
  for (const auto& [group, ln] : by_group(evidence)) {
    weights += std::exp(ln_prior_odds(group));
    of_groups.push_back(ln);
  }
  return ln_mean_exp(of_groups) + std::log(static_cast<double>(of_groups.size()) / weights);
}

ChangeWatch::Parts::Start ChangeWatch::Parts::start_at(double ln_weight, const Normal& n) const {
  const Eigen::Index changes = n.gradient.size() - base;
  const Eigen::LLT<Eigen::MatrixXd> llt(n.information.topLeftCorner(base, base) + known);
  const Eigen::MatrixXd cross = llt.solve(n.information.topRightCorner(base, changes));
  Start start;
  start.ln_weight = ln_weight;
  start.information =
      n.information.bottomRightCorner(changes, changes) - n.information.bottomLeftCorner(changes, base) * cross;
  start.gradient = n.gradient.tail(changes) - cross.transpose() * n.gradient.head(base);
  for (std::size_t u = 0; u < units.size(); ++u) {
    const Eigen::Index first = first_of_unit[u] - base, numbers = first_of_unit[u + 1] - first_of_unit[u];
    start.evidence.push_back(change_evidence(start.information.block(first, first, numbers, numbers),
                                             start.gradient.segment(first, numbers)));
  }
  start.ln_e_value = mixture(start.evidence);
  return start;
}

std::vector<ChangeWatch::Parts::Start> ChangeWatch::Parts::starts() const {
  std::vector<PoseSums> sums;
  std::vector<Normal> normals;
  Normal total, from_first;
  const auto add_to = [](Normal& sum, const Normal& one) {
    if (sum.gradient.size() == 0)
      sum = one;
    else
      sum.add(one, 1);
  };
  for (const WatchedPose& p : poses) {
    sums.push_back(p.unchanged);
    normals.push_back(without_pose(p.unchanged, coordinate, p.repeatability));
    add_to(total, normals.back());
    add_to(from_first, without_pose(p.changed, coordinate, p.repeatability));
  }
  std::vector<Start> all;
  for (std::size_t i = recent.size(); i-- > 0;) {
    const Recent& r = recent[i];
    total.add(normals[r.pose], -1);
    sums[r.pose].add(r.sums.unchanged(base), -1);
    sums[r.pose].add(r.sums);
    normals[r.pose] = without_pose(sums[r.pose], coordinate, poses[r.pose].repeatability);
    total.add(normals[r.pose], 1);
    all.push_back(start_at(r.ln_weight, total));
  }
  if (recent.front().number > 0) all.push_back(start_at(ln_first_weight, from_first));
  return all;
}

/// Its numbers and their sigmas, each held at three prior sigmas.
WatchedChange ChangeWatch::Parts::measure_size(std::size_t unit, const Start& start) const {
  const Eigen::Index first = first_of_unit[unit] - base, numbers = first_of_unit[unit + 1] - first_of_unit[unit];
  Eigen::MatrixXd information = start.information.block(first, first, numbers, numbers);
  information.diagonal().array() += 1 / (change_scale * change_scale);
  const Eigen::MatrixXd covariance = information.ldlt().solve(Eigen::MatrixXd::Identity(numbers, numbers));
  const Eigen::VectorXd size = sizes.segment(first, numbers);
  const Eigen::VectorXd values = size.cwiseProduct(covariance * start.gradient.segment(first, numbers));
  WatchedChange change{units[unit].group, units[unit].where, units[unit].terms,
                       size.cwiseProduct(covariance.diagonal().cwiseMax(0).cwiseSqrt())};
  Eigen::Index next = 0;
  for (EffectTerm& term : change.terms)
    for (std::size_t p = 0; p < term.values.size(); ++p)
      if (!term_effect(term).parameters[p].is_choice) term.values[p] = values[next++];
  return change;
}

WatchStep ChangeWatch::Parts::reported(const std::vector<Start>& all) const {
  WatchStep step;
  std::vector<double> weighed;
  std::size_t best = 0;
  for (std::size_t s = 0; s < all.size(); ++s) {
    weighed.push_back(all[s].ln_e_value + all[s].ln_weight);
    if (weighed[s] > weighed[best]) best = s;
  }
  step.ln_e_value = ln_mean_exp(weighed) + std::log(static_cast<double>(weighed.size()));
  const Start& start = all[best];
  const std::map<std::string, double> groups = by_group(start.evidence);
  const auto likeliest =
      std::max_element(groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  step.what = likeliest->first;
  for (const auto& [group, ln] : groups)
    if (group != step.what && ln > likeliest->second - ln_20) step.indistinguishable_from.push_back(group);
  std::size_t unit = units.size();
  for (std::size_t u = 0; u < units.size(); ++u)
    if (units[u].group == step.what && (unit == units.size() || start.evidence[u] > start.evidence[unit])) unit = u;
  for (std::size_t u = 0; u < units.size(); ++u) step.each.push_back(measure_size(u, start));
  step.terms = step.each[unit].terms;
  step.sigma = step.each[unit].sigma;
  step.where = units[unit].where;
  step.text = change_text(units[unit], step.terms, step.sigma, *chain);
  if (!step.indistinguishable_from.empty() && step.ln_e_value > 0)
    step.text +=
        message("; or it is {}, which these poses do not tell apart.", fmt::join(step.indistinguishable_from, " or "));
  return step;
}

ChangeWatch::ChangeWatch(CalibratedRobot before, WatchOptions options) : parts_(std::make_unique<Parts>()) {
  parts_->before = std::move(before);
  parts_->options = options;
}
ChangeWatch::~ChangeWatch() = default;
ChangeWatch::ChangeWatch(ChangeWatch&&) noexcept = default;
ChangeWatch& ChangeWatch::operator=(ChangeWatch&&) noexcept = default;

std::optional<WatchStep> ChangeWatch::add(const Session& session, const Observation& observation) {
  if (observation.sightings.empty() || observation.decision == Decision::excluded) return std::nullopt;
  Parts& p = *parts_;
  Matrix6 repeatability;
  Recent one;
  one.sums = p.sums_of(session, observation, repeatability);
  one.pose = p.locate(observation.position, repeatability);
  one.number = p.count++;
  one.ln_weight = p.rounds.next_ln_weight(one.pose);
  if (one.number == 0) p.ln_first_weight = one.ln_weight;
  p.poses[one.pose].unchanged.add(one.sums.unchanged(p.base));
  p.poses[one.pose].changed.add(one.sums);
  p.recent.push_back(std::move(one));
  if (p.recent.size() > p.options.window) p.recent.pop_front();
  WatchStep step = p.reported(p.starts());
  p.has_changed = p.has_changed || step.ln_e_value >= -std::log(p.options.chance);
  step.changed = p.has_changed;
  return step;
}

namespace {

/// What a sensor that measures points would see there, by the calibration.
Observation seen_at_pose(const CalibratedRobot& before, const Session& session, const Eigen::VectorXd& position) {
  const TcpPrediction there = predict_tcp(before.chain, position, before.model);
  const Rigid root_from_sensor =
      there.root_from_sensor_est ? *there.root_from_sensor_est
                                 : chain_ends(before.chain, position).root_from_mount * session.mount.mount_from_sensor;
  Observation o;
  o.position = position;
  for (std::size_t m = 0; m < before.calibration.markers.size(); ++m) {
    Sighting sighting{.marker = static_cast<int>(m)};
    sighting.point = inverse(root_from_sensor) * (there.root_from_body_est * before.calibration.markers[m]);
    o.sightings.push_back(sighting);
  }
  return o;
}

}  // namespace

std::vector<std::size_t> telling_poses(const CalibratedRobot& before, const Session& session,
                                       const std::vector<Eigen::VectorXd>& positions, int count) {
  Session by_points = session;
  by_points.rig.reset();
  by_points.sigma_point = 1e-4;
  ChangeWatch::Parts parts;
  parts.before = before;
  std::vector<Normal> normals;
  for (const Eigen::VectorXd& q : positions) {
    Matrix6 repeatability;
    const PoseSums sums = parts.sums_of(by_points, seen_at_pose(before, session, q), repeatability);
    normals.push_back(without_pose(sums, 0, repeatability));
  }
  std::vector<Eigen::Index> columns;
  for (std::size_t u = 0; u < parts.units.size(); ++u)
    for (Eigen::Index c = parts.first_of_unit[u]; c < parts.first_of_unit[u + 1]; ++c)
      for (const char* group : {"camera_mount", "body_slip", "joint_offset"})
        if (parts.units[u].group == group) columns.push_back(c);
  std::vector<std::size_t> chosen;
  Eigen::MatrixXd information =
      Eigen::MatrixXd::Identity(static_cast<Eigen::Index>(columns.size()), static_cast<Eigen::Index>(columns.size()));
  while (static_cast<int>(chosen.size()) < std::min<int>(count, static_cast<int>(positions.size()))) {
    std::size_t best = positions.size();
    double most = -1e300;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      if (std::find(chosen.begin(), chosen.end(), i) != chosen.end()) continue;
      const Eigen::LLT<Eigen::MatrixXd> llt(information + normals[i].information(columns, columns));
      const double gain = llt.matrixLLT().diagonal().array().log().sum();
      if (gain > most) most = gain, best = i;
    }
    information += normals[best].information(columns, columns);
    chosen.push_back(best);
  }
  return chosen;
}

}  // namespace handsight
