// SPDX-License-Identifier: Apache-2.0
// A calibration against a few new poses, or against another calibration.
#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.h"
#include "base/text.h"
#include "compare/calibrated_sides.h"
#include "compare/change_verdict.h"
#include "compare/comparison.h"
#include "compare/number_changes.h"

namespace handsight {
namespace {

/// Poses anywhere within the middle of the joints' limits.
std::vector<Eigen::VectorXd> poses_within_limits(const Chain& chain, int count) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-0.8, 0.8);
  std::vector<Eigen::VectorXd> poses;
  for (int i = 0; i < count; ++i) {
    Eigen::VectorXd& q = poses.emplace_back(static_cast<Eigen::Index>(chain.joints.size()));
    for (std::size_t j = 0; j < chain.joints.size(); ++j) {
      const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[j])];
      const double low = std::max(joint.lower, -3.0), high = std::min(joint.upper, 3.0);
      q[static_cast<Eigen::Index>(j)] = 0.5 * (low + high) + 0.5 * (high - low) * uniform(random);
    }
  }
  return poses;
}

std::vector<NumberChange> list_numbers(const CalibratedRobot& before, const CalibratedRobot& after) {
  std::vector<NumberChange> numbers;
  add_motion(numbers, "tcp_from_body", before.model.tcp_from_body, after.model.tcp_from_body,
             before.calibration.tcp_from_body.covariance + after.calibration.tcp_from_body.covariance);
  if (before.calibration.mount_from_sensor && after.calibration.mount_from_sensor)
    add_motion(numbers, "mount_from_sensor", before.calibration.mount_from_sensor->motion,
               after.calibration.mount_from_sensor->motion,
               before.calibration.mount_from_sensor->covariance + after.calibration.mount_from_sensor->covariance);
  const auto variances = [](const CalibratedRobot& r) -> Eigen::VectorXd {
    return r.model.covariance.diagonal().tail(r.model.covariance.cols() - 6);
  };
  add_effects(numbers, before.chain.robot, before.model.effects, variances(before), after.model.effects,
              variances(after));
  return numbers;
}

}  // namespace

std::vector<CalibrationResidual> compute_residuals(const CalibratedRobot& before, const Session& after) {
  const Session session = as_calibrated(before, after);
  const ComparedSides sides = make_sides(before, session, make_chain(session));
  const Problem& problem = sides.after.problem;
  std::vector<CalibrationResidual> all;
  for (const CornerResidual& c : corner_residuals(problem, sides.start))
    all.push_back({problem.observations[static_cast<std::size_t>(c.place)].index, c});
  return all;
}

Comparison compare(const CalibratedRobot& before, const Session& after, const ComparisonProgress& progress) {
  const Session session = as_calibrated(before, after);
  const Chain chain = make_chain(session);
  Comparison c;
  ComparedSides sides = make_sides(before, session, chain);
  sides.progress = progress;
  keep_going(progress, 0.2);
  judge(sides, c);
  measure_hand(chain, used_positions(session), before.model.effects, before.model.tcp_from_body, c);
  return c;
}

Comparison compare(const CalibratedRobot& before, const CalibratedRobot& after) {
  if (before.tcp != after.tcp || before.joint_names != after.joint_names)
    throw InputError("The calibrations are of other links or joints; name two of one robot.");
  Comparison c;
  c.numbers = list_numbers(before, after);
  constexpr int poses = 200;
  double sum = 0, largest = 0;
  for (const Eigen::VectorXd& q : poses_within_limits(before.chain, poses)) {
    const auto body = [&](const CalibratedRobot& r) {
      return predict_tcp(r.chain, q, r.model).root_from_body_est.translation;
    };
    const double way = (body(after) - body(before)).norm();
    sum += way / poses;
    largest = std::max(largest, way);
  }
  c.hand_mean_m = sum;
  c.hand_max_m = largest;
  double most = 0;
  for (const NumberChange& n : c.numbers) {
    if (std::abs(n.in_sigmas()) <= most) continue;
    most = std::abs(n.in_sigmas());
    c.sentence = message(
        "Most of all {} has changed, by {:.1f} of its sigma; the marker body is {:.2f} mm from where it "
        "was (mean over {} poses).",
        n.name, most, 1e3 * sum, poses);
  }
  // Of many numbers the largest is beyond 3.5 sigma once in a hundred times by chance.
  c.verdict = most > 4 ? ComparisonVerdict::changed : ComparisonVerdict::unchanged;
  if (c.verdict == ComparisonVerdict::unchanged)
    c.sentence = message(
        "No number differs by more than {:.1f} of its sigma; the marker body is {:.2f} mm from where it "
        "was (mean over {} poses).",
        most, 1e3 * sum, poses);
  c.notes.emplace_back("Two calibrations tell which numbers differ, not why; compare the sessions for what changed.");
  return c;
}

}  // namespace handsight
