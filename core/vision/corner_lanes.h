// SPDX-License-Identifier: Apache-2.0
// The same instructions in 8 lanes where the processor has AVX2, in 2 x 4 elsewhere: results are the same bit by bit.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__x86_64__) && defined(__ELF__)
#define HANDSIGHT_LANES __attribute__((target_clones("avx2", "default")))
#else
#define HANDSIGHT_LANES
#endif
#define HANDSIGHT_INLINE inline __attribute__((always_inline))

namespace handsight {

constexpr int kLanes = 8;
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using Whole = std::int32_t __attribute__((vector_size(kLanes * sizeof(std::int32_t))));

HANDSIGHT_INLINE void load(const float* from, Lanes& to) { std::memcpy(&to, from, sizeof to); }
HANDSIGHT_INLINE void store(const Lanes& from, float* to) { std::memcpy(to, &from, sizeof from); }

// exp(-t) for 0 <= t, to 2e-6: a polynomial for the fraction of the power of two, its whole part into the exponent.
HANDSIGHT_INLINE void exp_minus(const Lanes& t, Lanes& result) {
  const Lanes y = (t < 80.f ? t : Lanes{} + 80.f) * 1.44269504f;
  const Whole whole = __builtin_convertvector(y, Whole);
  const Lanes x = __builtin_convertvector(whole, Lanes) - y;  // in (-1, 0]
  const Lanes x2 = x * x;
  const Lanes low = 0.99999804f + 0.69304893f * x, high = 0.2394306f + 0.05321312f * x;
  const Whole exponent = (127 - whole) << 23;
  Lanes power;
  std::memcpy(&power, &exponent, sizeof power);
  result = (low + x2 * (high + 0.00683515f * x2)) * power;
}

// erf(x) and its derivative / (2 / sqrt(pi)) by Abramowitz and Stegun 7.1.25, to 3e-5: of a contrast of 200 grey levels
// it is a hundredth of one.
HANDSIGHT_INLINE void erf_and_bell(const Lanes& x, Lanes& erf, Lanes& bell) {
  const Lanes a = x < 0.f ? -x : x;
  exp_minus(a * a, bell);
  const Lanes t = 1.f / (1.f + 0.47047f * a);
  const Lanes value = 1.f - t * (0.3480242f + t * (0.7478556f * t - 0.0958798f)) * bell;
  erf = x < 0.f ? -value : value;
}

HANDSIGHT_INLINE float total(const Lanes& sum) {
  float __attribute__((vector_size(16))) low, high;
  std::memcpy(&low, &sum, sizeof low);
  std::memcpy(&high, reinterpret_cast<const char*>(&sum) + sizeof low, sizeof high);
  low += high;
  return (low[0] + low[2]) + (low[1] + low[3]);
}

}  // namespace handsight
