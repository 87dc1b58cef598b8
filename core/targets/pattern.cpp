// SPDX-License-Identifier: Apache-2.0
#include "targets/pattern.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "print/circle_grid.h"

namespace handsight {
namespace {

void add_tag(std::vector<Box>& black, const TagPattern& pattern, const Vector2& top_left, double size) {
  const double module = size / pattern.side;
  for (int row = 0; row < pattern.side; ++row)
    for (int column = 0; column < pattern.side; ++column) {
      if (pattern.is_white(column, row)) continue;
      int end = column;
      while (end < pattern.side && !pattern.is_white(end, row)) ++end;
      black.push_back({top_left + Vector2(column * module, row * module), Vector2((end - column) * module, module)});
      column = end;
    }
}

/// Squares of a chessboard or ChArUco board from `first` on; the first is black unless `first_is_white`.
void add_squares(std::vector<Box>& black, int columns, int rows, double square, double first, bool first_is_white) {
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      if (((row + column) % 2 == 1) == first_is_white)
        black.push_back({Vector2(first + column * square, first + row * square), Vector2::Constant(square)});
}

/// The black squares where the gaps of a grid cross, which make X-corners of the tags' corners.
void add_crossings(std::vector<Box>& black, const Target& target) {
  const double gap = target.tag * target.spacing, step = target.tag + gap;
  for (int row = 0; row <= target.rows; ++row)
    for (int column = 0; column <= target.columns; ++column)
      black.push_back({Vector2(column * step - gap, row * step - gap), Vector2::Constant(gap)});
}

/// Circles as strips, each as wide as the circle is in the strip's middle.
void add_circles(std::vector<Box>& black, const Target& target) {
  constexpr int strips = 128;
  const double radius = 0.5 * target.tag, height = target.tag / strips;
  for (const TargetPoint& point : circle_points(target))
    for (int i = 0; i < strips; ++i) {
      const double up = (i + 0.5) * height - radius, half = std::sqrt(radius * radius - up * up);
      black.push_back({point.position.head<2>() + Vector2(-half, i * height - radius), Vector2(2 * half, height)});
    }
}

Box outline_of(const std::vector<Box>& boxes) {
  Vector2 lowest = Vector2::Constant(1e300), highest = Vector2::Constant(-1e300);
  for (const Box& box : boxes) {
    lowest = lowest.cwiseMin(box.top_left);
    highest = highest.cwiseMax(box.top_left + box.size);
  }
  return {lowest, highest - lowest};
}

bool first_is_white(const Target& target) {
  return target.kind == TargetKind::charuco && target.old_layout && target.rows % 2 == 0;
}

}  // namespace

PrintedPattern pattern_of(const Target& target, int piece) {
  PrintedPattern pattern;
  if (is_circle_grid(target))
    add_circles(pattern.black, target);
  else if (target.kind == TargetKind::chessboard)
    add_squares(pattern.black, target.columns + 1, target.rows + 1, target.square, -target.square, false);
  if (target.kind == TargetKind::charuco)
    add_squares(pattern.black, target.columns, target.rows, target.square, 0, first_is_white(target));
  if (target.kind == TargetKind::aprilgrid) add_crossings(pattern.black, target);
  if (target.kind != TargetKind::chessboard) {
    const Dictionary* dictionary = find_dictionary(target.dictionary);
    check(dictionary != nullptr, "no dictionary {}", target.dictionary);
    for (const PlacedTag& tag : placed_tags(target))
      if (tag.piece == piece)
        add_tag(pattern.black, tag_pattern(*dictionary, tag.id, target.border), tag.top_left, tag.size);
  }
  pattern.outline = outline_of(pattern.black);
  // Where its corners are white squares a ChArUco board reaches farther than its black boxes.
  if (target.kind == TargetKind::charuco)
    pattern.outline = {Vector2::Zero(), Vector2(target.columns * target.square, target.rows * target.square)};
  return pattern;
}

BlackAt::BlackAt(const Target& target, int piece) : target_(target) {
  if (target.kind == TargetKind::chessboard) return;
  const Dictionary* dictionary = find_dictionary(target.dictionary);
  check(dictionary != nullptr, "no dictionary {}", target.dictionary);
  if (target.kind == TargetKind::charuco)
    tag_of_cell_.assign(static_cast<std::size_t>(target.columns) * target.rows, -1);
  for (const PlacedTag& tag : placed_tags(target)) {
    if (tag.piece != piece) continue;
    if (target.kind == TargetKind::charuco) {
      const auto column = static_cast<int>(tag.top_left.x() / target.square),
                 row = static_cast<int>(tag.top_left.y() / target.square);
      tag_of_cell_[static_cast<std::size_t>(row * target.columns + column)] = static_cast<int>(tags_.size());
    }
    tags_.push_back(tag);
    patterns_.push_back(tag_pattern(*dictionary, tag.id, target.border));
  }
}

bool BlackAt::tag_is_black(std::size_t tag, double x, double y) const {
  const TagPattern& pattern = patterns_[tag];
  const double scale = pattern.side / tags_[tag].size;
  const double column = std::floor((x - tags_[tag].top_left.x()) * scale),
               row = std::floor((y - tags_[tag].top_left.y()) * scale);
  if (!(column >= 0 && row >= 0 && column < pattern.side && row < pattern.side)) return false;
  return !pattern.is_white(static_cast<int>(column), static_cast<int>(row));
}

bool BlackAt::square_is_black(double x, double y) const {
  const bool is_charuco = target_.kind == TargetKind::charuco;
  const int columns = target_.columns + !is_charuco, rows = target_.rows + !is_charuco;
  const double first = is_charuco ? 0 : -target_.square;
  const double column = std::floor((x - first) / target_.square), row = std::floor((y - first) / target_.square);
  if (!(column >= 0 && row >= 0 && column < columns && row < rows)) return false;
  const auto c = static_cast<int>(column), r = static_cast<int>(row);
  if (((r + c) % 2 == 1) == first_is_white(target_)) return true;
  const int tag = is_charuco ? tag_of_cell_[static_cast<std::size_t>(r * target_.columns + c)] : -1;
  return tag >= 0 && tag_is_black(static_cast<std::size_t>(tag), x, y);
}

bool BlackAt::grid_is_black(double x, double y) const {
  const double gap = target_.tag * target_.spacing, step = target_.tag + gap;
  const double column = std::floor((x + gap) / step), row = std::floor((y + gap) / step);  // cells begin with the gap
  if (!(column >= 0 && row >= 0 && column <= target_.columns && row <= target_.rows)) return false;
  const bool in_gap_x = x + gap - column * step < gap, in_gap_y = y + gap - row * step < gap;
  if (in_gap_x || in_gap_y || column == target_.columns || row == target_.rows) return in_gap_x && in_gap_y;
  return tag_is_black(static_cast<std::size_t>((target_.rows - 1 - row) * target_.columns + column), x, y);
}

bool BlackAt::circle_is_black(double x, double y) const {
  const double unit = target_.square, radius = 0.5 * target_.tag;
  const int row = static_cast<int>(std::clamp(std::round(y / unit), 0.0, target_.rows - 1.0));
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, target_.rows - 1);
       ++r) {  // those of the next rows reach in
    const double step = is_asymmetric(target_) ? 2 * unit : unit, first = is_asymmetric(target_) ? r % 2 * unit : 0;
    const double column = std::clamp(std::round((x - first) / step), 0.0, target_.columns - 1.0);
    if (Vector2(x - first - column * step, y - r * unit).squaredNorm() < radius * radius) return true;
  }
  return false;
}

bool BlackAt::operator()(double x, double y) const {
  if (is_circle_grid(target_)) return circle_is_black(x, y);
  switch (target_.kind) {
    case TargetKind::aprilgrid:
      return grid_is_black(x, y);
    case TargetKind::tags:
      return !tags_.empty() && tag_is_black(0, x, y);
    default:
      return square_is_black(x, y);
  }
}

}  // namespace handsight
