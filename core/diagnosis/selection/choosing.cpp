// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/choosing.h"

#include <algorithm>
#include <map>
#include <set>

#include "estimation/fit/sure_fit.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/mean_error.h"
#include "estimation/report/regions.h"
#include "session/sample.h"

namespace handsight {

bool are_few_to_choose_by(const Fit& fit) {
  constexpr std::size_t few = 40;
  const std::vector<int> same_pose = first_of_same_pose(fit.problem);
  return std::set<int>(same_pose.begin(), same_pose.end()).size() <= few;
}

bool is_cheap_to_choose(const Fit& fit, int models) {
  constexpr int most_rows = 8000;  // of all models together: a few seconds
  return fit.rows <= most_rows / std::max(models, 1);
}

std::optional<ErrorSummary> error_with_choosing(const Session& session, const Fit& chosen,
                                                const std::function<std::optional<Fit>(const Session& part)>& choose) {
  const std::vector<int> same_pose = first_of_same_pose(chosen.problem);
  std::map<int, std::set<int>> folds;
  for (std::size_t i = 0; i < same_pose.size(); ++i)
    folds[fold_of(same_pose[i])].insert(chosen.problem.observations[i].index);
  if (folds.size() < 2) return std::nullopt;
  MeanError mean;
  for (const auto& [fold, left] : folds) {
    std::vector<int> kept;
    for (const ProblemObservation& o : chosen.problem.observations)
      if (!left.contains(o.index)) kept.push_back(o.index);
    const std::optional<Fit> fit = choose(take_part(session, kept));
    if (!fit || has_no_answer(*fit)) return std::nullopt;
    mean.add(error_on(take_part(session, {left.begin(), left.end()}), *fit), static_cast<double>(left.size()));
  }
  return mean.all();
}

}  // namespace handsight
