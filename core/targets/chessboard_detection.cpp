// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/median.h"
#include "targets/board_corners.h"
#include "targets/board_detection.h"
#include "targets/corner_lattice.h"
#include "targets/sampling.h"
#include "vision/corners/corner_detector.h"

namespace handsight {
namespace {

/// A quarter turn of the numbering, still right-handed.
CornerLattice quarter_turned(const CornerLattice& lattice) {
  CornerLattice result;
  for (const auto& [cell, corner] : lattice) result[{cell.row, -cell.column}] = corner;
  return result;
}

int count_in(const CornerLattice& lattice, int LatticeCell::*line, int number) {
  return static_cast<int>(
      std::count_if(lattice.begin(), lattice.end(), [&](const auto& at) { return at.first.*line == number; }));
}

/// Cuts the emptier of the first and the last line, if there are more than `most` and it is half empty.
bool cut_line(CornerLattice& lattice, int LatticeCell::*line, int most, int full) {
  const LatticeExtent e = find_extent(lattice);
  if (lattice.empty() || e.most.*line - e.least.*line + 1 <= most) return false;
  const int first = count_in(lattice, line, e.least.*line), last = count_in(lattice, line, e.most.*line);
  if (2 * std::min(first, last) > full) return false;
  const int number = first < last ? e.least.*line : e.most.*line;
  std::erase_if(lattice, [&](const auto& at) { return at.first.*line == number; });
  return true;
}

/// Rows and columns at the rim of which only few corners were found are no part of the board.
void trim(CornerLattice& lattice, int columns, int rows) {
  for (int round = 0; round < 8; ++round) {
    const bool is_narrower = cut_line(lattice, &LatticeCell::column, columns, rows);
    if (!cut_line(lattice, &LatticeCell::row, rows, columns) && !is_narrower) return;
  }
}

/// Rows and columns at the rim that are hardly there belong to what stands beside the board.
void trim_ragged(CornerLattice& lattice) {
  for (std::size_t before = 0; before != lattice.size() && !lattice.empty();) {
    before = lattice.size();
    const LatticeExtent e = find_extent(lattice);
    const auto cut = [&](auto is_in, int full) {
      const auto count = std::count_if(lattice.begin(), lattice.end(), [&](const auto& at) { return is_in(at.first); });
      if (5 * count < 3 * full) std::erase_if(lattice, [&](const auto& at) { return is_in(at.first); });
    };
    cut([&](const LatticeCell& c) { return c.column == e.least.column; }, e.rows());
    cut([&](const LatticeCell& c) { return c.column == e.most.column; }, e.rows());
    cut([&](const LatticeCell& c) { return c.row == e.least.row; }, e.columns());
    cut([&](const LatticeCell& c) { return c.row == e.most.row; }, e.columns());
  }
}

/// The board's points by number; those that the detector has missed are nothing yet.
using BoardPoints = std::vector<std::optional<TargetPixel>>;

LatticePixels list_pixels(const BoardPoints& points, int columns) {
  LatticePixels pixels;
  for (const auto& point : points)
    if (point) pixels[{point->number % columns, point->number / columns}] = point->pixel;
  return pixels;
}

/// Looks for the points that are lacking where their neighbours say that they are, until no more are found.
void fill(const Image& image, const PreparedTarget& target, BoardPoints& points, int& dropped) {
  const int columns = target.target.columns;
  for (bool is_new = true; is_new;) {
    is_new = false;
    const LatticePixels pixels = list_pixels(points, columns);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i]) continue;
      const int number = static_cast<int>(i);
      const auto guess = guess_pixel(pixels, {number % columns, number / columns});
      if (!guess) continue;
      points[i] =
          corner_at(image, guess->pixel, guess->slope / target.target.square, expected_corner(target, number), dropped);
      is_new = is_new || points[i];
    }
  }
}

/// Does every point lie where its neighbours have it? Between them to a tenth of a step, at the rim to four of
/// them,
/// or as the others do.
bool is_smooth(const std::vector<TargetPixel>& points, int columns) {
  LatticePixels pixels;
  for (const TargetPixel& p : points) pixels[{p.number % columns, p.number / columns}] = p.pixel;
  std::vector<double> errors, most;
  for (const auto& [cell, pixel] : pixels) {
    const auto guess = guess_pixel(pixels, cell);
    if (!guess) continue;
    const double step = std::min(guess->slope.col(0).norm(), guess->slope.col(1).norm());
    errors.push_back((guess->pixel - pixel).norm());
    most.push_back(std::max(1.0, (guess->is_between ? 0.1 : 0.4) * step));
  }
  if (errors.empty()) return true;
  const double usual = median(errors);
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (errors[i] > std::max(most[i], 6 * usual)) return false;
  return true;
}

