// SPDX-License-Identifier: Apache-2.0
#include "targets/board_detection.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "targets/board_corners.h"
#include "targets/sampling.h"
#include "targets/tag_fit.h"
#include "vision/corners/corner_noise.h"

namespace handsight {
namespace {

constexpr double least_module = 1.5;   // px: smaller ones cannot be read
constexpr double near_share = 0.25;    // of a tag's side: how well a tag lies where others have it
constexpr double most_tag_left = 0.1;  // unexplained share of a tag whose corners nothing else confirms

/// Tags that agree on where the board is.
struct Agreement {
  std::vector<std::size_t> members;  // of the readings
  PlaneMap map;
};

struct Board {
  const PreparedTarget& target;
  std::vector<TagReading> readings;

  Vector2 place(const TagReading& reading, std::size_t corner) const {
    const PlacedTag& tag = target.tags[static_cast<std::size_t>(reading.tag)];
    const bool right = corner == 1 || corner == 2, down = corner >= 2;
    return tag.top_left + target.target.tag * Vector2(right, down);
  }
};

std::vector<PlacePixel> pairs_of(const Board& board, const std::vector<std::size_t>& members) {
  std::vector<PlacePixel> pairs;
  for (const std::size_t member : members)
    for (std::size_t i = 0; i < 4; ++i)
      pairs.push_back({board.place(board.readings[member], i), board.readings[member].corners[i]});
  return pairs;
}

/// How far a tag is from where the map has it, in sides of the tag.
double distance_from(const Board& board, const PlaneMap& map, const TagReading& reading) {
  double most = 0;
  const double side =
      0.5 * (reading.corners[0] - reading.corners[2]).norm() + 0.5 * (reading.corners[1] - reading.corners[3]).norm();
  for (std::size_t i = 0; i < 4; ++i) {
    const auto expected = mapped(map, board.place(reading, i));
    most = std::max(most, expected ? (*expected - reading.corners[i]).norm() : 1e9);
  }
  return most / (side / std::sqrt(2.0));
}

double tags_between(const Board& board, const std::vector<std::size_t>& members, std::size_t other) {
  double least = 1e300;
  for (const std::size_t member : members)
    least = std::min(least, (board.place(board.readings[member], 0) - board.place(board.readings[other], 0)).norm());
  return least / board.target.target.tag;
}

/// From one tag outward: what a few tags say far away is not worth much.
std::optional<Agreement> grown_from(const Board& board, std::size_t seed, int width, int height) {
  Agreement agreement{{seed}, {}};
  for (int round = 0; round < 12; ++round) {
    const auto map = fit_plane_map(pairs_of(board, agreement.members), width, height);
    if (!map) return std::nullopt;
    agreement.map = *map;
    std::vector<std::size_t> members;
    const double reach = 2.5 * static_cast<double>(agreement.members.size() + 1);
    for (std::size_t i = 0; i < board.readings.size(); ++i) {
      const bool is_near = tags_between(board, agreement.members, i) < reach;
      const double most = agreement.members.size() < 3 ? 2 * near_share : near_share;
      if (is_near && distance_from(board, *map, board.readings[i]) < most) members.push_back(i);
    }
    if (members == agreement.members || members.empty()) break;
    agreement.members = members;
  }
  return agreement;
}

std::optional<Agreement> best_agreement(const Board& board, int width, int height) {
  std::optional<Agreement> best;
  std::vector<bool> is_settled(board.readings.size(), false);
  for (std::size_t seed = 0; seed < board.readings.size(); ++seed) {
    if (is_settled[seed]) continue;  // it would end where it already is a member
    const auto agreement = grown_from(board, seed, width, height);
    if (!agreement || (best && agreement->members.size() <= best->members.size())) continue;
    best = agreement;
    if (best->members.size() >= 3)
      for (const std::size_t member : best->members) is_settled[member] = true;
  }
  return best;
}

/// Where the board is: by the agreement of most tags, over the ways in which it may have been printed.
struct Placed {
  Board board;
  Agreement agreement;
  int border = 1, turns = 0;
};

void turn(std::vector<TagReading>& readings) {
  for (TagReading& reading : readings)
    std::rotate(reading.corners.begin(), reading.corners.begin() + 2, reading.corners.end());
}

std::optional<Placed> place_by(const std::vector<Quad>& quads, const Image& image, const PreparedTarget& target,
                               std::size_t& most_read) {
  std::optional<Placed> best;
  std::vector<int> borders{target.target.border};
  for (const auto& [border, reader] : target.readers)
    if (border != target.target.border) borders.push_back(border);
  for (const int border : borders) {
    Board board{target, read_tags(image, quads, target.readers.at(border))};
    most_read = std::max(most_read, board.readings.size());
    for (const int turns : {0, 2}) {
      if (turns == 2) turn(board.readings);
      if (turns == 2 && target.target.kind != TargetKind::aprilgrid) break;
      const auto agreement = best_agreement(board, image.width, image.height);
      if (!agreement || agreement->members.size() < 2) continue;
      if (!best || agreement->members.size() > best->agreement.members.size())
        best.emplace(Placed{board, *agreement, border, turns});
    }
    if (best) break;
  }
  return best;
}

/// Large images are looked through in small first, where most of the time of a large one goes into its noise; where
/// that finds four tags and half of them, the rest is found from there.
std::optional<Placed> place_board(const Image& image, const PreparedTarget& target, std::size_t& most_read) {
  constexpr double enough = 1.6e6;  // px
  const double least_side = least_module * target.patterns.begin()->second.front().side;
  const int factor =
      static_cast<int>(std::ceil(std::sqrt(static_cast<double>(image.width) * image.height / enough) - 0.3));
  if (factor >= 2) {
    auto placed = place_by(find_quads_in_small(image, factor, least_side), image, target, most_read);
    if (placed && placed->agreement.members.size() >= std::max<std::size_t>(4, target.tags.size() / 2)) return placed;
  }
  return place_by(find_quads(image, least_side), image, target, most_read);
}

/// Points that have been looked for, round by round, from the tags outward.
struct Search {
  const Image& image;
  const PreparedTarget& target;
  PlaneMap map;
  std::vector<PlacePixel> known;     // of the tags
  std::map<int, TargetPixel> found;  // by number
  std::map<int, Vector2> failed;     // where nothing was
  int dropped = 0;

