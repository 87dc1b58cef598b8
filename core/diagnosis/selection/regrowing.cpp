// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/regrowing.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "diagnosis/ranking/refitting.h"
#include "diagnosis/selection/begin_of_names.h"
#include "diagnosis/selection/cost_of_names.h"
#include "diagnosis/selection/diagnosed_model.h"
#include "diagnosis/selection/elsewhere.h"
#include "diagnosis/selection/model_changes.h"
#include "diagnosis/selection/pruning.h"
#include "diagnosis/selection/taken_over.h"
#include "diagnosis/verdict/explanation.h"
#include "estimation/fit/sure_fit.h"

namespace handsight {
namespace {

/// How many more models a walk may try; `others` that were tried do not count. Unless it is to be thorough, rows times
/// models are seconds.
int models_left(const ImprovementOptions& options, const Improvement& m, int others) {
  constexpr int most_rows = 10000;
  const int most = options.is_thorough ? options.most_models : most_rows / std::max(m.last.model.fit.rows, 1) + others;
  return std::min(most, options.most_models) - m.models;
}

/// The ids of a model's terms from `first` on.
std::vector<std::string> least_certain_first(const Diagnosis& model, std::size_t first,
                                             const InclusionProbabilities& certain) {
  std::map<std::string, double> probability;
  for (const InclusionProbability& n : certain.names) probability[n.id] = n.probability;
  std::vector<std::string> ids;
  const std::vector<EffectTerm>& all = model.model_options.estimated;
  for (std::size_t t = begin_of_names(all, first); t < all.size(); ++t)
    if (std::find(ids.begin(), ids.end(), all[t].id) == ids.end()) ids.push_back(all[t].id);
  const auto sure = [&](const std::string& id) {
    const auto told = probability.find(id);
    return told == probability.end() ? 1 : told->second;
  };
  std::stable_sort(ids.begin(), ids.end(),
                   [&](const std::string& a, const std::string& b) { return sure(a) < sure(b); });
  return ids;
}

std::set<std::string> ids_of(const Diagnosis& model, std::size_t first) {
  std::set<std::string> ids;
  const std::vector<EffectTerm>& all = model.model_options.estimated;
  for (std::size_t t = begin_of_names(all, first); t < all.size(); ++t) ids.insert(all[t].id);
  return ids;
}

/// ln of the odds of models of the same points against the one at which the search has ended.
class Odds {
 public:
  Odds(const Diagnosis& end, std::size_t first) : end_(end), first_(first), by_(noise_model(end.model.fit)) {
    FitOptions plain = end.model_options;
    plain.estimated.resize(first);
    plain.start.reset();
    set_quick(by_, plain);
    const Fit without = fit(end.model.session, plain);
    base_ = without.problem.effect_count();
    places_ = places_of_effects(all_candidates(without.problem));
    of_end_ = worth(end);
  }

  /// None where their points differ: something else was taken for an outlier.
  std::optional<double> of(const Diagnosis& other) const {
    if (has_no_answer(other.model.fit) || other.model.fit.rows != end_.model.fit.rows) return std::nullopt;
    return worth(other) - of_end_;
  }

 private:
  double worth(const Diagnosis& d) const {
    const std::vector<EffectTerm>& all = d.model_options.estimated;
    const std::vector<EffectTerm> names(all.begin() + static_cast<std::ptrdiff_t>(begin_of_names(all, first_)),
                                        all.end());
    return fit_evidence(d.model.fit, base_, by_).ln_evidence -
           cost_of_names(names, places_, InclusionProbabilities::cost_of_a_name);
  }

