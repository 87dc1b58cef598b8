// SPDX-License-Identifier: Apache-2.0
// What the measurements say of functions of the observation that act at one site of the chain: a joint's angle, the
// hand, the mount.
#pragma once

#include "diagnosis/evidence/evidence.h"

namespace handsight {

enum class EmpiricalErrorSite { joint, tcp, mount };

/// A site of the chain and what the measurements say of its directions, whitened; a row an observation.
struct CurveSite {
  EmpiricalErrorSite kind = EmpiricalErrorSite::joint;
  int joint = -1;                       // of the robot, where the site is a joint
  Eigen::VectorXd sizes;                // plausible, per direction: rad or m
  Eigen::MatrixXd information;          // the directions' information, column by column: observations x directions^2
  Eigen::MatrixXd gradient;             // observations x directions
  std::vector<Eigen::MatrixXd> shared;  // per direction, its share in the base: observations x base

  Eigen::Index directions() const { return sizes.size(); }
};

/// The hand, the mount, and every joint of the session that moves what is seen.
std::vector<CurveSite> curve_sites(const WhitenedModel& w, const Problem& problem);

/// The score of functions (observations x functions) at a site: parameters function by function, within each the
/// site's directions.
Score score_at(const WhitenedModel& w, const CurveSite& site, const Eigen::MatrixXd& values);

/// score_at() of each of several: together they take a fraction of the time.
std::vector<Score> scores_at(const WhitenedModel& w, const CurveSite& site,
                             const std::vector<const Eigen::MatrixXd*>& values);

}  // namespace handsight
