// SPDX-License-Identifier: Apache-2.0
#include "certify/workspace_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "certify/limits.h"
#include "certify/seen_hand.h"

namespace handsight {

std::vector<ExpectedError> expected_errors(const Chain& chain, const PredictionModel& model,
                                           const std::vector<Eigen::VectorXd>& positions, int count,
                                           std::uint64_t seed) {
  std::vector<ExpectedError> errors;
  if (positions.empty()) return errors;
  Eigen::VectorXd lowest = positions.front(), highest = lowest;
  for (const Eigen::VectorXd& p : positions) {
    lowest = lowest.cwiseMin(p);
    highest = highest.cwiseMax(p);
  }
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < count; ++i) {
    Eigen::VectorXd position = lowest;
    for (Eigen::Index j = 0; j < position.size(); ++j) position[j] += uniform(random) * (highest[j] - lowest[j]);
    const SeenHand hand = seen_hand(states_at(chain, position), model);
    errors.push_back({hand.nominal.translation, (hand.predicted.translation - hand.nominal.translation).norm(),
                      length_limit(hand.covariance, 0.95)});
  }
  return errors;
}

MapView map_view(const std::vector<ExpectedError>& errors, int across, int up, int cells_a_side) {
  const char* const names[] = {"x", "y", "z"};
  MapView view{names[across], names[up], 0, {}};
  if (errors.empty()) return view;
  Vector3 lowest = errors.front().hand, highest = lowest;
  for (const ExpectedError& e : errors) {
    lowest = lowest.cwiseMin(e.hand);
    highest = highest.cwiseMax(e.hand);
  }
  const Vector3 size = highest - lowest;
  view.cell = std::max({size[across], size[up], 1e-3}) / cells_a_side;
  std::map<std::pair<int, int>, MapCell> cells;
  for (const ExpectedError& e : errors) {
    const int column = static_cast<int>((e.hand[across] - lowest[across]) / view.cell);
    const int row = static_cast<int>((e.hand[up] - lowest[up]) / view.cell);
    MapCell& cell = cells[{column, row}];
    cell.across = lowest[across] + (column + 0.5) * view.cell;
    cell.up = lowest[up] + (row + 0.5) * view.cell;
    cell.before += e.before;
    cell.limit += e.limit;
    ++cell.poses;
  }
  for (auto& [place, cell] : cells) {
    cell.before /= cell.poses;
    cell.limit /= cell.poses;
    view.cells.push_back(cell);
  }
  return view;
}

}  // namespace handsight
