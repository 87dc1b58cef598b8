// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_candidates.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <utility>

#include "base/threads.h"
#include "vision/corners/corner_simd.h"

namespace handsight {
namespace {

// Everything here happens at half the resolution: the sum of 2 x 2 pixels and a binomial of variance 1 act like a
// Gaussian of 2.06 px on the image, which wins over the noise of 8 grey levels at a contrast of 40, in a quarter of
// the time.
// Rows come and go, so that all stays in the nearest cache.
template <class Value, int row_count>
class Ring {
 public:
  explicit Ring(int width)
      : stride_(width + 2 * simd_lanes), values_(static_cast<std::size_t>(row_count) * stride_, 0) {}
  Value* row(int y) { return values_.data() + static_cast<std::size_t>(y % row_count) * stride_; }

 private:
  int stride_;
  std::vector<Value> values_;
};
using Sums = Ring<std::int16_t, 5>;
using Smoothed = Ring<std::int16_t, 4>;
using Saddles = Ring<float, 3>;

constexpr float near_px = 1.5f, farthest = 5;  // half-resolution px, from the peak to where the gradient vanishes
constexpr int tile_size = 128;                 // px
constexpr std::size_t most_of_tile = 400;      // a board of cells of 6 px has as many
constexpr int rows_of_band = 128;              // of half the resolution
constexpr float unit = 16;                     // of the smoothed plane, per grey level

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

// The largest of three neighbours each. Reads up to 8 more than `count`, and writes up to 7.
HANDSIGHT_LANES void widen_row(const float* at, int count, float* wide) {
  for (int x = 0; x < count; x += simd_lanes) {
    Simd left, s, right;
    load(at + x - 1, left), load(at + x, s), load(at + x + 1, right);
    s = left > s ? left : s;
    s = right > s ? right : s;
    store(s, wide + x);
  }
}

// Of each group of eight a bit for each column where `at` is a peak above `least`; of equals the upper one is one, then
// the left one. `up` and `down` are widened. Reads up to 8 more than `count`.
HANDSIGHT_LANES void find_peaks(const float* up, const float* at, const float* down, int count, float least,
                                std::uint8_t* groups) {
  constexpr Whole lane_bits{1, 2, 4, 8, 16, 32, 64, 128};
  using FourWhole = std::int32_t __attribute__((vector_size(16)));
  for (int x = 0; x < count; x += simd_lanes) {
    Simd s, other;
    load(at + x, s);
    Whole is_peak = s > least;
    load(at + x - 1, other), is_peak &= s > other;
    load(at + x + 1, other), is_peak &= s >= other;
    load(up + x, other), is_peak &= s > other;
    load(down + x, other), is_peak &= s >= other;
    const Whole bits = is_peak & lane_bits;
    FourWhole four, high;
    std::memcpy(&four, &bits, sizeof four);
    std::memcpy(&high, reinterpret_cast<const char*>(&bits) + sizeof four, sizeof high);
    four |= high, four |= __builtin_shufflevector(four, four, 2, 3, 0, 1);
    groups[x / simd_lanes] = static_cast<std::uint8_t>(four[0] | four[1]);
  }
}

// Calls act(x) for each column below `count` whose bit is set: few, so that 64 at a time are passed over. There are 7
// groups more.
template <class Act>
void each_peak(const std::uint8_t* groups, int count, const Act& act) {
  for (int x = 0; x < count; x += 8 * simd_lanes) {
    std::uint64_t bits;  // the first group's lowest
    std::memcpy(&bits, groups + x / simd_lanes, sizeof bits);
    if constexpr (std::endian::native == std::endian::big) bits = __builtin_bswap64(bits);
    for (; bits != 0; bits &= bits - 1)
      if (const int column = x + std::countr_zero(bits); column < count) act(column);
  }
}

// One Newton step to where the gradient vanishes; false where that is not near.
bool saddle_point(Smoothed& smoothed, int x, int y, float saddle, CornerCandidate& candidate) {
  const std::int16_t *up = smoothed.row(y - 1), *at = smoothed.row(y), *down = smoothed.row(y + 1);
  const int twice = 2 * at[x];
  const auto gx = static_cast<float>(at[x + 1] - at[x - 1]), gy = static_cast<float>(down[x] - up[x]);
  const auto xx = static_cast<float>(at[x - 1] + at[x + 1] - twice), yy = static_cast<float>(up[x] + down[x] - twice);
  const float xy = 0.25f * static_cast<float>(up[x - 1] + down[x + 1] - up[x + 1] - down[x - 1]);
  const float half = 0.5f / saddle;
  float dx = half * (yy * gx - xy * gy), dy = half * (xx * gy - xy * gx);
  const float far = std::max(std::abs(dx), std::abs(dy));
  if (!(far <= farthest)) return false;
  candidate.stationary = far <= near_px;
  if (!candidate.stationary) dx = dy = 0;  // a shadow's edge moves the point where the gradient vanishes, not the peak
  candidate.position = {2 * (x + static_cast<double>(dx)) + 0.5, 2 * (y + static_cast<double>(dy)) + 0.5};
  const float full = 0.25f / unit;  // half-resolution units to grey levels per px^2
  candidate.saddle = saddle * full * full;
  return true;
}

// Row by row as they are, the strongest of each tile.
void keep_strongest(int width, std::vector<CornerCandidate>& candidates) {
  if (candidates.size() <= most_of_tile) return;
  const int across = width / tile_size + 1;
  const auto tile = [&](const CornerCandidate& c) {
    return static_cast<std::size_t>(static_cast<int>(c.position.y()) / tile_size * across +
                                    static_cast<int>(c.position.x()) / tile_size);
  };
  const std::size_t tiles = tile(candidates.back()) + static_cast<std::size_t>(2 * across);
  std::vector<std::size_t> counts(tiles, 0);
  for (const CornerCandidate& c : candidates) ++counts[tile(c)];
  if (*std::max_element(counts.begin(), counts.end()) <= most_of_tile) return;
  std::vector<std::vector<float>> depths(tiles);
  for (const CornerCandidate& c : candidates) depths[tile(c)].push_back(c.saddle);
  std::vector<float> least(depths.size(), 0);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (depths[i].size() <= most_of_tile) continue;
    std::nth_element(depths[i].begin(), depths[i].begin() + most_of_tile, depths[i].end(), std::greater<>());
    least[i] = depths[i][most_of_tile];
  }
  std::erase_if(candidates, [&](const CornerCandidate& c) { return c.saddle < least[tile(c)]; });
}

// What a saddle must have to be one.
struct Asked {
  float least;  // of the smoothed plane's saddles
  double min_contrast, noise;
};

// The saddles of a band of rows, of half the resolution, whatever bands there are; writes its rows of `half`, if any.
// The rings round them are looked at while the nearest caches still hold their pixels.
struct Band {
  int begin, end;
};
void find_in_band(const Image& image, const Band& band, const Asked& asked, Image* half,
                  std::vector<CornerCandidate>& candidates) {
  const int width = image.width / 2, height = image.height / 2;
  const int first = std::max(band.begin, 3), last = std::min(band.end, height - 3);  // where saddles may be peaks
  candidates.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(band.end - band.begin) / 64);
  Sums sums(width);
  Smoothed smoothed(width);
  Saddles saddles(width), widened(width);
  std::vector<std::uint16_t> column_sums(width);
  std::vector<std::uint8_t> peaks(static_cast<std::size_t>(width) / simd_lanes + 1 + sizeof(std::uint64_t), 0);
  const auto find_in_row = [&](int y) {
    const float* const at = saddles.row(y) + 3;
    find_peaks(widened.row(y - 1) + 3, at, widened.row(y + 1) + 3, width - 6, asked.least, peaks.data());
    each_peak(peaks.data(), width - 6, [&](int n) {
      CornerCandidate candidate;
      if (!saddle_point(smoothed, n + 3, y, at[n], candidate)) return;
      const Eigen::Vector2i pixel = (candidate.position.array() + 0.5).cast<int>();  // none is negative
      candidate.ring = may_be_cross(image, pixel, asked.min_contrast, asked.noise);
      candidates.push_back(candidate);
    });
  };
  // Two smoothed rows and columns and three rows of saddles at each side of the image do not exist: they stay 0.
  const int begin = std::max(band.begin == 0 ? 0 : first - 4, 0), end = std::min(std::max(last + 4, band.end), height);
  for (int y = begin; y < end; ++y) {
    add_pairs(image.row(2 * y), image.row(2 * y + 1), width, sums.row(y));
    if (half && y >= band.begin && y < band.end) mean_of_sums(sums.row(y), width, half->row(y));
    if (y < begin + 4) continue;
    const std::int16_t* const rows[5] = {sums.row(y - 4), sums.row(y - 3), sums.row(y - 2), sums.row(y - 1),
                                         sums.row(y)};
    smooth_row(rows, width, column_sums.data(), smoothed.row(y - 2));
    if (y < begin + 6) continue;
    saddle_row(smoothed.row(y - 4), smoothed.row(y - 3), smoothed.row(y - 2), width, saddles.row(y - 3));
    widen_row(saddles.row(y - 3) + 3, width - 6, widened.row(y - 3) + 3);
    if (y - 4 >= first && y - 4 < last) find_in_row(y - 4);
  }
  if (last < height - 3 || last <= first) return;
  std::fill(widened.row(height - 3), widened.row(height - 3) + width, 0.f);
  find_in_row(height - 4);
}

}  // namespace

