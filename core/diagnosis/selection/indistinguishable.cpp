// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/indistinguishable.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace handsight {
namespace {

constexpr double ln_odds_of_telling = 3;  // ln 20, as where a diagnosis tells candidates apart
constexpr double of_a_prior = 1.0 / 9;    // three prior sigmas
constexpr double of_any_size = 1e-2;      // ten of them, which few have
constexpr double least_visible = 1;       // chi-squared of a rival's prior sigma
constexpr double largest_left = 0.1;      // of the chi-squared, by what does the same
using Numbers = std::vector<Eigen::Index>;

/// The information of some numbers once these others have taken up what they can.
Eigen::MatrixXd information_beside(const Eigen::MatrixXd& all, const Numbers& some, const Numbers& others) {
  Eigen::MatrixXd information = all(some, some);
  if (others.empty()) return information;
  Eigen::MatrixXd taken = all(others, others);
  taken.diagonal().array() += of_a_prior;
  const Eigen::MatrixXd shared = all(others, some);
  information -= shared.transpose() * taken.ldlt().solve(shared);
  return information;
}

/// What a name of the model does: its numbers, and what they are in prior sigmas.
struct Own {
  Numbers numbers;
  Eigen::VectorXd value;
};

Own own_of(const ModelSpace& all, const Chosen& units) {
  Own own{all.list_numbers(units), {}};
  own.value.resize(static_cast<Eigen::Index>(own.numbers.size()));
  Eigen::Index i = 0;
  for (const std::size_t u : units) {
    const EffectTerm& term = all.units()[u].term;
    const Effect& effect = term_effect(term);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (is_free(effect, term, p) && i < own.value.size()) {
        own.value[i] = term.values[p] / all.plausible(own.numbers[static_cast<std::size_t>(i)]);
        ++i;
      }
  }
  return own;
}

/// Half the chi-squared that is left where the rival stands in its place: ln of the odds against the rival, of which a
/// number of one prior sigma costs `precision`.
double left_by(const ModelSpace& all, const Own& own, const Numbers& rival, const Numbers& rest,
               double precision = of_a_prior) {
  Numbers both = own.numbers;
  both.insert(both.end(), rival.begin(), rival.end());
  const Eigen::MatrixXd a = information_beside(all.score().information, both, rest);
  const Eigen::Index n = own.value.size(), m = a.rows() - n;
  const double signal = own.value.dot(a.topLeftCorner(n, n) * own.value);
  Eigen::MatrixXd of_rival = a.bottomRightCorner(m, m);
  if (of_rival.trace() < least_visible) return 0.5 * signal;
  of_rival.diagonal().array() += precision;
  const Eigen::VectorXd shared = a.bottomLeftCorner(m, n) * own.value;
  return 0.5 * (signal - shared.dot(of_rival.ldlt().solve(shared)));
}

bool is_joints(const ModelSpace& all, std::size_t unit) { return moves_one_joint(term_effect(all.units()[unit].term)); }

/// A name's units as they can be together: of joints all, of what is one of several (a marker, an observation) each.
std::vector<Chosen> forms_of(const ModelSpace& all, std::size_t name) {
  std::vector<Chosen> forms;
  for (std::size_t u = 0; u < all.units().size(); ++u) {
    if (all.units()[u].name != name) continue;
    if (forms.empty() || !is_joints(all, u))
      forms.push_back({u});
    else
      forms.front().push_back(u);
  }
  return forms;
}

bool imitates(const ModelSpace& all, const Own& own, std::size_t rival, const Chosen& of_model) {
  Chosen others;
  for (const std::size_t u : of_model)
    if (all.units()[u].name != rival) others.push_back(u);
  const Numbers rest = all.list_numbers(others);
  const std::vector<Chosen> forms = forms_of(all, rival);
  return std::any_of(forms.begin(), forms.end(), [&](const Chosen& form) {
    return left_by(all, own, all.list_numbers(form), rest) < ln_odds_of_telling;
  });
}

}  // namespace

std::vector<std::string> told_by_size_from(const ModelSpace& all, std::size_t name) {
  Chosen units, others;
  for (const std::size_t u : all.present()) (all.units()[u].name == name ? units : others).push_back(u);
  const Own own = own_of(all, units);
  std::vector<std::string> ids;
  if (static_cast<std::size_t>(own.value.size()) != own.numbers.size()) return ids;
  for (std::size_t n = 0; n < all.names().size(); ++n) {
    Chosen rival, rest;
    for (const std::size_t u : others) (all.units()[u].name == n ? rival : rest).push_back(u);
    if (rival.empty()) continue;
    const Numbers numbers = all.list_numbers(rival), of_rest = all.list_numbers(rest);
    const double left = left_by(all, own, numbers, of_rest, of_any_size), seen = left_by(all, own, {}, of_rest);
    if (left < ln_odds_of_telling && left < largest_left * seen) ids.push_back(all.names()[n].id);
  }
  return ids;
}

std::vector<std::string> indistinguishable_from(const ModelSpace& all, std::size_t name) {
  Chosen units, others;
  for (const std::size_t u : all.present()) (all.units()[u].name == name ? units : others).push_back(u);
  const Own own = own_of(all, units);
  std::vector<std::string> ids;
  const double seen = own.numbers.empty() ? 0 : left_by(all, own, {}, all.list_numbers(others));
  if (seen < ln_odds_of_telling || static_cast<std::size_t>(own.value.size()) != own.numbers.size()) return ids;
  for (std::size_t n = 0; n < all.names().size(); ++n)
    if (n != name && imitates(all, own, n, others)) ids.push_back(all.names()[n].id);
  return ids;
}

}  // namespace handsight
