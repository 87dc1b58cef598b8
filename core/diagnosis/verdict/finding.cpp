// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/finding.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

double& share_of_what_moves(const Problem& problem, const std::vector<EffectTerm>& terms,
                            ErrorAttribution& attribution) {
  const std::vector<ObservationState>& all = problem.source->states;
  const std::size_t every = all.size() / 100 + 1;  // a slip begins somewhere on the way
  for (std::size_t i = 0; i < all.size(); i += every) {
    const Sites s = moved_sites(all[i], terms);
    const bool moves_cameras =
        std::any_of(s.cameras.begin(), s.cameras.end(), [](const CameraChange& c) { return !c.is_zero(); });
    if (moves_cameras || !s.mount.isZero() || !s.drift.isZero()) return attribution.cameras;
    const bool moves_markers =
        std::any_of(s.markers.begin(), s.markers.end(), [](const auto& m) { return !m.isZero(); });
    if (moves_markers || !s.body.isZero()) return attribution.body;
  }
  return attribution.robot;
}

std::size_t count_of_numbers(const DiagnosisCandidate& c) {
  std::size_t count = 0;
  for (const EffectTerm& t : c.terms) count += t.values.size();
  return count;
}

}  // namespace

std::string find_id(const DiagnosisCandidate& c) {
  if (!c.unnamed) return c.id;
  return c.terms.empty() ? std::string() : c.terms.front().id;
}

bool can_be_added(const DiagnosisCandidate& c) { return !c.terms.empty() && (!c.unnamed || c.refitted); }

bool pushes_back(const std::vector<EffectTerm>& terms, const std::vector<std::vector<double>>& sigmas) {
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const Effect& effect = term_effect(terms[t]);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      const std::string& name = effect.parameters[p].name;
      const bool is_spring = name == "compliance" || name == "xx" || name == "yy";
      if (!is_spring || effect.parameters[p].unit != "rad/(N m)") continue;
      const double sigma = t < sigmas.size() && p < sigmas[t].size() ? sigmas[t][p] : 0;
      if (terms[t].values[p] < -2 * sigma) return true;
    }
  }
  return false;
}

Disbelief find_disbelief(const DiagnosisCandidate& c) {
  constexpr double nearly_all = 0.9;  // of what the model misses
  if (pushes_back(c.terms, c.sigmas)) return Disbelief::pushes_back;
  if (c.plausible) return Disbelief::none;
  if (c.too_large) return Disbelief::too_large;
  const bool leaves_little = c.explained.value_or(1) >= nearly_all || c.ln_of_small.value_or(0) > 0;
  return leaves_little ? Disbelief::none : Disbelief::leaves_much;
}

bool may_stand_in(const DiagnosisCandidate& best, const DiagnosisCandidate& c) {
  return best.unnamed || (!best.plausible && 2 * count_of_numbers(c) <= count_of_numbers(best));
}

bool is_likelier_beside_small(const DiagnosisCandidate& best, const DiagnosisCandidate& c) {
  return best.ln_of_small && c.ln_of_small &&
         c.ln_bayes_factor + *c.ln_of_small >= best.ln_bayes_factor + *best.ln_of_small;
}

/// A curve follows chance too: odds below 20 do not set it before a name that explains most of the same.
static bool is_name_for(const DiagnosisCandidate& curve, const DiagnosisCandidate& c) {
  constexpr double most = 0.8;  // of what is explained, where that is known
  const double lead = curve.ln_bayes_factor - c.ln_bayes_factor;
  return curve.unnamed && is_believable(c) && lead < std::log(20) &&
         c.explained.value_or(0) >= most * curve.explained.value_or(c.explained ? 1 : 0);
}

bool comes_before(const DiagnosisCandidate& c, const DiagnosisCandidate& best) {
  constexpr double about_as_much = 0.5;  // of the evidence
  constexpr double nearly = 0.99;        // of what is explained
  if (&c == &best || c.unnamed || !c.refitted) return false;
  const bool is_of_target = c.id == "target_scale" || c.id == "target_bend";
  if (is_of_target && c.plausible && c.ln_bayes_factor > about_as_much * best.ln_bayes_factor) return true;
  if (is_name_for(best, c)) return true;
  if (!may_stand_in(best, c)) return false;
  return is_likelier_beside_small(best, c) || c.explained.value_or(0) >= nearly * best.explained.value_or(1);
}

/// Of the best one's evidence: what is believable and explains less is no rival of what is only large.
static constexpr double as_good_a_reason = 0.5;

std::vector<std::size_t> offered(const Diagnosis& d, const std::set<std::string>& refused) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < d.candidates.size(); ++i)
    if (can_be_added(d.candidates[i]) && d.candidates[i].ln_bayes_factor >= d.threshold) order.push_back(i);
  const auto rank = [&](std::size_t i) {
    const DiagnosisCandidate& c = d.candidates[i];
    if (refused.contains(find_id(c))) return 3;
    if (comes_before(c, d.candidates.front())) return 0;
    return is_believable(c) && c.ln_bayes_factor >= as_good_a_reason * d.candidates.front().ln_bayes_factor ? 1 : 2;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return order;
}

const DiagnosisCandidate* finding_of(const Diagnosis& d, const std::set<std::string>& refused) {
  const std::vector<std::size_t> order = offered(d, refused);
  if (order.empty() || refused.contains(find_id(d.candidates[order.front()]))) return nullptr;
  return &d.candidates[order.front()];
}

std::vector<std::string> unseen_effects(const Diagnosis& d) {
  std::vector<std::string> unseen;
  for (const std::string& id : d.invisible) {
    const bool has_place = std::any_of(d.candidates.begin(), d.candidates.end(),
                                       [&](const DiagnosisCandidate& c) { return c.id == id && !c.unnamed; });
    const bool is_in_model = std::any_of(d.model.fit.effects.begin(), d.model.fit.effects.end(),
                                         [&](const FittedEffect& f) { return f.term.id == id; });
    if (has_place && !is_in_model) unseen.push_back(id);
  }
  return unseen;
}

ErrorAttribution attribution_by_finding(const ErrorAttribution& attribution, const Diagnosis& d,
                                        const std::set<std::string>& refused) {
  const DiagnosisCandidate* finding = finding_of(d, refused);
  if (attribution.cause == ErrorCause::none || !finding || !is_believable(*finding) || !finding->explained ||
      !d.model.fit.problem.source)
    return attribution;
  const double share = std::clamp(*finding->explained, 0.0, 1.0);
  ErrorAttribution b = attribution;
  for (double* part : {&b.cameras, &b.body, &b.robot}) *part *= 1 - share;
  share_of_what_moves(d.model.fit.problem, finding->terms, b) += share;
  b.cause = b.robot >= std::max(b.cameras, b.body) ? ErrorCause::robot
            : b.body >= b.cameras                  ? ErrorCause::body
                                                   : ErrorCause::cameras;
  return b;
}

}  // namespace handsight
