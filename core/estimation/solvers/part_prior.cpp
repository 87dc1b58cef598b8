// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/part_prior.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "geometry/orthonormal_columns.h"

namespace handsight {
namespace {

using Places = Eigen::Matrix3Xd;

Places as_columns(const std::vector<Vector3>& points) {
  Places columns(3, static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index m = 0; m < columns.cols(); ++m) columns.col(m) = points[static_cast<std::size_t>(m)];
  return columns;
}

/// How a shift and a turn about `centre` move places, 3n x 6.
Eigen::MatrixXd motions_of(const Places& places, const Vector3& centre) {
  Eigen::MatrixXd motions(3 * places.cols(), 6);
  for (Eigen::Index m = 0; m < places.cols(); ++m) {
    motions.block<3, 3>(3 * m, 0) = Matrix3::Identity();
    motions.block<3, 3>(3 * m, 3) = -cross_matrix(Vector3(places.col(m) - centre));
  }
  return motions;
}

/// The inverse root of the covariance of a part's coordinates.
Eigen::MatrixXd whitening(const ShapePart& part, const Places& places, double sigma) {
  Vector6 sigmas;
  sigmas << Vector3::Constant(part.sigma), Vector3::Constant(part.sigma_angle);
  const Eigen::MatrixXd by = motions_of(places, places.rowwise().mean()) * sigmas.asDiagonal();
  Eigen::MatrixXd covariance = by * by.transpose();
  covariance.diagonal().array() += sigma * sigma;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(covariance);
  const Eigen::VectorXd scales = eigen.eigenvalues().cwiseMax(sigma * sigma).cwiseSqrt().cwiseInverse();
  return eigen.eigenvectors() * scales.asDiagonal() * eigen.eigenvectors().transpose();
}

/// L of all parts: block by block, applied to columns.
class Whitening {
 public:
  Whitening(const KnownShape& shape, const Places& laid, double sigma) {
    for (const ShapePart& part : shape.parts)
      blocks_.push_back(whitening(part, laid.middleCols(part.first, part.count), sigma));
  }
  Eigen::MatrixXd operator()(const Eigen::MatrixXd& columns) const {
    Eigen::MatrixXd result(columns.rows(), columns.cols());
    Eigen::Index row = 0;
    for (const Eigen::MatrixXd& block : blocks_) {
      result.middleRows(row, block.rows()) = block * columns.middleRows(row, block.rows());
      row += block.rows();
    }
    return result;
  }

 private:
  std::vector<Eigen::MatrixXd> blocks_;
};

Eigen::VectorXd stacked(const Places& off) { return Eigen::Map<const Eigen::VectorXd>(off.data(), off.size()); }

}  // namespace

PartRows part_rows(const KnownShape& shape, const std::vector<Vector3>& markers, double sigma) {
  constexpr int rounds = 3;  // a firm part leads the body to within rounding at once but for its turn
  const Places here = as_columns(markers), known = as_columns(shape.markers);
  Rigid laid = align_points(here, known, Eigen::VectorXd::Ones(known.cols()));
  PartRows rows;
  for (int round = 0; round <= rounds; ++round) {
    const Places there = (laid.rotation * known).colwise() + laid.translation;
    const Vector3 middle = there.rowwise().mean();
    const Whitening whitened(shape, there, sigma);
    const Eigen::MatrixXd motions = whitened(motions_of(there, middle));
    const Eigen::VectorXd off = whitened(stacked(here - there));
    if (round < rounds) {
      const Vector6 step = motions.householderQr().solve(off);
      const Matrix3 turn = rotation_from_vector<double>(step.tail<3>());
      laid = {turn * laid.rotation, turn * (laid.translation - middle) + middle + step.head<3>()};
      continue;
    }
    const Eigen::MatrixXd q = orthonormal_columns(motions);
    rows.off = off - q * (q.transpose() * off);
    const Eigen::MatrixXd all = whitened(Eigen::MatrixXd::Identity(off.size(), off.size()));
    rows.by_markers = all - q * (q.transpose() * all);
  }
  return rows;
}

}  // namespace handsight
