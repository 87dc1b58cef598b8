// SPDX-License-Identifier: Apache-2.0
#include "simulation/texture.h"

#include <algorithm>
#include <cmath>

#include "simulation/random.h"

namespace handsight {

namespace {

double smooth_step(double x) { return x * x * x * (x * (6 * x - 15) + 10); }

/// Adds value noise with `cells` random values a side, smoothly interpolated and periodic.
void add_octave(int cells, double amplitude, Random& random, std::vector<double>& values) {
  std::vector<double> lattice(static_cast<std::size_t>(cells) * cells);
  for (double& value : lattice) value = random.uniform(-1, 1);
  const double step = static_cast<double>(cells) / Texture::size;
  for (int y = 0; y < Texture::size; ++y) {
    const int y0 = static_cast<int>(y * step), y1 = (y0 + 1) % cells;
    const double fy = smooth_step(y * step - y0);
    for (int x = 0; x < Texture::size; ++x) {
      const int x0 = static_cast<int>(x * step), x1 = (x0 + 1) % cells;
      const double fx = smooth_step(x * step - x0);
      const double top = lattice[y0 * cells + x0] * (1 - fx) + lattice[y0 * cells + x1] * fx;
      const double bottom = lattice[y1 * cells + x0] * (1 - fx) + lattice[y1 * cells + x1] * fx;
      values[static_cast<std::size_t>(y) * Texture::size + x] += amplitude * (top * (1 - fy) + bottom * fy);
    }
  }
}

}  // namespace

Texture make_texture(std::uint64_t seed) {
  Random random(seed);
  std::vector<double> values(static_cast<std::size_t>(Texture::size) * Texture::size, 0.0);
  add_octave(8, 1.0, random, values);
  add_octave(16, 0.6, random, values);
  add_octave(32, 0.35, random, values);
  add_octave(64, 0.2, random, values);
  double mean = 0, largest = 0;
  for (double value : values) mean += value / static_cast<double>(values.size());
  for (double value : values) largest = std::max(largest, std::abs(value - mean));
  Texture texture;
  for (double value : values) texture.values.push_back(static_cast<float>((value - mean) / largest));
  return texture;
}

}  // namespace handsight
