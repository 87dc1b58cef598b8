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

  void add(const PoseSums& other) {
    if (information.size() == 0) {
      *this = other;
      return;
    }
    information += other.information;
    gradient += other.gradient;
    rows += other.rows;
    error += other.error;
    count += other.count;
  }

  /// Adds what the changes do in another sum that is already in this one as unchanged.
  void add_changes(const PoseSums& other, Eigen::Index base) {
    const Eigen::Index changes = gradient.size() - 6 - base, end = base + changes;
    gradient.segment(base, changes) += other.gradient.segment(base, changes);
    rows.middleCols(base, changes) += other.rows.middleCols(base, changes);
    information.middleCols(base, changes) += other.information.middleCols(base, changes);
    information.block(base, 0, changes, base) += other.information.block(base, 0, changes, base);
    information.block(base, end, changes, 6) += other.information.block(base, end, changes, 6);
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

  /// Adds the one and takes off the other, which was added before; nothing where there was none.
  void replace(const Normal& old, const Normal& by) {
    if (gradient.size() == 0) {
      *this = by;
      return;
    }
    information += by.information;
    gradient += by.gradient;
    if (old.gradient.size() == 0) return;
    information -= old.information;
    gradient -= old.gradient;
  }
};

/// What is the same at every visit of the pose taken out: an offset of each coordinate of this variance, and the pose's
/// own motion of this covariance.
Normal without_pose(const PoseSums& sums, double coordinate, const Matrix6& repeatability);

/// Each coordinate in a row of its own, so that those of several visits add up; `a_marker`: coordinates of one marker.
PoseSums sums_of_rows(const ProblemObservation& o, const SingleRows& single, int a_marker, int markers);

}  // namespace handsight