/// The board's points by number, where the lattice has its size; those that the detector has missed are looked for.
std::optional<std::vector<TargetPixel>> whole_board(const Image& image, const PreparedTarget& target,
                                                    const std::vector<Corner>& corners, const CornerLattice& lattice,
                                                    int& dropped) {
  const Target& t = target.target;
  const LatticeExtent e = find_extent(lattice);
  if (e.columns() != t.columns || e.rows() != t.rows) return std::nullopt;
  if (5 * lattice.size() < 4 * static_cast<std::size_t>(t.columns * t.rows)) return std::nullopt;
  BoardPoints points(target.points.size());
  for (const auto& [cell, corner] : lattice) {
    const int number = (cell.row - e.least.row) * t.columns + cell.column - e.least.column;
    points[static_cast<std::size_t>(number)] =
        TargetPixel{number, corners[corner].position, corners[corner].covariance};
  }
  fill(image, target, points, dropped);
  std::vector<TargetPixel> whole;
  for (const auto& point : points) {
    if (!point) return std::nullopt;
    whole.push_back(*point);
  }
  return whole;
}

/// The first square and the one diagonal to it across the first corner are black.
bool first_square_is_black(const Image& image, const std::vector<TargetPixel>& points, int columns) {
  const Vector2 right = points[1].pixel - points[0].pixel;
  const Vector2 down = points[static_cast<std::size_t>(columns)].pixel - points[0].pixel;
  const auto grey = [&](double x, double y) { return grey_at(image, points[0].pixel + 0.4 * (x * right + y * down)); };
  return grey(1, 1) + grey(-1, -1) < grey(1, -1) + grey(-1, 1);
}

std::optional<std::vector<TargetPixel>> numbered(const Image& image, const PreparedTarget& target,
                                                 const std::vector<Corner>& corners, CornerLattice lattice,
                                                 int& dropped) {
  std::optional<std::vector<TargetPixel>> best;
  double most_right = -1e300;
  for (int turns = 0; turns < 4; ++turns, lattice = quarter_turned(lattice)) {
    CornerLattice cut = lattice;
    trim(cut, target.target.columns, target.target.rows);
    const auto points = whole_board(image, target, corners, cut, dropped);
    if (!points) continue;
    if (!first_square_is_black(image, *points, target.target.columns)) continue;
    const double right = (*points)[1].pixel.x() - (*points)[0].pixel.x();
    if (right > most_right) best = points, most_right = right;
  }
  return best;
}

}  // namespace

TargetSighting detect_chessboard(const Image& image, const PreparedTarget& target) {
  const auto count = target.points.size();
  const auto corners = detect_corners(image, {.max_corners = static_cast<int>(std::max<std::size_t>(2000, 2 * count))});
  TargetSighting sighting;
  for (const CornerLattice& lattice : corner_lattices(image, corners, (count + 1) / 2)) {
    const auto points = numbered(image, target, corners, lattice, sighting.dropped_points);
    if (!points || !is_smooth(*points, target.target.columns)) continue;
    sighting.points = *points;
    return sighting;
  }
  sighting.reason = message("of {} X-corners none form the whole board of {} x {}", corners.size(),
                            target.target.columns, target.target.rows);
  return sighting;
}

std::optional<std::pair<int, int>> chessboard_size(const Image& image) {
  constexpr int most_points = 4096;
  const auto corners = detect_corners(image, {.max_corners = most_points});
  CornerLattice best;
  for (CornerLattice& lattice : corner_lattices(image, corners, 6)) {
    trim_ragged(lattice);
    if (lattice.size() > best.size()) best = std::move(lattice);
  }
  if (best.size() < 6) return std::nullopt;
  const LatticeExtent e = find_extent(best);
  if (10 * best.size() < 9 * static_cast<std::size_t>(e.columns() * e.rows())) return std::nullopt;
  return std::pair(e.columns(), e.rows());
}

}  // namespace handsight
