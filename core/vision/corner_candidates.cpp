// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_candidates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "vision/corner_lanes.h"

namespace handsight {
namespace {

// Everything here happens at half the resolution: the sum of 2 x 2 pixels and a binomial of variance 1 act like a
// Gaussian of 2.06 px on the image, which wins over the noise of 8 grey levels at a contrast of 40, in a quarter of
// the time.
struct Plane {
  int width = 0, height = 0;
  std::vector<std::int16_t> values;
  std::int16_t* row(int y) { return values.data() + static_cast<std::size_t>(y) * width; }
  const std::int16_t* row(int y) const { return values.data() + static_cast<std::size_t>(y) * width; }
};

constexpr double kNear = 1.5, kFarthest = 5;  // half-resolution px, from the peak to where the gradient vanishes
constexpr float kUnit = 16;                   // of the smoothed plane, per grey level

HANDSIGHT_LANES void add_pairs(const std::uint8_t* upper, const std::uint8_t* lower, int count, std::int16_t* sums) {
  for (int x = 0; x < count; ++x) {
    std::uint16_t a, b;  // two neighbours at once; their order does not matter to the sum
    std::memcpy(&a, upper + 2 * x, 2);
    std::memcpy(&b, lower + 2 * x, 2);
    sums[x] = static_cast<std::int16_t>((a & 255) + (a >> 8) + (b & 255) + (b >> 8));
  }
}

Plane half_resolution(const Image& image) {
  Plane half{image.width / 2, image.height / 2, {}};
  half.values.resize(static_cast<std::size_t>(half.width) * half.height);
  for (int y = 0; y < half.height; ++y) add_pairs(image.row(2 * y), image.row(2 * y + 1), half.width, half.row(y));
  return half;
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

// Two rows and columns at each side stay 0.
Plane smoothed(const Plane& half) {
  Plane out{half.width, half.height, std::vector<std::int16_t>(half.values.size())};
  std::vector<std::uint16_t> sums(half.width);
  for (int y = 2; y + 2 < half.height; ++y) {
    const std::int16_t* const rows[5] = {half.row(y - 2), half.row(y - 1), half.row(y), half.row(y + 1),
                                         half.row(y + 2)};
    smooth_row(rows, half.width, sums.data(), out.row(y));
  }
  return out;
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

void saddle_row(const Plane& plane, int y, float* saddle) {
  saddle_row(plane.row(y - 1), plane.row(y), plane.row(y + 1), plane.width, saddle);
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
bool saddle_point(const Plane& plane, int x, int y, float saddle, Candidate& candidate) {
  const std::int16_t *up = plane.row(y - 1), *at = plane.row(y), *down = plane.row(y + 1);
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

}  // namespace

std::vector<Candidate> saddle_candidates(const Image& image, double min_contrast, double noise, int most) {
  std::vector<Candidate> candidates;
  if (image.width < 14 || image.height < 14) return candidates;
  const Plane plane = smoothed(half_resolution(image));
  // Ixy of a right-angled X-corner is 0.637 b / (2.06^2 + blur^2) at half contrast b, a quarter of that per
  // half-resolution px^2; 0.075 of the contrast is what one of 2.5 px blur has left at 53 deg, less 3 sigma of noise.
  // Noise of sigma 1 leaves 0.062 in Ixy.
  const float least = static_cast<float>(std::pow(kUnit * std::max(0.075 * min_contrast, 2 * 0.062 * noise), 2));
  const int w = plane.width;
  const int stride = w + 2 * kLanes;
  std::vector<float> rows(3 * static_cast<std::size_t>(stride), 0.f);
  std::vector<std::int32_t> peaks(stride);
  float *up = rows.data(), *at = up + stride, *down = at + stride;
  saddle_row(plane, 3, at);
  for (int y = 3; y + 3 < plane.height; ++y) {
    if (y + 4 < plane.height)
      saddle_row(plane, y + 1, down);
    else
      std::fill(down, down + w, 0.f);
    find_peaks(up + 3, at + 3, down + 3, w - 6, least, peaks.data() + 3);
    each_peak(peaks.data() + 3, w - 6, [&](int n) {
      Candidate candidate;
      if (saddle_point(plane, n + 3, y, at[n + 3], candidate)) candidates.push_back(candidate);
    });
    float* const old = up;
    up = at, at = down, down = old;
  }
  if (static_cast<int>(candidates.size()) > most) {
    const auto stronger = [](const Candidate& a, const Candidate& b) { return a.saddle > b.saddle; };
    std::stable_sort(candidates.begin(), candidates.end(), stronger);
    candidates.resize(most);
  }
  return candidates;
}

}  // namespace handsight
