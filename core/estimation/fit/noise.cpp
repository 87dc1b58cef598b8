// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/noise.h"

#include <Eigen/QR>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <map>
#include <numeric>

#include "chain/sighting.h"
#include "estimation/problem/body_pose.h"
#include "estimation/problem/column_products.h"
#include "estimation/solvers/inverse_parts.h"

namespace handsight {
namespace {

/// The rows of one observation: by the body's six small motions, and by what observations share (3 a marker, then
/// the rig's numbers) with the error as the last column, so that one product makes all sums. Kept from one observation
/// to the next, for their memory.
struct NoiseRows {
  Eigen::Matrix<double, Eigen::Dynamic, 6> by_pose;
  Eigen::MatrixXd shared_and_error;
};

/// A step of the body (m, rad) that changes no residual by more than 1e-5 px: near enough to linearise.
constexpr double near_enough = 1e-3;

Eigen::Index rig_numbers(const Problem& problem) { return problem.rig ? rig_number_count(problem.rig->count()) : 0; }

void set_rows(const Problem& problem, const ProblemObservation& o, const Unknowns& u, NoiseRows& rows) {
  const Rig* rig = problem.rig_or_null();
  // The body's own pose is the place to linearise at: with a large effect the chain's is pixels away.
  Rigid sensor_from_tcp = sensor_from_tcp_at(o, u);
  if (const auto pose = refined_body_pose(rig, o.sightings, markers_at(o, u), sensor_from_tcp, near_enough))
    sensor_from_tcp = *pose;

  const Eigen::Index cameras = 3 * problem.marker_count;
  const Eigen::Index error = cameras + rig_numbers(problem);
  Eigen::Index count = 0;
  for (const Sighting& s : o.sightings) count += row_count(s);
  rows.by_pose.resize(count, 6);
  rows.shared_and_error.setZero(count, error + 1);
  Eigen::Index row = 0;
  for (const Sighting& s : o.sightings) {
    const Vector3 x = sensor_from_tcp * marker_at(o, u, s.marker);
    const SightingResidual r = sighting_residual(rig, s, x);
    const SightingRows<3> by_rotation = -r.by_point * cross_matrix(x);
    const SightingRows<3> by_marker = r.by_point * sensor_from_tcp.rotation;
    rows.shared_and_error.col(error).segment(row, r.rows) = r.error;
    rows.by_pose.block(row, 0, r.rows, 3) = r.by_point;
    rows.by_pose.block(row, 3, r.rows, 3) = by_rotation;
    rows.shared_and_error.block(row, 3 * s.marker, r.rows, 3) = by_marker;
    if (rig) rows.shared_and_error.block(row, cameras, r.rows, rig_numbers(problem)) = camera_columns(*rig, s, x);
    row += r.rows;
  }
}

}  // namespace

std::optional<NoiseEstimate> estimate_noise(const Problem& problem, const Unknowns& unknowns) {
  const Eigen::Index shared = 3 * problem.marker_count + rig_numbers(problem);
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(shared + 1, shared + 1);  // lower triangle
  GatheredRows gathered(sums);
  Eigen::Index free_rows = 0;
  NoiseRows rows;
  Eigen::ColPivHouseholderQR<Eigen::Matrix<double, Eigen::Dynamic, 6>> qr;
  qr.setThreshold(1e-9);
  Eigen::RowVectorXd workspace(shared + 1);
  for (const ProblemObservation& o : problem.observations) {
    set_rows(problem, o, unknowns, rows);
    if (rows.by_pose.rows() <= 6) continue;
    qr.compute(rows.by_pose);
    qr.householderQ().adjoint().applyThisOnTheLeft(rows.shared_and_error, workspace);
    const Eigen::Index left = rows.by_pose.rows() - qr.rank();
    free_rows += left;
    gathered.add(rows.shared_and_error.bottomRows(left));
  }
  if (free_rows == 0) return std::nullopt;
  gathered.settle();
  const Eigen::MatrixXd h = Eigen::MatrixXd(sums.selfadjointView<Eigen::Lower>()).topLeftCorner(shared, shared);
  const Eigen::VectorXd g = sums.row(shared).head(shared).transpose();
  const double squares = sums(shared, shared);
  int unobservable = 0;
  const Eigen::MatrixXd inverse = pseudo_inverse(h, &unobservable);
  Eigen::Index used = -unobservable;
  for (Eigen::Index i = 0; i < shared; ++i) used += h(i, i) > 0 ? 1 : 0;
  const auto degrees = static_cast<int>(free_rows - used);
  if (degrees < 10) return std::nullopt;
  const double sigma = std::sqrt(std::max(squares - g.dot(inverse * g), 0.0) / degrees);
  return NoiseEstimate{sigma, sigma / std::sqrt(2.0 * degrees), degrees, false};
}

namespace {

constexpr double same_pose = 5e-3;  // rad, m
constexpr int fewest_degrees = 10;

/// Places of observations in groups of one pose each, groups of one left out.
std::vector<std::vector<std::size_t>> repeated_poses(const Problem& problem) {
  const auto position = [&](std::size_t place) -> const Eigen::VectorXd& {
    return problem.source->states[static_cast<std::size_t>(problem.observations[place].index)].sensor;
  };
  std::vector<std::size_t> order(problem.observations.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (order.empty()) return {};
  // Along the joint that moves most neighbours are few.
  Eigen::VectorXd low = position(0), high = low;
  for (const std::size_t i : order) {
    low = low.cwiseMin(position(i));
    high = high.cwiseMax(position(i));
  }
  Eigen::Index joint = 0;
  (high - low).maxCoeff(&joint);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return position(a)[joint] < position(b)[joint]; });
  std::vector<std::vector<std::size_t>> groups;
  std::vector<char> taken(order.size(), 0);
  for (std::size_t a = 0; a < order.size(); ++a) {
    if (taken[a]) continue;
    std::vector<std::size_t> group{order[a]};
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      if (position(order[b])[joint] - position(order[a])[joint] > same_pose) break;
      if (taken[b] || (position(order[b]) - position(order[a])).cwiseAbs().maxCoeff() > same_pose) continue;
      group.push_back(order[b]);
      taken[b] = 1;
    }
    if (group.size() > 1) groups.push_back(std::move(group));
  }
  return groups;
}

