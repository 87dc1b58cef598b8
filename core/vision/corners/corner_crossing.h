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
#include <array>
#include <cmath>

#include "vision/corners/corner_shape.h"
#include "vision/corners/corner_simd.h"

namespace handsight {

struct Crossing {
  static constexpr double nothing_shared = 5;  // q, where a 150th is left of what they share at the corner
  float narrow, twist;                         // q = narrow (d^2 + e^2) - twist d e
  float most, per_blur;                        // where both edges are; by how much q grows it as blur does
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
    reach = blur * std::sqrt(2 * nothing_shared * (1 - std::abs(s)) / (1 - std::abs(r)));
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

/// The same of one of the corner's edges and a shadow's, whose light is blurred with it: of the shadow's softness the
/// lens makes only its blur, the rest is its own, so that the correlation is blur / softness times the cosine. Edges
/// that run along each other share most; there it is off by 0.04 at most.
struct ShadowCrossing {
  static constexpr float nothing_shared = 6,
                         left_shared = 0.00247875f;  // q, and exp(-q), from where on they share nothing
  float by_edge = 0, by_shadow = 0, twist = 0, most = 0;
  ShadowCrossing() = default;
  // `cosine`: of the angle between both normals; `blur`, `softness`: px; `factor`: what stands before what they share.
  ShadowCrossing(double cosine, double blur, double softness, double factor) {
    const double r = std::clamp(cosine * blur / softness, -0.98, 0.98), angle = std::asin(r);
    const double s = std::sin(0.5 * angle), c2 = 1 - s * s;
    const auto set = [](float& to, double value) { to = static_cast<float>(value); };
    set(by_edge, 0.5 / (blur * blur * c2)), set(by_shadow, 0.5 / (softness * softness * c2));
    set(twist, s / (blur * softness * c2)), set(most, factor * M_2_PI * angle);
  }
  // The exponent q at the distances d and e (px) from both; what they share follows, and its derivatives by these.
  template <class Vector>
  HANDSIGHT_INLINE void exponent(const Vector& d, const Vector& e, Vector& q) const {
    q = by_edge * d * d + by_shadow * e * e - twist * d * e;
  }
  template <class Vector>
  HANDSIGHT_INLINE void share(const Vector& d, const Vector& e, const Vector& q, Vector& shared, Vector& by_d,
                              Vector& by_e) const {
    Vector bell, zero{};
    exp_minus(q, bell);
    shared = q < nothing_shared ? most * (bell - left_shared) : zero;
    bell = q < nothing_shared ? most * bell : zero;
    by_d = bell * (twist * e - 2.f * by_edge * d), by_e = bell * (twist * d - 2.f * by_shadow * e);
  }
  template <class Vector>
  HANDSIGHT_INLINE void share(const Vector& d, const Vector& e, Vector& shared) const {
    Vector q, bell, zero{};
    exponent(d, e, q), exp_minus(q, bell);
    shared = q < nothing_shared ? most * (bell - left_shared) : zero;
  }
};

/// Of a model's two edges, each times what it changes the grey levels by.
inline std::array<ShadowCrossing, 2> find_crossings(const CornerModel& model) {
  const auto of_edge = [&](int i) {
    return ShadowCrossing(std::sin(model.shadow.direction - model.edges[i]), model.blur, model.shadow.softness,
                          -0.5 * model.shadow.depth * model.half_contrast);
  };
  return {of_edge(0), of_edge(1)};
}

}  // namespace handsight
