// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/bent_robot.h"

namespace handsight::app {

std::vector<Rigid> bent_links(const ProblemSource& source, int observation, const std::vector<EffectTerm>& terms) {
  // What has come since the model was fitted it does not know: then the last that it knows.
  const auto last = source.states.size() - 1;
  const ObservationState& c = source.states[std::min(static_cast<std::size_t>(observation), last)];
  const Sites sites = moved_sites(c, terms);
  return solve_posture<double>(c.chain->robot, c.sensor, sites.robot, c.chain->gravity, false).root_from_link;
}

std::vector<EffectTerm> terms_with(const Problem& problem, const Eigen::VectorXd& values) {
  std::vector<EffectTerm> terms = problem.terms;
  for (Eigen::Index i = 0; i < std::min<Eigen::Index>(values.size(), problem.effect_count()); ++i) {
    const EffectColumn& column = problem.columns_of_effects[static_cast<std::size_t>(i)];
    terms[column.term].values[column.parameter] = values[i];
  }
  return terms;
}

}  // namespace handsight::app
