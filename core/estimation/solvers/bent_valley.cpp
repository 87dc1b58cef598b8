// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/bent_valley.h"

#include <algorithm>
#include <utility>

#include "estimation/solvers/unknown_steps.h"

namespace handsight {
namespace {

/// Far above the floor of a valley the next step leads down to it, farther on. It is damped: across the valley it goes
/// all the way, along it, where it would leave the floor again, hardly any.
bool lead_down(const Problem& problem, const ValleyStep& taken, const NormalAt& normal_at, Unknowns& next,
               NormalEquations& normal) {
  constexpr double most_risen = 10;  // times: from farther up no single step leads there
  constexpr double least_damping = 1e-5;
  if (!(normal.cost < most_risen * taken.cost_before)) return false;
  const Eigen::MatrixXd basis = step_basis(problem, next, taken.fixed_body);
  Unknowns there =
      stepped(problem, next,
              damped_step(by_steps(normal.information, basis, taken.fixed_body),
                          gradient_by_steps(normal, basis, taken.fixed_body), std::max(taken.damping, least_damping)),
              taken.fixed_body);
  NormalEquations normal_there = normal_at(there, true);
  if (!(normal_there.cost < taken.cost_before)) return false;
  next = std::move(there);
  normal = std::move(normal_there);
  return true;
}

/// A long step along the floor of a bent valley leaves it. Steps across it alone lead back: along it another one would
/// go as far again.
bool lead_back(const Problem& problem, const ValleyStep& taken, const NormalAt& normal_at, Unknowns& next,
               NormalEquations& normal) {
  constexpr double most_risen = 100;     // times
  constexpr double damping = 1e-4;       // of steps across the valley hardly any, of those along other wide ones much
  constexpr double worth_another = 0.3;  // of what the one before it left
  constexpr int most_steps = 2;
  Unknowns there = next;
  NormalEquations normal_there = normal;
  double most_cost = most_risen * taken.cost_before;
  for (int i = 0; i < most_steps && normal_there.cost < most_cost; ++i) {
    most_cost = worth_another * normal_there.cost;
    const Eigen::MatrixXd basis = step_basis(problem, there, taken.fixed_body);
    there = stepped(problem, there,
                    damped_step_across(taken.step, by_steps(normal_there.information, basis, taken.fixed_body),
                                       gradient_by_steps(normal_there, basis, taken.fixed_body), damping),
                    taken.fixed_body);
    normal_there = normal_at(there, true);
    if (!(normal_there.cost < taken.cost_before)) continue;
    next = std::move(there);
    normal = std::move(normal_there);
    return true;
  }
  return false;
}

}  // namespace

bool lead_to_floor(const Problem& problem, const ValleyStep& taken, const NormalAt& normal_at, Unknowns& next,
                   NormalEquations& normal) {
  constexpr double of_floor = 0.3;  // of the cost: along a valley's floor hardly any of it is to be gained
  return taken.promised < of_floor * taken.cost_before ? lead_back(problem, taken, normal_at, next, normal)
                                                       : lead_down(problem, taken, normal_at, next, normal);
}

}  // namespace handsight
