// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "chain/body_frame.h"
#include "effects/list.h"
#include "effects/target_effects.h"

namespace handsight {

Effect target_bend() {
  Effect effect;
  effect.id = "target_bend";
  effect.title = "Bent target";
  effect.cause = "A target that is described as flat is bent, as paper or a thin plate is: its edges stand off.";
  effect.visibility = "Seen in the shape of the target where it is large in the image; small ones look flat.";
  effect.check = "Lay a ruler over the target, along and across, and look for light under it.";
  effect.check_reads = CheckReads::number;
  effect.source = "Albarelli, Rodola and Torsello 2010";
  effect.scope = EffectScope::session;
  effect.parameters = {{"bend_x", "1/m", 0.05}, {"bend_y", "1/m", 0.05}};
  effect.move = move_no_target;
  return effect;
}

Effect target_bend(const KnownShape& shape) {
  const std::vector<Vector3>& points = shape.markers;
  const double count = static_cast<double>(points.size());
  Vector3 middle = Vector3::Zero();
  for (const Vector3& x : points) middle += x / count;
  // Half the squares of x and y from the middle; less their mean, so that the body's origin stays in its middle.
  Eigen::Matrix2Xd squares(2, points.size());
  for (std::size_t m = 0; m < points.size(); ++m)
    squares.col(static_cast<Eigen::Index>(m)) = 0.5 * (points[m] - middle).head<2>().cwiseAbs2();
  squares.colwise() -= squares.rowwise().mean().eval();
  const BodySides sides = choose_sides({points.begin(), points.end()});
  const Vector3 across = inverse(body_frame(sides, points).tcp_from_body).rotation.col(2);  // z of the target
  Effect effect = target_bend();
  effect.move = [squares, across](const ObservationState&, int, std::span<const double> values, Sites& sites) {
    const auto all = std::min(static_cast<std::size_t>(squares.cols()), sites.markers.size());
    for (std::size_t m = 0; m < all; ++m) {
      const auto column = static_cast<Eigen::Index>(m);
      sites.markers[m] += (values[0] * squares(0, column) + values[1] * squares(1, column)) * across;
    }
  };
  return effect;
}

}  // namespace handsight