  Vector2 place(int number) const { return target.points[static_cast<std::size_t>(number)].position.head<2>(); }
};

bool is_supported(const Search& search, const Vector2& place, double within) {
  const auto near = [&](const Vector2& other) { return (other - place).norm() < within; };
  return std::any_of(search.known.begin(), search.known.end(), [&](const PlacePixel& p) { return near(p.place); }) ||
         std::any_of(search.found.begin(), search.found.end(),
                     [&](const auto& f) { return near(search.place(f.first)); });
}

bool look_round(Search& search, double step) {
  const std::size_t before = search.found.size();
  int dropped = 0;
  std::map<int, TargetPixel> added;
  for (int number = 0; number < static_cast<int>(search.target.points.size()); ++number) {
    if (search.found.contains(number)) continue;
    const Vector2 place = search.place(number);
    const auto expected = mapped(search.map, place);
    if (!expected || !is_inside(search.image, *expected, 4) || !is_supported(search, place, step)) continue;
    const auto failed = search.failed.find(number);
    if (failed != search.failed.end() && (failed->second - *expected).norm() < 0.7) continue;
    if (const auto seen = corner_at(search.image, search.map, expected_corner(search.target, number), dropped))
      added.emplace(number, *seen);
    else
      search.failed[number] = *expected;
  }
  search.found.merge(added);
  search.dropped = std::max(search.dropped, dropped);
  return search.found.size() > before;
}

void fit_to_found(Search& search) {
  std::vector<PlacePixel> pairs = search.known;
  for (const auto& [number, seen] : search.found) pairs.push_back({search.place(number), seen.pixel});
  if (const auto map = fit_plane_map(pairs, search.image.width, search.image.height)) search.map = *map;
}

/// Tags of a grid whose corners are no X-corners: no squares between them, or too small ones.
void fit_plain_tags(Search& search, const Placed& placed) {
  const double noise = image_noise(search.image), size = search.target.target.tag;
  for (std::size_t tag = 0; tag < search.target.tags.size(); ++tag) {
    const int first = 4 * static_cast<int>(tag);
    const auto is_found = [&](int i) { return search.found.contains(first + i); };
    if (is_found(0) || is_found(1) || is_found(2) || is_found(3)) continue;
    Quad quad;
    bool is_seen = is_supported(search, search.target.tags[tag].top_left, 3 * size);
    for (int i = 0; i < 4; ++i) {
      const auto pixel = mapped(search.map, search.place(first + i));
      is_seen = is_seen && pixel && is_inside(search.image, *pixel, 1);
      if (pixel) quad[static_cast<std::size_t>(i)] = *pixel;
    }
    if (!is_seen) continue;
    const TagPattern pattern = turned(search.target.patterns.at(placed.border)[tag], placed.turns);
    const auto fit = fit_tag(search.image, pattern, quad, noise, {.quiet_zone = 0.6, .corners_touch = true});
    if (!fit || fit->unexplained > most_tag_left) continue;
    for (int i = 0; i < 4; ++i)
      search.found.emplace(first + i, TargetPixel{first + i, fit->corners[static_cast<std::size_t>(i)],
                                                  fit->covariances[static_cast<std::size_t>(i)]});
  }
}

/// Tags that stand where they should, and no corner between them that looks like one.
Message why_no_corner(const Search& search, const Placed& placed) {
  constexpr double enough_to_see = 5;  // px around a corner
  std::vector<double> reaches;
  for (int number = 0; number < static_cast<int>(search.target.points.size()); ++number) {
    const ExpectedCorner corner = expected_corner(search.target, number);
    const auto slope = mapped_slope(search.map, corner.place, 0.5 * corner.reach);
    const auto at = mapped(search.map, corner.place);
    if (slope && at && is_inside(search.image, *at, 4))
      reaches.push_back(corner.reach * std::sqrt(std::abs(slope->determinant())));
  }
  std::sort(reaches.begin(), reaches.end());
  const std::size_t tags = placed.agreement.members.size();
  if (reaches.size() >= 6 && tags >= 4 && reaches[reaches.size() / 2] > enough_to_see)
    return message(
        "{} of its tags were read where they should be, but none of the {} corners between them looks like one: "
        "something is drawn or lies over them (an earlier detection drawn into the image?), or it is out of focus",
        tags, reaches.size());
  return "its tags were read, but none of its corners is clear enough";
}

}  // namespace

Message lies_otherwise() {
  return "its tags were read, but lie otherwise than on this board: another layout, or several boards";
}

TargetSighting detect_board(const Image& image, const PreparedTarget& target) {
  TargetSighting sighting;
  std::size_t most_read = 0;
  const auto placed = place_board(image, target, most_read);
  if (!placed) {
    sighting.dropped_tags = static_cast<int>(most_read);
    sighting.reason = most_read == 0 ? "none of its tags was found"
                                     : "fewer than two of the tags that were read lie as they do on the board";
    return sighting;
  }
  sighting.dropped_tags = static_cast<int>(placed->board.readings.size() - placed->agreement.members.size());
  // One wrong tag may be read; where a third of them lies elsewhere the board is another one, of the other layout say.
  if (3 * placed->agreement.members.size() < 2 * placed->board.readings.size()) {
    sighting.reason = lies_otherwise();
    return sighting;
  }
  Search search{image, target, placed->agreement.map, pairs_of(placed->board, placed->agreement.members), {}, {}, 0};
  const Target& t = target.target;
  const double step = t.kind == TargetKind::charuco ? 2.2 * t.square : 2.2 * t.tag * (1 + t.spacing);
  for (int round = 0; round < 20; ++round) {
    if (!look_round(search, step)) break;
    fit_to_found(search);
  }
  if (t.kind == TargetKind::aprilgrid) fit_plain_tags(search, *placed);
  for (const auto& [number, seen] : search.found) sighting.points.push_back(seen);
  sighting.dropped_points = search.dropped;
  drop_far_points(sighting, target.points, image.width, image.height);
  if (sighting.points.empty()) sighting.reason = why_no_corner(search, *placed);
  return sighting;
}

}  // namespace handsight
