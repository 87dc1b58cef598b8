// SPDX-License-Identifier: Apache-2.0
#include "compare/pose_sums.h"

#include "chain/sighting.h"
#include "estimation/problem/column_products.h"

namespace handsight {

Normal without_pose(const PoseSums& sums, double coordinate, const Matrix6& repeatability) {
  const Eigen::VectorXd share = coordinate / (1 + coordinate * sums.count.array());
  const Eigen::MatrixXd weighed = share.cwiseSqrt().asDiagonal() * sums.rows;
  const Eigen::MatrixXd information = sums.information - column_products(weighed);
  const Eigen::VectorXd gradient = sums.gradient - sums.rows.transpose() * share.cwiseProduct(sums.error);
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
  sums.information = column_products(sums.rows);
  sums.gradient = sums.rows.transpose() * sums.error;
  return sums;
}

}  // namespace handsight
