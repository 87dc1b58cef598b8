// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_odd_rows.h"

#include <cmath>

#include "vision/corners/corner_crossing.h"

namespace handsight {
namespace {

using Products = RowProducts<odd_rows>;

HANDSIGHT_LANES void products_simd(const float* const* rows, int count, Products& products) {
  all_products<Simd, odd_rows>(rows, count, products);
}
HANDSIGHT_WIDE void products_in_wide(const float* const* rows, int count, Products& products) {
  all_products<WideSimd, odd_rows>(rows, count, products);
}

// Derivatives by added light and bends, from those by level and by the edges' directions; but a bend does not change
// the angle at which the edges cross.
HANDSIGHT_LANES void fill_more(const CornerModel& model, const CornerPatch& patch,
                               std::array<CornerPatch::Row, 4>& more) {
  const float *const all_u = pixel_columns(), *const all_v = pixel_rows();
  const auto pu = static_cast<float>(model.position.x() - patch.centre.x());
  const auto pv = static_cast<float>(model.position.y() - patch.centre.y());
  const auto first = static_cast<float>(model.edges[0]), second = static_cast<float>(model.edges[1]);
  const float s1 = std::sin(first), c1 = std::cos(first), s2 = std::sin(second), c2 = std::cos(second);
  const Crossing crossing(c1 * c2 + s1 * s2, s1 * c2 - c1 * s2, model.blur);
  const auto half = static_cast<float>(model.half_contrast);
  for (int n = 0; n < patch.padded; n += simd_lanes) {
    Simd u, v, level, turn, together;
    Shared<Simd> shared;
    load(all_u + n, u), load(all_v + n, v), load(&patch.even[3][n], level);
    const Simd x = u - pu, y = v - pv;
    store(level * x, &more[0][n]);
    store(level * y, &more[1][n]);
    share<Simd>(crossing, c1 * y - s1 * x, c2 * y - s2 * x, shared);
    turned(crossing, shared, together);
    together *= half * level;
    load(&patch.even[0][n], turn);
    store(-0.5f * (c1 * x + s1 * y) * (turn + together), &more[2][n]);
    load(&patch.even[1][n], turn);
    store(-0.5f * (c2 * x + s2 * y) * (turn - together), &more[3][n]);
  }
}

}  // namespace

bool fill_rows(const Image& image, const CornerFit& fit, OddRows& all) {
  all.reach = static_cast<int>(fit.radius) + 1, all.centre = nearest_pixel(fit.model.position);
  if (!is_inside(image, all.centre, all.reach)) return false;
  gather(image, all.centre, all.reach, all.patch);
  evaluate(fit.model, fit.radius, 0, all.patch.count, all.patch);
  fill_more(fit.model, all.patch, all.more);
  all.rows.fill(all.patch.residual.data());
  for (int i = 0; i < 4; ++i) all.rows[i] = all.patch.odd[i].data(), all.rows[i + 4] = all.more[i].data();
  return true;
}

void set_equations(const float* const* rows, int count, OddSystem& system) {
  Products products;
  (has_wide_simd() ? products_in_wide : products_simd)(rows, count, products);
  for (int i = 0; i < odd_unknown_count; ++i) {
    for (int j = 0; j <= i; ++j) system.hessian(i, j) = system.hessian(j, i) = products[i][j];
    system.side(i) = products[odd_unknown_count][i];
  }
}

}  // namespace handsight
