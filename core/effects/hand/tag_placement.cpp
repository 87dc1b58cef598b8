// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "chain/body_frame.h"
#include "effects/list.h"
#include "effects/target_effects.h"

namespace handsight {

Effect tag_placement() {
  Effect effect;
  effect.id = "tag_placement";
  effect.title = "Misplaced tag";
  effect.cause =
      "One tag of a body of several does not lie where its description says: glued on askew, or its place measured or "
      "typed wrong.";
  effect.visibility =
      "Seen where the tag and others of the body are in view together, or by turns in many poses; of two tags nothing "
      "tells which is the wrong one.";
  effect.check = "Measure the tag's distance from the edges of what it is fastened to, and from its neighbours.";
  effect.check_reads = CheckReads::number;
  effect.source = "Wang and Olson 2016; Munoz-Salinas et al. 2018";
  effect.scope = EffectScope::tag;
  effect.parameters = {{"x", "m", 1e-3},    {"y", "m", 1e-3},    {"z", "m", 1e-3},
                       {"rx", "rad", 2e-2}, {"ry", "rad", 2e-2}, {"rz", "rad", 2e-2}};
  effect.move = move_no_target;
  return effect;
}

namespace {

/// A tag on the body: which markers are its corners, and where they lie in its own frame.
struct TagOnBody {
  std::size_t first = 0;
  Matrix3 body_from_tag;
  std::vector<Vector3> in_tag;
};

}  // namespace

Effect tag_placement(const Target& target) {
  const std::vector<TargetPoint> points = target_points(target), printed = printed_points(target);
  KnownShape shape;
  for (const TargetPoint& point : points) shape.markers.push_back(point.position);
  const Matrix3 body_from_target = body_from_described(shape).rotation;
  std::map<int, TagOnBody> tags;
  Effect effect = tag_placement();
  for (std::size_t k = 0; k < target.ids.size(); ++k) {
    TagOnBody& tag = tags[target.ids[k]];
    tag.first = 4 * k;
    tag.body_from_tag = body_from_target * target_from_tag(target.places[k]).rotation;
    for (std::size_t i = 0; i < 4; ++i) tag.in_tag.push_back(printed[tag.first + i].position);
    effect.tags.push_back(target.ids[k]);
  }
  // target_from_tag * exp(v), to first order in the turn: sites move by what is linear.
  effect.move = [tags = std::move(tags)](const ObservationState&, int place, std::span<const double> v, Sites& sites) {
    const auto found = tags.find(place);
    if (found == tags.end()) return;
    const TagOnBody& tag = found->second;
    for (std::size_t i = 0; i < tag.in_tag.size() && tag.first + i < sites.markers.size(); ++i)
      sites.markers[tag.first + i] +=
          tag.body_from_tag * (Vector3(v[0], v[1], v[2]) + Vector3(v[3], v[4], v[5]).cross(tag.in_tag[i]));
  };
  return effect;
}

}  // namespace handsight
