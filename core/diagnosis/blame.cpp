// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/blame.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <cmath>
#include <limits>

#include "estimation/body_pose.h"

namespace handsight {
namespace {

constexpr double least_likely = 1e-5;  // of noise alone
constexpr double power = 0.8;
constexpr double beyond = 4;  // times what is typical: an observation's own fault
constexpr double never = std::numeric_limits<double>::infinity();

double rms(double squares, int rows) { return rows > 0 ? std::sqrt(std::max(squares, 0.0) / rows) : 0; }

bool exceeds(double squares, int rows, double noise) {
  if (rows <= 0 || noise <= 0) return false;
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(rows),
                                                  std::min(squares / (noise * noise), 1e6))) < least_likely;
}

double median_of(std::vector<double> values) {
  constexpr std::size_t fewest = 5;
  if (values.size() < fewest) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Blame shares(double cameras, double body, double robot) {
  Blame blame;
  const double sum = cameras + body + robot;
  if (!(sum > 0)) return blame;
  blame.cameras = cameras / sum;
  blame.body = body / sum;
  blame.robot = robot / sum;
  return blame;
}

/// The body's own pose without some of the points, and how well the rest then agrees.
struct Rest {
  double squares_per_degree = never;
  Rigid sensor_from_body;
};

Rest rest_of(const Problem& problem, const std::vector<Vector3>& markers, const Rigid& guess,
             std::vector<Sighting> sightings) {
  std::erase_if(sightings, [](const Sighting& s) { return row_count(s) == 0; });
  const auto pose = estimate_body_pose(problem.rig_or_null(), sightings, markers, guess);
  if (!pose || pose->rows <= 6) return {};
  return {pose->cost / (pose->rows - 6), pose->sensor_from_body};
}

/// The corner without which the rest agrees best.
SingleChange best_corner(const Problem& problem, const ProblemObservation& o, const Unknowns& u, double& squares) {
  SingleChange best;
  squares = never;
  const Rigid guess = sensor_from_tcp_at(o, u.mount_from_sensor);
  const std::vector<Vector3> markers = markers_at(o, u);
  for (std::size_t i = 0; i < o.sightings.size(); ++i)
    for (const SeenBy camera : {SeenBy::left, SeenBy::right}) {
      std::vector<Sighting> others = o.sightings;
      std::optional<Vector2>& corner = camera == SeenBy::left ? others[i].left : others[i].right;
      if (!corner) continue;
      const Vector2 measured = *corner;
      corner.reset();
      const Rest rest = rest_of(problem, markers, guess, others);
      if (rest.squares_per_degree >= squares) continue;
      squares = rest.squares_per_degree;
      const Vector3 x = rest.sensor_from_body * markers[static_cast<std::size_t>(o.sightings[i].marker)];
      const Vector2 expected = camera == SeenBy::left
                                   ? project(problem.rig->left, x)
                                   : project(problem.rig->right, Vector3(problem.rig->right_from_left * x));
      best = {SingleChange::Kind::corner,
              o.sightings[i].marker,
              camera,
              expected - measured,
              Vector3::Zero(),
              (expected - measured).norm(),
              0};
    }
  return best;
}

/// The marker without which the rest agrees best: moved on the body, hidden in part, or another corner in both images.
SingleChange best_marker(const Problem& problem, const ProblemObservation& o, const Unknowns& u, double& squares) {
  SingleChange best;
  squares = never;
  const Rigid guess = sensor_from_tcp_at(o, u.mount_from_sensor);
  const std::vector<Vector3> markers = markers_at(o, u);
  for (std::size_t i = 0; i < o.sightings.size(); ++i) {
    const Sighting& s = o.sightings[i];
    std::vector<Sighting> others = o.sightings;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const Rest rest = rest_of(problem, markers, guess, others);
    if (rest.squares_per_degree >= squares) continue;
    std::optional<Vector3> seen = s.point;
    if (!seen && problem.rig && s.left && s.right)
      if (const auto point = triangulate(*problem.rig, *s.left, *s.right)) seen = point->point;
    if (!seen) continue;
    squares = rest.squares_per_degree;
    const Vector3 in_body = inverse(rest.sensor_from_body) * *seen;
    const Vector3 offset = in_body - markers[static_cast<std::size_t>(s.marker)];
    best = {SingleChange::Kind::marker, s.marker, SeenBy::left, Vector2::Zero(), offset, offset.norm(), 0};
  }
  return best;
}

std::string direction(const Vector2& d) {
  const bool sideways = std::abs(d.x()) >= std::abs(d.y());
  const char* way = sideways ? (d.x() > 0 ? "right" : "left") : (d.y() > 0 ? "down" : "up");
  return fmt::format("{:.1f} px further {}", sideways ? std::abs(d.x()) : std::abs(d.y()), way);
}

/// What a test of two degrees (three) of freedom shows with that power.
double noncentrality_of(int degrees) {
  const double limit = boost::math::quantile(boost::math::complement(boost::math::chi_squared(degrees), least_likely));
  return boost::math::non_central_chi_squared::find_non_centrality(degrees, limit, 1 - power);
}

double noncentrality(Eigen::Index degrees) {
  static const double two = noncentrality_of(2), three = noncentrality_of(3);
  return degrees == 3 ? three : two;
}

}  // namespace

