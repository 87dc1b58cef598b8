// SPDX-License-Identifier: Apache-2.0
#include "compare/several_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "compare/change_limits.h"
#include "compare/change_verdict.h"
#include "compare/several_changes.h"
#include "diagnosis/evidence/evidence.h"
#include "diagnosis/ranking/outlier_rejection.h"
#include "effects/own_effect.h"

namespace handsight {
namespace {

constexpr std::size_t most_changes = 8, most_alternatives = 6;
constexpr double least_likely = 0.01;

[[noreturn]] void refuse_pair(const JoinedMember& a, const JoinedMember& b, const char* what) {
  throw InputError(message("{} and {} cannot be compared: {}.", a.title, b.title, what));
}

void require_same_rig(const JoinedMember& a, const JoinedMember& b) {
  const Session &x = a.session, &y = b.session;
  if (x.is_tracker() != y.is_tracker()) refuse_pair(a, b, "one has cameras, the other a tracker");
  if (x.rig && camera_names(*x.rig) != camera_names(*y.rig)) refuse_pair(a, b, "their cameras have other names");
  if (x.mount.link != y.mount.link) refuse_pair(a, b, "their sensors sit on other links");
}

void require_same_body(const JoinedMember& a, const JoinedMember& b) {
  if (a.session.tcp != b.session.tcp) refuse_pair(a, b, "their TCPs are other links");
  if (a.session.marker_count != b.session.marker_count) refuse_pair(a, b, "they have other numbers of markers");
}

void require_comparable(const std::vector<JoinedMember>& members) {
  if (members.size() < 2) throw InputError("A comparison takes two sessions at least; name another one.");
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].session.is_touch())
      throw InputError(
          message("{}: a session of touches is compared with one other at a time; name two.", members[i].title));
    if (i > 0) require_same_robot(members.front().session, members[i].session);
    for (std::size_t j = 0; j < i; ++j) {
      if (!members[i].rig.empty() && members[i].rig == members[j].rig) require_same_rig(members[j], members[i]);
      if (!members[i].body.empty() && members[i].body == members[j].body) require_same_body(members[j], members[i]);
    }
  }
}

/// Where one session of a rig guesses its mount, all do.
void share_mounts(std::vector<JoinedMember>& members) {
  for (JoinedMember& m : members)
    for (const JoinedMember& other : members)
      if (!m.rig.empty() && m.rig == other.rig && other.session.mount.estimate) m.session.mount.estimate = true;
}

FitOptions options_for(const Session& session, const std::vector<std::string>& effects) {
  FitOptions options;
  const Chain chain = make_chain(session);
  const OwnEffects own = list_own_effects(session, chain);
  for (const std::string& text : effects)
    for (EffectTerm& t : effect_terms(text, chain, own)) options.estimated.push_back(std::move(t));
  return options;
}

/// Each session by itself, without what is wrong in it.
std::vector<Fit> fits_alone(std::vector<JoinedMember>& members, const std::vector<std::string>& effects,
                            const ComparisonProgress& progress, SeveralComparison& c) {
  std::vector<Fit> fits;
  for (JoinedMember& m : members) {
    keep_going(progress, 0.5 * static_cast<double>(fits.size()) / static_cast<double>(members.size()));
    FitOptions options = options_for(m.session, effects);
    if (progress) options.on_iteration = [&](int, double, const Unknowns&) { return progress(0); };
    CleanFit clean = fit_without_outliers(m.session, options);
    if (!clean.fit.converged())
      throw InputError(
          message("{} cannot be compared: its fit finds no answer; run `handsight-cli fit` on it, exclude the "
                  "observations that it says stand out, and compare again.",
                  m.title));
    if (!clean.lone.empty())
      c.notes.push_back(message("{}: {}", m.title, lone_text(clean.lone, m.session.is_tracker())));
    if (!clean.wrong.empty())
      c.notes.push_back(message("{}: {} single wrong points are left out.", m.title, clean.wrong.size()));
    m.session = std::move(clean.session);
    fits.push_back(std::move(clean.fit));
  }
  return fits;
}

