// SPDX-License-Identifier: Apache-2.0
#include "comparison_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "json_values.h"

namespace handsight::cli {
namespace {

const char* verdict_name(ComparisonVerdict v) {
  return v == ComparisonVerdict::unchanged ? "unchanged" : v == ComparisonVerdict::changed ? "changed" : "several";
}

Json change_json(const Change& c) {
  Json parameters = Json::array();
  Eigen::Index s = 0;
  for (const EffectTerm& t : c.terms) {
    const Effect& effect = term_effect(t);
    for (std::size_t p = 0; p < t.values.size(); ++p) {
      if (effect.parameters[p].is_choice) continue;
      parameters.push_back({{"id", t.id},
                            {"name", effect.parameters[p].name},
                            {"value", number(t.values[p])},
                            {"sigma", s < c.sigma.size() ? number(c.sigma[s]) : Json(nullptr)},
                            {"unit", c.units[static_cast<std::size_t>(s)]}});
      ++s;
    }
  }
  return {{"id", c.id},
          {"where", c.where},
          {"ln_bayes_factor", number(c.ln_bayes_factor)},
          {"explained", number(c.explained)},
          {"parameters", parameters}};
}

}  // namespace

void print_comparison(const Output& output, const Comparison& c) {
  for (const Message& note : c.notes) Output::note(note);
  output.line(c.sentence);
  if (!c.changes.empty()) {
    output.line();
    output.line("what may have changed   ln Bayes factor   where");
    for (const Change& change : c.changes)
      output.line(fmt::format("{:<22} {:>16.1f}   {}", change.id, change.ln_bayes_factor,
                              change.where.empty() ? "" : change.where.front()));
    output.line(fmt::format("(what counts: above {:.1f})", c.threshold));
  }
  if (!c.numbers.empty()) {
    output.line();
    output.line("number                                  change        sigma   in sigmas");
    for (const NumberChange& n : c.numbers)
      output.line(fmt::format("{:<34} {:>11.4g} {:>12.3g} {:>11.1f}  {}", n.name, n.after - n.before, n.sigma,
                              n.in_sigmas(), n.unit));
  }
  if (c.hand_mean_m)
    output.line(
        fmt::format("\nThe hand is {:.3f} mm from where it was in the mean over these poses, at most {:.3f} mm.",
                    1e3 * *c.hand_mean_m, 1e3 * c.hand_max_m.value_or(0)));
}

Json comparison_json(const Comparison& c) {
  Json changes = Json::array(), numbers = Json::array();
  for (const Change& change : c.changes) changes.push_back(change_json(change));
  for (const NumberChange& n : c.numbers)
    numbers.push_back({{"name", n.name},
                       {"unit", n.unit},
                       {"before", number(n.before)},
                       {"after", number(n.after)},
                       {"sigma", number(n.sigma)},
                       {"in_sigmas", number(n.in_sigmas())}});
  return {{"verdict", verdict_name(c.verdict)},
          {"reason", c.sentence},
          {"changes", changes},
          {"cannot_be_told_from", c.indistinguishable_from},
          {"threshold", number(c.threshold)},
          {"numbers", numbers},
          {"hand_mean_m", number(c.hand_mean_m)},
          {"hand_max_m", number(c.hand_max_m)},
          {"model_fits", c.model_fits}};
}

namespace {

std::string sessions_text(const ChangeCandidate& c) {
  return fmt::format("{} | {}", fmt::join(c.before, ", "), fmt::join(c.after, ", "));
}

Json candidate_json(const ChangeCandidate& c) {
  return {{"id", c.id},
          {"where", c.where},
          {"before", c.before},
          {"after", c.after},
          {"probability", number(c.probability)}};
}

Json between_json(const ChangeBetween& c) {
  Json json = change_json(c.change);
  json["before"] = c.reported.before;
  json["after"] = c.reported.after;
  json["probability"] = number(c.reported.probability);
  json["text"] = c.text.english();
  json["alternatives"] = Json::array();
  for (const ChangeCandidate& other : c.alternatives) json["alternatives"].push_back(candidate_json(other));
  json["hand_mean_m"] = number(c.hand_mean_m);
  json["hand_max_m"] = number(c.hand_max_m);
  return json;
}

void print_change(const Output& output, const ChangeBetween& c) {
  const auto line = [&](const ChangeCandidate& x) {
    output.line(fmt::format("{:<22} {:<14} {:>6.1f} %   {}", x.id, x.where, 100 * x.probability, sessions_text(x)));
  };
  line(c.reported);
  for (const ChangeCandidate& other : c.alternatives) {
    ChangeCandidate shown = other;
    shown.id = "  or " + other.id;
    line(shown);
  }
}

}  // namespace

void print_comparison(const Output& output, const SeveralComparison& c) {
  for (const Message& note : c.notes) Output::note(note);
  output.line(c.sentence);
  if (!c.changes.empty()) {
    output.line();
    output.line("what has changed       where          likely    before | after");
    for (const ChangeBetween& change : c.changes) print_change(output, change);
    output.line();
    for (const ChangeBetween& change : c.changes)
      output.line(fmt::format("{}{} moves the hand by {:.3f} mm in the mean over these poses, at most {:.3f} mm.",
                              change.reported.id, change.reported.where.empty() ? "" : " of " + change.reported.where,
                              1e3 * change.hand_mean_m, 1e3 * change.hand_max_m));
  }
  output.line();
  output.line(c.changes.empty() ? "what is shared         changed with" : "what else is shared    changed with");
  for (const SharedThing& s : c.shared)
    output.line(fmt::format("{:<22} {:>10.2g} %", s.id, 100 * s.probability_changed));
}

Json comparison_json(const SeveralComparison& c) {
  Json changes = Json::array(), shared = Json::array();
  for (const ChangeBetween& change : c.changes) changes.push_back(between_json(change));
  for (const SharedThing& s : c.shared)
    shared.push_back({{"id", s.id},
                      {"probability_changed", number(s.probability_changed)},
                      {"ln_bayes_factor", number(s.ln_bayes_factor)}});
  return {{"verdict", verdict_name(c.verdict)},
          {"reason", c.sentence},
          {"sessions", c.sessions},
          {"same_rig", c.rigs},
          {"same_body", c.bodies},
          {"changes", changes},
          {"shared", shared},
          {"threshold", number(c.threshold)},
          {"model_fits", c.model_fits}};
}

}  // namespace handsight::cli
