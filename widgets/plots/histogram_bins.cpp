// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/histogram_bins.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "base/median.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

int number_of_bin(double place) { return static_cast<int>(std::floor(place / histogram_bin)); }

std::optional<NoiseShape> find_noise(const ObservationCell& cell, SizeUnit unit) {
  if (cell.noise) return cell.noise;
  if (unit != SizeUnit::sigma) return std::nullopt;
  return NoiseShape{1, static_cast<double>(cell.coordinates)};
}

/// Probability that noise alone gives a size of less than `size`.
double noise_below(double size, const NoiseShape& noise) {
  const double coordinates = std::max(noise.coordinates, 1.0), ratio = size / noise.size;
  return boost::math::cdf(boost::math::chi_squared(coordinates), ratio * ratio * coordinates);
}

}  // namespace

bool counts_in(const ObservationCell& cell, SizeUnit unit) {
  const ShownSize size = reported_size(cell);
  return cell.state == CellState::used && size.value && size.unit == unit;
}

double place_of_size(double size, double smallest) { return std::log10(std::max(size, smallest)); }

std::map<int, SizeBin> size_bins(const std::vector<ObservationCell>& cells, SizeUnit unit, double smallest) {
  std::map<int, SizeBin> bins;
  for (const ObservationCell& cell : cells) {
    if (!counts_in(cell, unit)) continue;
    SizeBin& bin = bins[number_of_bin(place_of_size(*reported_size(cell).value, smallest))];
    bin.ids.push_back(cell.id);
    // Without a known noise a middling grey: neither good nor bad.
    const int step = cell.rms_over_sigma ? residual_step(*cell.rms_over_sigma, cell.coordinates) : 1;
    ++bin.steps[static_cast<std::size_t>(step)];
  }
  return bins;
}

std::optional<double> typical_noise(const std::vector<ObservationCell>& cells, SizeUnit unit) {
  std::vector<double> sizes;
  for (const ObservationCell& cell : cells)
    if (const auto noise = find_noise(cell, unit); noise && counts_in(cell, unit)) sizes.push_back(noise->size);
  if (sizes.empty()) return std::nullopt;
  return median(std::move(sizes));
}

std::map<int, double> noise_bins(const std::vector<ObservationCell>& cells, SizeUnit unit) {
  std::map<int, double> bins;
  const auto typical = typical_noise(cells, unit);
  if (!typical || *typical <= 0) return bins;
  // Thousands of observations have few shapes of noise, as far as a histogram can show them.
  constexpr double of_size = 0.01, of_coordinates = 0.5;
  std::map<std::pair<long, long>, int> shapes;
  for (const ObservationCell& cell : cells)
    if (const auto noise = find_noise(cell, unit); noise && noise->size > 0 && counts_in(cell, unit))
      ++shapes[{std::lround(std::log10(noise->size) / of_size), std::lround(noise->coordinates / of_coordinates)}];
  const int middle = number_of_bin(std::log10(*typical));
  for (int bin = middle - 12; bin < middle + 9; ++bin) {
    const double low = std::pow(10, bin * histogram_bin), high = std::pow(10, (bin + 1) * histogram_bin);
    double& expected = bins[bin];
    for (const auto& [shape, times] : shapes) {
      const NoiseShape noise{std::pow(10, of_size * static_cast<double>(shape.first)),
                             of_coordinates * static_cast<double>(shape.second)};
      expected += times * (noise_below(high, noise) - noise_below(low, noise));
    }
  }
  return bins;
}

}  // namespace handsight::widgets