/// Sums of one coordinate of one marker over the observations of a group.
struct Sums {
  int count = 0;
  double sum = 0, squares = 0;
};

}  // namespace

std::optional<NoiseEstimate> noise_from_repeats(const Problem& problem, const Unknowns& unknowns) {
  double squares = 0;
  int degrees = 0;
  for (const std::vector<std::size_t>& group : repeated_poses(problem)) {
    std::map<std::pair<int, int>, Sums> coordinates;  // of a marker: u and v by camera, or x, y, z
    for (const std::size_t place : group) {
      const ProblemObservation& o = problem.observations[place];
      const Rigid sensor_from_tcp = sensor_from_tcp_at(o, unknowns);
      for (const Sighting& s : o.sightings) {
        const SightingResidual r =
            sighting_residual(problem.rig_or_null(), s, sensor_from_tcp * marker_at(o, unknowns, s.marker));
        for (int row = 0; row < r.rows; ++row) {
          const int camera = s.point ? 0 : s.in_cameras[static_cast<std::size_t>(row / 2)].camera;
          Sums& sums = coordinates[{s.marker, s.point ? row : 2 * camera + row % 2}];
          ++sums.count;
          sums.sum += r.error[row];
          sums.squares += r.error[row] * r.error[row];
        }
      }
    }
    for (const auto& [coordinate, sums] : coordinates) {
      squares += std::max(0.0, sums.squares - sums.sum * sums.sum / sums.count);
      degrees += sums.count - 1;
    }
  }
  if (degrees < fewest_degrees) return std::nullopt;
  const double sigma = std::sqrt(squares / degrees);
  return NoiseEstimate{sigma, sigma / std::sqrt(2.0 * degrees), degrees, true};
}

double chi_squared_tail(double chi2, double degrees) {
  // The incomplete gamma function overflows where there is nearly nothing of very many degrees.
  if (degrees > 100 && chi2 < 1e-3 * degrees) return 1;
  if (chi2 > 100 * degrees + 1e4) return 0;
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees), chi2));
}

std::optional<NoiseTest> noise_test(double squares, double degrees, double estimated) {
  namespace bm = boost::math;
  NoiseTest test{squares, degrees, 1};
  if (estimated > 0) {
    test.chi2 = std::max(squares - estimated, 0.0);
    test.degrees = degrees - estimated;
  }
  if (test.degrees < 1) return std::nullopt;
  test.p = estimated > 0 ? bm::cdf(bm::complement(bm::fisher_f(test.degrees, estimated), test.chi2 / test.degrees))
                         : chi_squared_tail(test.chi2, test.degrees);
  return test;
}

}  // namespace handsight
