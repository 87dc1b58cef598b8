// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/planning/expected_poses.h"

#include <cmath>

#include "chain/sighting.h"
#include "estimation/solvers/normal_equations.h"
#include "session/pose_points.h"
#include "session/touch_xml.h"

namespace handsight {
namespace {

/// What is known before any measurement, so that what nothing determines has a size too.
constexpr double marker_sigma_m = 0.3, mount_sigma_m = 0.3, mount_sigma_rad = 1.0;

/// Does a change of every observation's observation states change what the terms do?
template <class Change>
bool depends_on(const Fit& fit, const Change& change) {
  const Chain& chain = fit.problem.source->chain;
  ObservationState plain = states_at(chain, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chain.joints.size())));
  ObservationState changed = plain;
  change(changed);
  for (EffectTerm term : fit.problem.terms) {
    const Effect& effect = term_effect(term);
    for (std::size_t p = 0; p < term.values.size(); ++p)
      if (!effect.parameters[p].is_choice) term.values[p] = 1;
    const Sites a = moved_sites(plain, {term}), b = moved_sites(changed, {term});
    for (std::size_t j = 0; j < std::max(a.robot.joints.size(), b.robot.joints.size()); ++j) {
      const double before = j < a.robot.joints.size() ? a.robot.joints[j].angle : 0;
      const double after = j < b.robot.joints.size() ? b.robot.joints[j].angle : 0;
      if (before != after) return true;
    }
  }
  return false;
}

}  // namespace

ExpectedPoses::ExpectedPoses(const Fit& fit, double noise) : fit_(fit), noise_(noise) {
  Problem problem = fit.problem;
  problem.noise = noise;
  information_ = normal_equations(problem, estimate(fit)).information / (noise * noise);
  information_.diagonal().head(problem.mount_column()).array() += 1 / (marker_sigma_m * marker_sigma_m);
  for (Eigen::Index column = problem.mount_column(); column < problem.effect_column(); column += 6) {
    information_.diagonal().segment<3>(column).array() += 1 / (mount_sigma_m * mount_sigma_m);
    information_.diagonal().segment<3>(column + 3).array() += 1 / (mount_sigma_rad * mount_sigma_rad);
  }
  llt_.compute(information_);
}

namespace {

/// Each marker that was seen, by every camera.
std::vector<Sighting> list_sightings(const Problem& problem) {
  std::vector<Sighting> sightings;
  for (int m = 0; m < problem.marker_count; ++m) {
    if (!problem.marker_is_seen[static_cast<std::size_t>(m)]) continue;
    Sighting s{.marker = m};
    if (problem.rig) {
      for (int camera = 0; camera < problem.rig->count(); ++camera) see(s, camera, Vector2::Zero());
    } else {
      s.point = Vector3::Zero();
    }
    sightings.push_back(s);
  }
  return sightings;
}

}  // namespace

void ExpectedPoses::look_at(const std::vector<Eigen::VectorXd>& poses, const Eigen::VectorXd& before,
                            const PoseJudge& judge) {
  Look all;
  all.sightings = list_sightings(fit_.problem);
  linearise(poses, std::vector<Look>(poses.size(), all), before, judge);
}

void ExpectedPoses::look_at(const std::vector<Eigen::VectorXd>& poses, const Session& session,
                            const std::vector<int>& fixtures, const Eigen::VectorXd& before, const PoseJudge& judge) {
  const double usual = usual_sigma(session);
  std::vector<Look> looks;
  for (const int f : fixtures) {
    Look& look = looks.emplace_back();
    look.part = f;
    look.sightings = touch_sightings(session.fixtures[static_cast<std::size_t>(f)], 0, 0);
    for (Sighting& s : look.sightings) s.usual_sigma = usual;
  }
  linearise(poses, looks, before, judge);
}

void ExpectedPoses::linearise(const std::vector<Eigen::VectorXd>& poses, const std::vector<Look>& looks,
                              const Eigen::VectorXd& before, const PoseJudge& judge) {
  auto source = std::make_shared<ProblemSource>();
  source->chain = fit_.problem.source->chain;
  const ObservationState from = states_at(source->chain, before);
  const auto chain_of_look = [&](const Look& look) -> const Chain& {
    return look.part < 0 ? source->chain : source->chain.parts[static_cast<std::size_t>(look.part)];
  };
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ObservationState c = states_at(chain_of_look(looks[i]), poses[i]);
    c.approach = (c.sensor - from.sensor).cwiseSign();
    source->states.push_back(std::move(c));
  }
  Problem problem = fit_.problem;
  problem.source = source;
  problem.observations.clear();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ProblemObservation& o = problem.observations.emplace_back();
    o.index = static_cast<int>(i);
    o.mount = chain_of_look(looks[i]).mount;
    o.sightings = looks[i].sightings;
  }
  place_observations(problem);
  rows_.clear();
  for (const ProblemObservation& o : problem.observations) rows_.push_back(rows_at(problem, o, judge));
}

