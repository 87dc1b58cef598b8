// SPDX-License-Identifier: Apache-2.0
// The same instructions in 8 lanes where the processor has AVX2, in 2 x 4 elsewhere, and where it pays in 16 where it
// has AVX-512: results are the same bit by bit.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__x86_64__) && defined(__ELF__) && !defined(HANDSIGHT_NO_CLONES)
#define HANDSIGHT_LANES __attribute__((target_clones("avx2", "default")))
#define HANDSIGHT_WIDE __attribute__((target("avx512f,avx512vl,avx512dq,avx512bw")))
#else
#define HANDSIGHT_LANES
#define HANDSIGHT_WIDE
#endif
#define HANDSIGHT_INLINE inline __attribute__((always_inline))

namespace handsight {

constexpr int simd_lanes = 8, wide_simd_lanes = 16;
using Simd = float __attribute__((vector_size(simd_lanes * sizeof(float))));
using Whole = std::int32_t __attribute__((vector_size(simd_lanes * sizeof(std::int32_t))));
using WideSimd = float __attribute__((vector_size(wide_simd_lanes * sizeof(float))));
using WideWhole = std::int32_t __attribute__((vector_size(wide_simd_lanes * sizeof(std::int32_t))));

template <class Vector>
constexpr int lanes_of_simd = sizeof(Vector) / sizeof(float);

// Rounded up to whole groups of the wider lanes, in which everything comes, so that results do not depend on the lanes.
constexpr int in_groups(int count) { return (count + wide_simd_lanes - 1) / wide_simd_lanes * wide_simd_lanes; }

template <class Vector>
struct WholeOf;
template <>
struct WholeOf<Simd> {
  using Type = Whole;
};
template <>
struct WholeOf<WideSimd> {
  using Type = WideWhole;
};

// Whether functions marked HANDSIGHT_WIDE may be called; tests turn it off to compare.
inline bool& has_wide_simd() {
#if defined(__x86_64__) && defined(__ELF__)
  static bool has = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                    __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
#else
  static bool has = false;
#endif
  return has;
}

template <class Vector>
HANDSIGHT_INLINE void load(const float* from, Vector& to) {
  std::memcpy(&to, from, sizeof to);
}

template <class Vector>
HANDSIGHT_INLINE void store(const Vector& from, float* to) {
  std::memcpy(to, &from, sizeof from);
}

// exp(-t) for 0 <= t, to 2e-6: a polynomial for the fraction of the power of two, its whole part into the exponent.
template <class Vector>
HANDSIGHT_INLINE void exp_minus(const Vector& t, Vector& result) {
  using Integers = typename WholeOf<Vector>::Type;
  const Vector y = (t < 80.f ? t : Vector{} + 80.f) * 1.44269504f;
  const Integers whole = __builtin_convertvector(y, Integers);
  const Vector x = __builtin_convertvector(whole, Vector) - y;  // in (-1, 0]
  const Vector x2 = x * x;
  const Vector low = 0.99999804f + 0.69304893f * x, high = 0.2394306f + 0.05321312f * x;
  const Integers exponent = (127 - whole) << 23;
  Vector power;
  std::memcpy(&power, &exponent, sizeof power);
  result = (low + x2 * (high + 0.00683515f * x2)) * power;
}

// erf(x) and its derivative / (2 / sqrt(pi)) by Abramowitz and Stegun 7.1.25, to 3e-5: of a contrast of 200 grey levels
// it is a hundredth of one.
template <class Vector>
HANDSIGHT_INLINE void erf_and_bell(const Vector& x, Vector& erf, Vector& bell) {
  const Vector a = x < 0.f ? -x : x;
  exp_minus(a * a, bell);
  const Vector t = 1.f / (1.f + 0.47047f * a);
  const Vector value = 1.f - t * (0.3480242f + t * (0.7478556f * t - 0.0958798f)) * bell;
  erf = x < 0.f ? -value : value;
}

// Two at once share the division.
template <class Vector>
HANDSIGHT_INLINE void erfs_and_bells(const Vector& x, const Vector& y, Vector& erf_x, Vector& bell_x, Vector& erf_y,
                                     Vector& bell_y) {
  const Vector a = x < 0.f ? -x : x, b = y < 0.f ? -y : y;
  exp_minus(a * a, bell_x), exp_minus(b * b, bell_y);
  const Vector over_a = 1.f + 0.47047f * a, over_b = 1.f + 0.47047f * b, both = 1.f / (over_a * over_b);
  const Vector s = both * over_b, t = both * over_a;
  const Vector value_x = 1.f - s * (0.3480242f + s * (0.7478556f * s - 0.0958798f)) * bell_x;
  const Vector value_y = 1.f - t * (0.3480242f + t * (0.7478556f * t - 0.0958798f)) * bell_y;
  erf_x = x < 0.f ? -value_x : value_x, erf_y = y < 0.f ? -value_y : value_y;
}

// A sum over groups of 16, in which each lane of its own adds up every 16th: in two parts or in one.
template <class Vector>
struct Sum {
  static constexpr int part_count = wide_simd_lanes / lanes_of_simd<Vector>;
  Vector part[part_count]{};
};

HANDSIGHT_INLINE void fold(const Sum<Simd>& sum, Simd& to) { to = sum.part[0] + sum.part[1]; }
HANDSIGHT_INLINE void fold(const Sum<WideSimd>& sum, Simd& to) {
  Simd high;
  std::memcpy(&to, &sum, sizeof to);
  std::memcpy(&high, reinterpret_cast<const char*>(&sum) + sizeof to, sizeof high);
  to += high;
}

using Four = float __attribute__((vector_size(16)));

HANDSIGHT_INLINE void fold(const Simd& sum, Four& to) {
  Four high;
  std::memcpy(&to, &sum, sizeof to);
  std::memcpy(&high, reinterpret_cast<const char*>(&sum) + sizeof to, sizeof high);
  to += high;
}

HANDSIGHT_INLINE float total(const Simd& sum) {
  Four four;
  fold(sum, four);
  return (four[0] + four[2]) + (four[1] + four[3]);
}

// Whether any lane of either is below `bound`. Comparisons are not looked at themselves: of wide lanes they are slow.
HANDSIGHT_INLINE void add_halves(const Simd& lanes, Simd& to) { to = lanes; }
HANDSIGHT_INLINE void add_halves(const WideSimd& lanes, Simd& to) { fold(Sum<WideSimd>{{lanes}}, to); }
template <class Vector>
HANDSIGHT_INLINE bool any_below(const Vector& a, const Vector& b, float bound) {
  const Vector least = a < b ? a : b, zero{};
  Simd below;
  add_halves(least < bound ? bound - least : zero, below);
  return total(below) > 0;
}

// Four totals at once, each the same as alone.
HANDSIGHT_INLINE void totals(const Simd* sums, float* to) {
  Four a, b, c, d;
  fold(sums[0], a), fold(sums[1], b), fold(sums[2], c), fold(sums[3], d);
  const Four ab = __builtin_shufflevector(a, b, 0, 4, 1, 5) + __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Four cd = __builtin_shufflevector(c, d, 0, 4, 1, 5) + __builtin_shufflevector(c, d, 2, 6, 3, 7);
  const Four all = __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
  std::memcpy(to, &all, sizeof all);
}

}  // namespace handsight