/// Titles of members with the same name, in their order; those without a name by themselves.
std::vector<std::vector<std::string>> together(const std::vector<JoinedMember>& members,
                                               std::string JoinedMember::*name) {
  std::vector<std::vector<std::string>> all;
  std::vector<std::string> names;
  for (const JoinedMember& m : members) {
    const auto found = (m.*name).empty() ? names.end() : std::find(names.begin(), names.end(), m.*name);
    if (found == names.end()) {
      names.push_back(m.*name);
      all.push_back({m.title});
    } else {
      all[static_cast<std::size_t>(found - names.begin())].push_back(m.title);
    }
  }
  return all;
}

double ln_odds(const std::string& group, const GroupEvidence& e) { return e.ln_bayes_factor + ln_prior_odds(group); }

std::string best_group(const SeveralRanking& ranking) {
  const auto best = std::max_element(ranking.groups.begin(), ranking.groups.end(), [](const auto& a, const auto& b) {
    return ln_odds(a.first, a.second) < ln_odds(b.first, b.second);
  });
  return best == ranking.groups.end() ? "" : best->first;
}

/// What each alternative's odds are, ln, against nothing having changed: half of the prior is for nothing, the other
/// half is parted over the groups, and in each evenly over its alternatives. How large a change is plausible is only
/// known so well, and may not decide between two that explain the same: beside the evidence with those sizes stands, as
/// likely, that of a prior which tells as much as one measurement (Schwarz 1978).
class Odds {
 public:
  Odds(const SeveralComparer& comparer, const SeveralRanking& ranking) : comparer_(comparer), ranking_(ranking) {
    double weights = 0;
    for (const auto& [group, evidence] : ranking.groups) weights += std::exp(ln_prior_odds(group));
    ln_weights_ = std::log(std::max(weights, 1e-300));
    double points = 1;
    for (const SeveralSide& s : comparer.sides().sides)
      for (const ProblemObservation& o : s.problem.observations) points += static_cast<double>(o.sightings.size());
    ln_measured_ = std::log(points);
    for (std::size_t a = 0; a < ranking.found.size(); ++a)
      if (ranking.found[a].is_visible) most_ = std::max(most_, ln(a));
    sum_ = std::exp(-most_);
    for (std::size_t a = 0; a < ranking.found.size(); ++a)
      if (ranking.found[a].is_visible) sum_ += std::exp(ln(a) - most_);
  }

  double probability(std::size_t a) const { return ranking_.found[a].is_visible ? std::exp(ln(a) - most_) / sum_ : 0; }

  double of_group(const std::string& group) const {
    double sum = 0;
    for (std::size_t a = 0; a < ranking_.found.size(); ++a)
      if (name(a) == group) sum += probability(a);
    return sum;
  }

 private:
  const std::string& name(std::size_t a) const { return comparer_.units()[comparer_.alternatives()[a].unit].group; }
  double ln(std::size_t a) const {
    const GroupEvidence& group = ranking_.groups.at(name(a));
    const FoundChange& f = ranking_.found[a];
    std::array<double, 2> evidence{f.ln_bayes_factor, f.ln_bayes_factor};
    if (f.change.size() > 0) evidence[1] = 0.5 * (f.explained - static_cast<double>(f.change.size()) * ln_measured_);
    return ln_mean_exp(evidence) + ln_prior_odds(name(a)) - ln_weights_ - std::log(static_cast<double>(group.places));
  }

  const SeveralComparer& comparer_;
  const SeveralRanking& ranking_;
  double ln_weights_ = 0, ln_measured_ = 0, most_ = 0, sum_ = 1;
};

/// What was taken, and what was as likely when it was.
struct Taken {
  ActiveChange active;
  double ln_bayes_factor = 0, explained = 0;
  ChangeCandidate reported;
  std::vector<ChangeCandidate> alternatives;
};

