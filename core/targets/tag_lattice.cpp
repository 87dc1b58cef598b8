// SPDX-License-Identifier: Apache-2.0
#include "targets/tag_lattice.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "base/median.h"
#include "targets/homography.h"

namespace handsight {
namespace {

constexpr double most_off = 0.25;  // of the pitch
constexpr std::size_t neighbours = 4;
constexpr double farthest_pitch = 4;  // sides of a tag

/// Where the other tags' centres are, in sides of this tag and from its centre; nearest first.
struct Neighbour {
  std::size_t tag = 0;
  Vector2 offset;
};

Vector2 centre_of(const Quad& quad) { return 0.25 * (quad[0] + quad[1] + quad[2] + quad[3]); }

std::vector<Neighbour> neighbours_of(const std::vector<SurveyedTag>& tags, std::size_t of) {
  const Matrix3 tag_from_pixel = homography_from_quad(tags[of].corners, 1).inverse();
  const Vector2 own = mapped(tag_from_pixel, centre_of(tags[of].corners));
  std::vector<Neighbour> all;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    if (i == of) continue;
    const Vector2 offset = mapped(tag_from_pixel, centre_of(tags[i].corners)) - own;
    if (offset.allFinite() && offset.norm() < 2 * farthest_pitch) all.push_back({i, offset});
  }
  std::sort(all.begin(), all.end(),
            [](const Neighbour& a, const Neighbour& b) { return a.offset.norm() < b.offset.norm(); });
  if (all.size() > neighbours) all.resize(neighbours);
  return all;
}

/// Nearest neighbours stand askew on a ChArUco board, straight on a grid.
bool find_pitch(const std::vector<std::vector<Neighbour>>& near, TagLattice& lattice) {
  std::vector<double> askew, straight;
  for (const auto& list : near)
    for (std::size_t i = 0; i < std::min<std::size_t>(list.size(), 2); ++i) {
      const Vector2 size = list[i].offset.cwiseAbs();
      (size.minCoeff() > 0.5 * size.maxCoeff() ? askew : straight).push_back(size.maxCoeff());
    }
  lattice.is_checkered = askew.size() > straight.size();
  const auto& steps = lattice.is_checkered ? askew : straight;
  if (steps.empty()) return false;
  lattice.pitch = median(steps);
  return lattice.pitch > 0.9 && lattice.pitch < farthest_pitch;
}

std::vector<LatticeTag> grown_from(const std::vector<SurveyedTag>& tags, const TagLattice& lattice,
                                   const std::vector<std::vector<Neighbour>>& near, std::size_t seed) {
  std::vector<std::optional<LatticeTag>> placed(tags.size());
  placed[seed] = LatticeTag{tags[seed].id, 0, 0};
  std::deque<std::size_t> open{seed};
  while (!open.empty()) {
    const std::size_t at = open.front();
    open.pop_front();
    for (const Neighbour& next : near[at]) {
      if (placed[next.tag]) continue;
      const Vector2 steps = next.offset / lattice.pitch;
      const int x = static_cast<int>(std::lround(steps.x())), y = static_cast<int>(std::lround(steps.y()));
      const double reach = std::max(1.0, steps.norm());
      if ((steps - Vector2(x, y)).norm() > most_off * reach || (x == 0 && y == 0)) continue;
      if (lattice.is_checkered && (x + y) % 2 != 0) continue;
      placed[next.tag] = LatticeTag{tags[next.tag].id, placed[at]->x + x, placed[at]->y + y};
      open.push_back(next.tag);
    }
  }
  std::vector<LatticeTag> found;
  for (const auto& tag : placed)
    if (tag) found.push_back(*tag);
  return found;
}

/// The pitch by all tags at once: their sides in steps of the lattice, from the map of their centres.
std::optional<double> pitch_of_all(const std::vector<SurveyedTag>& tags, const std::vector<LatticeTag>& lattice) {
  std::vector<PlacePixel> centres;
  std::vector<const SurveyedTag*> found;
  for (const LatticeTag& place : lattice)
    for (const SurveyedTag& tag : tags) {
      if (tag.id != place.id) continue;
      centres.push_back({Vector2(place.x, place.y), centre_of(tag.corners)});
      found.push_back(&tag);
      break;
    }
  const auto map = linear_homography(centres);
  if (!map) return std::nullopt;
  const Matrix3 back = map->inverse();
  std::vector<double> sides;
  for (const SurveyedTag* tag : found)
    for (std::size_t i = 0; i < 4; ++i)
      sides.push_back((mapped(back, tag->corners[i]) - mapped(back, tag->corners[(i + 1) % 4])).norm());
  const double side = median(sides);
  return side > 0.2 && side < 1.1 ? std::optional(1 / side) : std::nullopt;
}

}  // namespace

std::optional<TagLattice> tag_lattice(const std::vector<SurveyedTag>& tags) {
  std::vector<std::vector<Neighbour>> near;
  for (std::size_t i = 0; i < tags.size(); ++i) near.push_back(neighbours_of(tags, i));
  TagLattice lattice;
  if (tags.size() < 3 || !find_pitch(near, lattice)) return std::nullopt;
  for (std::size_t seed = 0; seed < tags.size() && 2 * lattice.tags.size() < tags.size(); ++seed) {
    auto found = grown_from(tags, lattice, near, seed);
    if (found.size() > lattice.tags.size()) lattice.tags = std::move(found);
  }
  if (const auto pitch = pitch_of_all(tags, lattice.tags)) lattice.pitch = *pitch;
  return lattice.tags.size() >= 3 ? std::optional(lattice) : std::nullopt;
}

}  // namespace handsight
