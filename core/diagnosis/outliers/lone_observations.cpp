// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/outliers/lone_observations.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/text.h"
#include "diagnosis/evidence/noise_model.h"
#include "estimation/report/fit_report.h"

namespace handsight {
namespace {

constexpr std::size_t fewest_others = 8, one_in = 20;
constexpr double apart = 2;          // rms over that of the next, while they still pull at the fit: only a suspicion
constexpr double apart_beside = 6;   // ... over the worst of the others, once they no longer do
constexpr double beyond_noise = 10;  // rms over the noise

/// The used observations by their error, the worst first; and at which counts of them those that remain are far better.
struct StandingApart {
  std::vector<std::size_t> order, counts;  // counts descending
};

StandingApart standing_apart(const std::vector<double>& squares, std::size_t most) {
  StandingApart a;
  if (squares.size() <= fewest_others) return a;
  a.order.resize(squares.size());
  std::iota(a.order.begin(), a.order.end(), std::size_t{0});
  std::sort(a.order.begin(), a.order.end(), [&](std::size_t x, std::size_t y) { return squares[x] > squares[y]; });
  for (std::size_t count = std::min(most, squares.size() - fewest_others); count > 0; --count)
    if (squares[a.order[count - 1]] >= apart * apart * squares[a.order[count]]) a.counts.push_back(count);
  return a;
}

/// Several at the beginning or the end of the session, one after another.
bool is_like_a_slip(std::vector<std::size_t> places, std::size_t count) {
  if (places.size() < 2) return false;
  std::sort(places.begin(), places.end());
  const bool in_a_row = places.back() - places.front() + 1 == places.size();
  return in_a_row && (places.front() == 0 || places.back() + 1 == count);
}

Session only(const Session& session, const std::vector<LoneObservation>& lone) {
  Session s = session;
  for (std::size_t i = 0; i < s.observations.size(); ++i)
    if (std::none_of(lone.begin(), lone.end(),
                     [&](const LoneObservation& l) { return l.index == static_cast<int>(i); }))
      s.observations[i].decision = Decision::excluded;
  return s;
}

/// How a fit without some observations predicts these, and the others.
struct Prediction {
  std::vector<double> squares;  // of these, in the session's order
  double worst = 0;             // of the others
  double least = 0;             // from which on these stand apart

  bool stands_apart(double times) const {
    return std::all_of(squares.begin(), squares.end(), [&](double square) { return square >= times * least; });
  }
};

/// Nothing where not all of these can be predicted.
std::optional<Prediction> prediction(const Session& session, const std::vector<LoneObservation>& lone,
                                     const Fit& rest) {
  Prediction p;
  const std::vector<double> others = mean_squares(rest);
  p.worst = *std::max_element(others.begin(), others.end());
  p.least = std::max(apart_beside * apart_beside * p.worst,
                     beyond_noise * beyond_noise * rest.noise.value_or(0) * rest.noise.value_or(0));
  p.squares = mean_squares_on(only(session, lone), rest);
  return p.squares.size() == lone.size() ? std::optional(std::move(p)) : std::nullopt;
}

/// A fit that ends sooner says so, where a model bends and its exact fit takes long.
bool is_far_from_confirmed(const Session& session, const std::vector<LoneObservation>& lone, const Fit& all,
                           FitOptions options) {
  constexpr double by_far = 0.25;  // of the squares
  if (options.estimated.empty()) return false;
  set_quick(noise_model(all), options);
  const Fit rest = fit(without(session, lone), options);
  if (!rest.converged()) return false;
  const std::optional<Prediction> p = prediction(session, lone, rest);
  return p && !p->stands_apart(by_far);
}

/// How far off they are by a fit without them; nothing where the others do not agree without them either.
std::vector<LoneObservation> confirmed(const Session& session, std::vector<LoneObservation> lone,
                                       const FitOptions& options) {
  const Fit rest = fit(without(session, lone), options);
  if (!rest.converged()) return {};
  const std::optional<Prediction> p = prediction(session, lone, rest);
  if (!p || !p->stands_apart(1)) return {};
  std::sort(lone.begin(), lone.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
  for (std::size_t i = 0; i < lone.size(); ++i) {
    lone[i].error = std::sqrt(p->squares[i]);
    lone[i].others = std::sqrt(p->worst);
  }
  return lone;
}

}  // namespace

Session without(const Session& session, const std::vector<LoneObservation>& lone) {
  Session s = session;
  for (const LoneObservation& l : lone) {
    s.observations[static_cast<std::size_t>(l.index)].decision = Decision::excluded;
    s.observations[static_cast<std::size_t>(l.index)].reason = "it alone does not agree with the others";
  }
  return s;
}

std::vector<LoneObservation> lone_observations(const Session& session, const Fit& fit, const FitOptions& options) {
  const std::vector<ProblemObservation>& used = fit.problem.observations;
  const std::size_t most = std::max<std::size_t>(1, used.size() / one_in);
  const StandingApart a = standing_apart(mean_squares(fit), most);
  for (const std::size_t count : a.counts) {
    const std::vector<std::size_t> places(a.order.begin(), a.order.begin() + static_cast<std::ptrdiff_t>(count));
    if (is_like_a_slip(places, used.size())) continue;
    std::vector<LoneObservation> lone;
    lone.reserve(places.size());
    for (const std::size_t p : places)
      lone.push_back({session.observations[static_cast<std::size_t>(used[p].index)].id, used[p].index});
    if (is_far_from_confirmed(session, lone, fit, options)) continue;
    if (auto found = confirmed(session, std::move(lone), options); !found.empty()) return found;
  }
  return {};
}

Message lone_text(const std::vector<LoneObservation>& lone, bool is_tracker, bool is_left_out) {
  if (lone.empty()) return {};
  const bool is_one = lone.size() == 1;
  std::string ids;
  double least = lone.front().error;
  for (const LoneObservation& l : lone) {
    ids += fmt::format("{}{}", ids.empty() ? "" : ", ", l.id);
    least = std::min(least, l.error);
  }
  const auto size = [&](double x) { return is_tracker ? message("{:.3g} mm", 1e3 * x) : message("{:.3g} px", x); };
  const char* const state = is_left_out ? is_one ? "is left out" : "are left out"
                            : is_one    ? "stands alone"
                                        : "stand alone";
  return message(
      "{} {} {}: by what the others say {} off by {}{}, and the others by {} at most. Look for a wrong reading or "
      "image, correct it or exclude it.",
      is_one ? "Observation" : "Observations", ids, state, is_one ? "it is" : "they are", size(least),
      is_one ? "" : " and more", size(lone.front().others));
}

}  // namespace handsight