  const Diagnosis& end_;
  std::size_t first_;
  NoiseModel by_;
  Eigen::Index base_ = 0;
  std::map<std::string, int> places_;
  double of_end_ = 0;
};

std::vector<EffectTerm> terms_gone(const Diagnosis& from, const Diagnosis& to, std::size_t first) {
  const std::set<std::string> left = ids_of(to, first);
  std::vector<EffectTerm> gone = from.model_options.estimated;
  std::erase_if(gone, [&](const EffectTerm& t) { return left.contains(t.id); });
  return gone;
}

/// `gained`: ln of the odds of the other end. Where that has a large cause of the end in another name it is to predict
/// better.
bool stands_in_its_place(const std::optional<double>& gained, const Diagnosis& end, Diagnosis& other,
                         std::size_t first) {
  if (!gained || *gained < -clear_gain) return false;
  const bool is_other_name = is_taken_over(terms_gone(end, other, first), end.model.session, end.model_options,
                                           end.model.fit, other.model.fit);
  const double most =
      (*gained > clear_gain && !is_other_name ? as_good_as_reported : clearly_less) * held_out_error(end);
  return held_out_error(other) <= most && worse_elsewhere(end, other).empty();
}

/// Is nothing left but noise, or too little measured to say?
bool is_explained(const Diagnosis& end) {
  return (end.verdict == Verdict::adequate && !end.repeatability.is_any()) ||
         end.verdict == Verdict::too_few_observations || has_no_answer(end.model.fit);
}

/// Seeks ends other than that of a walk, and goes on from those that are better.
class Regrowth {
 public:
  Regrowth(const Session& session, const ImprovementOptions& options, ModelWalk& walk)
      : session_(session), options_(options), walk_(walk), first_(options.estimated.size()) {}

  void run() {
    const int before = walk_.so_far().models;
    take_names_found_without_what_is_given();
    tried_beside_ = walk_.so_far().models - before;
    while (is_open() && (took_an_end_without_a_name() || took_an_end_from_another_beginning())) {
    }
  }

 private:
  bool is_open() {
    const Improvement& m = walk_.so_far();
    if (m.stopped || is_out_of_models_) return false;
    return is_worth_seeking(m.last, first_) || (walk_.has_passed_over() && m.last.verdict == Verdict::adequate);
  }

  /// Terms that were given stay, and with them the search may have gone another way. Beside them the names are tried at
  /// which it ends without.
  void take_names_found_without_what_is_given() {
    const Improvement& m = walk_.so_far();
    const auto models = [&] { return options_.most_models - m.models; };
    if (m.stopped || options_.estimated.empty() || is_explained(m.last) || models() <= 0) return;
    ImprovementOptions own = options_;
    own.estimated.clear();
    ModelWalk alone(session_, quiet(own, models()));
    alone.begin();
    alone.run();
    if (!has_ended(alone.so_far()) || models() <= 0) return;
    std::vector<EffectTerm> terms = options_.estimated;
    for (const EffectTerm& t : alone.so_far().last.model_options.estimated)
      if (std::none_of(terms.begin(), terms.end(), [&](const EffectTerm& g) { return is_same_place(g, t); }))
        terms.push_back(t);
    if (terms.size() == options_.estimated.size()) return;
    const auto begin = [&](ModelWalk& other) {
      other.begin_at(diagnosed_from(session_, quiet(options_, models()), terms, std::nullopt));
      other.so_far().models = 1;
    };
    took_the_end_within(models(), options_, begin, left_to_begin());
  }

  bool took_an_end_without_a_name() {
    const std::vector<std::string> ids = least_certain_first(walk_.so_far().last, first_, walk_.certain());
    if (ids.size() < 2) return false;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const auto begin = [&](ModelWalk& other) { other.begin_without(ids[i], walk_.so_far().last); };
      if (took_the_end_of(options_, begin, ids.size() - i + left_to_begin())) return true;
      if (!is_open()) return false;
    }
    return false;
  }

  std::size_t left_to_begin() const {
    constexpr std::size_t usual = 12;
    return beginnings_ ? beginnings_->size() - begun_ : usual;
  }

