// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_patch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "vision/corners/corner_crossing.h"
#include "vision/corners/corner_simd.h"

namespace handsight {
namespace {

constexpr double sharp = 0.7;  // px, of blur: below it the pixel's own shape matters
// Grey levels beyond which a pixel may be cut off; JPEG spreads the limit a little.
constexpr int white_level = 249, black_level = 2;

// Offsets from the central pixel, nearest first: the first count[r] of them are the disc of r px without its four
// outermost pixels. Those have no weight in a fit with a rim half a pixel inside, wherever in its pixel the corner is,
// and 77 pixels fit five groups where 81 do not.
struct Disc {
  std::vector<std::array<int, 2>> offsets;
  std::array<int, most_patch_radius + 3> count{};
  CornerPatch::Row u, v;  // the offsets again; 1000 px where there are no more
  std::array<int, most_patch_pixels> u_whole{}, v_whole{};
};

const Disc& disc() {
  static const Disc made = [] {
    Disc d;
    constexpr int most = most_patch_radius + 2;
    for (int v = -most; v <= most; ++v)
      for (int u = -most; u <= most; ++u)
        if (u * u + v * v <= most * most) d.offsets.push_back({u, v});
    const auto square = [](const auto& o) { return o[0] * o[0] + o[1] * o[1]; };
    const auto on_axis = [](const auto& o) { return o[0] == 0 || o[1] == 0; };
    const auto rank = [&](const auto& o) { return 2 * square(o) + on_axis(o); };
    std::stable_sort(d.offsets.begin(), d.offsets.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    for (int r = 0; r <= most; ++r)
      d.count[r] = static_cast<int>(
          std::count_if(d.offsets.begin(), d.offsets.end(), [&](const auto& o) { return rank(o) < 2 * r * r + 1; }));
    d.u.fill(1e3f), d.v.fill(1e3f);
    for (std::size_t n = 0; n < d.offsets.size(); ++n) {
      d.u_whole[n] = d.offsets[n][0], d.v_whole[n] = d.offsets[n][1];
      d.u[n] = static_cast<float>(d.offsets[n][0]), d.v[n] = static_cast<float>(d.offsets[n][1]);
    }
    return d;
  }();
  return made;
}

// From the central pixel to all others, in an image of this width; most patches follow others of the same image.
const int* offsets_in(int width) {
  thread_local int last = 0;
  thread_local std::array<int, most_patch_pixels> offsets;
  if (width != last) {
    const Disc& d = disc();
    for (std::size_t n = 0; n < d.offsets.size(); ++n) offsets[n] = d.v_whole[n] * width + d.u_whole[n];
    last = width;
  }
  return offsets.data();
}

// A blurred edge at distance d: its value in -1 to 1 and its derivatives by d and by the blur.
template <class Vector>
struct Edge {
  Vector value, slope, spread;
};

struct SmoothEdge {  // lens and pixel together as one Gaussian
  float scale, slope_scale, per_blur;
  explicit SmoothEdge(double blur)
      : scale(static_cast<float>(M_SQRT1_2 / blur)),
        slope_scale(static_cast<float>(M_2_SQRTPI * M_SQRT1_2 / blur)),
        per_blur(static_cast<float>(-1 / blur)) {}
  template <class Vector>
  HANDSIGHT_INLINE void operator()(const Vector& d, const Vector& e, Edge<Vector>& one, Edge<Vector>& other) const {
    erfs_and_bells<Vector>(scale * d, scale * e, one.value, one.slope, other.value, other.slope);
    one.slope *= slope_scale, other.slope *= slope_scale;
    one.spread = d * one.slope * per_blur, other.spread = e * other.slope * per_blur;
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
  template <class Vector>
  HANDSIGHT_INLINE void operator()(const Vector& d, const Vector& e, Edge<Vector>& one, Edge<Vector>& other) const {
    edge_at(d, one), edge_at(e, other);
  }
  template <class Vector>
  HANDSIGHT_INLINE void edge_at(const Vector& d, Edge<Vector>& edge) const {
    const Vector before = d - 0.5f, after = d + 0.5f;
    Vector f0, f1, g0, g1;
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
  float s1, c1, s2, c2;
  float pu, pv, level, half, hu, hv, rim, taper;
  Crossing crossing;
  int crossing_end = 0;  // of the pixels that lie in its reach
  Constants(const CornerModel& model, const Eigen::Vector2i& centre, double radius)
      : Constants(model, centre, radius, static_cast<float>(model.edges[0]), static_cast<float>(model.edges[1])) {}
  Constants(const CornerModel& model, const Eigen::Vector2i& centre, double radius, float first, float second)
      : disc(handsight::disc()),
        s1(std::sin(first)),
        c1(std::cos(first)),
        s2(std::sin(second)),
        c2(std::cos(second)),
        crossing(c1 * c2 + s1 * s2, s1 * c2 - c1 * s2, model.blur) {
    const auto set = [](float& to, double value) { to = static_cast<float>(value); };
    set(pu, model.position.x() - centre.x()), set(pv, model.position.y() - centre.y());
    set(level, model.level), set(half, model.half_contrast);
    set(hu, model.shade.x()), set(hv, model.shade.y());
    const double reach = std::ceil(crossing.reach + M_SQRT1_2);  // the corner is half a pixel off the central one
    crossing_end = in_groups(disc.count[static_cast<int>(std::min(reach, most_patch_radius + 2.0))]);
    set(taper, 0.5 / radius), set(rim, (radius + 0.5) * (radius + 0.5) * 0.5 / radius);
  }
};

template <class Vector, bool WithDerivatives, bool Crosses, class EdgeShape>
HANDSIGHT_INLINE void evaluate_part(const EdgeShape& shape, const Constants& c, int begin, int end,
                                    CornerPatch& patch) {
  const float *const all_u = c.disc.u.data(), *const all_v = c.disc.v.data();
  const Vector zero{}, one = zero + 1.f;
  [[maybe_unused]] const Crossing& k = c.crossing;
  for (int n = begin; n < end; n += lanes_of_simd<Vector>) {
    Vector u, v, value;
    load(all_u + n, u), load(all_v + n, v), load(&patch.value[n], value);
    const Vector x = u - c.pu, y = v - c.pv;
    Vector w = c.rim - (x * x + y * y) * c.taper;
    w = w < zero ? zero : w;
    w = w > one ? one : w;
    Edge<Vector> a, b;
    const Vector d = c.c1 * y - c.s1 * x, e = c.c2 * y - c.s2 * x;
    shape(d, e, a, b);
    [[maybe_unused]] Shared<Vector> at;
    [[maybe_unused]] Vector shared, turn;
    Vector f = a.value * b.value;
    if constexpr (Crosses) share(k, d, e, at), shared = k.most * at.bell, f += shared;
    const Vector base = w * (c.level + c.half * f);
    store(w, &patch.weight[n]);
    store(w * value - (1.f + c.hu * x + c.hv * y) * base, &patch.residual[n]);
    store(w * f, &patch.even[4][n]);
    if constexpr (!WithDerivatives) continue;
    const Vector wh = w * c.half;
    Vector ea = a.slope * b.value, eb = b.slope * a.value;  // dI/dd of either edge
    Vector spread = a.spread * b.value + b.spread * a.value;
    if constexpr (Crosses) {
      const Vector twice = 2.f * k.narrow * shared, twisted = k.twist * shared;
      ea -= d * twice - e * twisted, eb -= e * twice - d * twisted;
      spread += k.per_blur * at.q * shared;
      turned(k, at, turn), turn *= wh;
    }
    ea *= wh, eb *= wh;
    store(c.s1 * ea + c.s2 * eb, &patch.odd[0][n]);
    store(-c.c1 * ea - c.c2 * eb, &patch.odd[1][n]);
    store(x * base, &patch.odd[2][n]);
    store(y * base, &patch.odd[3][n]);
    Vector first = -(c.c1 * x + c.s1 * y) * ea, second = -(c.c2 * x + c.s2 * y) * eb;
    if constexpr (Crosses) first -= turn, second += turn;
    store(first, &patch.even[0][n]);
    store(second, &patch.even[1][n]);
    store(wh * spread, &patch.even[2][n]);
    store(w, &patch.even[3][n]);
  }
}

// Pixels come nearest first: of the farther ones the edges share nothing.
template <class Vector, bool WithDerivatives, class EdgeShape>
HANDSIGHT_INLINE void evaluate_with(const EdgeShape& shape, const Constants& c, int begin, int end,
                                    CornerPatch& patch) {
  const int middle = std::clamp(c.crossing_end, begin, end);
  evaluate_part<Vector, WithDerivatives, true>(shape, c, begin, middle, patch);
  evaluate_part<Vector, WithDerivatives, false>(shape, c, middle, end, patch);
}

// The numbers of a shadow's edge as the loop needs them.
struct ShadowConstants {
  const Disc& disc;
  float nu, nv, pu, pv, distance, half_depth, scale, slope, per_softness, per_depth, per_half, per_blur;
  SmoothEdge shape;
  std::array<float, 2> sine, cosine;  // of the edges' directions
  std::array<ShadowCrossing, 2> crossings;
  bool shares;
  ShadowConstants(const CornerModel& model, const Eigen::Vector2d& corner, Sharing sharing)
      : disc(handsight::disc()), shape(model.blur), shares(sharing == Sharing::all) {
    if (shares) crossings = find_crossings(model);
    const ShadowEdge& shadow = model.shadow;
    const auto set = [](float& to, double value) { to = static_cast<float>(value); };
    set(nu, std::cos(shadow.direction)), set(nv, std::sin(shadow.direction));
    set(pu, corner.x()), set(pv, corner.y());
    set(distance, shadow.distance), set(half_depth, 0.5 * shadow.depth);
    set(scale, M_SQRT1_2 / shadow.softness), set(per_softness, -1 / shadow.softness);
    set(slope, 0.5 * M_2_SQRTPI * M_SQRT1_2 * shadow.depth / shadow.softness);
    set(per_depth, 1 / shadow.depth), set(per_half, 1 / model.half_contrast), set(per_blur, -1 / model.blur);
    for (int i = 0; i < 2; ++i)
      sine[i] = std::sin(static_cast<float>(model.edges[i])), cosine[i] = std::cos(static_cast<float>(model.edges[i]));
  }
};

// What `evaluate_with` left, under the light of the shadow.
template <class Vector>
HANDSIGHT_INLINE void shade_with(const ShadowConstants& c, int begin, int end, CornerPatch& patch) {
  const float *const all_u = c.disc.u.data(), *const all_v = c.disc.v.data();
  const auto scale_and_add = [&](CornerPatch::Row& row, int n, const Vector& light, const Vector& more) {
    Vector value;
    load(&row[n], value), store(light * value + more, &row[n]);
  };
  for (int n = begin; n < end; n += lanes_of_simd<Vector>) {
    Vector u, v, weight, value, residual, erf, bell;
    load(all_u + n, u), load(all_v + n, v);
    load(&patch.weight[n], weight), load(&patch.value[n], value), load(&patch.residual[n], residual);
    const Vector x = u - c.pu, y = v - c.pv, beyond = c.nu * x + c.nv * y - c.distance;
    erf_and_bell(c.scale * beyond, erf, bell);
    const Vector light = 1.f - c.half_depth * (1.f + erf), lit = weight * value - residual,
                 steep = c.slope * lit * bell;
    // What either edge of the corner shares with the shadow's, times the other edge.
    const Vector d1 = c.cosine[0] * y - c.sine[0] * x, d2 = c.cosine[1] * y - c.sine[1] * x;
    Vector both{}, by_first{}, by_second{}, by_beyond{}, q1{}, q2{};
    if (c.shares) c.crossings[0].exponent(d1, beyond, q1), c.crossings[1].exponent(d2, beyond, q2);
    if (c.shares && any_below<Vector>(q1, q2, ShadowCrossing::nothing_shared)) {
      Edge<Vector> one, other;
      Vector share1, share2, by1, by2, by_shadow1, by_shadow2;
      c.shape(d1, d2, one, other);
      c.crossings[0].share(d1, beyond, q1, share1, by1, by_shadow1);
      c.crossings[1].share(d2, beyond, q2, share2, by2, by_shadow2);
      both = weight * (share1 * other.value + share2 * one.value);
      by_first = weight * (by1 * other.value + share2 * one.slope);
      by_second = weight * (by2 * one.value + share1 * other.slope);
      by_beyond = weight * (by_shadow1 * other.value + by_shadow2 * one.value);
    }
    store(weight * value - light * lit - both, &patch.residual[n]);
    const Vector along = steep - by_beyond;  // by the distance
    store(along * (c.nv * x - c.nu * y), &patch.shadow[0][n]);
    store(along, &patch.shadow[1][n]);
    store(c.per_depth * both - 0.5f * (1.f + erf) * lit, &patch.shadow[2][n]);
    store(along * beyond * -c.per_softness, &patch.shadow[3][n]);
    const Vector none{};
    scale_and_add(patch.odd[0], n, light, c.sine[0] * by_first + c.sine[1] * by_second);
    scale_and_add(patch.odd[1], n, light, -c.cosine[0] * by_first - c.cosine[1] * by_second);
    scale_and_add(patch.odd[2], n, light, none), scale_and_add(patch.odd[3], n, light, none);
    scale_and_add(patch.even[0], n, light, -(c.cosine[0] * x + c.sine[0] * y) * by_first);
    scale_and_add(patch.even[1], n, light, -(c.cosine[1] * x + c.sine[1] * y) * by_second);
    scale_and_add(patch.even[2], n, light, c.per_blur * (d1 * by_first + d2 * by_second));
    scale_and_add(patch.even[3], n, light, none);
    scale_and_add(patch.even[4], n, light, c.per_half * both);
  }
}

// Grey levels as numbers; whether any is cut off.
HANDSIGHT_LANES bool as_values(const std::uint8_t* pixels, int count, float* values) {
  int clipped = 0;
  for (int n = 0; n < count; ++n) {
    values[n] = pixels[n];
    clipped += (pixels[n] > white_level) | (pixels[n] < black_level);
  }
  return clipped > 0;
}

// What the sensor cuts off says no more than that there is at least as much, or as little: where the model agrees the
// pixel has no weight.
HANDSIGHT_LANES void leave_out_clipped(bool has_shadow, int begin, int end, CornerPatch& patch) {
  for (int n = begin; n < end; n += simd_lanes) {
    Simd value, beyond, row, zero{};
    load(&patch.value[n], value), load(&patch.residual[n], beyond);
    const Whole left_out = ((value > static_cast<float>(white_level)) & (beyond < 0.f)) |
                           ((value < static_cast<float>(black_level)) & (beyond > 0.f));
    std::uint64_t any[simd_lanes / 2];
    std::memcpy(any, &left_out, sizeof any);
    if (!(any[0] | any[1] | any[2] | any[3])) continue;
    const auto keep = [&](CornerPatch::Row& all) {
      load(&all[n], row);
      row = left_out ? zero : row;
      store(row, &all[n]);
    };
    keep(patch.weight), keep(patch.residual);
    for (CornerPatch::Row& all : patch.odd) keep(all);
    for (CornerPatch::Row& all : patch.even) keep(all);
    for (CornerPatch::Row& all : patch.shadow)
      if (has_shadow) keep(all);
  }
}

// Each loop twice, in lanes and in wide lanes; the processor decides.
HANDSIGHT_LANES void smooth_simd(const SmoothEdge& shape, const Constants& c, int begin, int end, CornerPatch& patch) {
  evaluate_with<Simd, true>(shape, c, begin, end, patch);
}
HANDSIGHT_WIDE void smooth_in_wide(const SmoothEdge& shape, const Constants& c, int begin, int end,
                                   CornerPatch& patch) {
  evaluate_with<WideSimd, true>(shape, c, begin, end, patch);
}
HANDSIGHT_LANES void residuals_simd(const SmoothEdge& shape, const Constants& c, int begin, int end,
                                    CornerPatch& patch) {
  evaluate_with<Simd, false>(shape, c, begin, end, patch);
}
HANDSIGHT_WIDE void residuals_in_wide(const SmoothEdge& shape, const Constants& c, int begin, int end,
                                      CornerPatch& patch) {
  evaluate_with<WideSimd, false>(shape, c, begin, end, patch);
}
HANDSIGHT_LANES void sharp_simd(const SharpEdge& shape, const Constants& c, int begin, int end, CornerPatch& patch) {
  evaluate_with<Simd, true>(shape, c, begin, end, patch);
}
HANDSIGHT_WIDE void sharp_in_wide(const SharpEdge& shape, const Constants& c, int begin, int end, CornerPatch& patch) {
  evaluate_with<WideSimd, true>(shape, c, begin, end, patch);
}
HANDSIGHT_LANES void shade_simd(const ShadowConstants& c, int begin, int end, CornerPatch& patch) {
  shade_with<Simd>(c, begin, end, patch);
}
HANDSIGHT_WIDE void shade_in_wide(const ShadowConstants& c, int begin, int end, CornerPatch& patch) {
  shade_with<WideSimd>(c, begin, end, patch);
}

}  // namespace

int pixels_in_disc(int radius) { return disc().count[radius]; }

Eigen::Vector2i offset_of_pixel(int number) { return {disc().offsets[number][0], disc().offsets[number][1]}; }

const float* pixel_columns() { return disc().u.data(); }
const float* pixel_rows() { return disc().v.data(); }

void gather(const Image& image, const Eigen::Vector2i& centre, int radius, CornerPatch& patch) {
  const Disc& d = disc();
  patch.count = d.count[radius];
  patch.padded = in_groups(patch.count);
  // What is left of a larger disc beyond `count` gets no weight, as it lies beyond the rim.
  const int there = centre == patch.centre && patch.gathered >= 0 ? d.count[patch.gathered] : 0;
  if (there >= patch.count) return;
  patch.centre = centre, patch.gathered = radius;
  const std::uint8_t* const middle = image.row(centre.y()) + centre.x();
  const int* const offsets = offsets_in(image.width);
  std::array<std::uint8_t, most_patch_pixels> pixels;
#pragma GCC unroll 8
  for (int n = there; n < patch.count; ++n) pixels[n] = middle[offsets[n]];
  const bool is_clipped = as_values(&pixels[there], patch.count - there, &patch.value[there]);
  patch.is_clipped = (there > 0 && patch.is_clipped) || is_clipped;
  for (int n = patch.count; n < patch.padded; ++n) patch.value[n] = 0;
}

void evaluate(const CornerModel& model, double radius, int begin, int end, CornerPatch& patch, Sharing sharing) {
  end = in_groups(end);
  const Constants constants(model, patch.centre, radius);
  if (model.blur < sharp)
    (has_wide_simd() ? sharp_in_wide : sharp_simd)(SharpEdge(model.blur), constants, begin, end, patch);
  else
    (has_wide_simd() ? smooth_in_wide : smooth_simd)(SmoothEdge(model.blur), constants, begin, end, patch);
  if (has_shadow(model)) {
    const ShadowConstants shadow(model, model.position - patch.centre.cast<double>(), sharing);
    (has_wide_simd() ? shade_in_wide : shade_simd)(shadow, begin, end, patch);
  }
  if (patch.is_clipped) leave_out_clipped(has_shadow(model), begin, end, patch);
}

void evaluate_residuals(const CornerModel& model, double radius, int begin, int end, CornerPatch& patch) {
  if (has_shadow(model) || model.blur < sharp || patch.is_clipped) return evaluate(model, radius, begin, end, patch);
  end = in_groups(end);
  const Constants constants(model, patch.centre, radius);
  (has_wide_simd() ? residuals_in_wide : residuals_simd)(SmoothEdge(model.blur), constants, begin, end, patch);
}

}  // namespace handsight
