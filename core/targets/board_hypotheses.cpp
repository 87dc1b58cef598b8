// SPDX-License-Identifier: Apache-2.0
#include "targets/board_hypotheses.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace handsight {
namespace {

constexpr int most_columns = 40;

struct Span {
  int least_x = 1 << 20, least_y = 1 << 20, most_x = -(1 << 20), most_y = -(1 << 20);
  int columns() const { return most_x - least_x + 1; }
  int rows() const { return most_y - least_y + 1; }
};

Span span_of(const std::vector<LatticeTag>& tags) {
  Span span;
  for (const LatticeTag& tag : tags) {
    span.least_x = std::min(span.least_x, tag.x), span.most_x = std::max(span.most_x, tag.x);
    span.least_y = std::min(span.least_y, tag.y), span.most_y = std::max(span.most_y, tag.y);
  }
  return span;
}

/// A board as its numbers tell it: `first` is the number of the first tag if the topmost row seen is the board's first
/// but for `rows_above`.
struct Hypothesis {
  int agreeing = 0, columns = 0, columns_before = 0, rows_above = 0, first = 0;
  bool begins_white = false;  // of a ChArUco board
  bool is_turned = false;     // the tags stand on their heads, as AprilTag prints those that OpenCV has too
  bool counts_down = false;   // of a grid: from the top left on, as OpenCV's grid boards; else from the bottom left
};

/// The number that most tags have before the first, and how many do.
template <class Index>
std::pair<int, int> most_common_first(const std::vector<LatticeTag>& tags, const Index& index) {
  std::map<int, int> counts;
  for (const LatticeTag& tag : tags) ++counts[tag.id - index(tag)];
  const auto best =
      std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return *best;
}

/// Tags before this square on a ChArUco board, which stand on squares with (column + row) odd, or even where the first
/// square is white.
int charuco_index(int column, int row, int columns, bool begins_white) {
  const int in_first_row = begins_white ? (columns + 1) / 2 : columns / 2, in_second = columns - in_first_row;
  return (row + 1) / 2 * in_first_row + row / 2 * in_second + column / 2;
}

std::vector<Hypothesis> charuco_hypotheses(const std::vector<LatticeTag>& tags, const Span& span) {
  std::vector<Hypothesis> all;
  for (int columns = std::max(span.columns(), 2); columns <= most_columns; ++columns)
    for (int before = 0; before + span.columns() <= columns; ++before)
      for (const bool begins_white : {false, true}) {
        const int sum = tags.front().x - span.least_x + before + tags.front().y - span.least_y;
        const int above = (sum % 2 == 0) == begins_white ? 0 : 1;
        const auto [first, agreeing] = most_common_first(tags, [&](const LatticeTag& tag) {
          return charuco_index(tag.x - span.least_x + before, tag.y - span.least_y + above, columns, begins_white);
        });
        if (first >= 0) all.push_back({agreeing, columns, before, above, first, begins_white});
      }
  return all;
}

int grid_index(const LatticeTag& tag, const Span& span, const Hypothesis& h) {
  const int column = h.is_turned ? span.most_x - tag.x : tag.x - span.least_x,
            row = h.is_turned || h.counts_down ? tag.y - span.least_y : span.most_y - tag.y;
  return row * h.columns + column + h.columns_before;
}

std::vector<Hypothesis> grid_hypotheses(const std::vector<LatticeTag>& tags, const Span& span) {
  std::vector<Hypothesis> all;
  for (int columns = span.columns(); columns <= most_columns; ++columns)
    for (int before = 0; before + span.columns() <= columns; ++before)
      for (const bool is_turned : {false, true})
        for (const bool counts_down : {false, true}) {
          Hypothesis h{.columns = columns, .columns_before = before};
          h.is_turned = is_turned, h.counts_down = counts_down;
          if (is_turned && counts_down) continue;
          std::tie(h.first, h.agreeing) =
              most_common_first(tags, [&](const LatticeTag& tag) { return grid_index(tag, span, h); });
          if (h.first >= 0) all.push_back(h);
        }
  return all;
}

/// How far a hypothesis is from what was described; the first that differs counts.
std::vector<int> differences(const Hypothesis& h, const Target& described, int rows_seen) {
  const bool is_other_layout = h.begins_white != described.old_layout, is_other_first = h.first != described.first_id,
             is_partly_seen = h.rows_above > 0;
  return {-h.agreeing,
          h.columns != described.columns,
          is_other_layout + is_other_first + is_partly_seen,
          h.rows_above + rows_seen > described.rows,
          is_other_layout,
          h.rows_above,
          h.columns,
          h.counts_down != is_tag_grid(described)};
}

/// Of whole rows above what is seen nothing tells: they are taken to be there where the number described says so.
int rows_added(const Hypothesis& h, int tags_in_two_rows, int rows_at_once, const Target& described, int rows_seen) {
  const int tags = h.first - described.first_id;
  if (tags <= 0 || tags % tags_in_two_rows != 0) return 0;
  const int rows = rows_at_once * (tags / tags_in_two_rows);
  return rows + h.rows_above + rows_seen <= described.rows ? rows : 0;
}

std::optional<Hypothesis> best_hypothesis(const TagLattice& lattice, const std::vector<LatticeTag>& tags,
                                          const Target& described) {
  const Span span = span_of(tags);
  const std::vector<Hypothesis> all =
      lattice.is_checkered ? charuco_hypotheses(tags, span) : grid_hypotheses(tags, span);
  if (all.empty()) return std::nullopt;
  return *std::min_element(all.begin(), all.end(), [&](const Hypothesis& a, const Hypothesis& b) {
    return differences(a, described, span.rows()) < differences(b, described, span.rows());
  });
}

/// The tags that have the hypothesis's numbers: others were misread or stand beside the board.
std::vector<LatticeTag> agreeing_tags(const TagLattice& lattice, const Hypothesis& h) {
  const Span span = span_of(lattice.tags);
  std::vector<LatticeTag> agreeing;
  for (const LatticeTag& tag : lattice.tags) {
    const int index = lattice.is_checkered
                          ? charuco_index(tag.x - span.least_x + h.columns_before, tag.y - span.least_y + h.rows_above,
                                          h.columns, h.begins_white)
                          : grid_index(tag, span, h);
    if (tag.id - index == h.first) agreeing.push_back(tag);
  }
  return agreeing;
}

}  // namespace

