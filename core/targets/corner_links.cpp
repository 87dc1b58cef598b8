// SPDX-License-Identifier: Apache-2.0
#include "targets/corner_links.h"

#include <algorithm>
#include <cmath>

#include "targets/sampling.h"

namespace handsight {
namespace {

constexpr double most_aside = 0.55;  // rad, between a ray and the way to the neighbour
constexpr double most_odd = 0.35;    // rad, by which the two ends of the way differ from those of an arc

Vector2 along(double angle) { return {std::cos(angle), std::sin(angle)}; }

double turned(double to, double from) { return std::remainder(to - from, 2 * M_PI); }

/// The ray that is nearest to a direction.
std::size_t ray_towards(const RayCorner& corner, double angle) {
  std::size_t best = 0;
  for (std::size_t ray = 1; ray < 4; ++ray)
    if (std::abs(turned(corner.angles[ray], angle)) < std::abs(turned(corner.angles[best], angle))) best = ray;
  return best;
}

/// The way from one corner to another, if an edge may run there.
CornerLink way(const std::vector<RayCorner>& corners, std::size_t from, std::size_t to, std::size_t ray, double angle) {
  const RayCorner &a = corners[from], &b = corners[to];
  const std::size_t back = ray_towards(b, angle + M_PI);
  if (a.is_dark_after(ray) == b.is_dark_after(back)) return {};  // what is left of the way there is right of it back
  const double leaves = turned(a.angles[ray], angle), comes = turned(b.angles[back], angle + M_PI);
  const double odd = std::abs(leaves + comes);  // an arc leaves to one side and comes back from the same
  if (std::abs(leaves) > most_aside || std::abs(comes) > most_aside || odd > most_odd) return {};
  const double length = (b.position - a.position).norm();
  return {static_cast<int>(to), back, length * (1 + leaves * leaves + comes * comes + 4 * odd * odd)};
}

std::array<CornerLink, 4> ways_from(const std::vector<RayCorner>& corners, std::size_t from) {
  std::array<CornerLink, 4> best;
  for (std::size_t to = 0; to < corners.size(); ++to) {
    if (to == from) continue;
    const Vector2 between = corners[to].position - corners[from].position;
    const double length = between.norm();
    if (std::all_of(best.begin(), best.end(), [&](const CornerLink& l) { return l.corner >= 0 && l.cost < length; }))
      continue;
    const double angle = std::atan2(between.y(), between.x());
    const std::size_t ray = ray_towards(corners[from], angle);
    if (best[ray].corner >= 0 && best[ray].cost < length) continue;
    const CornerLink link = way(corners, from, to, ray, angle);
    if (link.corner >= 0 && (best[ray].corner < 0 || link.cost < best[ray].cost)) best[ray] = link;
  }
  return best;
}

bool is_mutual(const std::vector<std::array<CornerLink, 4>>& links, std::size_t from, std::size_t ray) {
  const CornerLink& link = links[from][ray];
  if (link.corner < 0) return false;
  const CornerLink& back = links[static_cast<std::size_t>(link.corner)][link.ray];
  return back.corner == static_cast<int>(from) && back.ray == ray;
}

/// Is the neighbour much farther away than the one on the other side? Then it is no part of the board.
bool is_too_far(const std::vector<std::array<CornerLink, 4>>& links, std::size_t from, std::size_t ray) {
  constexpr double most_ratio = 1.7;
  const CornerLink &link = links[from][ray], &opposite = links[from][(ray + 2) % 4];
  return is_mutual(links, from, (ray + 2) % 4) && link.cost > most_ratio * opposite.cost;
}

}  // namespace

RayCorner ray_corner(const Image& image, const Corner& corner) {
  const double first = std::min(corner.edges[0], corner.edges[1]), second = std::max(corner.edges[0], corner.edges[1]);
  RayCorner result{corner.position, {first, second, first + M_PI, second + M_PI}, false};
  const auto grey = [&](double angle) {
    double sum = 0;
    for (const double radius : {2.0, 3.0, 4.0})
      sum += grey_at(image, corner.position + radius * along(angle)) +
             grey_at(image, corner.position - radius * along(angle));
    return sum;
  };
  result.is_dark_after_first = grey(0.5 * (first + second)) < grey(0.5 * (first + second + M_PI));
  return result;
}

std::vector<std::array<CornerLink, 4>> link_corners(const std::vector<RayCorner>& corners) {
  std::vector<std::array<CornerLink, 4>> links;
  links.reserve(corners.size());
  for (std::size_t from = 0; from < corners.size(); ++from) links.push_back(ways_from(corners, from));
  std::vector<std::array<CornerLink, 4>> result(links.size());
  for (std::size_t from = 0; from < links.size(); ++from)
    for (std::size_t ray = 0; ray < 4; ++ray) {
      const CornerLink& link = links[from][ray];
      if (is_mutual(links, from, ray) && !is_too_far(links, from, ray) &&
          !is_too_far(links, static_cast<std::size_t>(link.corner), link.ray))
        result[from][ray] = link;
    }
  return result;
}

}  // namespace handsight
