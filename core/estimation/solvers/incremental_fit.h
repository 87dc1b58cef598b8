// SPDX-License-Identifier: Apache-2.0
// The same least squares as the batch fit, observation by observation, with bounded work for each.
#pragma once

#include <memory>

#include "estimation/solvers/least_squares.h"

namespace handsight {

/// Keeps the sum of every observation's normal equations, each linearised where the estimate then was. A new
/// observation linearises itself and the `relinearised_per_step` that were linearised longest ago anew: while there
/// are no more than that the answer is the batch answer, later it follows it, because an estimate from many
/// observations hardly moves between two turns. Of more than `most_kept` those that were linearised longest ago stay as
/// they are, only as their part of the sum: a day of observations takes no more memory than an hour.
class IncrementalFit {
 public:
  static constexpr std::size_t most_kept = 8192;

  /// `problem` gives rig, marker count and whether the mount is part of the fit; its observations are not read.
  IncrementalFit(const Problem& problem, const Unknowns& start, int relinearised_per_step = 48);

  void add(const ProblemObservation& observation);

  /// Where to start a marker that no observation has shown yet (m, TCP frame).
  void place_marker(int marker, const Vector3& in_tcp);

  const Unknowns& unknowns() const { return *current_; }
  std::size_t size() const { return count_; }
  int rows() const { return rows_; }
  double cost() const { return cost_; }              // at the places of linearisation
  Eigen::MatrixXd unit_covariance() const;           // for noise 1, problem columns
  Eigen::MatrixXd repeatability_covariance() const;  // from how the observations differ
  int unobservable() const;

 private:
  struct Entry {
    ProblemObservation observation;
    std::shared_ptr<const Unknowns> at;
  };
  Entry& place_for(Entry entry);
  void accumulate(const Entry& entry, double sign);
  void relinearise(Entry& entry);
  void relinearise_oldest(std::size_t count);
  void solve_step();
  Eigen::VectorXd coordinates(const Unknowns& unknowns) const;
  Unknowns from_coordinates(const Eigen::VectorXd& x) const;

  Problem problem_;
  Rigid mount_reference_;
  std::shared_ptr<const Unknowns> current_;
  std::vector<Entry> entries_;
  std::size_t count_ = 0;  // of all observations
  std::size_t next_ = 0;   // the entry that was linearised longest ago
  std::size_t per_step_;
  Eigen::MatrixXd information_, middle_;
  Eigen::VectorXd right_;  // sum of gradient + H x
  double cost_ = 0;
  int rows_ = 0;
};

}  // namespace handsight
