// SPDX-License-Identifier: Apache-2.0
#include "convert/points_of_body.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/median.h"

namespace handsight {
namespace {

constexpr double least_apart = 1e-3;   // m: nearer points are one
constexpr double as_far_m = 2e-3;      // m: how far a distance may differ, or
constexpr double as_far_share = 0.02;  // that share of it
constexpr double most_others = 0.1;    // of the instants: mistaken points
constexpr std::size_t fewest = 3;      // instants

/// The distances of two markers, an instant each in which both were seen.
std::vector<double> distances_between(const PointSeries& s, std::size_t a, std::size_t b) {
  std::vector<double> all;
  for (const auto& row : s.points)
    if (row[a] && row[b]) all.push_back((*row[a] - *row[b]).norm());
  return all;
}

bool is_kept(const std::vector<double>& distances) {
  if (distances.size() < fewest) return false;
  const double usual = median(distances), most = std::max(as_far_m, as_far_share * usual);
  const auto others =
      std::count_if(distances.begin(), distances.end(), [&](double d) { return std::abs(d - usual) > most; });
  return usual > least_apart && static_cast<double>(others) <= most_others * static_cast<double>(distances.size());
}

}  // namespace

bool are_of_one_body(const PointSeries& s) {
  const std::size_t markers = s.points.empty() ? 0 : s.points.front().size();
  for (std::size_t a = 0; a < markers; ++a)
    for (std::size_t b = a + 1; b < markers; ++b)
      if (!is_kept(distances_between(s, a, b))) return false;
  return markers > 1;
}

std::optional<PointSeries> with_more_markers(const PointSeries& points, const PointSeries& more) {
  if (points.points.size() != more.points.size() || points.times != more.times) return std::nullopt;
  PointSeries both = points;
  for (std::size_t i = 0; i < both.points.size(); ++i)
    both.points[i].insert(both.points[i].end(), more.points[i].begin(), more.points[i].end());
  return are_of_one_body(both) ? std::optional(std::move(both)) : std::nullopt;
}

std::optional<PointSeries> markers_line_by_line(const PointSeries& points, std::size_t instants) {
  const std::size_t lines = points.points.size();
  const bool has_one_each = lines > 0 && points.points.front().size() == 1 && points.times.empty();
  if (!has_one_each || instants == 0 || lines <= instants || lines % instants != 0) return std::nullopt;
  PointSeries all;
  for (std::size_t i = 0; i < lines; ++i) {
    if (i % (lines / instants) == 0) all.points.emplace_back();
    all.points.back().push_back(points.points[i][0]);
  }
  return are_of_one_body(all) ? std::optional(std::move(all)) : std::nullopt;
}

PointSeries markers_by_number(const PointSeries& points, const std::vector<double>& numbers) {
  const bool has_one_each = !points.points.empty() && points.points.front().size() == 1;
  if (!has_one_each || points.points.size() != numbers.size())
    throw InputError(
        message("The lines of joint readings say which marker was measured ({} lines), and there are {} measurements "
                "of {} points each; expected one point for each line.",
                numbers.size(), points.points.size(), points.points.empty() ? 0 : points.points.front().size()));
  std::map<double, std::size_t> places;
  for (const double number : numbers) {
    if (number != std::floor(number))
      throw InputError(message("The column marker has {:g}, expected whole numbers.", number));
    places[number] = 0;
  }
  std::size_t next = 0;
  for (auto& [number, place] : places) place = next++;
  PointSeries all{points.times, {}};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    all.points.emplace_back(places.size());
    all.points.back()[places[numbers[i]]] = points.points[i][0];
  }
  return all;
}

}  // namespace handsight
