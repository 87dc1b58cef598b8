// SPDX-License-Identifier: Apache-2.0
// Random numbers that are the same on every platform, from a counter and a seed.
#pragma once

#include <cmath>
#include <cstdint>

#include "geometry/rigid.h"

namespace handsight {

/// A 64 bit word scrambled so that neighbouring words have nothing in common (the finaliser of SplitMix64).
inline std::uint64_t scramble(std::uint64_t word) {
  word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9ull;
  word = (word ^ (word >> 27)) * 0x94D049BB133111EBull;
  return word ^ (word >> 31);
}

/// A stream of random numbers (SplitMix64): equal seeds give equal streams.
struct Random {
  std::uint64_t state = 0;

  Random() = default;
  explicit Random(std::uint64_t seed) : state(scramble(seed + 0x9E3779B97F4A7C15ull)) {}
  /// A stream for one purpose, which does not depend on how many numbers this one has given since.
  Random child(std::uint64_t purpose) const { return Random(scramble(state ^ scramble(purpose + 1))); }
  std::uint64_t word() { return scramble(state += 0x9E3779B97F4A7C15ull); }
  /// In [0, 1).
  double uniform() { return static_cast<double>(word() >> 11) * 0x1.0p-53; }
  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }
  /// In 0 ... count - 1.
  int integer(int count) { return static_cast<int>(uniform() * count); }
  /// Mean 0, standard deviation 1 (Box and Muller; the second of the pair is dropped to keep the stream simple).
  double gaussian() {
    const double length = std::sqrt(-2 * std::log(1 - uniform()));
    return length * std::cos(2 * M_PI * uniform());
  }
  Vector3 gaussian3() {
    const double x = gaussian(), y = gaussian(), z = gaussian();
    return {x, y, z};
  }
};

}  // namespace handsight