namespace {

/// Of more than two cameras a good pose is seen by two at least: what the others see of it too.
std::vector<Sighting> shown(const Problem& problem, const ProblemObservation& o, const Unknowns& u,
                            const Rigid& sensor_from_tcp, const Rigid& tcp_from_body) {
  std::vector<Sighting> seen = o.sightings;
  if (problem.source->chain.is_one_target && !problem.rig) {  // a sensor of poses: each point by one coordinate
    const Matrix3 turn = sensor_from_tcp.rotation * tcp_from_body.rotation;
    for (Sighting& s : seen) s.along = measured_along(turn, s.marker);
  }
  if (!problem.rig || problem.rig->count() <= 2) return seen;
  for (Sighting& s : seen) {
    const Vector3 x = sensor_from_tcp * marker_at(o, u, s.marker);
    for (int c = 0; c < problem.rig->count(); ++c)
      if (!is_visible(problem.rig->at(c).camera, problem.rig->at(c).camera_from_first * x)) forget(s, c);
  }
  return seen;
}

}  // namespace

Problem expected_problem(const Problem& like, const Unknowns& unknowns, const Rigid& tcp_from_body,
                         const std::vector<Eigen::VectorXd>& poses, const Eigen::VectorXd& before) {
  auto source = std::make_shared<ProblemSource>();
  source->chain = like.source->chain;
  source->own_effects = like.source->own_effects;
  const ObservationState from = states_at(source->chain, before);
  Problem problem = like;
  problem.observations.clear();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ObservationState c = states_at(source->chain, poses[i]);
    c.approach = (c.sensor - from.sensor).cwiseSign();
    source->states.push_back(std::move(c));
    ProblemObservation& o = problem.observations.emplace_back();
    o.index = static_cast<int>(i);
    o.mount = source->chain.mount;
    o.sightings = list_sightings(like);
  }
  problem.source = source;
  place_observations(problem);
  for (ProblemObservation& o : problem.observations)
    o.sightings = shown(problem, o, unknowns, sensor_from_tcp_at(o, unknowns), tcp_from_body);
  return problem;
}

ExpectedRows ExpectedPoses::rows_at(const Problem& problem, const ProblemObservation& o, const PoseJudge& judge) const {
  const Unknowns& u = estimate(fit_);
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u);
  const Eigen::Matrix<double, 6, Eigen::Dynamic> motion = motion_by_columns(problem, o, u);
  const bool direct = problem.cameras_by_effect.cols() > 0 || !o.motion.markers.empty();
  ExpectedRows rows;
  rows.is_shown = o.springs_hold && judge.is_shown(sensor_from_tcp);
  Eigen::Index count = 0, row = 0;
  const std::vector<Sighting> sightings = shown(problem, o, u, sensor_from_tcp, fit_.tcp_from_body);
  for (const Sighting& s : sightings) count += row_count(s);
  rows.by_columns.setZero(count, problem.columns());
  rows.predicted.resize(count);
  for (const Sighting& s : sightings) {
    const Vector3 x = sensor_from_tcp * marker_at(o, u, s.marker);
    const SightingResidual r = sighting_residual(problem.rig_or_null(), s, x);
    const SightingRows<3> by_marker = r.by_point * sensor_from_tcp.rotation;
    rows.by_columns.block(row, 3 * s.marker, r.rows, 3) = by_marker;
    rows.by_columns.block(row, problem.mount_column(), r.rows, motion.cols()).noalias() =
        by_motion(r.by_point, x) * motion;
    if (direct)
      rows.by_columns.block(row, problem.effect_column(), r.rows, problem.effect_count()) +=
          direct_by_effects(problem, o, s, r, x, sensor_from_tcp.rotation);
    rows.predicted.segment(row, r.rows) = -r.error;  // against a measurement of zero
    row += r.rows;
  }
  rows.by_columns /= noise_;
  rows.predicted /= noise_;
  return rows;
}

void ExpectedPoses::measure(const ExpectedRows& rows) {
  information_.noalias() += rows.by_columns.transpose() * rows.by_columns;
  llt_.compute(information_);
}

Eigen::MatrixXd ExpectedPoses::whitened(const ExpectedRows& rows) const {
  return llt_.matrixL().solve(rows.by_columns.transpose());
}

Vector6 ExpectedPoses::sigma_of_body() const {
  BodyFrame frame = body_frame(fit_.sides, estimate(fit_).markers_in_tcp, fit_.tcp_from_body.rotation);
  frame.unobserved.resize(6, 0);
  const Eigen::Index markers = fit_.problem.mount_column();
  const Eigen::MatrixXd all =
      llt_.solve(Eigen::MatrixXd::Identity(information_.rows(), information_.cols()).leftCols(markers));
  return body_covariance(frame, all.topRows(markers)).diagonal().cwiseMax(0).cwiseSqrt();
}

bool ExpectedPoses::depends_on_approach() const {
  return depends_on(fit_, [](ObservationState& c) { c.approach.setOnes(); });
}

bool ExpectedPoses::depends_on_velocity() const {
  return depends_on(fit_, [](ObservationState& c) { c.velocity.setOnes(); });
}

}  // namespace handsight
