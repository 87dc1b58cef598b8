// SPDX-License-Identifier: Apache-2.0
#include "proof_output.h"

#include <fmt/format.h>

#include "json_values.h"

namespace handsight::cli {
namespace {

constexpr std::size_t most_points = 200;

Json number_json(const ProofNumber& n) {
  return {{"name", n.name},
          {"value", number(n.value)},
          {"sigma", number(n.sigma)},
          {"unit", n.unit},
          {"slope", number(n.slope)}};
}

Json plot_json(const ProofPlot& plot) {
  Json numbers = Json::array(), points = Json::array();
  for (const ProofNumber& n : plot.numbers) numbers.push_back(number_json(n));
  const std::size_t count = std::min(plot.points.size(), most_points);
  for (std::size_t i = 0; i < count; ++i) {
    const ProofPoint& p = plot.points[i * plot.points.size() / count];
    points.push_back({{"id", p.id},
                      {"x", number(p.x)},
                      {"y", number(p.y)},
                      {"sigma", number(p.sigma)},
                      {"curve", number(p.curve)},
                      {"left", number(p.y - p.curve)}});
  }
  return {{"of", plot.of.empty() ? Json(nullptr) : Json(plot.of)},
          {"quantity", plot.quantity},
          {"unit", plot.unit},
          {"against", plot.against},
          {"against_unit", plot.against_unit},
          {"numbers", numbers},
          {"noise", number(plot.noise)},
          {"hand_m", number(plot.hand_m)},
          {"text", proof_text(plot)},
          {"left_out", plot.left_out},
          {"points_in_all", plot.points.size()},
          {"points", points}};
}

Json plots_json(const std::vector<ProofPlot>& plots) {
  Json list = Json::array();
  for (const ProofPlot& plot : plots) list.push_back(plot_json(plot));
  return list;
}

std::string display_name(const DiagnosisCandidate& c) {
  return c.unnamed ? "unnamed: " + c.unnamed->empirical_error.variable->name : c.id;
}

}  // namespace

Proofs make_proofs(const Session& session, const Diagnosis& d, bool in_full) {
  Proofs proofs;
  if (d.verdict == Verdict::too_few_observations) return proofs;
  if (in_full) proofs.model = make_proof(session, d.model.fit, d.model.fit.problem.terms);
  for (const DiagnosisCandidate& c : d.candidates) {
    if (!proofs.candidates.empty() && (!in_full || c.ln_bayes_factor < d.threshold)) break;
    proofs.candidates.push_back(make_proof(d, c));
  }
  return proofs;
}

void print_proof(const Output& out, const Diagnosis& d, const Proofs& proofs) {
  const bool is_named =
      d.verdict == Verdict::missing_effect || d.verdict == Verdict::ambiguous || d.verdict == Verdict::unexplained;
  if (!is_named || proofs.candidates.empty() || d.candidates.front().ln_bayes_factor < d.threshold) return;
  constexpr std::size_t most = 6;
  const std::vector<ProofPlot>& plots = proofs.candidates.front();
  for (std::size_t i = 0; i < std::min(plots.size(), most); ++i)
    out.line((i == 0 ? "\nProof     " : "          ") + proof_text(plots[i]));
}

void add_proof(const Proofs& proofs, Json& j) {
  j["proof"] = plots_json(proofs.model);
  for (std::size_t i = 0; i < j["candidates"].size(); ++i)
    j["candidates"][i]["proof"] = i < proofs.candidates.size() ? plots_json(proofs.candidates[i]) : Json::array();
}

std::string proof_csv(const Diagnosis& d, const Proofs& proofs) {
  std::string text = proof_csv_head();
  for (const ProofPlot& plot : proofs.model) text += proof_csv_lines("in the model", plot);
  for (std::size_t i = 0; i < proofs.candidates.size(); ++i)
    for (const ProofPlot& plot : proofs.candidates[i]) text += proof_csv_lines(display_name(d.candidates[i]), plot);
  return text;
}

}  // namespace handsight::cli