ResidualParts residual_parts(const Problem& problem, const ProblemObservation& o, const Unknowns& u) {
  ResidualParts parts;
  const StereoRig* rig = problem.rig_or_null();
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u.mount_from_sensor);
  for (const Sighting& s : o.sightings) {
    const SightingNormal normal = sighting_normal(rig, s, sensor_from_tcp * marker_at(o, u, s.marker));
    parts.total += normal.cost;
    parts.rows += normal.rows;
    if (!rig || !s.left || !s.right) continue;
    if (const auto point = triangulate(*rig, *s.left, *s.right)) {
      parts.cameras += sighting_normal(rig, s, point->point).cost;
      parts.camera_rows += 1;
    }
  }
  const auto pose = estimate_body_pose(rig, o.sightings, markers_at(o, u), sensor_from_tcp);
  if (!pose) return parts;
  parts.sensor_from_body = pose->sensor_from_body;
  parts.body = std::max(0.0, pose->cost - parts.cameras);
  parts.body_rows = std::max(0, parts.rows - 6 - parts.camera_rows);
  parts.robot = std::max(0.0, parts.total - pose->cost);
  parts.robot_rows = 6;
  return parts;
}

TypicalParts typical_parts(const std::vector<ResidualParts>& used) {
  std::vector<double> cameras, body;
  for (const ResidualParts& p : used) {
    if (p.camera_rows > 0) cameras.push_back(rms(p.cameras, p.camera_rows));
    if (p.body_rows > 0) body.push_back(rms(p.body, p.body_rows));
  }
  return {median_of(cameras), median_of(body)};
}

Blame blame_of(const ResidualParts& parts, double noise, const TypicalParts& typical) {
  const auto excess = [&](double squares, int rows) { return std::max(0.0, squares - rows * noise * noise); };
  char letter = 0;
  // From the inside out: images that do not fit together spoil the body's shape too, and a body out of shape its pose.
  if (exceeds(parts.cameras, parts.camera_rows, noise) &&
      rms(parts.cameras, parts.camera_rows) > beyond * typical.cameras) {
    letter = 'C';
  } else if (exceeds(parts.body, parts.body_rows, noise) && rms(parts.body, parts.body_rows) > beyond * typical.body) {
    letter = 'B';
  } else if (exceeds(parts.robot, parts.robot_rows, noise)) {
    letter = 'R';
  }
  if (letter == 0) return {};
  Blame blame = shares(excess(parts.cameras, parts.camera_rows), excess(parts.body, parts.body_rows),
                       excess(parts.robot, parts.robot_rows));
  blame.letter = letter;
  return blame;
}

Blame blame_of(const std::vector<ResidualParts>& used, double noise) {
  ResidualParts sum;
  for (const ResidualParts& p : used) {
    sum.cameras += p.cameras;
    sum.body += p.body;
    sum.robot += p.robot;
    sum.camera_rows += p.camera_rows;
    sum.body_rows += p.body_rows;
    sum.robot_rows += p.robot_rows;
  }
  const auto excess = [&](double squares, int rows) {
    return exceeds(squares, rows, noise) ? squares - rows * noise * noise : 0.0;
  };
  Blame blame =
      shares(excess(sum.cameras, sum.camera_rows), excess(sum.body, sum.body_rows), excess(sum.robot, sum.robot_rows));
  const double largest = std::max({blame.cameras, blame.body, blame.robot});
  if (largest > 0) blame.letter = largest == blame.robot ? 'R' : largest == blame.body ? 'B' : 'C';
  return blame;
}

SingleChange single_change(const Problem& problem, const ProblemObservation& o, const Unknowns& u, double noise,
                           const TypicalParts& typical, const ResidualParts& parts, char letter) {
  SingleChange change;
  if (letter == 0) return change;
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u.mount_from_sensor);
  if (letter == 'R') {
    if (!parts.sensor_from_body) return change;
    const Rigid motion = inverse(sensor_from_tcp) * *parts.sensor_from_body;
    change.kind = SingleChange::Kind::pose;
    change.size = motion.translation.norm();
    change.angle = vector_from_rotation(motion.rotation).norm();
    return change;
  }
  // The rest agrees where it is no worse than three times what it usually is.
  const double usual = std::max(noise, typical.body);
  double squares = never;
  if (problem.rig) {
    const SingleChange corner = best_corner(problem, o, u, squares);
    if (squares < 9 * usual * usual) return corner;
  }
  const SingleChange marker = best_marker(problem, o, u, squares);
  if (squares < 9 * usual * usual) return marker;
  const bool images = letter == 'C';
  change.kind = images ? SingleChange::Kind::images : SingleChange::Kind::body;
  change.size = images ? rms(parts.cameras, parts.camera_rows) : rms(parts.body, parts.body_rows);
  return change;
}

