// SPDX-License-Identifier: Apache-2.0
// How much a change explains, and what chance explains. Internal to comparison.cpp.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace handsight {

/// ln of the mean Bayes factor over plausible scales of a change, by what the data say of its numbers (in plausible
/// sizes).
double change_evidence(const Eigen::Ref<const Eigen::MatrixXd>& information,
                       const Eigen::Ref<const Eigen::VectorXd>& gradient);

/// The same where the change was fitted: at these values it took away `gained` of chi-squared.
double change_evidence_at(const Eigen::MatrixXd& information, const Eigen::VectorXd& values, double gained);

/// Columns of one place at which a change may sit; places of one group count as one alternative.
struct ChangePlace {
  std::string group;
  Eigen::Index first = 0, count = 0;
};

/// What the best of all groups reaches once in 200 times by noise alone, and no less than 6. `information`: of all
/// changes together.
double change_threshold(const Eigen::MatrixXd& information, const std::vector<ChangePlace>& places);

}  // namespace handsight