class Judge {
 public:
  Judge(std::vector<JoinedMember> members, SeveralComparison& c) : members_(std::move(members)), c_(c) {}

  void decide(const SeveralSides& sides) {
    choose_width(sides);
    while (taken_.size() < most_changes) {
      const std::string best = best_group(ranking_);
      if (best.empty() || ln_odds(best, ranking_.groups.at(best)) < c_.threshold + (taken_.empty() ? 0 : ln_20)) break;
      take(likeliest(ranking_.groups.at(best).best));
      drop_needless();
      keep_going(comparer_->sides().progress, 0.7 + 0.25 * static_cast<double>(taken_.size()) / most_changes);
      ranking_ = comparer_->rank(active(), false);
    }
    tell();
  }

 private:
  /// The narrowest model that leaves no more than noise, else the widest.
  void choose_width(const SeveralSides& sides) {
    for (const Width width : {Width::reported, Width::catalogue, Width::catalogue_and_curves}) {
      keep_going(sides.progress, width == Width::reported ? 0.5 : width == Width::catalogue ? 0.55 : 0.6);
      comparer_.emplace(widened(sides, width));
      ranking_ = comparer_->rank({}, true);
      if (width == Width::reported) c_.model_fits = ranking_.left.p > model_misses;
      if (ranking_.left.p > in_model_uncertainty) break;
    }
    c_.threshold = ranking_.threshold;
  }

  std::vector<ActiveChange> active() const {
    std::vector<ActiveChange> all;
    for (const Taken& t : taken_) all.push_back(t.active);
    return all;
  }

  ChangeCandidate candidate(std::size_t a, double probability) const {
    const Alternative& alternative = comparer_->alternatives()[a];
    const SeveralUnit& unit = comparer_->units()[alternative.unit];
    ChangeCandidate reported{unit.group, unit.where, {}, {}, probability};
    for (const std::size_t k : unit.who)
      (alternative.in[k] ? reported.after : reported.before).push_back(members_[k].title);
    return reported;
  }

  /// Of all whose kind is no chance either.
  std::size_t likeliest(std::size_t best) const {
    const Odds odds(*comparer_, ranking_);
    const double least = c_.threshold + (taken_.empty() ? 0 : ln_20);
    for (std::size_t a = 0; a < ranking_.found.size(); ++a) {
      const std::string& group = comparer_->units()[comparer_->alternatives()[a].unit].group;
      if (!ranking_.found[a].is_visible || ln_odds(group, ranking_.groups.at(group)) < least) continue;
      if (odds.probability(a) > odds.probability(best)) best = a;
    }
    return best;
  }

  void take(std::size_t a) {
    const Odds odds(*comparer_, ranking_);
    const FoundChange& found = ranking_.found[a];
    Taken t;
    const Eigen::Index count = comparer_->list_sizes(comparer_->alternatives()[a].unit).size();
    t.active = {a, found.change.size() > 0 ? found.change : Eigen::VectorXd(Eigen::VectorXd::Zero(count))};
    t.ln_bayes_factor = found.ln_bayes_factor;
    t.explained = found.explained;
    t.reported = candidate(a, odds.probability(a));
    for (std::size_t other = 0; other < ranking_.found.size(); ++other)
      if (other != a && odds.probability(other) > least_likely)
        t.alternatives.push_back(candidate(other, odds.probability(other)));
    std::stable_sort(t.alternatives.begin(), t.alternatives.end(),
                     [](const auto& x, const auto& y) { return x.probability > y.probability; });
    if (t.alternatives.size() > most_alternatives) t.alternatives.resize(most_alternatives);
    taken_.push_back(std::move(t));
  }

