// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/bill.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/percent.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/selection/hand_places.h"
#include "diagnosis/verdict/explanation.h"
#include "diagnosis/verdict/stand_in.h"

namespace handsight {
namespace {

constexpr const char* nameless = ": it has no name";  // what a curve's cause ends with; the row says so too

/// A number of a cause that the fit has estimated, and its place among all numbers of the fit's effects.
struct Estimated {
  std::size_t term = 0, parameter = 0;
  Eigen::Index place = 0;
  double sigma = 0;
};

bool is_of(const BillRow& row, const EffectTerm& term) { return term.id == row.id && is_small(term) == row.is_small; }

std::vector<Estimated> estimated_of(const Fit& fit, const BillRow& row) {
  std::vector<Estimated> list;
  Eigen::Index place = 6;  // after TCP->Body's
  for (std::size_t t = 0; t < fit.effects.size(); ++t) {
    const std::vector<double>& sigmas = fit.effects[t].sigmas;
    for (std::size_t p = 0; p < sigmas.size(); ++p, ++place)
      if (is_of(row, fit.effects[t].term) && sigmas[p] > 0) list.push_back({t, p, place, sigmas[p]});
  }
  return list;
}

double root_mean_square(const Eigen::Matrix3Xd& moved) {
  return moved.cols() ? std::sqrt(moved.squaredNorm() / static_cast<double>(moved.cols())) : 0;
}

/// By linear propagation: d rms = sum of (moved . d moved) / (n rms). What is hardly more than nothing is as sure as
/// its numbers are.
double sigma_of(const Fit& fit, const std::vector<Estimated>& numbers, const Eigen::Matrix3Xd& moved,
                HandPlaces& places) {
  const auto count = static_cast<Eigen::Index>(numbers.size());
  const double n = static_cast<double>(std::max<Eigen::Index>(moved.cols(), 1)), rms = root_mean_square(moved);
  Eigen::MatrixXd covariance(count, count);
  Eigen::VectorXd slope(count);
  for (Eigen::Index a = 0; a < count; ++a) {
    const Estimated& number = numbers[static_cast<std::size_t>(a)];
    std::vector<EffectTerm> less = list_terms(fit);
    less[number.term].values[number.parameter] -= number.sigma;
    const Eigen::Matrix3Xd by_one = -places.moved_by(less) / number.sigma;
    slope[a] = rms > 0 ? moved.cwiseProduct(by_one).sum() / (n * rms) : root_mean_square(by_one);
    for (Eigen::Index b = 0; b < count; ++b)
      covariance(a, b) = fit.model_covariance(number.place, numbers[static_cast<std::size_t>(b)].place);
  }
  return std::sqrt(std::max(slope.dot(covariance * slope), 0.0));
}

void set_worth(const Fit& fit, HandPlaces& places, BillRow& row) {
  std::vector<EffectTerm> others = list_terms(fit);
  std::erase_if(others, [&](const EffectTerm& t) { return is_of(row, t); });
  const Eigen::Matrix3Xd moved = -places.moved_by(others);
  row.hand_m = root_mean_square(moved);
  const std::vector<Estimated> numbers = estimated_of(fit, row);
  row.held = numbers.empty();
  if (!row.held) row.hand_sigma_m = sigma_of(fit, numbers, moved, places);
}

BillRow find_row(const Fit& fit, const EffectTerm& like) {
  BillRow row{.id = like.id, .is_small = is_small(like)};
  std::vector<EffectTerm> terms;
  for (const FittedEffect& f : fit.effects)
    if (is_of(row, f.term)) terms.push_back(f.term);
  row.where = list_places(terms, fit.problem.source->chain);
  row.unnamed = is_curve(terms.front());
  if (row.unnamed) row.follows = terms.front().own->definition->cause;
  row.follows = row.follows.substr(0, row.follows.find(nameless));
  while (row.follows.ends_with('.')) row.follows.pop_back();
  return row;
}

}  // namespace

std::vector<BillRow> make_bill(const Fit& fit, const InclusionProbabilities* inclusion_probabilities) {
  std::vector<BillRow> rows;
  if (fit.effects.empty() || !fit.problem.source || fit.problem.observations.empty()) return rows;
  HandPlaces places(fit);
  for (const FittedEffect& f : fit.effects) {
    if (std::any_of(rows.begin(), rows.end(), [&](const BillRow& r) { return is_of(r, f.term); })) continue;
    rows.push_back(find_row(fit, f.term));
    set_worth(fit, places, rows.back());
  }
  for (const StandIn& odd : stand_ins(fit))
    for (BillRow& row : rows)
      if (row.id == odd.id && !row.is_small) {
        (odd.pushes_back ? row.pushes_back : row.too_large) = true;
        if (!odd.is_everywhere) row.stands_in_at = odd.where;
      }
  std::stable_sort(rows.begin(), rows.end(), [](const BillRow& a, const BillRow& b) { return a.hand_m > b.hand_m; });
  return inclusion_probabilities ? with_inclusion_probabilities(std::move(rows), *inclusion_probabilities) : rows;
}

std::vector<BillRow> with_inclusion_probabilities(std::vector<BillRow> rows,
                                                  const InclusionProbabilities& inclusion_probabilities) {
  for (BillRow& row : rows)
    for (const InclusionProbability& name : inclusion_probabilities.names) {
      if (name.id != row.id || row.is_small || !name.is_in_model) continue;
      row.probability = name.probability;
      row.indistinguishable_from = name.indistinguishable_from;
    }
  return rows;
}

namespace {

/// What and where.
std::string cause_text(const BillRow& row) {
  if (row.unnamed) return row.follows;
  return row.where.empty() ? row.id : fmt::format("{} ({})", row.id, listed(row.where));
}

std::string model_uncertainty_of(const BillRow& row) {
  const std::string at = row.stands_in_at.empty() ? "" : fmt::format(" at {}", listed(row.stands_in_at));
  if (row.pushes_back) return fmt::format("stands in{}: a spring that pushes back", at);
  if (row.too_large) return fmt::format("stands in{}: larger than robots are built", at);
  if (row.is_small) return "a little at each joint";
  return row.held ? "held" : row.unnamed ? "no name" : "plausible";
}

std::string told_from(const BillRow& row) {
  if (row.held || row.is_small) return "-";
  if (!row.indistinguishable_from) return "not looked at";
  return row.indistinguishable_from->empty() ? "from all others" : "not from " + listed(*row.indistinguishable_from);
}

std::string sure_text(const std::optional<double>& probability) {
  if (!probability) return "-";
  return *probability > 0.999 ? "over 99.9 %" : two_digit_percent(*probability) + " %";
}

}  // namespace

Message hand_text(const BillRow& row) {
  const double value = 1e3 * row.hand_m, sigma = 1e3 * row.hand_sigma_m;
  const auto last = [](double size) { return static_cast<int>(std::floor(std::log10(size))); };
  if (!(value > 0)) return "0 mm";
  if (!(sigma > 0)) return message("{:.{}f} mm", value, std::max(2 - last(value), 0));
  const int digits = std::clamp(1 - last(sigma), 0, 6);
  return message("{:.{}f} +- {:.{}f} mm", value, digits, sigma, digits);
}

std::vector<std::string> bill_lines(const std::vector<BillRow>& rows) {
  std::vector<std::string> lines;
  if (rows.empty()) return lines;
  std::size_t wide = 5;
  for (const BillRow& row : rows) wide = std::max(wide, cause_text(row).size());
  const auto line = [&](const auto&... cells) { return fmt::format("{:<{}}  {:>20}  {:>12}  {:<40}  {}", cells...); };
  lines.push_back(line("cause", wide, "at the hand (rms)", "sure", "is it built so", "can it be told"));
  for (const BillRow& row : rows)
    lines.push_back(line(cause_text(row), wide, hand_text(row).english(), sure_text(row.probability),
                         model_uncertainty_of(row), told_from(row)));
  return lines;
}

}  // namespace handsight
