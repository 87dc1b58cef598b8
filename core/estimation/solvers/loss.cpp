// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/loss.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "chain/sighting.h"
#include "estimation/solvers/normal_equations.h"

namespace handsight {

double tuning_constant(int rows) {
  constexpr double lengths[] = {2.45, 2.45, 2.45, 2.80, 3.08, 3.33, 3.55, 3.75, 3.94,
                                4.11, 4.28, 4.44, 4.59, 4.73, 4.87, 5.00, 5.13};
  return lengths[std::clamp(rows, 0, static_cast<int>(std::size(lengths)) - 1)];
}

LossValue loss_at(Loss loss, double squared_length, int rows, double noise) {
  if (loss == Loss::none || rows == 0) return {1, squared_length, 0};
  const double limit = tuning_constant(rows) * noise;
  const double length = std::sqrt(squared_length);
  if (loss == Loss::huber) {
    if (length <= limit) return {1, squared_length, 0};
    return {limit / length, 2 * limit * length - limit * limit, -limit / (2 * squared_length * length)};
  }
  const double ratio = squared_length / (limit * limit);
  const double weight = 1 / (1 + ratio);
  return {weight, limit * limit * std::log1p(ratio), -weight * weight / (limit * limit)};
}

NormalEquations weighted_normal_equations(Problem& problem, const Unknowns& unknowns, Loss loss, double noise) {
  if (loss == Loss::none) return normal_equations(problem, unknowns);
  double cost = 0;
  for (ProblemObservation& o : problem.observations) {
    const Rigid sensor_from_tcp = sensor_from_tcp_at(o, unknowns);
    o.weights.resize(o.sightings.size());
    for (std::size_t i = 0; i < o.sightings.size(); ++i) {
      const Vector3 x = sensor_from_tcp * marker_at(o, unknowns, o.sightings[i].marker);
      const SightingNormal n = sighting_normal(problem.rig_or_null(), o.sightings[i], x);
      const LossValue value = loss_at(loss, n.cost, n.rows, noise);
      o.weights[i] = value.weight;
      cost += value.cost;
    }
  }
  NormalEquations normal = normal_equations(problem, unknowns);
  normal.cost = cost + normal.prior_cost;
  return normal;
}

}  // namespace handsight