  /// A name that says little alone may say much beside others, and stays to the end of its walk. Each is tried once.
  bool took_an_end_from_another_beginning() {
    if (!beginnings_) list_beginnings();
    while (begun_ < beginnings_->size() && is_open()) {
      const std::vector<EffectTerm>& terms = (*beginnings_)[begun_++];
      if (ids_of(walk_.so_far().last, first_).contains(terms.front().id)) continue;
      ImprovementOptions own = options_;
      own.estimated.insert(own.estimated.end(), terms.begin(), terms.end());
      if (took_the_end_of(
              own, [](ModelWalk& other) { other.begin(); }, left_to_begin() + 1))
        return true;
    }
    return false;
  }

  /// The names that the session's own model may lack.
  void list_beginnings() {
    beginnings_.emplace();
    Improvement& m = walk_.so_far();
    if (is_without_models()) return;
    ImprovementOptions own = options_;
    own.with_held_out = false;
    own.on_progress = [&](double) { return goes_on(); };
    const Diagnosis plain = diagnosed(session_, own);
    ++m.models;
    m.stopped = plain.stopped;
    for (const DiagnosisCandidate& c : plain.candidates)
      if (!c.unnamed && c.ln_bayes_factor > 0) beginnings_->push_back(c.terms);
  }

  bool is_without_models() {
    Improvement& m = walk_.so_far();
    if (models_left(options_, m, tried_beside_) > 0) return false;
    is_out_of_models_ = true;
    m.is_budget_spent = m.is_budget_spent || options_.is_thorough;
    return true;
  }

  /// What is done at once is nearly done.
  bool goes_on() const {
    return !options_.on_progress || options_.on_progress(options_.is_thorough ? done_ : nearly_all);
  }

  /// Of a walk beside.
  ImprovementOptions quiet(ImprovementOptions own, int most_models) const {
    own.on_step = {};
    own.on_progress = [this](double) { return goes_on(); };
    own.most_models = most_models;
    return own;
  }

  /// Counts the models of another walk; false where that was stopped.
  bool has_ended(const Improvement& other) {
    Improvement& m = walk_.so_far();
    m.models += other.models;
    m.stopped = other.stopped;
    return !m.stopped;
  }

  /// Of another walk, where that is better. `left`: walks that may be left with it, should none be better.
  bool took_the_end_of(const ImprovementOptions& own, const std::function<void(ModelWalk&)>& begin, std::size_t left) {
    if (is_without_models()) return false;
    return took_the_end_within(models_left(options_, walk_.so_far(), tried_beside_), own, begin, left);
  }

  bool took_the_end_within(int most_models, const ImprovementOptions& own, const std::function<void(ModelWalk&)>& begin,
                           std::size_t left) {
    Improvement& m = walk_.so_far();
    ModelWalk other(session_, quiet(own, most_models));
    begin(other);
    other.run();
    done_ += (1 - done_) / static_cast<double>(left + 1);
    Improvement& end = other.so_far();
    if (!has_ended(end)) return false;
    if (!odds_) odds_.emplace(m.last, first_);
    if (!stands_in_its_place(odds_->of(end.last), m.last, end.last, first_)) return false;
    odds_.reset();
    walk_.take(std::move(other));
    m.stopped = options_.on_step && !options_.on_step(m.steps.back());
    return true;
  }

  const Session& session_;
  const ImprovementOptions& options_;
  ModelWalk& walk_;
  std::size_t first_;  // term that was added
  std::optional<std::vector<std::vector<EffectTerm>>> beginnings_;
  std::size_t begun_ = 0;
  int tried_beside_ = 0;      // models for which there is no budget but that of all
  std::optional<Odds> odds_;  // against the end where the walk stands
  bool is_out_of_models_ = false;
  static constexpr double nearly_all = 0.98;
  double done_ = 0;  // of the walks
};

}  // namespace

bool is_worth_seeking(const Diagnosis& end, std::size_t first) {
  const std::vector<EffectTerm>& all = end.model_options.estimated;
  return !is_explained(end) && all.size() > begin_of_names(all, first);
}

void regrow(const Session& session, const ImprovementOptions& options, ModelWalk& walk) {
  Regrowth(session, options, walk).run();
}

}  // namespace handsight
