// SPDX-License-Identifier: Apache-2.0
#include "targets/target_detection.h"

#include <algorithm>

#include "base/error.h"
#include "print/circle_grid.h"
#include "targets/board_detection.h"
#include "targets/circle_detection.h"
#include "targets/drawn_over.h"
#include "targets/grid_layout.h"
#include "targets/tag_fit.h"
#include "vision/corners/corner_noise.h"

namespace handsight {
namespace {

void prepare_border(PreparedTarget& prepared, const Dictionary& dictionary, int border) {
  std::vector<TagCandidate> candidates;
  for (const PlacedTag& tag : prepared.tags) {
    prepared.patterns[border].push_back(tag_pattern(dictionary, tag.id, border));
    candidates.push_back({static_cast<int>(candidates.size()), prepared.patterns[border].back()});
  }
  prepared.readers.emplace(border, TagReader(candidates));
}

Message why_no_tag(const PreparedTarget& target, const std::map<int, int>& times) {
  if (times.empty()) return "none of its tags was found";
  const auto most =
      std::max_element(times.begin(), times.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most->second < 2) return "tags were read, but none clearly enough";
  return message(
      "the tag with the number {} is there {} times, and nothing tells which of them is meant: give every tag its own "
      "number",
      target.tags[static_cast<std::size_t>(most->first)].id,
      most->second == 2   ? "two"
      : most->second == 3 ? "three"
                          : std::to_string(most->second));
}

TargetSighting detect_single_tags(const Image& image, const PreparedTarget& target) {
  constexpr double least_module = 1.5;  // px
  const int border = target.target.border;
  const auto& patterns = target.patterns.at(border);
  TargetSighting sighting;
  std::vector<TagReading> readings =
      read_tags(image, find_quads(image, least_module * patterns.front().side), target.readers.at(border));
  const double noise = image_noise(image);
  std::map<int, std::vector<TagFit>> fits;
  std::map<int, int> times;  // that a tag was read
  for (const TagReading& reading : readings) {
    ++times[reading.tag];
    const auto fit = fit_tag(image, patterns[static_cast<std::size_t>(reading.tag)], reading.corners, noise);
    if (fit)
      fits[reading.tag].push_back(*fit);
    else
      ++sighting.dropped_tags;
  }
  for (const auto& [tag, found] : fits) {
    if (found.size() > 1) {  // which of them is it?
      sighting.dropped_tags += static_cast<int>(found.size());
      continue;
    }
    for (std::size_t i = 0; i < 4; ++i)
      sighting.points.push_back({4 * tag + static_cast<int>(i), found[0].corners[i], found[0].covariances[i]});
  }
  for (const auto& [tag, found] : fits)
    if (found.size() > 1) sighting.repeated.push_back(target.tags[static_cast<std::size_t>(tag)].id);
  if (sighting.points.empty()) sighting.reason = why_no_tag(target, times);
  if (!lies_as_described(sighting, target)) {
    sighting.points.clear();
    sighting.reason = lies_otherwise();
  }
  return sighting;
}

}  // namespace

PreparedTarget prepare(const Target& target) {
  check_target(target, "target");
  PreparedTarget prepared{target, target_points(target), placed_tags(target), {}, {}};
  if (target.kind == TargetKind::chessboard) return prepared;
  const Dictionary& dictionary = *find_dictionary(target.dictionary);
  prepare_border(prepared, dictionary, target.border);
  if (target.kind == TargetKind::aprilgrid && target.border <= 2)
    prepare_border(prepared, dictionary, 3 - target.border);
  return prepared;
}

namespace {

TargetSighting detected(const Image& image, const PreparedTarget& target) {
  if (is_circle_grid(target.target)) return detect_circles(image, target);
  switch (target.target.kind) {
    case TargetKind::chessboard:
      return detect_chessboard(image, target);
    case TargetKind::tags:
      return detect_single_tags(image, target);
    default:
      return detect_board(image, target);
  }
}

}  // namespace

TargetSighting detect_target(const Image& image, const PreparedTarget& target) {
  check(image.width > 0 && image.height > 0, "an image of {} x {}", image.width, image.height);
  TargetSighting sighting = detected(image, target);
  if (sighting.points.empty() && is_drawn_over(image))
    sighting.reason =
        "lines or numbers in pure colours are drawn into the image, over what would be looked for: " + sighting.reason;
  return sighting;
}

}  // namespace handsight
