// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/outliers/snooping.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/median.h"
#include "chain/sighting.h"
#include "diagnosis/evidence/body_rows.h"
#include "diagnosis/evidence/noise_model.h"
#include "estimation/fit/fit_noise.h"
#include "estimation/fit/sure_fit.h"
#include "estimation/problem/problem_part.h"
#include "geometry/orthonormal_columns.h"

namespace handsight {
namespace {

constexpr double most_dropped = 0.15;  // share of all points
constexpr std::size_t at_once = 2000;  // observations whose motions are in memory together

/// The errors of one observation, parted by the body's six motions.
struct Squares {
  std::size_t place = 0;  // in the problem
  Eigen::Index rows = 0;
  Vector6 external_error;  // in the eigenframe of the joints' errors
  Vector6 joint_variance;  // per rad^2
  double internal_squares = 0;
};

/// One observation: rows parted by the body's six motions, and how joint errors move them.
struct Parted : Squares {
  Eigen::MatrixXd motions;  // n x 6 orthonormal: the external part
  Eigen::VectorXd error;    // n
};

std::optional<Parted> parted(const Problem& problem, const ProblemObservation& o, const Unknowns& u) {
  const BodyRows rows = body_rows(problem, o, u);
  const Eigen::Index count = rows.error.size();
  if (count <= 6) return std::nullopt;
  Parted p;
  p.rows = count;
  p.error = rows.error;
  const Eigen::MatrixXd q = orthonormal_columns(rows.by_body);
  const Rigid sensor_from_root = inverse(o.root_from_mount * find_mount(o, u) * o.sensor_motion);
  const Eigen::MatrixXd by_joints = q.transpose() * rows.by_body * (adjoint(sensor_from_root) * o.motion.tcp_by_value);
  const Eigen::MatrixXd shown = by_joints * by_joints.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(shown);
  p.joint_variance = eigen.eigenvalues().cwiseMax(0);
  p.motions = q * eigen.eigenvectors();
  p.external_error = p.motions.transpose() * p.error;
  p.internal_squares = std::max(p.error.squaredNorm() - p.external_error.squaredNorm(), 0.0);
  return p;
}

/// The chi-squared quantile of as many degrees of freedom, each number of degrees worked out once.
class ChiSquared {
 public:
  explicit ChiSquared(double upper_tail) : upper_tail_(upper_tail) {}
  double at(Eigen::Index degrees) {
    const auto place = static_cast<std::size_t>(degrees);
    if (place >= known_.size()) known_.resize(place + 1, 0);
    if (known_[place] == 0)
      known_[place] = boost::math::quantile(
          boost::math::complement(boost::math::chi_squared(static_cast<double>(degrees)), upper_tail_));
    return known_[place];
  }

