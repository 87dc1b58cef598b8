// SPDX-License-Identifier: Apache-2.0
// The numbers of changes in normal equations, and what the linearised model says of them: for two sessions and for
// several alike. Apart stay the columns: two sessions, or a calibration and a session, share those of one problem; of
// several each has its own, with a map to those of all. Internal to comparison.cpp and several_comparison.cpp.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compare/change_rows.h"

namespace handsight {

/// Numbers of these terms that are no choices.
Eigen::Index count_numbers(const std::vector<EffectTerm>& terms);

/// The terms with these values as their numbers, choices left as they are.
std::vector<EffectTerm> with_numbers(std::vector<EffectTerm> terms, const Eigen::VectorXd& values);

/// The problem with these terms as changes behind its own effects, standing at `effects` (its own) and their values.
Problem with_changes(const Problem& problem, const std::vector<EffectTerm>& terms, const Eigen::VectorXd& effects);

/// A number at `value` that is held at `scale` of its sizes.
void add_prior(ScatteredNormal& n, Eigen::Index column, double value, double scale);

/// So that what nothing tells has an answer.
void stiffen(ScatteredNormal& n);

/// The covariance of the last so many numbers.
Eigen::MatrixXd last_covariance(const Eigen::MatrixXd& information, Eigen::Index count);

struct EvidenceAt {
  double evidence = 0, gained = 0;
};

/// Of a change that was fitted with this answer and covariance, by the squares with and without it. It was held at
/// change_scale; the prior of each scale is counted in the evidence.
EvidenceAt evidence_at(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& change, double squares_without,
                       double squares_with);

/// What of a change is known so far.
struct ChangeFinding {
  std::string group;         // ChangeUnit's
  Eigen::Index numbers = 0;  // how many it has
  double ln_bayes_factor = 0;
  bool is_visible = false;  // can these poses show it at all?
};

struct LinearRanking {
  std::vector<std::size_t> order;  // places in the list of those that can be seen, best first
  double threshold = 0;
};

/// Of changes whose columns are the last of a linearised model with priors, in their order, each by itself and freed of
/// what the columns before do as well: sets evidence and visibility.
LinearRanking rank_linearly(const ScatteredNormal& n, std::vector<ChangeFinding>& changes);

/// Of one thing, over all places and sessions where it may be.
struct GroupEvidence {
  double ln_bayes_factor = 0;  // the mean's
  std::size_t best = 0;        // place in the list
  std::size_t places = 0;      // how many there are
};
std::map<std::string, GroupEvidence> group_evidence(const std::vector<ChangeFinding>& changes);

}  // namespace handsight
