// SPDX-License-Identifier: Apache-2.0
// What two edges that cross askew share once they are blurred together.
//
// The blurred sgn(d) sgn(e), with a blur b that is the same in all directions and the cosine r between the edges, is
//   erf(d / (sqrt2 b)) erf(e / (sqrt2 b)) + 2 / pi  int_0^{asin r} exp(-q(t)) dt,
//   q(t) = (d^2 + e^2 - 2 d e sin t) / (2 b^2 cos^2 t)
// (Plackett: its derivative by r is four times the joint density). At right angles the integral vanishes. Its midpoint
// is enough: at r = 0.7 it is off by 0.005 at most, and even, so that no position can be mistaken for it.
#pragma once

#include <algorithm>
#include <cmath>

#include "vision/corner_lanes.h"

namespace handsight {

struct Crossing {
  static constexpr double kNothing = 5;  // q, where a 150th is left of what they share at the corner
  float narrow, twist;                   // q = narrow (d^2 + e^2) - twist d e
  float most, per_blur;                  // where both edges are; by how much q grows it as blur does
  float turn, turn_by_both,
      turn_by_square;  // of the derivative by the first edge's direction; the second's is minus it
  double reach;        // px, from the corner: beyond it they share nothing
  // `cosine`, `sine`: of the first edge's direction less the second's; `blur`: px.
  Crossing(double cosine, double sine, double blur) {
    const auto set = [](float& to, double value) { to = static_cast<float>(value); };
    const double r = std::clamp(cosine, -1.0, 1.0), variance = blur * blur;
    const double c = std::sqrt(0.5 * (1 + std::abs(sine))), s = 0.5 * r / c, s2 = s * s;  // of half the angle
    const double angle =
        2 * s * (1 + s2 * (1 / 6. + s2 * (3 / 40. + s2 * (15 / 336. + s2 * (105 / 3456.)))));  // asin r
    const double whole = sine < 0 ? -M_2_PI : M_2_PI;
    set(narrow, 0.5 / (variance * c * c)), set(twist, s / (variance * c * c));
    set(most, M_2_PI * angle), set(per_blur, 2 / blur);
    set(turn, whole), set(turn_by_both, 0.5 * whole * angle / (c * variance)),
        set(turn_by_square, whole * angle * s / c);
    reach = blur * std::sqrt(2 * kNothing * (1 - std::abs(s)) / (1 - std::abs(r)));
  }
};

// q and exp(-q) at the distances d and e from both edges.
template <class Vector>
struct Shared {
  Vector both, q, bell;
};
template <class Vector>
HANDSIGHT_INLINE void share(const Crossing& k, const Vector& d, const Vector& e, Shared<Vector>& shared) {
  shared.both = d * e;
  shared.q = k.narrow * (d * d + e * e) - k.twist * shared.both;
  exp_minus(shared.q, shared.bell);
}

// Minus the derivative by the first edge's direction, as far as it changes the angle between both.
template <class Vector>
HANDSIGHT_INLINE void turned(const Crossing& k, const Shared<Vector>& shared, Vector& to) {
  to = shared.bell * (k.turn + k.turn_by_both * shared.both - k.turn_by_square * shared.q);
}

}  // namespace handsight
