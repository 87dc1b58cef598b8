// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_candidates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>

#include "vision/corner_lanes.h"

namespace handsight {
namespace {

// Everything here happens at half the resolution: the sum of 2 x 2 pixels and a binomial of variance 1 act like a
// Gaussian of 2.06 px on the image, which wins over the noise of 8 grey levels at a contrast of 40, in a quarter of
// the time.
// Rows come and go, so that all stays in the nearest cache.
template <class Value, int kRows>
class Ring {
 public:
  explicit Ring(int width) : stride_(width + 2 * kLanes), values_(static_cast<std::size_t>(kRows) * stride_, 0) {}
  Value* row(int y) { return values_.data() + static_cast<std::size_t>(y % kRows) * stride_; }

 private:
  int stride_;
  std::vector<Value> values_;
};
using Sums = Ring<std::int16_t, 5>;
using Smoothed = Ring<std::int16_t, 4>;
using Saddles = Ring<float, 3>;

constexpr double kNear = 1.5, kFarthest = 5;  // half-resolution px, from the peak to where the gradient vanishes
constexpr int kTile = 128;                    // px
constexpr std::size_t kMostOfTile = 400;      // a board of cells of 6 px has as many
constexpr float kUnit = 16;                   // of the smoothed plane, per grey level

HANDSIGHT_LANES void add_pairs(const std::uint8_t* upper, const std::uint8_t* lower, int count, std::int16_t* sums) {
  for (int x = 0; x < count; ++x) {
    std::uint16_t a, b;  // two neighbours at once; their order does not matter to the sum
    std::memcpy(&a, upper + 2 * x, 2);
    std::memcpy(&b, lower + 2 * x, 2);
    sums[x] = static_cast<std::int16_t>((a & 255) + (a >> 8) + (b & 255) + (b >> 8));
  }
}

HANDSIGHT_LANES void mean_of_sums(const std::int16_t* sums, int count, std::uint8_t* means) {
  for (int x = 0; x < count; ++x) means[x] = static_cast<std::uint8_t>((sums[x] + 2) >> 2);
}

// The binomial 1 4 6 4 1 down and across; every intermediate fits 16 bits. Two columns at each side stay as they are.
HANDSIGHT_LANES void smooth_row(const std::int16_t* const* rows, int width, std::uint16_t* sums, std::int16_t* to) {
  const std::int16_t *a = rows[0], *b = rows[1], *c = rows[2], *d = rows[3], *e = rows[4];
  for (int x = 0; x < width; ++x)
    sums[x] =
        static_cast<std::uint16_t>(static_cast<std::uint16_t>(a[x] + e[x] + 4 * (b[x] + d[x]) + 6 * c[x] + 2) >> 2);
  for (int x = 2; x < width - 2; ++x)
    to[x] = static_cast<std::int16_t>(
        static_cast<std::uint16_t>(sums[x - 2] + sums[x + 2] + 4 * (sums[x - 1] + sums[x + 1]) + 6 * sums[x]) >> 4);
}

HANDSIGHT_LANES void saddle_row(const std::int16_t* up, const std::int16_t* at, const std::int16_t* down, int width,
                                float* saddle) {
  for (int x = 1; x < width - 1; ++x) {
    const auto twice = static_cast<std::int16_t>(2 * at[x]);
    const float xx = static_cast<std::int16_t>(at[x - 1] + at[x + 1] - twice);
    const float yy = static_cast<std::int16_t>(up[x] + down[x] - twice);
    const float xy = static_cast<std::int16_t>(up[x - 1] + down[x + 1] - up[x + 1] - down[x - 1]);
    saddle[x] = xy * xy * 0.0625f - xx * yy;
  }
}

// Not 0 where `at` is a peak above `least`; of equals the upper one is one, then the left one. Eight at a time: reads 8
// more than `count`.
HANDSIGHT_LANES void find_peaks(const float* up, const float* at, const float* down, int count, float least,
                                std::int32_t* peaks) {
  for (int x = 0; x < count; x += kLanes) {
    Lanes s, other;
    load(at + x, s);
    Whole is_peak = s > least;
    load(at + x - 1, other), is_peak &= s > other;
    load(at + x + 1, other), is_peak &= s >= other;
    for (int i = -1; i <= 1; ++i) {
      load(up + x + i, other), is_peak &= s > other;
      load(down + x + i, other), is_peak &= s >= other;
    }
    std::memcpy(peaks + x, &is_peak, sizeof is_peak);
  }
}

// Calls act(x) for those that are not 0: few, so that four at a time are passed over.
template <class Act>
void each_peak(const std::int32_t* peaks, int count, const Act& act) {
  for (int x = 0; x < count; x += 4) {
    std::uint64_t four[2];
    std::memcpy(four, peaks + x, sizeof four);
    if (!(four[0] | four[1])) continue;
    for (int i = x; i < std::min(x + 4, count); ++i)
      if (peaks[i]) act(i);
  }
}

// One Newton step to where the gradient vanishes; false where that is not near.
bool saddle_point(Smoothed& smoothed, int x, int y, float saddle, Candidate& candidate) {
  const std::int16_t *up = smoothed.row(y - 1), *at = smoothed.row(y), *down = smoothed.row(y + 1);
  const double gx = 0.5 * (at[x + 1] - at[x - 1]), gy = 0.5 * (down[x] - up[x]);
  const double xx = at[x - 1] + at[x + 1] - 2 * at[x], yy = up[x] + down[x] - 2 * at[x];
  const double xy = 0.25 * (up[x - 1] + down[x + 1] - up[x + 1] - down[x - 1]);
  double dx = (yy * gx - xy * gy) / saddle, dy = (xx * gy - xy * gx) / saddle;
  const double far = std::max(std::abs(dx), std::abs(dy));
  if (far > kFarthest) return false;
  candidate.stationary = far <= kNear;
  if (!candidate.stationary) dx = dy = 0;  // a shadow's edge moves the point where the gradient vanishes, not the peak
  candidate.position = {2 * (x + dx) + 0.5, 2 * (y + dy) + 0.5};
  const float full = 0.25f / kUnit;  // half-resolution units to grey levels per px^2
  candidate.saddle = saddle * full * full;
  return true;
}

// Row by row as they are, the strongest of each tile.
void keep_strongest(int width, std::vector<Candidate>& candidates) {
  if (candidates.size() <= kMostOfTile) return;
  const int across = width / kTile + 1;
  const auto tile = [&](const Candidate& c) {
    return static_cast<std::size_t>(static_cast<int>(c.position.y()) / kTile * across +
                                    static_cast<int>(c.position.x()) / kTile);
  };
  std::vector<std::vector<float>> depths(tile(candidates.back()) + static_cast<std::size_t>(2 * across));
  for (const Candidate& c : candidates) depths[tile(c)].push_back(c.saddle);
  std::vector<float> least(depths.size(), 0);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (depths[i].size() <= kMostOfTile) continue;
    std::nth_element(depths[i].begin(), depths[i].begin() + kMostOfTile, depths[i].end(), std::greater<>());
    least[i] = depths[i][kMostOfTile];
  }
  std::erase_if(candidates, [&](const Candidate& c) { return c.saddle < least[tile(c)]; });
}

}  // namespace

