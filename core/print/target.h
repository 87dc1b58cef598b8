// SPDX-License-Identifier: Apache-2.0
// Flat targets whose points name themselves: chessboards, ChArUco boards, grids of AprilTags, and single tags.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "geometry/rigid.h"

namespace handsight {

enum class TargetKind { chessboard, charuco, aprilgrid, tags };

/// "chessboard", "charuco", "aprilgrid", "tags".
std::string_view display_name(TargetKind kind);
std::optional<TargetKind> target_kind(std::string_view name);

/// Where one tag of a body of several lies: target_from_tag, the tag's frame having its origin in the tag's middle, x
/// to the right, y down and z into the tag, as it is printed.
struct TagPlace {
  Vector3 xyz = Vector3::Zero();  // m
  Vector3 rpy = Vector3::Zero();  // rad, XYZ fixed angles
  double size = 0;                // m, side of its black square
  double sigma = 0;               // m, how exactly `xyz` is known, one coordinate; 0: exactly
  double sigma_angle = 0;         // rad, how exactly its turn about each axis is known; 0: exactly
};

Rigid target_from_tag(const TagPlace& place);

/// What is printed on the target. The target's frame: x to the right, y down and z into the sheet, as it is printed, so
/// that a camera that looks straight at an upright sheet has the same axes. Its origin: the first inner corner of a
/// chessboard; of a ChArUco board the outer corner of its first square; of a grid the top left corner of its top left
/// tag; of each single tag its centre; of a body of tags at known places it is where these say.
struct Target {
  TargetKind kind = TargetKind::chessboard;
  int columns = 0, rows = 0;  // inner corners of a chessboard, squares of a ChArUco board, tags of a grid
  double square = 0;          // m, side of a square of a chessboard or a ChArUco board
  double tag = 0;             // m, side of a tag's black square, its border included
  double spacing = 0;         // of a grid: gap between two tags / side of a tag
  std::string dictionary;  // OpenCV's name (DICT_5X5_100), or AprilTag's (tag36h11), whose tags stand upside down there
  int border = 1;          // modules: width of a tag's black border; Kalibr's grids have 2
  bool old_layout = false;  // ChArUco: as OpenCV before 4.6: with an even number of rows the first square is white
  int first_id = 0;         // of the tags of a ChArUco board or a grid, which have consecutive ids
  std::vector<int> ids;     // of single tags
  /// Where they lie, in the order of `ids`: the tags are one rigid body. Empty: nothing is known of one against
  /// another.
  std::vector<TagPlace> places;
  double separation = 0;  // m, of an ArUco grid (tags with columns and rows): white between two tags
  /// m, how exactly the print is known, one coordinate; 0: it is as described; nothing: it is to be estimated. Of tags
  /// with places each print is as described, 0: the places are known within their sigmas; nothing: they are not known.
  std::optional<double> sigma = 0;
};

/// A point that can be seen. `piece`: points of one piece form a rigid body whose shape is known; boards and bodies of
/// tags are one piece, each single tag is one of its own, and `position` (m) is in its frame.
struct TargetPoint {
  Vector3 position = Vector3::Zero();
  int piece = 0;
};

/// The points by number: chessboard and ChArUco inner corners row by row from the first square; of grids and tags four
/// a tag, clockwise from its top left corner as the sheet stands; tag k of `placed_tags` has the points 4 k to 4 k + 3.
std::vector<TargetPoint> target_points(const Target& target);
int point_count(const Target& target);

/// The same, each tag of `TargetKind::tags` as a piece of its own whatever is known of its place: what is printed.
std::vector<TargetPoint> printed_points(const Target& target);

/// m, how exactly the points of a piece are known to each other; nothing: they are to be estimated.
inline std::optional<double> print_sigma(const Target& target) {
  return target.places.empty() ? target.sigma : std::optional<double>(0);
}

/// Tags that are one rigid body, held or known within the sigmas of their places.
inline bool has_places(const Target& target) { return !target.places.empty() && target.sigma; }

/// Is each of these places known exactly?
bool are_places_exact(const Target& target);

/// The target with the places of its tags not known: each is a piece of its own.
Target without_places(Target target);

/// All its lengths times `factor`.
Target scaled(Target target, double factor);

/// Gives a target of tags the places of an ArUco grid board as OpenCV draws it: its columns x rows tags from `first_id`
/// on, row by row from the top left one, in whose top left corner the frame has its origin.
void lay_out_grid(Target& target);

/// An ArUco grid board: tags with columns and rows.
inline bool is_tag_grid(const Target& target) { return target.kind == TargetKind::tags && target.columns > 0; }

/// A tag on the target: `top_left` (m) in the frame of its piece, of which each of `TargetKind::tags` is one. A grid's
/// tags follow their ids, which begin at the bottom left, run to the right and then up, as Kalibr prints them;
/// ChArUco's row by row from the first square.
struct PlacedTag {
  int id = 0;
  Vector2 top_left = Vector2::Zero();
  int piece = 0;
  double size = 0;  // m
};
std::vector<PlacedTag> placed_tags(const Target& target);

/// Where a chessboard of an odd and an odd, or an even and an even number of corners looks the same after half a turn.
bool looks_the_same_turned(const Target& target);

/// InputError with one sentence that begins with `where` unless the target can be: numbers of rows and columns, sizes
/// in m, at most 4096 points, a dictionary that is known and has the ids.
void check_target(const Target& target, std::string_view where);

/// "ChArUco board of 8 x 11 squares of 15 mm, tags of 11 mm from DICT_5X5_100": for people.
Message describe_target(const Target& target);

}  // namespace handsight