 private:
  double upper_tail_;
  std::vector<double> known_;
};

/// Of one coordinate, from the internal squares of the middle observation: wrong points do not reach it.
double robust_noise(const std::vector<Squares>& all) {
  std::vector<double> variances;
  ChiSquared middle(0.5);
  for (const Squares& p : all) variances.push_back(p.internal_squares / middle.at(p.rows - 6));
  return std::sqrt(std::max(median(variances), 1e-300));
}

/// Of all rows of an observation, with joints that err by `scatter` (rad).
double chi_squared(const Squares& p, double noise, double repeatability) {
  double chi2 = p.internal_squares / (noise * noise);
  for (Eigen::Index k = 0; k < 6; ++k)
    chi2 += p.external_error[k] * p.external_error[k] /
            (noise * noise + repeatability * repeatability * p.joint_variance[k]);
  return chi2;
}

/// The joints' random error (rad) for which the middle observation is as likely as it should be.
double joint_repeatability(const std::vector<Squares>& all, double noise) {
  ChiSquared find_middle(0.5);
  const auto excess = [&](double repeatability) {
    std::vector<double> ratios;
    for (const Squares& p : all) ratios.push_back(chi_squared(p, noise, repeatability) / find_middle.at(p.rows));
    return median(ratios) > 1;
  };
  if (!excess(0)) return 0;
  double low = 1e-7, high = 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = std::sqrt(low * high);
    (excess(middle) ? low : high) = middle;
  }
  return high;
}

/// The least likely point of an observation, if it is less likely than `wrong_by_chance`.
std::optional<WrongPoint> worst_point(const Session& session, const ProblemObservation& observed, const Parted& p,
                                      double noise, double repeatability, ChiSquared& likely) {
  // V^-1 = (1 - Q diag(m) Q^T) / noise^2 with m = g / (1 + g).
  const Eigen::VectorXd g = repeatability * repeatability / (noise * noise) * p.joint_variance;
  const Eigen::VectorXd m = g.array() / (1 + g.array());
  const Eigen::VectorXd z = (p.error - p.motions * (m.asDiagonal() * p.external_error)) / (noise * noise);
  std::optional<WrongPoint> worst;
  double largest = 0;
  Eigen::Index row = 0;
  const auto consider = [&](const Sighting& s, int camera, Eigen::Index size) {
    const Eigen::MatrixXd q = p.motions.middleRows(row, size);
    const Eigen::MatrixXd precision =
        (Eigen::MatrixXd::Identity(size, size) - q * m.asDiagonal() * q.transpose()) / (noise * noise);
    const Eigen::VectorXd displacement = precision.ldlt().solve(z.segment(row, size));
    const double chi2 = z.segment(row, size).dot(displacement);
    row += size;
    if (chi2 < likely.at(size) || chi2 <= largest) return;
    largest = chi2;
    const Observation& o = session.observations[static_cast<std::size_t>(observed.index)];
    worst = WrongPoint{o.id, observed.index, s.marker, camera, displacement.norm()};
  };
  for (const Sighting& s : observed.sightings) {
    if (s.point) consider(s, by_tracker, row_count(s));
    for (const CameraPoint& seen : s.in_cameras) consider(s, seen.camera, 2);
  }
  return worst;
}

void drop(Session& session, const WrongPoint& w) {
  std::vector<Sighting>& sightings = session.observations[static_cast<std::size_t>(w.index)].sightings;
  for (Sighting& s : sightings) {
    if (s.marker != w.marker) continue;
    if (w.camera == by_tracker)
      s.point.reset();
    else
      forget(s, w.camera);
  }
  std::erase_if(sightings, [](const Sighting& s) { return row_count(s) == 0; });
}

/// The observations at these places with their motions, a stretch of the problem at a time.
template <class See>
void see_motions(const Problem& problem, const std::vector<std::size_t>& places, const See& see) {
  for (std::size_t first = 0; first < places.size(); first += at_once) {
    Problem some = without_observations(problem);
    const std::size_t last = std::min(first + at_once, places.size());
    for (std::size_t i = first; i < last; ++i) some.observations.push_back(problem.observations[places[i]]);
    some = with_motions(some);
    for (std::size_t i = first; i < last; ++i) see(some, some.observations[i - first], places[i]);
  }
}

std::vector<WrongPoint> wrong_points(const Session& session, const Fit& f) {
  const Unknowns& unknowns = estimate(f);
  std::vector<std::size_t> places(f.problem.observations.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::vector<Squares> all;
  see_motions(f.problem, places, [&](const Problem& some, const ProblemObservation& o, std::size_t place) {
    if (auto p = parted(some, o, unknowns)) all.emplace_back(std::move(*p)).place = place;
  });
  std::vector<WrongPoint> wrong;
  if (all.size() < 5) return wrong;
  // What the session declares is the least: points of one rigid thing (a tracker's) may fit each other far better than
  // they are right, and are none the worse for it.
  const double noise = std::max(robust_noise(all), declared_noise(session).value_or(finest_noise(session)));
  const double repeatability = joint_repeatability(all, noise);
  ChiSquared likely(wrong_by_chance);
  // No point takes more from chi-squared than all rows have: few observations need a second look.
  const double least = (1 - 1e-9) * likely.at(1);
  places.clear();
  for (const Squares& p : all)
    if (chi_squared(p, noise, repeatability) >= least) places.push_back(p.place);
  see_motions(f.problem, places, [&](const Problem& some, const ProblemObservation& o, std::size_t) {
    const auto p = parted(some, o, unknowns);
    if (!p) return;
    if (const auto w = worst_point(session, o, *p, noise, repeatability, likely)) wrong.push_back(*w);
  });
  return wrong;
}

}  // namespace

std::size_t point_count(const Session& session) {
  std::size_t count = 0;
  for (const Observation& o : session.observations)
    for (const Sighting& s : o.sightings) count += s.in_cameras.size() + (s.point ? 1 : 0);
  return count;
}

namespace {

/// The same fit from where it ended, on what is left of the session.
FitOptions from_there(const FitOptions& options, const Fit& fit) {
  FitOptions again = options;
  again.start = estimate(fit);
  for (std::size_t t = 0; t < again.estimated.size(); ++t)
    again.estimated[t] = fit.effects[options.effects.size() + t].term;
  return again;
}

/// A fit that goes on from where one has ended that has looked at all starts need not look at them again.
constexpr double nothing = std::numeric_limits<double>::min();

/// Which points are wrong does not hang on what no Bayes factor shows.
FitOptions roughly(FitOptions options, const NoiseModel& by) {
  set_quick(by, options);
  return options;
}

/// Has it an answer, and come to its end?
bool has_ended(const Fit& fit) { return fit.converged() && !has_no_answer(fit); }

/// Where a fit has no answer no point is far from where the others put it for a reason of its own, unless without it
/// less is left.
bool leads_to_an_answer(const Fit& now, double residual_before) {
  constexpr double hardly_less = 0.97;
  return has_ended(now) || now.residual_rms < hardly_less * residual_before;
}

}  // namespace

CleanFit clean_fit(const Session& session, const FitOptions& options) {
  // Models that bend are fitted roughly until the wrong points are known.
  const bool bends = !options.estimated.empty() && options.least_gain == 0;
  const std::optional<double>& declared = declared_noise(session);
  bool is_rough = bends && options.start && declared;
  CleanFit clean{session, fit(session, is_rough ? roughly(options, {.noise = *declared}) : options), {}};
  const auto most = static_cast<std::size_t>(most_dropped * static_cast<double>(point_count(session)));
  const std::optional<CleanFit> as_it_is = has_ended(clean.fit) ? std::nullopt : std::optional(clean);
  const bool was_rough = is_rough;
  constexpr int most_rounds = 8, most_fruitless = 2;
  int fruitless = 0;
  for (int round = 0; round < most_rounds && !clean.fit.solution.stopped; ++round) {
    std::vector<WrongPoint> wrong = wrong_points(clean.session, clean.fit);
    if (wrong.empty() || clean.wrong.size() + wrong.size() > most) break;
    for (const WrongPoint& w : wrong) drop(clean.session, w);
    clean.wrong.insert(clean.wrong.end(), wrong.begin(), wrong.end());
    is_rough = bends;
    FitOptions again = from_there(options, clean.fit);
    if (is_rough)
      again = roughly(again, noise_model(clean.fit));
    else if (again.least_gain == 0)
      again.least_gain = nothing;
    const double before = clean.fit.residual_rms;
    clean.fit.problem = {};  // of a long session every copy counts
    clean.fit = fit(clean.session, again);
    if (as_it_is && !leads_to_an_answer(clean.fit, before) && ++fruitless == most_fruitless) {
      clean = *as_it_is;
      is_rough = was_rough;
      break;
    }
  }
  if (is_rough && !clean.fit.solution.stopped) {
    const FitOptions whole = from_there(options, clean.fit);
    clean.fit.problem = {};
    clean.fit = fit(clean.session, whole);
  }
  return clean;
}

}  // namespace handsight