std::vector<CornerCandidate> saddle_candidates(const Image& image, double min_contrast, double noise, Image* half) {
  const int width = image.width / 2, height = image.height / 2;
  if (half && (half->width != width || half->height != height)) *half = Image(width, height);
  if (image.width < 14 || image.height < 14) return {};
  // Ixy of a right-angled X-corner is 0.637 b / (2.06^2 + blur^2) at half contrast b, a quarter of that per
  // half-resolution px^2; 0.075 of the contrast is what one of 2.5 px blur has left at 53 deg, less 3 sigma of noise.
  // Noise of sigma 1 leaves 0.062 in Ixy.
  const float least = static_cast<float>(std::pow(unit * std::max(0.075 * min_contrast, 2 * 0.062 * noise), 2));
  const bool is_large = is_worth_threads(image);
  const int bands = is_large ? std::max(1, height / rows_of_band) : 1;
  std::vector<std::vector<CornerCandidate>> of_band(static_cast<std::size_t>(bands));
  const auto edge = [&](int band) { return static_cast<int>(static_cast<std::int64_t>(height) * band / bands); };
  each_part(bands, is_large, [&](int band) {
    find_in_band(image, {edge(band), edge(band + 1)}, {least, min_contrast, noise}, half,
                 of_band[static_cast<std::size_t>(band)]);
  });
  std::vector<CornerCandidate> candidates = std::move(of_band.front());
  std::size_t count = candidates.size();
  for (int band = 1; band < bands; ++band) count += of_band[static_cast<std::size_t>(band)].size();
  candidates.reserve(count);
  for (int band = 1; band < bands; ++band) {
    const auto& more = of_band[static_cast<std::size_t>(band)];
    candidates.insert(candidates.end(), more.begin(), more.end());
  }
  keep_strongest(image.width, candidates);
  return candidates;
}

}  // namespace handsight
