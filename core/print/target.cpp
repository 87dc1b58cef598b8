// SPDX-License-Identifier: Apache-2.0
#include "print/target.h"

#include <algorithm>
#include <array>
#include <set>

#include "base/bounds.h"
#include "base/error.h"
#include "print/circle_grid.h"
#include "print/dictionary.h"

namespace handsight {
namespace {

constexpr std::array<std::string_view, 4> kind_names{"chessboard", "charuco", "aprilgrid", "tags"};
constexpr int most_points = 4096;
constexpr Bounds lengths{1e-5, 100};  // m

std::vector<TargetPoint> lattice(int columns, int rows, double square, double first) {
  std::vector<TargetPoint> points;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      points.push_back({Vector3(first + column * square, first + row * square, 0), 0});
  return points;
}

std::vector<TargetPoint> tag_points(const Target& target) {
  std::vector<TargetPoint> points;
  for (const PlacedTag& tag : placed_tags(target))
    for (const auto& [right, down] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      points.push_back(
          {Vector3(tag.top_left.x() + right * tag.size, tag.top_left.y() + down * tag.size, 0), tag.piece});
  return points;
}

std::vector<PlacedTag> charuco_tags(const Target& target) {
  std::vector<PlacedTag> tags;
  const double margin = 0.5 * (target.square - target.tag);
  const int first_white = target.old_layout && target.rows % 2 == 0 ? 0 : 1;  // column of the first row's first white
  for (int row = 0; row < target.rows; ++row)
    for (int column = (row + first_white) % 2; column < target.columns; column += 2)
      tags.push_back({target.first_id + static_cast<int>(tags.size()),
                      Vector2(column * target.square + margin, row * target.square + margin), 0, target.tag});
  return tags;
}

std::vector<PlacedTag> grid_tags(const Target& target) {
  std::vector<PlacedTag> tags;
  const double step = target.tag * (1 + target.spacing);
  for (int up = 0; up < target.rows; ++up)
    for (int column = 0; column < target.columns; ++column)
      tags.push_back({target.first_id + static_cast<int>(tags.size()),
                      Vector2(column * step, (target.rows - 1 - up) * step), 0, target.tag});
  return tags;
}

void require(bool holds, std::string_view where, const Message& sentence) {
  if (!holds) throw InputError(message("{}: {}", looked_up(std::string(where)), sentence));
}

void check_size(double size, const char* name, std::string_view where) {
  require(
      lengths.hold(size), where,
      message("{} is {:g}; expected a length in m from {:g} to {:g}.", name, size, lengths.lowest, lengths.highest));
}

void check_ids(const Target& target, std::string_view where) {
  const Dictionary* dictionary = find_dictionary(target.dictionary);
  require(dictionary != nullptr, where,
          message("the dictionary \"{}\" is not known; expected one of OpenCV's, such as DICT_5X5_100 or "
                  "DICT_APRILTAG_36h11, or AprilTag's tag36h11.",
                  target.dictionary.substr(0, 60)));
  const int count = static_cast<int>(dictionary->codes.size());
  std::set<int> seen;
  for (const PlacedTag& tag : placed_tags(target)) {
    require(tag.id >= 0 && tag.id < count, where,
            message("the tag {} is not in {}, which has 0 to {}.", tag.id, dictionary->name, count - 1));
    require(seen.insert(tag.id).second, where, message("the tag {} is named twice; every id once.", tag.id));
  }
}

void check_counts(const Target& target, std::string_view where) {
  const int least = target.kind == TargetKind::aprilgrid ? 1 : 2;
  require(
      target.columns >= least && target.columns <= most_points && target.rows >= least && target.rows <= most_points,
      where,
      message("it has {} columns and {} rows; expected {} to {} of each.", target.columns, target.rows, least,
              most_points));
  require(target.kind != TargetKind::chessboard || target.columns * target.rows >= 6, where,
          is_circle_grid(target)
              ? "a grid of circles needs at least 6 of them, for example columns=\"4\" rows=\"11\"."
              : "a chessboard needs at least 6 inner corners, for example columns=\"3\" rows=\"2\".");
}

}  // namespace

void check_grid(const Target& target, std::string_view where) {
  require(target.columns >= 1 && target.rows >= 1 && target.columns <= most_points / 4 / std::max(target.rows, 1),
          where,
          message("it has {} columns and {} rows; expected 1 or more of each, and at most {} tags.", target.columns,
                  target.rows, most_points / 4));
  check_size(target.tag, "marker", where);
  check_size(target.separation, "separation", where);
}

namespace {

void check_places(const Target& target, std::string_view where) {
  if (target.places.empty()) return;
  require(target.places.size() == target.ids.size(), where,
          message("it has {} tags and {} places; expected one place a tag.", target.ids.size(), target.places.size()));
  for (std::size_t k = 0; k < target.places.size(); ++k) {
    const TagPlace& place = target.places[k];
    check_size(place.size, "size of a tag", where);
    for (std::size_t other = 0; other < k; ++other)
      require(place.xyz != target.places[other].xyz || place.rpy != target.places[other].rpy, where,
              message("the tags {} and {} lie at the same place; every tag has its own xyz or rpy.", target.ids[other],
                      target.ids[k]));
  }
}

Message tags_text(const Target& target) {
  std::string list;
  for (std::size_t i = 0; i < target.ids.size() && i < 12; ++i)
    list += fmt::format("{}{}", i ? " " : "", target.ids[i]);
  if (target.ids.size() > 12) return message("{} ... ({} tags)", list, target.ids.size());
  return verbatim(list);
}

}  // namespace

std::string_view display_name(TargetKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

std::optional<TargetKind> target_kind(std::string_view name) {
  for (std::size_t i = 0; i < kind_names.size(); ++i)
    if (kind_names[i] == name) return static_cast<TargetKind>(i);
  return std::nullopt;
}

std::vector<PlacedTag> placed_tags(const Target& target) {
  if (target.kind == TargetKind::charuco) return charuco_tags(target);
  if (target.kind == TargetKind::aprilgrid) return grid_tags(target);
  std::vector<PlacedTag> tags;
  for (std::size_t k = 0; target.kind == TargetKind::tags && k < target.ids.size(); ++k) {
    const double size = target.places.empty() ? target.tag : target.places[k].size;
    tags.push_back({target.ids[k], Vector2::Constant(-0.5 * size), static_cast<int>(k), size});
  }
  return tags;
}

std::vector<TargetPoint> printed_points(const Target& target) {
  if (is_circle_grid(target)) return circle_points(target);
  if (target.kind == TargetKind::chessboard) return lattice(target.columns, target.rows, target.square, 0);
  if (target.kind == TargetKind::charuco)
    return lattice(target.columns - 1, target.rows - 1, target.square, target.square);
  return tag_points(target);
}

std::vector<TargetPoint> target_points(const Target& target) {
  std::vector<TargetPoint> points = printed_points(target);
  if (!has_places(target)) return points;
  for (TargetPoint& point : points)
    point = {target_from_tag(target.places[static_cast<std::size_t>(point.piece)]) * point.position, 0};
  return points;
}

int point_count(const Target& target) {
  switch (target.kind) {
    case TargetKind::chessboard:
      return target.columns * target.rows;
    case TargetKind::charuco:
      return (target.columns - 1) * (target.rows - 1);
    case TargetKind::aprilgrid:
      return 4 * target.columns * target.rows;
    case TargetKind::tags:
      break;
  }
  return 4 * static_cast<int>(target.ids.size());
}

bool looks_the_same_turned(const Target& target) {
  if (is_circle_grid(target)) return !is_asymmetric(target) || target.rows % 2 == 0;
  return target.kind == TargetKind::chessboard && (target.columns + target.rows) % 2 == 0;
}

void check_target(const Target& target, std::string_view where) {
  if (target.kind != TargetKind::tags) check_counts(target, where);
  require(target.kind != TargetKind::tags || !target.ids.empty(), where,
          "tags need the numbers that are used, for example ids=\"3 7 9\".");
  check_places(target, where);
  require(point_count(target) <= most_points, where,
          message("it has {} points; expected at most {}.", point_count(target), most_points));
  const bool has_squares = target.kind == TargetKind::chessboard || target.kind == TargetKind::charuco;
  if (has_squares) check_size(target.square, "square", where);
  if (target.sigma)
    require(*target.sigma >= 0 && *target.sigma <= 1, where,
            message("sigma is {:g}; expected 0 to 1 m, or \"free\".", *target.sigma));
  if (is_circle_grid(target)) check_circles(target, where);
  if (target.kind == TargetKind::chessboard) return;
  check_size(target.tag,
             target.kind == TargetKind::charuco ? "marker"
             : target.kind == TargetKind::tags  ? "size"
                                                : "tag",
             where);
  require(target.kind != TargetKind::charuco || target.tag < target.square, where,
          message("its markers of {:g} m do not fit into its squares of {:g} m.", target.tag, target.square));
  require(target.kind != TargetKind::aprilgrid || (target.spacing >= 0.02 && target.spacing <= 10), where,
          message("spacing is {:g}; expected the gap between two tags over a tag's side, 0.02 to 10.", target.spacing));
  require(target.border >= 1 && target.border <= 4, where,
          message("border is {}; expected 1 to 4 modules.", target.border));
  check_ids(target, where);
}

static Message mm(double metres) { return message("{:g} mm", 1e3 * metres); }

static Message sizes_text(const Target& t) {
  double least = t.tag, most = t.tag;
  for (const TagPlace& place : t.places) least = std::min(least, place.size), most = std::max(most, place.size);
  return least == most ? mm(most) : message("{:g} to {}", 1e3 * least, mm(most));
}

Message describe_target(const Target& t) {
  if (is_circle_grid(t)) return circles_description(t);
  switch (t.kind) {
    case TargetKind::chessboard:
      return message("chessboard of {} x {} inner corners, squares of {}", t.columns, t.rows, mm(t.square));
    case TargetKind::charuco:
      return message("ChArUco board of {} x {} squares of {}, tags of {} from {}{}", t.columns, t.rows, mm(t.square),
                     mm(t.tag), t.dictionary, t.old_layout ? ", old layout" : "");
    case TargetKind::aprilgrid:
      return message("grid of {} x {} tags of {} from {}, gaps of {}", t.columns, t.rows, mm(t.tag), t.dictionary,
                     mm(t.tag * t.spacing));
    case TargetKind::tags:
      break;
  }
  if (is_tag_grid(t))
    return message("ArUco grid board of {} x {} tags of {}, {} apart, from {}", t.columns, t.rows, mm(t.tag),
                   mm(t.separation), t.dictionary);
  if (t.places.empty()) return message("tags {} of {} from {}", tags_text(t), mm(t.tag), t.dictionary);
  return message("body of the tags {} of {} from {}", tags_text(t), sizes_text(t), t.dictionary);
}

}  // namespace handsight
