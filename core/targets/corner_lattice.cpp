// SPDX-License-Identifier: Apache-2.0
#include "targets/corner_lattice.h"

#include <Eigen/QR>
#include <algorithm>
#include <queue>

#include "targets/corner_links.h"

namespace handsight {
namespace {

constexpr std::array<LatticeCell, 4> directions{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};  // from x to y, as rays are

/// A step that waits to be taken: cheap ones first, so that a doubtful one comes late and finds its place taken.
struct Step {
  double cost = 0;
  std::size_t from = 0, ray = 0;
  bool operator<(const Step& other) const { return cost > other.cost; }
};

struct PlacedCorner {
  LatticeCell cell;
  std::size_t turn = 0;  // quarter turns from its first ray to the lattice's x
};

/// Grows one lattice from a corner.
class Growth {
 public:
  Growth(const std::vector<RayCorner>& corners, const std::vector<std::array<CornerLink, 4>>& links,
         std::vector<bool>& is_used)
      : corners_(corners), links_(links), is_used_(is_used), placed_(corners.size()) {}

  CornerLattice from(std::size_t seed) {
    place(seed, {{0, 0}, 0});
    while (!open_.empty()) {
      const Step step = open_.top();
      open_.pop();
      take(step);
    }
    return std::move(lattice_);
  }

 private:
  void place(std::size_t corner, const PlacedCorner& placed) {
    is_used_[corner] = true;
    placed_[corner] = placed;
    lattice_[placed.cell] = corner;
    for (std::size_t ray = 0; ray < 4; ++ray)
      if (links_[corner][ray].corner >= 0) open_.push({links_[corner][ray].cost, corner, ray});
  }

  void take(const Step& step) {
    const CornerLink& link = links_[step.from][step.ray];
    const auto to = static_cast<std::size_t>(link.corner);
    const PlacedCorner& here = placed_[step.from];
    const std::size_t direction = (step.ray + here.turn) % 4;
    const LatticeCell cell{here.cell.column + directions[direction].column, here.cell.row + directions[direction].row};
    if (is_used_[to] || lattice_.contains(cell) || !is_like_the_last(here.cell, directions[direction], to)) return;
    place(to, {cell, (direction + 2 + 4 - link.ray) % 4});
  }

  /// Does the step go on as the one before it, within what a lens and a tilt can do?
  bool is_like_the_last(const LatticeCell& cell, const LatticeCell& direction, std::size_t to) const {
    constexpr double most_ratio = 1.7, least_cosine = 0.8;
    const auto back = lattice_.find({cell.column - direction.column, cell.row - direction.row});
    if (back == lattice_.end()) return true;
    const Vector2& here = corners_[lattice_.at(cell)].position;
    const Vector2 last = here - corners_[back->second].position, next = corners_[to].position - here;
    return next.norm() < most_ratio * last.norm() && last.norm() < most_ratio * next.norm() &&
           next.dot(last) > least_cosine * next.norm() * last.norm();
  }

  const std::vector<RayCorner>& corners_;
  const std::vector<std::array<CornerLink, 4>>& links_;
  std::vector<bool>& is_used_;
  std::vector<PlacedCorner> placed_;
  CornerLattice lattice_;
  std::priority_queue<Step> open_;
};

/// Columns and rows, of what `cell` is left out.
std::vector<std::pair<Vector2, Vector2>> around(const LatticePixels& pixels, const LatticeCell& cell, int reach) {
  std::vector<std::pair<Vector2, Vector2>> result;
  for (int row = -reach; row <= reach; ++row)
    for (int column = -reach; column <= reach; ++column)
      if (const auto at = pixels.find({cell.column + column, cell.row + row});
          at != pixels.end() && (row != 0 || column != 0))
        result.emplace_back(Vector2(column, row), at->second);
  return result;
}

bool has_both_sides(const LatticePixels& pixels, const LatticeCell& cell) {
  const auto has = [&](int column, int row) { return pixels.contains({cell.column + column, cell.row + row}); };
  return has(-1, 0) && has(1, 0) && has(0, -1) && has(0, 1);
}

/// The value at 0 and the slopes of a surface through the pixels; nearer ones count more.
std::optional<LatticeGuess> surface(const std::vector<std::pair<Vector2, Vector2>>& near, int terms) {
  Eigen::MatrixXd a(near.size(), terms), b(near.size(), 2);
  for (std::size_t i = 0; i < near.size(); ++i) {
    const auto& [at, pixel] = near[i];
    const double weight = 1 / at.squaredNorm();
    Eigen::VectorXd row(6);
    row << 1, at.x(), at.y(), at.x() * at.x(), at.x() * at.y(), at.y() * at.y();
    a.row(static_cast<Eigen::Index>(i)) = weight * row.head(terms).transpose();
    b.row(static_cast<Eigen::Index>(i)) = weight * pixel.transpose();
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
  qr.setThreshold(1e-6);
  if (qr.rank() < terms) return std::nullopt;
  const Eigen::MatrixXd x = qr.solve(b);
  LatticeGuess guess;
  guess.pixel = x.row(0).transpose();
  guess.slope = x.middleRows(1, 2).transpose();
  return guess;
}

}  // namespace

LatticeExtent find_extent(const CornerLattice& lattice) {
  LatticeExtent e;
  for (const auto& [cell, corner] : lattice) {
    e.least = {std::min(e.least.column, cell.column), std::min(e.least.row, cell.row)};
    e.most = {std::max(e.most.column, cell.column), std::max(e.most.row, cell.row)};
  }
  return e;
}

std::vector<CornerLattice> corner_lattices(const Image& image, const std::vector<Corner>& corners, std::size_t least) {
  std::vector<RayCorner> rays;
  rays.reserve(corners.size());
  for (const Corner& corner : corners) rays.push_back(ray_corner(image, corner));
  const auto links = link_corners(rays);
  std::vector<bool> is_used(corners.size(), false);
  std::vector<CornerLattice> lattices;
  for (std::size_t seed = 0; seed < corners.size(); ++seed) {
    if (is_used[seed]) continue;
    CornerLattice lattice = Growth(rays, links, is_used).from(seed);
    if (lattice.size() >= least) lattices.push_back(std::move(lattice));
  }
  std::stable_sort(lattices.begin(), lattices.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return lattices;
}

std::optional<LatticeGuess> guess_pixel(const LatticePixels& pixels, const LatticeCell& cell) {
  constexpr int most_reach = 4;
  constexpr std::size_t enough_to_bend = 9;  // of six numbers
  for (int reach = 2; reach <= most_reach; ++reach) {
    const auto near = around(pixels, cell, reach);
    if (near.size() < enough_to_bend && reach < most_reach) continue;
    auto guess = near.size() >= enough_to_bend ? surface(near, 6) : std::nullopt;
    if (!guess && reach == most_reach && near.size() >= 4) guess = surface(near, 3);
    if (!guess) continue;
    guess->is_between = has_both_sides(pixels, cell);
    return guess;
  }
  return std::nullopt;
}

}  // namespace handsight