std::string change_text(const SingleChange& c, bool in_pixels) {
  constexpr double degrees = 57.29577951308232;
  switch (c.kind) {
    case SingleChange::Kind::none:
      return {};
    case SingleChange::Kind::corner:
      return fmt::format("Marker {}, {} image, {}.", c.marker, c.camera == SeenBy::left ? "left" : "right",
                         direction(c.shift));
    case SingleChange::Kind::marker:
      return fmt::format("Marker {}, {:.1f} mm from its place on the body: loose, hidden in part, or another corner.",
                         c.marker, 1e3 * c.size);
    case SingleChange::Kind::images:
      return fmt::format(
          "The two images do not fit together ({:.1f} px across the epipolar lines): not taken at the same instant, or "
          "several wrong corners.",
          c.size);
    case SingleChange::Kind::body:
      return fmt::format(
          "The markers do not lie to each other as on the other images ({:.1f} {}): several are wrong, or the body is "
          "bent.",
          c.size * (in_pixels ? 1 : 1e3), in_pixels ? "px" : "mm");
    case SingleChange::Kind::pose:
      return fmt::format("The whole hand, {:.1f} mm and {:.1f} deg from where the robot says.", 1e3 * c.size,
                         degrees * c.angle);
  }
  return {};
}

std::optional<double> smallest_visible(const Problem& problem, const ProblemObservation& o, const Unknowns& u,
                                       double noise) {
  Eigen::Index count = 0;
  for (const Sighting& s : o.sightings) count += row_count(s);
  if (count <= 6) return std::nullopt;
  Eigen::MatrixXd by_body(count, 6);
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u.mount_from_sensor);
  Eigen::Index row = 0;
  for (const Sighting& s : o.sightings) {
    const Vector3 x = sensor_from_tcp * marker_at(o, u, s.marker);
    const SightingResidual r = sighting_residual(problem.rig_or_null(), s, x);
    by_body.block(row, 0, r.rows, 3) = r.by_point.topRows(r.rows);
    by_body.block(row, 3, r.rows, 3) = -r.by_point.topRows(r.rows) * cross_matrix(x);
    row += r.rows;
  }
  const Eigen::MatrixXd q =
      Eigen::HouseholderQR<Eigen::MatrixXd>(by_body).householderQ() * Eigen::MatrixXd::Identity(count, 6);
  double largest = 0;
  row = 0;
  for (const Sighting& s : o.sightings) {
    const Eigen::Index size = s.point ? 3 : 2;
    for (Eigen::Index end = row + row_count(s); row < end; row += size) {
      const Eigen::MatrixXd mine = q.middleRows(row, size);
      const Eigen::MatrixXd shown = Eigen::MatrixXd::Identity(size, size) - mine * mine.transpose();
      const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(shown).eigenvalues().minCoeff();
      if (least < 1e-6) return std::nullopt;
      largest = std::max(largest, noise * std::sqrt(noncentrality(size) / least));
    }
  }
  return largest;
}

std::vector<ObservationBlame> blame_observations(const Session& session, const Fit& fit) {
  std::vector<ObservationBlame> list;
  if (!fit.noise || !(*fit.noise > 0)) return list;
  Problem problem = make_problem(session, chain_of(session), terms_of(fit));
  if (!problem.terms.empty()) {
    problem.tcp_from_slip = fit.problem.tcp_from_slip;
    place_observations(problem);
  }
  const Unknowns& u = estimate(fit);
  std::vector<ResidualParts> parts;
  for (ProblemObservation& o : problem.observations) {
    std::erase_if(o.sightings,
                  [&](const Sighting& s) { return !fit.problem.marker_is_seen[static_cast<std::size_t>(s.marker)]; });
    parts.push_back(residual_parts(problem, o, u));
  }
  const TypicalParts typical = typical_parts(parts);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const ProblemObservation& o = problem.observations[i];
    ObservationBlame b;
    b.index = o.index;
    b.id = session.observations[static_cast<std::size_t>(o.index)].id;
    b.parts = parts[i];
    b.blame = blame_of(parts[i], *fit.noise, typical);
    b.change = single_change(problem, o, u, *fit.noise, typical, parts[i], b.blame.letter);
    b.smallest_visible = smallest_visible(problem, o, u, *fit.noise);
    list.push_back(b);
  }
  return list;
}

}  // namespace handsight
