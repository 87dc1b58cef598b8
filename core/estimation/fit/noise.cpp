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

/// The rows of one observation: by the body's six small motions, by the place of the marker that each row sees, and by
/// the rig's numbers with the error as the last column. Kept from one observation to the next, for their memory.
struct NoiseRows {
  Eigen::Matrix<double, Eigen::Dynamic, 6> by_pose;
  Eigen::Matrix<double, Eigen::Dynamic, 3> by_marker;
  Eigen::MatrixXd by_rig_and_error;
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

  const Eigen::Index rig_columns = rig_numbers(problem);
  Eigen::Index count = 0;
  for (const Sighting& s : o.sightings) count += row_count(s);
  rows.by_pose.resize(count, 6);
  rows.by_marker.resize(count, 3);
  rows.by_rig_and_error.resize(count, rig_columns + 1);
  Eigen::Index row = 0;
  for (const Sighting& s : o.sightings) {
    const Vector3 x = sensor_from_tcp * marker_at(o, u, s.marker);
    const SightingResidual r = sighting_residual(rig, s, x);
    rows.by_pose.block(row, 0, r.rows, 3) = r.by_point;
    rows.by_pose.block(row, 3, r.rows, 3) = -r.by_point * cross_matrix(x);
    rows.by_marker.middleRows(row, r.rows) = r.by_point * sensor_from_tcp.rotation;
    if (rig) rows.by_rig_and_error.block(row, 0, r.rows, rig_columns) = camera_columns(*rig, s, x);
    rows.by_rig_and_error.col(rig_columns).segment(row, r.rows) = r.error;
    row += r.rows;
  }
}

/// Sums of squares and products of what the body's six motions cannot explain: by 3 columns a marker, the rig's, and
/// the error. A row knows the place of one marker only, so that what the motions explain of these is summed apart, six
/// rows an observation; of rig and error, of which they may explain nearly all, it is taken away before.
class NoiseSums {
 public:
  NoiseSums(const Problem& problem)
      : markers_(3 * problem.marker_count),
        others_(rig_numbers(problem) + 1),
        sums_(Eigen::MatrixXd::Zero(markers_ + others_, markers_ + others_)),
        explained_(Eigen::MatrixXd::Zero(markers_, markers_)),
        gathered_(explained_, 6 * static_cast<Eigen::Index>(problem.observations.size())) {
    qr_.setThreshold(1e-9);
  }

  /// Changes `rows`. Returns how many of them the motions leave free.
  Eigen::Index add(const ProblemObservation& o, NoiseRows& rows) {
    const Eigen::Index count = rows.by_pose.rows();
    if (count <= 6) return 0;
    qr_.compute(rows.by_pose);
    const Eigen::Index rank = qr_.rank();
    if (rank == count) return 0;
    qr_.householderQ().adjoint().applyThisOnTheLeft(rows.by_rig_and_error);
    rows.by_rig_and_error.topRows(rank).setZero();
    qr_.householderQ().applyThisOnTheLeft(rows.by_rig_and_error);
    motions_.setIdentity(count, rank);
    qr_.householderQ().applyThisOnTheLeft(motions_);
    motions_by_marker_.setZero(rank, markers_);
    Eigen::Index row = 0;
    for (const Sighting& s : o.sightings) {
      const Eigen::Index m = 3 * s.marker, size = row_count(s);
      const auto by_marker = rows.by_marker.middleRows(row, size);
      sums_.block(m, m, 3, 3) += by_marker.transpose() * by_marker;
      sums_.block(markers_, m, others_, 3) += rows.by_rig_and_error.middleRows(row, size).transpose() * by_marker;
      motions_by_marker_.middleCols(m, 3) += motions_.middleRows(row, size).transpose() * by_marker;
      row += size;
    }
    sums_.bottomRightCorner(others_, others_) += rows.by_rig_and_error.transpose() * rows.by_rig_and_error;
    gathered_.add(motions_by_marker_);
    return count - rank;
  }

  /// All of them, the error as the last column.
  Eigen::MatrixXd settled() {
    constexpr double rounding = 1e-13;
    gathered_.settle();
    const Eigen::VectorXd before = sums_.diagonal().head(markers_);
    sums_.topLeftCorner(markers_, markers_) -= explained_;
    for (Eigen::Index i = 0; i < markers_; ++i) {
      if (sums_(i, i) > rounding * before[i]) continue;
      sums_.row(i).setZero();
      sums_.col(i).setZero();
    }
    return sums_.selfadjointView<Eigen::Lower>();
  }

 private:
  Eigen::Index markers_, others_;
  Eigen::MatrixXd sums_, explained_;  // lower triangles
  GatheredRows gathered_;
  Eigen::ColPivHouseholderQR<Eigen::Matrix<double, Eigen::Dynamic, 6>> qr_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Eigen::Dynamic, 6> motions_;
  Eigen::MatrixXd motions_by_marker_;
};

}  // namespace

std::optional<NoiseEstimate> estimate_noise(const Problem& problem, const Unknowns& unknowns) {
  const Eigen::Index shared = 3 * problem.marker_count + rig_numbers(problem);
  NoiseSums noise_sums(problem);
  Eigen::Index free_rows = 0;
  NoiseRows rows;
  for (const ProblemObservation& o : problem.observations) {
    set_rows(problem, o, unknowns, rows);
    free_rows += noise_sums.add(o, rows);
  }
  if (free_rows == 0) return std::nullopt;
  const Eigen::MatrixXd sums = noise_sums.settled();
  const Eigen::MatrixXd h = sums.topLeftCorner(shared, shared);
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
