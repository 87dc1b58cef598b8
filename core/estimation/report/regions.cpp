// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/regions.h"

#include <algorithm>
#include <numeric>

namespace handsight {
namespace {

constexpr double same_place = 5e-3;  // rad or m
constexpr Eigen::Index most_regions = 5;
constexpr int most_rounds = 100;

/// The measured joints of every observation, a row each.
Eigen::MatrixXd joint_values(const Problem& problem) {
  const std::vector<int>& joints = problem.source->chain.joints;
  Eigen::MatrixXd values(problem.observations.size(), joints.size());
  for (std::size_t i = 0; i < problem.observations.size(); ++i) {
    const auto index = static_cast<std::size_t>(problem.observations[i].index);
    const Eigen::VectorXd& all = problem.source->states[index].sensor;
    for (std::size_t j = 0; j < joints.size(); ++j)
      values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = all[static_cast<Eigen::Index>(joints[j])];
  }
  return values;
}

/// Each column from 0 to 1; one that does not vary is 0.
void scale_to_range(Eigen::Ref<Eigen::MatrixXd> columns) {
  for (auto column : columns.colwise()) {
    const double least = column.minCoeff(), range = column.maxCoeff() - least;
    if (range > 0)
      column = (column.array() - least) / range;
    else
      column.setZero();
  }
}

/// The row that is farthest from its nearest centre.
Eigen::Index farthest_row(const Eigen::MatrixXd& features, const Eigen::MatrixXd& centres) {
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(features.rows(), 1e300);
  for (const auto& centre : centres.rowwise())
    nearest = nearest.cwiseMin((features.rowwise() - centre).rowwise().squaredNorm());
  Eigen::Index farthest = 0;
  nearest.maxCoeff(&farthest);
  return farthest;
}

Eigen::MatrixXd first_centres(const Eigen::MatrixXd& features) {
  Eigen::MatrixXd centres = features.colwise().mean();
  centres.row(0) = features.row(farthest_row(features, centres));
  while (centres.rows() < std::min(most_regions, features.rows())) {
    const Eigen::RowVectorXd next = features.row(farthest_row(features, centres));
    centres.conservativeResize(centres.rows() + 1, Eigen::NoChange);
    centres.bottomRows<1>() = next;
  }
  return centres;
}

std::vector<int> nearest_centres(const Eigen::MatrixXd& features, const Eigen::MatrixXd& centres) {
  std::vector<int> nearest(static_cast<std::size_t>(features.rows()), 0);
  for (Eigen::Index i = 0; i < features.rows(); ++i) {
    Eigen::Index k = 0;
    (centres.rowwise() - features.row(i)).rowwise().squaredNorm().minCoeff(&k);
    nearest[static_cast<std::size_t>(i)] = static_cast<int>(k);
  }
  return nearest;
}

void move_to_means(const Eigen::MatrixXd& features, const std::vector<int>& nearest, Eigen::MatrixXd& centres) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(centres.rows(), centres.cols());
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(centres.rows());
  for (Eigen::Index i = 0; i < features.rows(); ++i) {
    const int k = nearest[static_cast<std::size_t>(i)];
    sums.row(k) += features.row(i);
    counts[k] += 1;
  }
  for (Eigen::Index k = 0; k < centres.rows(); ++k)
    if (counts[k] > 0) centres.row(k) = sums.row(k) / counts[k];
}

}  // namespace

std::vector<int> first_of_same_pose(const Problem& problem) {
  std::vector<int> first(problem.observations.size());
  std::iota(first.begin(), first.end(), 0);
  const Eigen::MatrixXd q = joint_values(problem);
  if (q.cols() == 0 || problem.source->chain.robot.is_of_poses) return first;
  std::vector<int> order = first;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return q(a, 0) < q(b, 0); });
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a + 1; b < order.size() && q(order[b], 0) - q(order[a], 0) < same_place; ++b) {
      if (!((q.row(order[a]) - q.row(order[b])).cwiseAbs().maxCoeff() < same_place)) continue;
      const auto [earlier, later] = std::minmax(order[a], order[b]);
      first[static_cast<std::size_t>(later)] =
          std::min(first[static_cast<std::size_t>(later)], first[static_cast<std::size_t>(earlier)]);
    }
  return first;
}

Eigen::MatrixXd posture_features(const Problem& problem) {
  const Eigen::MatrixXd joints = joint_values(problem);
  Eigen::MatrixXd features(joints.rows(), joints.cols() + 3);
  features.leftCols(joints.cols()) = joints;
  for (Eigen::Index i = 0; i < features.rows(); ++i) {
    // The nominal robot's: no effect of the model moves an observation to another region.
    const auto index = static_cast<std::size_t>(problem.observations[static_cast<std::size_t>(i)].index);
    features.row(i).tail<3>() =
        nominal_tcp(*problem.source->states[index].chain, problem.source->states[index].sensor).transpose();
  }
  scale_to_range(features);
  return features;
}

namespace {

std::vector<int> clusters_of(const Eigen::MatrixXd& features) {
  Eigen::MatrixXd centres = first_centres(features);
  std::vector<int> regions = nearest_centres(features, centres);
  for (int round = 0; round < most_rounds; ++round) {
    move_to_means(features, regions, centres);
    std::vector<int> next = nearest_centres(features, centres);
    if (next == regions) break;
    regions = std::move(next);
  }
  return regions;
}

}  // namespace

std::vector<int> list_regions(const Problem& problem) {
  if (problem.observations.empty()) return {};
  const Eigen::MatrixXd features = posture_features(problem);
  if (problem.source->chain.parts.empty()) return clusters_of(features);
  // A region is one of its own session: mount and body of a session that is left out as a whole would be told by
  // none.
  std::vector<int> regions(problem.observations.size(), 0);
  for (const Chain& part : problem.source->chain.parts) {
    std::vector<Eigen::Index> rows;
    for (std::size_t i = 0; i < problem.observations.size(); ++i) {
      const auto index = static_cast<std::size_t>(problem.observations[i].index);
      if (problem.source->states[index].chain->part == part.part) rows.push_back(static_cast<Eigen::Index>(i));
    }
    if (rows.empty()) continue;
    Eigen::MatrixXd own = features(rows, Eigen::all);
    scale_to_range(own);
    const std::vector<int> clusters = clusters_of(own);
    for (std::size_t i = 0; i < rows.size(); ++i) regions[static_cast<std::size_t>(rows[i])] = clusters[i];
  }
  return regions;
}

}  // namespace handsight
