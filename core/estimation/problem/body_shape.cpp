// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem/body_shape.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace handsight {
namespace {

struct Points {
  std::vector<int> markers;
  Eigen::Matrix3Xd in_sensor;
};

std::vector<Points> observed_points(const Problem& problem) {
  int left_out = 0;
  std::vector<Points> all;
  for (const ProblemObservation& o : as_points(problem, left_out).observations) {
    Points p;
    p.in_sensor.resize(3, static_cast<Eigen::Index>(o.sightings.size()));
    for (std::size_t i = 0; i < o.sightings.size(); ++i) {
      p.markers.push_back(o.sightings[i].marker);
      p.in_sensor.col(static_cast<Eigen::Index>(i)) = *o.sightings[i].point;
    }
    if (p.markers.size() >= 3) all.push_back(std::move(p));
  }
  return all;
}

struct Mean {
  std::vector<Vector3> sum;
  std::vector<int> count;
  explicit Mean(std::size_t markers) : sum(markers, Vector3::Zero()), count(markers, 0) {}
  Vector3 at(int m) const { return sum[static_cast<std::size_t>(m)] / count[static_cast<std::size_t>(m)]; }
  void add(int m, const Vector3& x) {
    sum[static_cast<std::size_t>(m)] += x;
    ++count[static_cast<std::size_t>(m)];
  }
};

/// Lays the points onto the mean by the markers that they share (three or more); nothing where they share fewer.
std::optional<Eigen::Matrix3Xd> laid_on(const Mean& mean, const Points& points) {
  Eigen::Matrix3Xd target(3, points.in_sensor.cols());
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(points.in_sensor.cols());
  for (Eigen::Index i = 0; i < points.in_sensor.cols(); ++i) {
    const int m = points.markers[static_cast<std::size_t>(i)];
    if (mean.count[static_cast<std::size_t>(m)] == 0) continue;
    target.col(i) = mean.at(m);
    weights[i] = 1;
  }
  for (Eigen::Index i = 0; i < target.cols(); ++i)
    if (weights[i] == 0) target.col(i).setZero();
  if (weights.sum() < 3) return std::nullopt;
  const Rigid motion = align_points(target, points.in_sensor, weights);
  return (motion.rotation * points.in_sensor).colwise() + motion.translation;
}

/// Covariance of each marker's average: the scatter of its laid points over their number; with one point nothing is
/// known of it, and it is taken as 0.
std::vector<Matrix3> mean_covariances(const std::vector<Points>& all, const std::vector<Eigen::Matrix3Xd>& laid,
                                      const Mean& mean) {
  std::vector<Matrix3> covariances(mean.sum.size(), Matrix3::Zero());
  for (std::size_t k = 0; k < all.size(); ++k)
    for (Eigen::Index i = 0; i < laid[k].cols(); ++i) {
      const int m = all[k].markers[static_cast<std::size_t>(i)];
      const Vector3 miss = laid[k].col(i) - mean.at(m);
      covariances[static_cast<std::size_t>(m)] += miss * miss.transpose();
    }
  for (std::size_t m = 0; m < covariances.size(); ++m) {
    const double n = mean.count[m];
    covariances[m] *= n > 1 ? 1 / (n * (n - 1)) : 0.0;
  }
  return covariances;
}

Matrix3 signed_components(const Matrix3& eigenvectors) {
  Matrix3 v;
  for (int c = 0; c < 2; ++c) {
    v.col(c) = eigenvectors.col(2 - c);  // Eigen sorts ascending
    Eigen::Index largest = 0;
    v.col(c).cwiseAbs().maxCoeff(&largest);
    if (v(largest, c) < 0) v.col(c) = -v.col(c);
  }
  v.col(2) = v.col(0).cross(v.col(1));
  return v;
}

}  // namespace

std::optional<BodyShape> average_shape(const Problem& problem) {
  std::vector<Points> all = observed_points(problem);
  if (all.empty()) return std::nullopt;
  std::stable_sort(all.begin(), all.end(),
                   [](const Points& a, const Points& b) { return a.markers.size() > b.markers.size(); });
  const auto markers = static_cast<std::size_t>(problem.marker_count);
  Mean mean(markers);
  for (std::size_t i = 0; i < all.front().markers.size(); ++i)
    mean.add(all.front().markers[i], all.front().in_sensor.col(static_cast<Eigen::Index>(i)));
  std::vector<Eigen::Matrix3Xd> laid(all.size());
  for (int pass = 0; pass < 3; ++pass) {
    Mean next(markers);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto points = laid_on(mean, all[k]);
      if (!points) continue;
      laid[k] = *points;
      for (std::size_t i = 0; i < all[k].markers.size(); ++i) {
        next.add(all[k].markers[i], points->col(static_cast<Eigen::Index>(i)));
        // Markers that the first observation did not show are learned as soon as one shows them.
        if (mean.count[static_cast<std::size_t>(all[k].markers[i])] == 0)
          mean.add(all[k].markers[i], points->col(static_cast<Eigen::Index>(i)));
      }
    }
    mean = next;
  }

  Vector3 centroid = Vector3::Zero();  // (4.19), divided by the number of points
  Matrix3 covariance = Matrix3::Zero();
  int count = 0;
  for (const auto& points : laid) {
    centroid += points.rowwise().sum();
    count += static_cast<int>(points.cols());
  }
  centroid /= count;
  for (const auto& points : laid) {
    const Eigen::Matrix3Xd centered = points.colwise() - centroid;
    covariance += centered * centered.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(Matrix3(covariance / count));
  const Matrix3 v = signed_components(eigen.eigenvectors());
  BodyShape shape;
  shape.variances = eigen.eigenvalues().reverse();
  for (const Matrix3& c : mean_covariances(all, laid, mean)) shape.covariances.push_back(v.transpose() * c * v);
  for (std::size_t m = 0; m < markers; ++m) {
    shape.is_known.push_back(mean.count[m] > 0);
    shape.markers.push_back(mean.count[m] > 0 ? Vector3(v.transpose() * (mean.at(static_cast<int>(m)) - centroid))
                                              : Vector3::Zero());
  }
  return shape;
}

}  // namespace handsight
