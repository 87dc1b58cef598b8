// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/report_pages.h"

#include <algorithm>
#include <numeric>

namespace handsight::app {
namespace {

constexpr double smallest = 0.6;  // of its size

/// The next of those that are left that fits as it is; else the end.
std::vector<int>::iterator next_that_fits(std::vector<int>& left, const std::vector<double>& heights, double room) {
  return std::find_if(left.begin(), left.end(), [&](int i) { return heights[static_cast<std::size_t>(i)] <= room; });
}

std::vector<int>::iterator next_that_shrinks(std::vector<int>& left, const std::vector<double>& heights, double room) {
  return std::find_if(left.begin(), left.end(),
                      [&](int i) { return smallest * heights[static_cast<std::size_t>(i)] <= room; });
}

}  // namespace

std::vector<PlacedPicture> placed_pictures(const std::vector<double>& heights, double page, double free_of_first) {
  std::vector<PlacedPicture> placed;
  std::vector<int> left(heights.size());
  std::iota(left.begin(), left.end(), 0);
  double room = free_of_first;
  const auto put = [&](std::vector<int>::iterator which, double scale) {
    placed.push_back({*which, scale});
    room -= scale * heights[static_cast<std::size_t>(*which)];
    left.erase(which);
  };
  while (!left.empty()) {
    if (const auto fits = next_that_fits(left, heights, room); fits != left.end()) {
      put(fits, 1);
      continue;
    }
    if (const auto shrinks = next_that_shrinks(left, heights, room); shrinks != left.end()) {
      put(shrinks, room / heights[static_cast<std::size_t>(*shrinks)]);
      continue;
    }
    if (room >= page) put(left.begin(), page / heights[static_cast<std::size_t>(left.front())]);  // higher than a page
    room = page;
  }
  return placed;
}

}  // namespace handsight::app