  /// What only stood in for others that were taken after it goes.
  void drop_needless() {
    if (taken_.size() < 2) return;
    const std::vector<double> factors = comparer_->evidence_of_each(active());
    for (std::size_t i = taken_.size() - 1; i-- > 0;)
      if (factors[i] < c_.threshold) taken_.erase(taken_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  void tell() {
    const Odds odds(*comparer_, ranking_);
    for (const auto& [group, evidence] : ranking_.groups)
      c_.shared.push_back({group, odds.of_group(group), evidence.ln_bayes_factor});
    c_.verdict = taken_.empty()       ? ComparisonVerdict::unchanged
                 : taken_.size() == 1 ? ComparisonVerdict::changed
                                      : ComparisonVerdict::several;
    c_.sentence = "Nothing has changed that these poses show: cameras, hands and arms are the same in all sessions.";
    if (taken_.empty()) return;
    const SeveralComparer::Together fitted = comparer_->fitted_together(active());
    std::vector<Message> texts;
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      tell(taken_[i], fitted.changes[i].change, fitted.sigmas[i]);
      texts.push_back(c_.changes.back().text + ".");
    }
    c_.sentence = joined(texts, " ");
  }

  void tell(const Taken& t, const Eigen::VectorXd& change, const Eigen::VectorXd& sigma) {
    const Alternative& alternative = comparer_->alternatives()[t.active.alternative];
    const SeveralUnit& unit = comparer_->units()[alternative.unit];
    const std::size_t side = unit.who.front();
    const Chain& chain = comparer_->sides().sides[side].problem.source->chain;
    ChangeBetween& reported = c_.changes.emplace_back();
    reported.reported = t.reported;
    reported.alternatives = t.alternatives;
    reported.change.id = unit.group;
    if (!unit.where.empty()) reported.change.where = {unit.where};
    reported.change.terms = comparer_->list_terms(side, alternative.unit, change);
    reported.change.sigma = sigma.cwiseProduct(comparer_->list_sizes(alternative.unit));
    reported.change.units = list_number_units(reported.change.terms, chain.robot);
    reported.change.ln_bayes_factor = t.ln_bayes_factor;
    reported.change.explained = t.explained;
    reported.text = message("{}: between {} and {}",
                            change_text({unit.group, reported.change.terms, unit.where}, reported.change.terms,
                                        reported.change.sigma, chain),
                            joined(verbatim(reported.reported.before)), joined(verbatim(reported.reported.after)));
    set_hand(unit, side, reported);
  }

  void set_hand(const SeveralUnit& unit, std::size_t first, ChangeBetween& reported) const {
    const SeveralSide& side = comparer_->sides().sides[first];
    std::vector<Eigen::VectorXd> poses;
    for (const std::size_t k : unit.who)
      if (comparer_->sides().sides[k].hand == side.hand)
        for (const Eigen::VectorXd& q : used_positions(members_[k].session)) poses.push_back(q);
    const HandWay way =
        hand_way(side.problem.source->chain, poses, {}, reported.change.terms, side.problem.tcp_from_slip);
    reported.hand_mean_m = way.mean;
    reported.hand_max_m = way.largest;
  }

  std::vector<JoinedMember> members_;
  SeveralComparison& c_;
  std::optional<SeveralComparer> comparer_;
  SeveralRanking ranking_;
  std::vector<Taken> taken_;
};

}  // namespace

SeveralComparison compare(const std::vector<JoinedMember>& given, const std::vector<std::string>& effects,
                          const ComparisonProgress& progress) {
  require_comparable(given);
  std::vector<JoinedMember> members = given;
  share_mounts(members);
  SeveralComparison c;
  for (const JoinedMember& m : members) c.sessions.push_back(m.title);
  c.rigs = together(members, &JoinedMember::rig);
  c.bodies = together(members, &JoinedMember::body);
  const std::vector<Fit> fits = fits_alone(members, effects, progress, c);
  SeveralSides sides = several_sides(members, fits);
  sides.progress = progress;
  Judge(std::move(members), c).decide(sides);
  if (!c.model_fits)
    c.notes.emplace_back(
        "The model misses what the sessions measured. What the catalogue has and smooth curves of the joints' angles, "
        "the same in all, were fitted beside the changes; a change that looks like them is not seen.");
  return c;
}

}  // namespace handsight
