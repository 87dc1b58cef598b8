// SPDX-License-Identifier: Apache-2.0
// The batch fit of a body whose shape is held, observation by observation: six unknowns a piece and six of the mount,
// however many points there are.
#pragma once

#include "estimation/problem/problem.h"

namespace handsight {

class HeldFit {
 public:
  /// `problem` gives shape, rig, marker count and whether the mount is part of the fit; its observations are not read.
  /// `start`: the markers as the shape has them.
  HeldFit(const Problem& problem, const Unknowns& start);

  void add(const ProblemObservation& observation);

  /// Goes on from other unknowns where these fit the observations better.
  void try_from(const Unknowns& other);

  const std::vector<ProblemObservation>& observations() const { return observations_; }
  const Unknowns& unknowns() const { return unknowns_; }
  std::size_t size() const { return observations_.size(); }
  int rows() const { return sums_.rows; }
  double cost() const { return sums_.cost; }  // squared residuals, px^2 (m^2)
  Eigen::Index columns() const { return columns_; }

  /// How the markers move with the unknowns (3 markers x columns).
  Eigen::MatrixXd markers_by_unknowns() const;
  Eigen::MatrixXd unit_covariance() const;           // of the unknowns, for noise 1
  Eigen::MatrixXd repeatability_covariance() const;  // from how the observations differ

 private:
  /// The normal equations of all observations at some unknowns.
  struct Sums {
    Eigen::MatrixXd information, middle;
    Eigen::VectorXd gradient;
    double cost = 0;
    int rows = 0;
    bool in_front = true;
  };
  Sums sums_at(const Unknowns& unknowns) const;
  Unknowns moved(const Unknowns& unknowns, const Eigen::VectorXd& step) const;
  void descend(int most_steps);

  Problem problem_;
  Unknowns unknowns_;
  std::vector<ProblemObservation> observations_;
  Eigen::Index columns_ = 0;
  Sums sums_;
};

}  // namespace handsight