std::optional<Target> board_with(const TagLattice& lattice, const Target& described) {
  const auto first_guess = best_hypothesis(lattice, lattice.tags, described);
  if (!first_guess || first_guess->agreeing < 3 ||
      3 * first_guess->agreeing < 2 * static_cast<int>(lattice.tags.size()))
    return std::nullopt;
  const std::vector<LatticeTag> tags = agreeing_tags(lattice, *first_guess);
  const auto best = best_hypothesis(lattice, tags, described);
  if (!best) return std::nullopt;
  const int rows_seen = span_of(tags).rows();
  Target board = described;
  board.ids.clear();
  board.places.clear();
  board.kind = lattice.is_checkered ? TargetKind::charuco
               : best->counts_down  ? TargetKind::tags
                                    : TargetKind::aprilgrid;
  board.columns = best->columns;
  const int at_once = lattice.is_checkered ? 2 : 1;
  const int added = rows_added(*best, best->columns, at_once, described, rows_seen);
  board.first_id = best->first - added / at_once * best->columns;
  board.rows = rows_seen + best->rows_above + added;
  // What is out of sight: as described, where the columns are right.
  if (board.columns == described.columns) board.rows = std::max(board.rows, described.rows);
  board.old_layout = lattice.is_checkered && best->begins_white;
  if (board.old_layout && board.rows % 2 != 0) ++board.rows;
  return board;
}

}  // namespace handsight
