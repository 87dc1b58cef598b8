// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/conclusion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/evidence/lack_of_fit.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/ranking/refitting.h"
#include "diagnosis/selection/pruning.h"
#include "diagnosis/verdict/explanation.h"
#include "diagnosis/verdict/judging.h"
#include "estimation/fit/sure_fit.h"

namespace handsight {
namespace {

/// chi-squared over what noise leaves, of a model without its curves.
std::optional<double> excess_without_curves(const Diagnosis& d) {
  FitOptions o = d.model_options;
  std::erase_if(o.estimated, is_curve);
  o.start = estimate(d.model.fit);
  o.start->effects.resize(0);
  set_quick(noise_model(d.model.fit), o);
  const auto left = lack_of_fit(fit(d.model.session, o));
  return left ? std::optional(left->excess()) : std::nullopt;
}

void set_shares(std::optional<double> excess, Improvement& m) {
  const std::vector<EffectTerm>& terms = m.last.model_options.estimated;
  const bool has_curves = std::any_of(terms.begin(), terms.end(), is_curve);
  if (!excess || !m.last.excess || !(*excess > 0) || terms.empty()) return;
  const double left = std::clamp(*m.last.excess, 0.0, *excess);
  double middle = left;
  if (has_curves) {
    const auto without = excess_without_curves(m.last);
    if (!without) return;
    middle = std::clamp(*without, left, *excess);
  }
  m.named_share = (*excess - middle) / *excess;
  m.unnamed_share = (middle - left) / *excess;
}

enum class Told { names, unsure_names, curves, nothing };

Told told_as(const BillRow& row) {
  constexpr double likely = 0.5;
  if (row.is_small) return Told::nothing;
  if (row.unnamed) return Told::curves;
  return row.probability.value_or(1) < likely ? Told::unsure_names : Told::names;
}

Message worth_text(const std::vector<BillRow>& rows, Told which) {
  std::vector<Message> texts;
  for (const BillRow& row : rows) {
    if (told_as(row) != which) continue;
    const bool unnamed = row.unnamed;
    texts.push_back(message("{}{} ({:.3g} mm at the hand)", unnamed ? row.follows : row.id,
                            unnamed || row.where.empty() ? Message() : message(" at {}", listed(row.where)),
                            1e3 * row.hand_m));
  }
  return joined(texts, "; ");
}

Message refused_text(const std::vector<RefusedStep>& refused) {
  if (refused.empty()) return "";
  const RefusedStep& r = refused.front();
  return message(" {}{} passes by its evidence and was not taken: {}.", r.id,
                 r.where.empty() ? Message() : message(" ({})", listed(r.where)), r.reason);
}

Message no_answer_text(const Diagnosis& d) {
  return message(
      "The fit finds no answer: {}. What the model lacks cannot be told before; check mount, cameras, "
      "joints' order and labels.",
      d.model.fit.solution.normal.in_front
          ? message("it leaves {}, more than any robot explains", reported_error(d.report.fitted))
          : "a marker would lie behind a camera that saw it");
}

}  // namespace

void conclude(std::optional<double> excess, const std::vector<RefusedStep>& refused, Improvement& m) {
  Diagnosis& d = m.last;
  if (d.verdict == Verdict::too_few_observations) return;
  m.bill = make_bill(d.model.fit, &m.inclusion_probabilities);
  set_shares(excess, m);
  const bool is_refused = !d.candidates.empty() && std::any_of(refused.begin(), refused.end(), [&](const auto& r) {
    return r.id == d.candidates.front().id && d.candidates.front().ln_bayes_factor >= d.threshold;
  });
  // What was tried and not taken explains nothing, not a part either.
  const bool passes = d.verdict == Verdict::missing_effect || d.verdict == Verdict::ambiguous ||
                      (d.verdict == Verdict::unexplained && is_refused);
  if (passes) judge_what_is_left(noise_model(d.model.fit).knowledge.known, d);
  const Message curves = worth_text(m.bill, Told::curves), names = worth_text(m.bill, Told::names);
  const Message unsure = worth_text(m.bill, Told::unsure_names);
  if (!curves.empty()) {
    d.verdict = Verdict::unexplained;
    d.reason = message("{}{}{} Held out {}.", names.empty() ? Message() : message("Named: {}. ", names),
                       unsure.empty() ? Message() : message("In the model, though less likely than not: {}. ", unsure),
                       message("Without a name: {}{}", curves, curves.english().back() == '.' ? "" : "."),
                       reported_error(d.report.held_out));
  }
  if (passes) d.reason += refused_text(refused);
  if (has_no_answer(d.model.fit)) {
    d.verdict = Verdict::unexplained;
    d.reason = no_answer_text(d);
  }
}

}  // namespace handsight