std::vector<Candidate> saddle_candidates(const Image& image, double min_contrast, double noise, Image* half) {
  std::vector<Candidate> candidates;
  const int width = image.width / 2, height = image.height / 2;
  if (half) *half = Image(width, height);
  if (image.width < 14 || image.height < 14) return candidates;
  // Ixy of a right-angled X-corner is 0.637 b / (2.06^2 + blur^2) at half contrast b, a quarter of that per
  // half-resolution px^2; 0.075 of the contrast is what one of 2.5 px blur has left at 53 deg, less 3 sigma of noise.
  // Noise of sigma 1 leaves 0.062 in Ixy.
  const float least = static_cast<float>(std::pow(kUnit * std::max(0.075 * min_contrast, 2 * 0.062 * noise), 2));
  Sums sums(width);
  Smoothed smoothed(width);
  Saddles saddles(width);
  std::vector<std::uint16_t> column_sums(width);
  std::vector<std::int32_t> peaks(static_cast<std::size_t>(width) + 2 * kLanes);
  const auto find_in_row = [&](int y) {
    find_peaks(saddles.row(y - 1) + 3, saddles.row(y) + 3, saddles.row(y + 1) + 3, width - 6, least, peaks.data() + 3);
    each_peak(peaks.data() + 3, width - 6, [&](int n) {
      Candidate candidate;
      if (saddle_point(smoothed, n + 3, y, saddles.row(y)[n + 3], candidate)) candidates.push_back(candidate);
    });
  };
  // Two smoothed rows and columns and three rows of saddles at each side do not exist: they stay 0.
  for (int y = 0; y < height; ++y) {
    add_pairs(image.row(2 * y), image.row(2 * y + 1), width, sums.row(y));
    if (half) mean_of_sums(sums.row(y), width, half->row(y));
    if (y < 4) continue;
    const std::int16_t* const rows[5] = {sums.row(y - 4), sums.row(y - 3), sums.row(y - 2), sums.row(y - 1),
                                         sums.row(y)};
    smooth_row(rows, width, column_sums.data(), smoothed.row(y - 2));
    if (y < 6) continue;
    saddle_row(smoothed.row(y - 4), smoothed.row(y - 3), smoothed.row(y - 2), width, saddles.row(y - 3));
    if (y > 6) find_in_row(y - 4);
  }
  std::fill(saddles.row(height - 3), saddles.row(height - 3) + width, 0.f);
  find_in_row(height - 4);
  keep_strongest(image.width, candidates);
  return candidates;
}

}  // namespace handsight
