// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/forecast.h"

#include <algorithm>
#include <cmath>

namespace handsight {

Message forecast(const Session& session, const ExperimentModel& model, const Knowledge& known, const Reach& reach,
                 double seconds_a_pose) {
  constexpr int asked = 12;
  constexpr double usual_seconds = 20;
  if (!known.fit || known.used < 2) return {};
  PlanOptions options;
  options.count = asked;
  options.effects = model.held;
  options.estimated = model.estimated;
  options.pool = 300;
  options.may_take = [&](const Eigen::VectorXd& q) {
    return can_be_taken(reach, q) && is_well_seen(reach, *known.fit, q);
  };
  try {
    const Plan planned = plan(session, options);
    if (planned.poses.empty()) return {};
    const double seconds = seconds_a_pose > 0.1 ? seconds_a_pose : usual_seconds;
    const auto count = static_cast<int>(planned.poses.size());
    const int in_an_hour = std::clamp(static_cast<int>(3600 / seconds), 1, 1000);
    const auto size = [](const Vector6& sigma) { return sigma.head<3>().norm(); };
    // Each pose adds about as much information as the mean of those that were planned.
    const double before = size(planned.sigma_before), after = size(planned.poses.back().sigma);
    const double information = std::pow(before, -2), added = (std::pow(after, -2) - information) / count;
    const double then = 1 / std::sqrt(information + in_an_hour * std::max(added, 0.0));
    return message(
        "One more hour (about {} poses at {:.0f} s each) would bring the body's place on the hand from +-{:.2g} mm to "
        "+-{:.2g} mm, as the model has it.",
        in_an_hour, seconds, 1e3 * before, 1e3 * then);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace handsight
