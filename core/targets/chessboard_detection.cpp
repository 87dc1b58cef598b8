// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <deque>

#include "base/error.h"
#include "targets/board_corners.h"
#include "targets/board_detection.h"
#include "targets/sampling.h"
#include "vision/corners/corner_detector.h"

namespace handsight {
namespace {

constexpr double most_askew = 0.35;  // rad, between neighbours' edges, and between a step and an edge
constexpr double most_off = 0.3;     // of a step: how far a neighbour may be from where its like had it

struct Cell {
  int column = 0, row = 0;
  auto operator<=>(const Cell&) const = default;  // NOLINT(modernize-use-nullptr): not of the code
};

/// Corners by their place in a lattice.
using Lattice = std::map<Cell, std::size_t>;

Vector2 along(double angle) { return {std::cos(angle), std::sin(angle)}; }

double apart(double a, double b) { return std::abs(std::remainder(a - b, M_PI)); }

bool alike(const Corner& a, const Corner& b) {
  return std::min(std::max(apart(a.edges[0], b.edges[0]), apart(a.edges[1], b.edges[1])),
                  std::max(apart(a.edges[0], b.edges[1]), apart(a.edges[1], b.edges[0]))) < most_askew;
}

/// The nearest corner along a direction; its distance is a first guess of the step.
std::optional<Vector2> step_along(const std::vector<Corner>& corners, std::size_t seed, double angle) {
  std::optional<Vector2> best;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 between = corners[i].position - corners[seed].position;
    if (i == seed || (best && between.norm() >= best->norm()) || !alike(corners[i], corners[seed])) continue;
    if (std::abs(along(angle).dot(between)) > std::cos(0.2) * between.norm())
      best = along(angle).dot(between) < 0 ? Vector2(-between) : between;
  }
  return best;
}

std::optional<std::size_t> nearest(const std::vector<Corner>& corners, const Vector2& place, double within) {
  std::optional<std::size_t> best;
  double least = within;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (const double distance = (corners[i].position - place).norm(); distance < least) least = distance, best = i;
  return best;
}

/// The step to the neighbour in a direction, from what is known near it.
Vector2 step_from(const std::vector<Corner>& corners, const Lattice& lattice, const Cell& cell, const Cell& direction,
                  const Vector2& otherwise) {
  const auto at = [&](int column, int row) { return lattice.find({column, row}); };
  const auto here = corners[lattice.at(cell)].position;
  if (const auto back = at(cell.column - direction.column, cell.row - direction.row); back != lattice.end())
    return here - corners[back->second].position;
  for (const int side : {-1, 1}) {  // the same step in the next line
    const auto a = at(cell.column + side * direction.row, cell.row + side * direction.column),
               b = at(cell.column + side * direction.row + direction.column,
                      cell.row + side * direction.column + direction.row);
    if (a != lattice.end() && b != lattice.end()) return corners[b->second].position - corners[a->second].position;
  }
  return otherwise;
}

struct Growing {
  const std::vector<Corner>& corners;
  Vector2 right, down;  // first guesses of the steps
  Lattice lattice;
  std::vector<bool> used;
};

void grow(Growing& growing, std::size_t seed, std::size_t most) {
  growing.lattice[{0, 0}] = seed;
  growing.used[seed] = true;
  std::deque<Cell> open{{0, 0}};
  while (!open.empty() && growing.lattice.size() < most) {
    const Cell cell = open.front();
    open.pop_front();
    const std::size_t here = growing.lattice.at(cell);
    for (const Cell direction : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
      const Cell next{cell.column + direction.column, cell.row + direction.row};
      if (growing.lattice.contains(next)) continue;
      const Vector2 first = direction.column * growing.right + direction.row * growing.down;
      const Vector2 step = step_from(growing.corners, growing.lattice, cell, direction, first);
      const auto other = nearest(growing.corners, growing.corners[here].position + step, most_off * step.norm());
      if (!other || growing.used[*other] || !alike(growing.corners[*other], growing.corners[here])) continue;
      growing.lattice[next] = *other;
      growing.used[*other] = true;
      open.push_back(next);
    }
  }
}

/// The lattice from the seed, right-handed as the image shows it (x right, y down).
std::optional<Lattice> lattice_from(const std::vector<Corner>& corners, std::size_t seed, std::size_t most) {
  auto right = step_along(corners, seed, corners[seed].edges[0]),
       down = step_along(corners, seed, corners[seed].edges[1]);
  if (!right || !down) return std::nullopt;
  if (right->x() * down->y() - right->y() * down->x() < 0) std::swap(right, down);
  if (right->x() * down->y() - right->y() * down->x() < 0) *down = -*down;
  Growing growing{corners, *right, *down, {}, std::vector<bool>(corners.size(), false)};
  grow(growing, seed, most);
  return growing.lattice;
}

/// A quarter turn of the numbering, still right-handed.
Lattice quarter_turned(const Lattice& lattice) {
  Lattice result;
  for (const auto& [cell, corner] : lattice) result[{cell.row, -cell.column}] = corner;
  return result;
}

struct Extent {
  Cell least{1 << 20, 1 << 20}, most{-(1 << 20), -(1 << 20)};
  int columns() const { return most.column - least.column + 1; }
  int rows() const { return most.row - least.row + 1; }
};

Extent extent_of(const Lattice& lattice) {
  Extent e;
  for (const auto& [cell, corner] : lattice) {
    e.least = {std::min(e.least.column, cell.column), std::min(e.least.row, cell.row)};
    e.most = {std::max(e.most.column, cell.column), std::max(e.most.row, cell.row)};
  }
  return e;
}

/// Rows and columns at the rim of which only few corners were found are no part of the board.
void trim(Lattice& lattice, int columns, int rows) {
  for (int round = 0; round < 8; ++round) {
    const Extent e = extent_of(lattice);
    const auto is_sparse = [&](auto is_in, int full) {
      return 3 * std::count_if(lattice.begin(), lattice.end(), [&](const auto& at) { return is_in(at.first); }) < full;
    };
    const std::size_t before = lattice.size();
    const auto cut = [&](bool is_too_long, auto is_in, int full) {
      if (is_too_long && is_sparse(is_in, full))
        std::erase_if(lattice, [&](const auto& at) { return is_in(at.first); });
    };
    cut(
        e.columns() > columns, [&](const Cell& c) { return c.column == e.least.column; }, rows);
    cut(
        e.columns() > columns, [&](const Cell& c) { return c.column == e.most.column; }, rows);
    cut(
        e.rows() > rows, [&](const Cell& c) { return c.row == e.least.row; }, columns);
    cut(
        e.rows() > rows, [&](const Cell& c) { return c.row == e.most.row; }, columns);
    if (lattice.size() == before) return;
  }
}

/// Rows and columns at the rim that are hardly there belong to what stands beside the board.
void trim_ragged(Lattice& lattice) {
  for (std::size_t before = 0; before != lattice.size() && !lattice.empty();) {
    before = lattice.size();
    const Extent e = extent_of(lattice);
    const auto cut = [&](auto is_in, int full) {
      const auto count = std::count_if(lattice.begin(), lattice.end(), [&](const auto& at) { return is_in(at.first); });
      if (5 * count < 3 * full) std::erase_if(lattice, [&](const auto& at) { return is_in(at.first); });
    };
    cut([&](const Cell& c) { return c.column == e.least.column; }, e.rows());
    cut([&](const Cell& c) { return c.column == e.most.column; }, e.rows());
    cut([&](const Cell& c) { return c.row == e.least.row; }, e.columns());
    cut([&](const Cell& c) { return c.row == e.most.row; }, e.columns());
  }
}

/// The board's points by number, where the lattice has its size; those that the detector has missed are looked for.
std::optional<std::vector<TargetPixel>> whole_board(const Image& image, const PreparedTarget& target,
                                                    const std::vector<Corner>& corners, const Lattice& lattice,
                                                    int& dropped) {
  const Target& t = target.target;
  const Extent e = extent_of(lattice);
  if (e.columns() != t.columns || e.rows() != t.rows) return std::nullopt;
  if (5 * lattice.size() < 4 * static_cast<std::size_t>(t.columns * t.rows)) return std::nullopt;
  std::vector<std::optional<TargetPixel>> points(target.points.size());
  std::vector<PlacePixel> pairs;
  for (const auto& [cell, corner] : lattice) {
    const int number = (cell.row - e.least.row) * t.columns + cell.column - e.least.column;
    points[static_cast<std::size_t>(number)] =
        TargetPixel{number, corners[corner].position, corners[corner].covariance};
    pairs.push_back({target.points[static_cast<std::size_t>(number)].position.head<2>(), corners[corner].position});
  }
  const auto map = fit_plane_map(pairs, image.width, image.height);
  if (!map) return std::nullopt;
  std::vector<TargetPixel> whole;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i]) points[i] = corner_at(image, *map, expected_corner(target, static_cast<int>(i)), dropped);
    if (!points[i]) return std::nullopt;
    whole.push_back(*points[i]);
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
                                                 const std::vector<Corner>& corners, Lattice lattice, int& dropped) {
  std::optional<std::vector<TargetPixel>> best;
  double most_right = -1e300;
  for (int turns = 0; turns < 4; ++turns, lattice = quarter_turned(lattice)) {
    Lattice cut = lattice;
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
  std::vector<bool> tried(corners.size(), false);
  for (std::size_t seed = 0; seed < corners.size(); ++seed) {
    if (tried[seed]) continue;
    tried[seed] = true;
    const auto lattice = lattice_from(corners, seed, 2 * count);
    if (!lattice || 2 * lattice->size() < count) continue;
    for (const auto& [cell, corner] : *lattice) tried[corner] = true;
    const auto points = numbered(image, target, corners, *lattice, sighting.dropped_points);
    if (!points) continue;
    sighting.points = *points;
    drop_far_points(sighting, target.points, image.width, image.height);
    if (sighting.points.size() == count) return sighting;
    sighting.points.clear();
  }
  sighting.reason = fmt::format("of {} X-corners none form the whole board of {} x {}", corners.size(),
                                target.target.columns, target.target.rows);
  return sighting;
}

std::optional<std::pair<int, int>> chessboard_size(const Image& image) {
  constexpr std::size_t most_points = 4096;
  const auto corners = detect_corners(image, {.max_corners = static_cast<int>(most_points)});
  std::vector<bool> tried(corners.size(), false);
  Lattice best;
  for (std::size_t seed = 0; seed < corners.size(); ++seed) {
    if (tried[seed]) continue;
    tried[seed] = true;
    auto lattice = lattice_from(corners, seed, most_points);
    if (!lattice || lattice->size() < 6) continue;
    for (const auto& [cell, corner] : *lattice) tried[corner] = true;
    trim_ragged(*lattice);
    if (lattice->size() > best.size()) best = std::move(*lattice);
  }
  if (best.size() < 6) return std::nullopt;
  const Extent e = extent_of(best);
  if (10 * best.size() < 9 * static_cast<std::size_t>(e.columns() * e.rows())) return std::nullopt;
  return std::pair(e.columns(), e.rows());
}

}  // namespace handsight
