// SPDX-License-Identifier: Apache-2.0
// What the observations of one pose say of a change, summed so that visits of the pose add up. Internal to
// change_watch.
#pragma once

#include "compare/change_rows.h"

namespace handsight {

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
Normal without_pose(const PoseSums& sums, double coordinate, const Matrix6& repeatability);

/// Each coordinate in a row of its own, so that those of several visits add up; `a_marker`: coordinates of one marker.
PoseSums sums_of_rows(const ProblemObservation& o, const SingleRows& single, int a_marker, int markers);

}  // namespace handsight
