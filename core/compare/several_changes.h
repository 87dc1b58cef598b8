// SPDX-License-Identifier: Apache-2.0
// What may have changed between which of several sessions, and the evidence for it. Internal to
// several_comparison.cpp. Units and
// alternatives stand in several_changes.cpp, fits in several_fits.cpp, the evidence in several_ranking.cpp.
#pragma once

#include <map>

#include "compare/change_candidates.h"
#include "compare/change_normal.h"
#include "compare/several_sides.h"

namespace handsight {

/// One thing that sessions have in common and that may be another in some of them.
struct SeveralUnit {
  std::string group, where;      // ChangeUnit's
  std::vector<int> at;           // by side: into its change_units; -1: it has not got this
  std::vector<std::size_t> who;  // the sides that have it in common, two at least
};

/// The unit in these sides is another than in those before, or beside, them.
struct Alternative {
  std::size_t unit = 0;
  std::vector<char> in;  // by side
};

/// An alternative with its numbers, in units of their prior sigmas.
struct ActiveChange {
  std::size_t alternative = 0;
  Eigen::VectorXd change;
};

/// What was found of one alternative beside those that are taken.
struct FoundChange : ChangeFinding {
  Eigen::VectorXd change, sigma;  // prior sigmas; empty: it was not fitted in full
  double explained = 0;
};

struct SeveralRanking {
  std::vector<FoundChange> found;  // by alternative
  std::map<std::string, GroupEvidence> groups;
  double threshold = 0;
  LeftOver left;  // what even all changes together leave; p is 1 where it was not asked
};

/// Looks for changes one after another; those that were taken are fitted beside the next.
class SeveralComparer {
 public:
  explicit SeveralComparer(SeveralSides sides);

  /// Of every alternative beside those that are taken. `learns`: first the sizes of what the model lacks, and the
  /// scatter, from what all changes together leave.
  SeveralRanking rank(const std::vector<ActiveChange>& taken, bool learns);

  /// ln of the Bayes factor of each of these changes beside the others.
  std::vector<double> evidence_of_each(const std::vector<ActiveChange>& changes) const;

  /// The changes fitted together: their numbers and sigmas.
  struct Together {
    std::vector<ActiveChange> changes;
    std::vector<Eigen::VectorXd> sigmas;  // of each, in prior sigmas
    double squares = 0;
  };
  Together fitted_together(const std::vector<ActiveChange>& changes) const;

  const SeveralSides& sides() const { return sides_; }
  const std::vector<SeveralUnit>& units() const { return units_; }
  const std::vector<Alternative>& alternatives() const { return alternatives_; }
  /// The unit's terms in that side, with numbers from prior sigmas.
  std::vector<EffectTerm> list_terms(std::size_t side, std::size_t unit, const Eigen::VectorXd& change) const;
  /// One prior sigma of each of its numbers.
  Eigen::VectorXd list_sizes(std::size_t unit) const;
  const ChangeUnit& find_unit(std::size_t side, std::size_t unit) const;

 private:
  struct Fitted {
    SeveralState state;
    std::vector<ActiveChange> active;
    Eigen::MatrixXd information;
    double squares = 0;  // what the changes are held at left out
  };
  struct Linear;

  void list_units();
  void list_alternatives();
  Eigen::Index count_numbers(std::size_t unit) const;
  ChangeRows take_rows(std::size_t side, const SeveralState& state, const std::vector<EffectTerm>& terms) const;
  ScatteredNormal make_normal(const SeveralState& state, const std::vector<ActiveChange>& active) const;
  Fitted fitted(std::vector<ActiveChange> active) const;
  void linearise(const std::vector<ActiveChange>& taken);
  Linear make_linear(const std::vector<ActiveChange>& columns, bool with_repeatability) const;
  ScatteredNormal with_priors(ScatteredNormal normal, const std::vector<ActiveChange>& columns, std::size_t taken,
                              double scale_of_free) const;
  std::vector<ActiveChange> all_changes() const;
  void learn(SeveralRanking& ranking);
  void set_repeatability(const Linear& linear, const Eigen::VectorXd& step, double settled, SeveralRanking& ranking);
  std::vector<std::size_t> rank_linearly(const std::vector<ActiveChange>& taken, SeveralRanking& ranking);
  std::vector<std::size_t> worth_a_fit(const std::vector<std::size_t>& order, const SeveralRanking& ranking) const;
  void refit(std::size_t alternative, const std::vector<ActiveChange>& taken, double squares_without,
             SeveralRanking& ranking) const;

  SeveralSides sides_;
  SeveralState state_;
  std::vector<std::vector<ChangeUnit>> of_sides_;
  std::vector<SeveralUnit> units_;
  std::vector<Alternative> alternatives_;
  std::vector<ChangeRows> linear_;  // by side, with all of its units as changes
};

}  // namespace handsight
