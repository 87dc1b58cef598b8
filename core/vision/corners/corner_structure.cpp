// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_structure.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "vision/corners/corner_simd.h"

namespace handsight {
namespace {

constexpr int half_size = CrossStructure::direction_count;  // on half a circle
constexpr std::array<float, 2> radii{2.5f, 4.f};            // px: outside of the blur, inside of the cell

constexpr std::size_t points_in_all = 2 * half_size * radii.size();
static_assert(2 * half_size % simd_lanes == 0);

struct Circles {
  std::array<float, points_in_all> u, v;  // px, circle by circle
};

const Circles& circles() {
  static const Circles made = [] {
    Circles c;
    std::size_t n = 0;
    for (const float radius : radii)
      for (int i = 0; i < 2 * half_size; ++i, ++n) {
        const double angle = M_PI * i / half_size;
        c.u[n] = static_cast<float>(radius * std::cos(angle)), c.v[n] = static_cast<float>(radius * std::sin(angle));
      }
    return c;
  }();
  return made;
}

// Bilinear values at the circles round (u, v), which must lie in the image.
HANDSIGHT_LANES void sample_circles(const Image& image, const Circles& at, float u, float v, float* values) {
  const std::int32_t width = image.width;
  const std::uint8_t* const pixels = image.pixels.data();
  for (std::size_t n = 0; n < points_in_all; n += simd_lanes) {
    Simd x, y;
    load(&at.u[n], x), load(&at.v[n], y);
    x += u, y += v;
    const Whole column = __builtin_convertvector(x, Whole), row = __builtin_convertvector(y, Whole);
    const Whole place = row * width + column;
    Whole upper, lower;  // two neighbours each, the left one in the low byte
    for (int i = 0; i < simd_lanes; ++i) {
      const std::uint8_t *const a = pixels + place[i], *const b = a + width;
      upper[i] = a[0] | a[1] << 8, lower[i] = b[0] | b[1] << 8;
    }
    const Simd fu = x - __builtin_convertvector(column, Simd), fv = y - __builtin_convertvector(row, Simd);
    const Simd left = __builtin_convertvector(upper & 255, Simd), right = __builtin_convertvector(upper >> 8, Simd);
    const Simd below = __builtin_convertvector(lower & 255, Simd), last = __builtin_convertvector(lower >> 8, Simd);
    const Simd above = left + fu * (right - left), under = below + fu * (last - below);
    store(above + fv * (under - above), values + n);
  }
}

// The mean over the circles, of even[i] = I at angle i and opposite, and the squared difference of these two.
struct Profile {
  std::array<float, half_size> even;
  std::array<std::array<float, half_size>, radii.size()> single;  // sum of both, circle by circle
  float odd_square;
};

HANDSIGHT_LANES void fold_circles(const float* values, Profile& profile) {
  constexpr float share = 0.5f / radii.size();
  std::array<float, half_size + 2> raw;  // and a neighbour at each side
  Simd squares{}, near, opposite, before, after;
  for (int i = 0; i < half_size; i += simd_lanes) {
    Simd even{}, odd{};
    for (std::size_t k = 0; k < radii.size(); ++k) {
      load(values + 2 * half_size * k + i, near), load(values + 2 * half_size * k + half_size + i, opposite);
      store(near + opposite, &profile.single[k][i]);
      even += share * (near + opposite), odd += share * (near - opposite);
    }
    store(even, &raw[i + 1]), squares += odd * odd;
  }
  profile.odd_square = total(squares) / half_size;
  raw[0] = raw[half_size], raw[half_size + 1] = raw[1];
  for (int i = 0; i < half_size; i += simd_lanes) {  // noise must not make crossings of its own
    load(&raw[i], before), load(&raw[i + 1], near), load(&raw[i + 2], after);
    store(0.25f * (before + 2 * near + after), &profile.even[i]);
  }
}

Profile profile_round(const Image& image, float u, float v) {
  Profile profile;
  std::array<float, points_in_all> values;
  sample_circles(image, circles(), u, v, values.data());
  fold_circles(values.data(), profile);
  return profile;
}

// Contrast on the inner circle over that on the outer one (1 of sharp sectors, 0.39 of a bare saddle), with the sectors
// as both together tell them.
HANDSIGHT_LANES float flatness(const Profile& profile, float middle) {
  Simd sums[4]{}, even, inner, outer;
  for (int i = 0; i < half_size; i += simd_lanes) {
    load(&profile.even[i], even), load(&profile.single.front()[i], inner), load(&profile.single.back()[i], outer);
    inner -= 2 * middle, outer -= 2 * middle;
    const Whole is_black = even < middle;
    sums[0] += is_black ? -inner : inner, sums[1] += is_black ? -outer : outer;
  }
  float sum[4];
  totals(sums, sum);
  return sum[0] / std::max(sum[1], 1e-3f);
}

// Mean of the lowest, or of the highest, three.
struct Extremes {
  float low = 0, high = 0;
};

template <class Vector>
HANDSIGHT_INLINE void order(Vector& low, Vector& high) {
  const auto is_ordered = low < high;
  const Vector lower = is_ordered ? low : high;
  high = is_ordered ? high : low, low = lower;
}

// In each lane the three lowest of one's and of other's, both in order, in order.
HANDSIGHT_INLINE void keep_lowest(Four* one, Four* other) {
  order(one[0], other[0]), order(one[1], other[1]);
  order(one[1], other[0]);
  order(one[2], other[2]), order(one[2], other[0]);
}

// Of eight lanes that hold a lower and a higher value each the three lowest.
HANDSIGHT_INLINE float sum_of_lowest(const Simd& lower, const Simd& higher) {
  Four one[3], other[3];
  const auto halves = [](const Simd& from, Four& first, Four& second) {
    std::memcpy(&first, &from, sizeof first);
    std::memcpy(&second, reinterpret_cast<const char*>(&from) + sizeof first, sizeof second);
  };
  halves(lower, one[0], other[0]), halves(higher, one[1], other[1]);
  order(one[0], other[0]), order(one[1], other[1]);
  one[2] = one[1], one[1] = other[0];
  order(one[1], one[2]);
  for (int i = 0; i < 3; ++i) other[i] = __builtin_shufflevector(one[i], one[i], 2, 3, 0, 1);
  keep_lowest(one, other);
  for (int i = 0; i < 3; ++i) other[i] = __builtin_shufflevector(one[i], one[i], 1, 0, 3, 2);
  keep_lowest(one, other);
  return one[0][0] + one[1][0] + one[2][0];
}

HANDSIGHT_LANES Extremes extremes(const float* values) {
  constexpr float third_size = 3;
  Simd lower, higher;
  load(values, lower), load(values + simd_lanes, higher);
  order(lower, higher);
  return {sum_of_lowest(lower, higher) / third_size, -sum_of_lowest(-higher, -lower) / third_size};
}

// A bit for each value that is less than `middle`, the first one's lowest.
HANDSIGHT_LANES std::uint32_t bits_below(const float* values, float middle) {
  constexpr Whole lane_bits{1, 2, 4, 8, 16, 32, 64, 128};
  Simd first, second;
  load(values, first), load(values + simd_lanes, second);
  const Whole bits = ((first < middle) & lane_bits) | (((second < middle) & lane_bits) << simd_lanes);
  std::uint64_t parts[simd_lanes / 2];
  std::memcpy(parts, &bits, sizeof parts);
  const std::uint64_t both = (parts[0] | parts[1]) | (parts[2] | parts[3]);
  return static_cast<std::uint32_t>(both | both >> 32);
}

constexpr std::array<float, 3> blurs{0.9f, 1.5f, 2.3f};

// The least that the pattern of two blurred edges that cross in the middle leaves of the profile `even`, whose mean is
// 0, or what is no more than `enough`: the sum of squares in half contrasts.
HANDSIGHT_LANES float left_by_sectors(const Circles& at, const std::array<double, 2>& edges, const float* even,
                                      float enough) {
  const auto first = static_cast<float>(edges[0]), second = static_cast<float>(edges[1]);
  const float s1 = std::sin(first), c1 = std::cos(first), s2 = std::sin(second), c2 = std::cos(second);
  float least = 1e9f;
  for (const float blur : blurs) {
    const float scale = static_cast<float>(M_SQRT1_2) / blur;
    Simd sums[4]{}, x, y, a, b, bell, e;  // of the pattern, its square, its product with the profile; of its square
    for (int i = 0; i < half_size; i += simd_lanes) {
      Simd pattern{};
      for (std::size_t k = 0; k < radii.size(); ++k) {
        load(&at.u[2 * half_size * k + i], x), load(&at.v[2 * half_size * k + i], y);
        erf_and_bell(scale * (c1 * y - s1 * x), a, bell);
        erf_and_bell(scale * (c2 * y - s2 * x), b, bell);
        pattern += (1.f / radii.size()) * a * b;
      }
      load(even + i, e);
      sums[0] += pattern, sums[1] += pattern * pattern, sums[2] += pattern * e, sums[3] += e * e;
    }
    float sum[4];
    totals(sums, sum);
    const float variance = sum[1] - sum[0] * sum[0] / half_size, both = sum[2];
    least = std::min(least, (sum[3] - both * both / variance) * variance * variance / (both * both));
    if (least <= enough) break;
  }
  return least;
}

}  // namespace

std::optional<Lighting> may_be_cross(const Image& image, const Eigen::Vector2i& pixel, double min_contrast,
                                     double noise) {
  constexpr std::array<std::array<int, 2>, 4> quarter{{{3, 0}, {3, 1}, {2, 2}, {1, 3}}};
  const std::uint8_t* const at = image.row(pixel.y()) + pixel.x();
  int opposite = 0, across = 0;
  for (const auto& [u, v] : quarter) {
    const int offset = v * image.width + u, turned = u * image.width - v;  // by a quarter turn
    const int one = at[offset], other = at[-offset], next = at[turned], last = at[-turned];
    opposite += std::abs(one - other) + std::abs(next - last);
    across += std::abs(one + other - next - last);
  }
  // A sharp right-angled corner gives 8 times its contrast, 2.5 px of blur and 53 deg leave about 2.6 times.
  // Noise makes 9 sigma of the opposite ones' differences.
  if (!(across > 1.5 * min_contrast)) return std::nullopt;
  const auto beyond = [&](double times) {
    return across > times / 1.5 * opposite && across > times * (opposite - 9 * noise);
  };
  if (beyond(1.5)) return Lighting::even;
  return beyond(0.6) ? std::optional(Lighting::shadowed) : std::nullopt;
}

std::optional<CrossStructure> cross_structure(const Image& image, const Eigen::Vector2d& centre, double min_contrast,
                                              Lighting light) {
  const float reach = radii.back() + 1, u = static_cast<float>(centre.x()), v = static_cast<float>(centre.y());
  if (!(u >= reach && v >= reach && u < image.width - reach - 1 && v < image.height - reach - 1)) return std::nullopt;
  const Profile profile = profile_round(image, u, v);
  const auto [black, white] = extremes(profile.even.data());
  const float contrast = white - black, middle = 0.5f * (white + black);
  // Blur of 2.5 px leaves half the contrast at these radii.
  if (contrast < 0.4 * min_contrast) return std::nullopt;
  CrossStructure cross;
  cross.asymmetry = std::sqrt(profile.odd_square) / contrast;
  // Shade over half of the patch makes opposite sectors differ, but less than black from white.
  if (cross.asymmetry > (light == Lighting::even ? 0.32 : 0.5)) return std::nullopt;
  const std::uint32_t below = bits_below(profile.even.data(), middle);
  std::uint32_t changes = below ^ (below >> 1 | (below & 1) << (half_size - 1));  // from one direction to the next
  if (std::popcount(changes) != 2) return std::nullopt;
  for (double& edge : cross.edges) {
    const int i = std::countr_zero(changes);
    changes &= changes - 1;
    const float here = profile.even[i] - middle, next = profile.even[(i + 1) % half_size] - middle;
    const double angle = M_PI / half_size * (i + here / (here - next));
    edge = angle < M_PI ? angle : angle - M_PI;
  }
  // Measured on right angles: 0.77 at 0.9 px of blur, 0.55 at 2 px; and the circles then miss a part of the contrast.
  // Never sharper than 0.9 px: a start that is off by more than the blur would see no slope.
  cross.blur = std::clamp(2.0 - 5.0 * (flatness(profile, middle) - 0.55), 0.9, 2.5);
  if (cross.edges[0] > cross.edges[1]) std::swap(cross.edges[0], cross.edges[1]);
  const double between = 0.5 * (cross.edges[0] + cross.edges[1]);
  const int index = static_cast<int>(std::lround(between * half_size / M_PI)) % half_size;
  cross.level = middle;
  cross.half_contrast = (profile.even[index] > middle ? -0.5 : 0.5) * contrast * (1 + 0.25 * cross.blur * cross.blur);
  cross.profile = profile.even;
  // Two thirds: this is a guess yet.
  if (3 * std::abs(cross.half_contrast) < min_contrast) return std::nullopt;
  return cross;
}

double sector_misfit(const CrossStructure& cross, double enough) {
  std::array<float, half_size> even = cross.profile;
  const float mean = std::accumulate(even.begin(), even.end(), 0.f) / half_size;
  for (float& value : even) value -= mean;
  const auto most = static_cast<float>((half_size - 3) * enough * enough);
  return std::sqrt(std::max(left_by_sectors(circles(), cross.edges, even.data(), most), 0.f) / (half_size - 3));
}

}  // namespace handsight
