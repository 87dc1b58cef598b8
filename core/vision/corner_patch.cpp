// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_patch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "vision/corner_lanes.h"

namespace handsight {
namespace {

constexpr double kSharp = 0.7;  // px, of blur: below it the pixel's own shape matters

// Offsets from the central pixel, nearest first: the first count[r] of them are the disc of r px.
struct Disc {
  std::vector<std::array<std::int8_t, 2>> offsets;
  std::array<int, kMostPatchRadius + 3> count{};
  CornerPatch::Row u, v;  // the offsets again; 1000 px where there are no more
  std::array<int, kMostPatchPixels> u_whole{}, v_whole{};
};

const Disc& disc() {
  static const Disc made = [] {
    Disc d;
    constexpr int most = kMostPatchRadius + 2;
    for (int v = -most; v <= most; ++v)
      for (int u = -most; u <= most; ++u)
        if (u * u + v * v <= most * most)
          d.offsets.push_back({static_cast<std::int8_t>(u), static_cast<std::int8_t>(v)});
    const auto square = [](const auto& o) { return o[0] * o[0] + o[1] * o[1]; };
    std::stable_sort(d.offsets.begin(), d.offsets.end(),
                     [&](const auto& a, const auto& b) { return square(a) < square(b); });
    for (int r = 0; r <= most; ++r)
      d.count[r] = static_cast<int>(
          std::count_if(d.offsets.begin(), d.offsets.end(), [&](const auto& o) { return square(o) <= r * r; }));
    d.u.fill(1e3f), d.v.fill(1e3f);
    for (std::size_t n = 0; n < d.offsets.size(); ++n) {
      d.u_whole[n] = d.offsets[n][0], d.v_whole[n] = d.offsets[n][1];
      d.u[n] = d.offsets[n][0], d.v[n] = d.offsets[n][1];
    }
    return d;
  }();
  return made;
}

// A blurred edge at distance d: its value in -1 to 1 and its derivatives by d and by the blur.
struct Edge {
  Lanes value, slope, spread;
};

struct SmoothEdge {  // lens and pixel together as one Gaussian
  float scale, slope_scale, per_blur;
  explicit SmoothEdge(double blur)
      : scale(static_cast<float>(M_SQRT1_2 / blur)),
        slope_scale(static_cast<float>(M_2_SQRTPI * M_SQRT1_2 / blur)),
        per_blur(static_cast<float>(-1 / blur)) {}
  HANDSIGHT_INLINE void operator()(const Lanes& d, Edge& edge) const {
    erf_and_bell(scale * d, edge.value, edge.slope);
    edge.slope *= slope_scale;
    edge.spread = d * edge.slope * per_blur;
  }
};

// A Gaussian averaged over a pixel's width, for images so sharp that the pixel is no Gaussian any more.
struct SharpEdge {
  float scale, per_scale, spread_scale;
  explicit SharpEdge(double blur) {
    const double lens = std::sqrt(std::max(blur * blur - 1 / 12.0, 0.01));
    scale = static_cast<float>(M_SQRT1_2 / lens);
    per_scale = static_cast<float>(0.5 * M_2_SQRTPI * M_SQRT2 * lens);
    spread_scale = static_cast<float>(M_SQRT1_2 * M_2_SQRTPI * blur / lens);
  }
  HANDSIGHT_INLINE void operator()(const Lanes& d, Edge& edge) const {
    const Lanes before = d - 0.5f, after = d + 0.5f;
    Lanes f0, f1, g0, g1;
    erf_and_bell(scale * before, f0, g0);
    erf_and_bell(scale * after, f1, g1);
    edge.value = after * f1 - before * f0 + per_scale * (g1 - g0);
    edge.slope = f1 - f0;
    edge.spread = spread_scale * (g1 - g0);
  }
};

// The model's numbers as the loop needs them.
struct Constants {
  const Disc& disc;
  float pu, pv, s1, c1, s2, c2, level, half, hu, hv, rim, taper;
  Constants(const CornerModel& model, const Eigen::Vector2i& centre, double radius) : disc(handsight::disc()) {
    const auto set = [](float& to, double value) { to = static_cast<float>(value); };
    set(pu, model.position.x() - centre.x()), set(pv, model.position.y() - centre.y());
    set(s1, std::sin(model.edges[0])), set(c1, std::cos(model.edges[0]));
    set(s2, std::sin(model.edges[1])), set(c2, std::cos(model.edges[1]));
    set(level, model.level), set(half, model.half_contrast);
    set(hu, model.shade.x()), set(hv, model.shade.y());
    set(taper, 0.5 / radius), set(rim, (radius + 0.5) * (radius + 0.5) * 0.5 / radius);
  }
};

template <bool WithDerivatives, class EdgeShape>
HANDSIGHT_INLINE void evaluate_with(const EdgeShape& shape, const Constants& c, int begin, int end,
                                    CornerPatch& patch) {
  const float *const all_u = c.disc.u.data(), *const all_v = c.disc.v.data();
  const Lanes zero{}, one = zero + 1.f;
  for (int n = begin; n < end; n += kLanes) {
    Lanes u, v, value;
    load(all_u + n, u), load(all_v + n, v), load(&patch.value[n], value);
    const Lanes x = u - c.pu, y = v - c.pv;
    Lanes w = c.rim - (x * x + y * y) * c.taper;
    w = w < zero ? zero : w;
    w = w > one ? one : w;
    Edge a, b;
    shape(c.c1 * y - c.s1 * x, a);
    shape(c.c2 * y - c.s2 * x, b);
    const Lanes f = a.value * b.value, base = w * (c.level + c.half * f);
    store(w, &patch.weight[n]);
    store(w * value - (1.f + c.hu * x + c.hv * y) * base, &patch.residual[n]);
    if constexpr (!WithDerivatives) continue;
    const Lanes wh = w * c.half;
    const Lanes ea = wh * a.slope * b.value, eb = wh * b.slope * a.value;  // dI/dd of either edge
    store(c.s1 * ea + c.s2 * eb, &patch.odd[0][n]);
    store(-c.c1 * ea - c.c2 * eb, &patch.odd[1][n]);
    store(x * base, &patch.odd[2][n]);
    store(y * base, &patch.odd[3][n]);
    store(-(c.c1 * x + c.s1 * y) * ea, &patch.even[0][n]);
    store(-(c.c2 * x + c.s2 * y) * eb, &patch.even[1][n]);
    store(wh * (a.spread * b.value + b.spread * a.value), &patch.even[2][n]);
    store(w, &patch.even[3][n]);
    store(w * f, &patch.even[4][n]);
  }
}

HANDSIGHT_LANES void evaluate_smooth(const SmoothEdge& shape, const Constants& c, int begin, int end,
                                     CornerPatch& patch) {
  evaluate_with<true>(shape, c, begin, end, patch);
}

HANDSIGHT_LANES void residuals_smooth(const SmoothEdge& shape, const Constants& c, int begin, int end,
                                      CornerPatch& patch) {
  evaluate_with<false>(shape, c, begin, end, patch);
}

HANDSIGHT_LANES void evaluate_sharp(const SharpEdge& shape, const Constants& c, int begin, int end,
                                    CornerPatch& patch) {
  evaluate_with<true>(shape, c, begin, end, patch);
}

// What `evaluate` left, under the light of the shadow.
HANDSIGHT_LANES void put_in_shadow(const ShadowEdge& shadow, const Eigen::Vector2d& corner, int begin, int end,
                                   CornerPatch& patch) {
  const float *const all_u = disc().u.data(), *const all_v = disc().v.data();
  const auto nu = static_cast<float>(std::cos(shadow.direction)), nv = static_cast<float>(std::sin(shadow.direction));
  const auto pu = static_cast<float>(corner.x()), pv = static_cast<float>(corner.y());
  const auto distance = static_cast<float>(shadow.distance), half_depth = static_cast<float>(0.5 * shadow.depth);
  const auto scale = static_cast<float>(M_SQRT1_2 / shadow.softness);
  const auto slope = static_cast<float>(0.5 * M_2_SQRTPI * M_SQRT1_2 * shadow.depth / shadow.softness);
  const auto per_softness = static_cast<float>(1 / shadow.softness);
  for (int n = begin; n < end; n += kLanes) {
    Lanes u, v, weight, value, residual, erf, bell;
    load(all_u + n, u), load(all_v + n, v);
    load(&patch.weight[n], weight), load(&patch.value[n], value), load(&patch.residual[n], residual);
    const Lanes x = u - pu, y = v - pv, beyond = nu * x + nv * y - distance;
    erf_and_bell(scale * beyond, erf, bell);
    const Lanes light = 1.f - half_depth * (1.f + erf), lit = weight * value - residual, steep = slope * lit * bell;
    store(weight * value - light * lit, &patch.residual[n]);
    store(steep * (nv * x - nu * y), &patch.shadow[0][n]);
    store(steep, &patch.shadow[1][n]);
    store(-0.5f * (1.f + erf) * lit, &patch.shadow[2][n]);
    store(steep * beyond * per_softness, &patch.shadow[3][n]);
    for (CornerPatch::Row& row : patch.odd) load(&row[n], value), store(light * value, &row[n]);
    for (CornerPatch::Row& row : patch.even) load(&row[n], value), store(light * value, &row[n]);
  }
}

// Products of `row` with the first rows and itself, and with the residual: few enough sums to stay in registers.
template <int Rows>
HANDSIGHT_INLINE void row_products(const CornerPatch::Row* rows, const CornerPatch::Row& residual, int count,
                                   float* triangle, float* side) {
  Lanes a[Rows], sum[Rows]{}, sides{}, rest;
  for (int n = 0; n < count; n += kLanes) {
#pragma GCC unroll 8
    for (int i = 0; i < Rows; ++i) load(&rows[i][n], a[i]);
    load(&residual[n], rest);
#pragma GCC unroll 8
    for (int i = 0; i < Rows; ++i) sum[i] += a[Rows - 1] * a[i];
    sides += a[Rows - 1] * rest;
  }
#pragma GCC unroll 8
  for (int i = 0; i < Rows; ++i) triangle[Rows * (Rows - 1) / 2 + i] = total(sum[i]);
  side[Rows - 1] = total(sides);
}

HANDSIGHT_LANES void add_up_odd(const CornerPatch& patch, PatchSums& result) {
  const int count = patch.padded;
  const CornerPatch::Row *const odd = patch.odd.data(), &rest_of = patch.residual;
  row_products<1>(odd, rest_of, count, result.odd.data(), result.odd_side.data());
  row_products<2>(odd, rest_of, count, result.odd.data(), result.odd_side.data());
  row_products<3>(odd, rest_of, count, result.odd.data(), result.odd_side.data());
  row_products<4>(odd, rest_of, count, result.odd.data(), result.odd_side.data());
}

HANDSIGHT_LANES void add_up_even(const CornerPatch& patch, PatchSums& result) {
  const int count = patch.padded;
  const CornerPatch::Row *const even = patch.even.data(), &rest_of = patch.residual;
  row_products<1>(even, rest_of, count, result.even.data(), result.even_side.data());
  row_products<2>(even, rest_of, count, result.even.data(), result.even_side.data());
  row_products<3>(even, rest_of, count, result.even.data(), result.even_side.data());
  row_products<4>(even, rest_of, count, result.even.data(), result.even_side.data());
  row_products<5>(even, rest_of, count, result.even.data(), result.even_side.data());
  Lanes squares{}, rest;
  for (int n = 0; n < count; n += kLanes) {
    load(&patch.residual[n], rest);
    squares += rest * rest;
  }
  result.squares = total(squares);
  result.weights = result.even[9];  // level with level
}

}  // namespace

int pixels_in_disc(int radius) { return disc().count[radius]; }

Eigen::Vector2i offset_of_pixel(int number) { return {disc().offsets[number][0], disc().offsets[number][1]}; }

void gather(const Image& image, const Eigen::Vector2i& centre, int radius, CornerPatch& patch) {
  const Disc& d = disc();
  patch.count = d.count[radius];
  patch.padded = (patch.count + kLanes - 1) / kLanes * kLanes;
  // What is left of a larger disc beyond `count` gets no weight, as it lies beyond the rim.
  if (centre == patch.centre && patch.gathered >= radius) return;
  patch.centre = centre, patch.gathered = radius;
  const std::uint8_t* const middle = image.row(centre.y()) + centre.x();
  for (int n = 0; n < patch.count; ++n) patch.value[n] = middle[d.v_whole[n] * image.width + d.u_whole[n]];
  for (int n = patch.count; n < patch.padded; ++n) patch.value[n] = 0;
}

void evaluate(const CornerModel& model, double radius, int begin, int end, CornerPatch& patch) {
  const Constants constants(model, patch.centre, radius);
  if (model.blur < kSharp)
    evaluate_sharp(SharpEdge(model.blur), constants, begin, end, patch);
  else
    evaluate_smooth(SmoothEdge(model.blur), constants, begin, end, patch);
  if (model.shadow.depth != 0)
    put_in_shadow(model.shadow, model.position - patch.centre.cast<double>(), begin, end, patch);
}

void evaluate_residuals(const CornerModel& model, double radius, int begin, int end, CornerPatch& patch) {
  if (has_shadow(model) || model.blur < kSharp) return evaluate(model, radius, begin, end, patch);
  residuals_smooth(SmoothEdge(model.blur), Constants(model, patch.centre, radius), begin, end, patch);
}

PatchSums sums(const CornerPatch& patch) {
  PatchSums result;
  add_up_odd(patch, result);
  add_up_even(patch, result);
  return result;
}

std::array<float, 10> odd_sums(const CornerPatch& patch) {
  PatchSums result;
  add_up_odd(patch, result);
  return result.odd;
}

}  // namespace handsight
