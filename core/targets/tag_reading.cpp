// SPDX-License-Identifier: Apache-2.0
#include "targets/tag_reading.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "targets/homography.h"
#include "targets/sampling.h"

namespace handsight {
namespace {

constexpr double least_likeness = 0.8;  // of a wrong code at the distance of the dictionaries: 0.5 to 0.75
constexpr double least_lead = 0.04;
constexpr double least_deviation = 6;  // grey levels, of the modules

/// Share of a module's light that falls into the next and the one after, for some blurs.
constexpr double neighbour_shares[][2] = {{0, 0}, {0.12, 0}, {0.21, 0.01}};

void normalise(std::vector<float>& values) {
  const float mean = std::accumulate(values.begin(), values.end(), 0.0f) / static_cast<float>(values.size());
  float square = 0;
  for (float& value : values) value -= mean, square += value * value;
  const float length = std::sqrt(square);
  if (length > 0)
    for (float& value : values) value /= length;
}

/// Blurred along rows and columns; outside the tag it is white.
std::vector<float> blurred(const TagPattern& pattern, const double (&shares)[2]) {
  const int n = pattern.side;
  std::vector<float> values(static_cast<std::size_t>(n) * n), between(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = pattern.white[i] ? 1 : 0;
  const double own = 1 - 2 * (shares[0] + shares[1]);
  const auto pass = [&](const std::vector<float>& from, std::vector<float>& to, bool is_row) {
    for (int row = 0; row < n; ++row)
      for (int column = 0; column < n; ++column) {
        const auto at = [&](int offset) {
          const int c = column + (is_row ? offset : 0), r = row + (is_row ? 0 : offset);
          return c < 0 || r < 0 || c >= n || r >= n ? 1.0
                                                    : static_cast<double>(from[static_cast<std::size_t>(r * n + c)]);
        };
        to[static_cast<std::size_t>(row * n + column)] =
            static_cast<float>(own * at(0) + shares[0] * (at(-1) + at(1)) + shares[1] * (at(-2) + at(2)));
      }
  };
  pass(values, between, true);
  pass(between, values, false);
  return values;
}

double deviation(const std::vector<float>& values) {
  double sum = 0, square = 0;
  for (const float value : values) sum += value, square += static_cast<double>(value) * value;
  const auto count = static_cast<double>(values.size());
  return std::sqrt(std::max(square / count - sum / count * sum / count, 0.0));
}

/// Corner i of the tag is corner i + turns of the quad, where the tag stands turned clockwise by so many quarter turns.
Quad turned_back(const Quad& quad, int turns) {
  Quad corners;
  for (int i = 0; i < 4; ++i) corners[static_cast<std::size_t>(i)] = quad[static_cast<std::size_t>((i + turns) % 4)];
  return corners;
}

}  // namespace

std::vector<float> module_values(const Image& image, const Quad& quad, int side) {
  const Matrix3 pixel_from_module = homography_from_quad(quad, side);
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(side) * side);
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      double sum = 0;
      for (const auto& [right, down] : {std::pair{0.5, 0.5}, {0.3, 0.3}, {0.7, 0.3}, {0.3, 0.7}, {0.7, 0.7}})
        sum += grey_at(image, mapped(pixel_from_module, Vector2(column + right, row + down)));
      values.push_back(static_cast<float>(sum / 5));
    }
  return values;
}

TagReader::TagReader(const std::vector<TagCandidate>& candidates) {
  for (const TagCandidate& candidate : candidates) {
    check(side_ == 0 || side_ == candidate.pattern.side, "tags of {} and {} modules in one reader", side_,
          candidate.pattern.side);
    side_ = candidate.pattern.side;
    for (int turns = 0; turns < 4; ++turns) {
      const TagPattern pattern = turned(candidate.pattern, turns);
      for (const auto& shares : neighbour_shares) {
        templates_.push_back({candidate.tag, turns, blurred(pattern, shares)});
        normalise(templates_.back().values);
      }
    }
  }
}

std::optional<TagReading> TagReader::read(const Image& image, const Quad& quad) const {
  for (const Vector2& corner : quad)
    if (!is_inside(image, corner, -0.5)) return std::nullopt;
  std::vector<float> values = module_values(image, quad, side_);
  if (!(deviation(values) >= least_deviation)) return std::nullopt;
  normalise(values);
  const Template* best = nullptr;
  float likeness = -1, second = -1;
  for (const Template& one : templates_) {
    const float alike = std::inner_product(values.begin(), values.end(), one.values.begin(), 0.0f);
    const bool is_same = best && best->tag == one.tag && best->turns == one.turns;
    if (alike > likeness) {
      if (!is_same) second = likeness;
      likeness = alike, best = &one;
    } else if (alike > second && !is_same) {
      second = alike;
    }
  }
  if (!best || likeness < least_likeness || likeness - second < least_lead) return std::nullopt;
  return TagReading{best->tag, turned_back(quad, best->turns), likeness, static_cast<double>(likeness) - second};
}

std::vector<TagReading> read_tags(const Image& image, const std::vector<Quad>& quads, const TagReader& reader) {
  std::vector<TagReading> readings;
  for (const Quad& quad : quads) {
    const auto reading = reader.read(image, quad);
    if (!reading) continue;
    const double near = 0.3 * (reading->corners[0] - reading->corners[2]).norm();
    const auto same = std::find_if(readings.begin(), readings.end(), [&](const TagReading& other) {
      return other.tag == reading->tag && (other.corners[0] - reading->corners[0]).norm() < near;
    });
    if (same == readings.end())
      readings.push_back(*reading);
    else if (reading->likeness > same->likeness)
      *same = *reading;
  }
  return readings;
}

}  // namespace handsight
