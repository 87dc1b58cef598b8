// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_odd_system.h"

#include <algorithm>

#include "vision/corners/corner_noise.h"
#include "vision/corners/corner_odd_grid.h"
#include "vision/corners/corner_odd_rows.h"
#include "vision/corners/corner_patch.h"
#include "vision/corners/corner_solve.h"

namespace handsight {
namespace {

constexpr std::array<std::array<int, 2>, neighbour_count> step_list{{{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {2, 0}, {0, 2}}};

HANDSIGHT_LANES bool invert_simd(OddMatrix& m) { return invert<odd_unknown_count>(m); }

}  // namespace

std::optional<OddSystem> odd_system(const Image& image, const CornerFit& fit, bool with_neighbours) {
  const CornerModel& model = fit.model;
  OddRows all;
  if (!fill_rows(image, fit, all)) return std::nullopt;
  auto& [patch, more, reach, centre, rows] = all;
  OddSystem system;
  set_equations(rows.data(), patch.padded, system);
  system.shade = model.shade;
  const double weights = squared_weights(patch);
  system.weights = weights;
  const double first = std::max(fit.noise * fit.noise, least_noise * least_noise);
  OddMatrix informed = system.hessian;
  const OddVector information = usual_information(first, wide_added, most_bend);
  informed.diagonal() += information;
  if (!invert_odd(informed)) return std::nullopt;
  const OddMatrix& inverse = informed;
  const OddVector step = inverse * system.side;
  const auto settle = [&](double variance) {
    system.variance = std::max(variance, least_noise * least_noise);
    for (int i = 0; i < odd_unknown_count; ++i)
      system.seen[i] = step(i), system.seen_variance[i] = system.variance * inverse(i, i);
  };
  settle(first);
  if (!with_neighbours) return system;
  // What is left when the odd unknowns are as they would be by themselves.
  for (int i = 0; i < odd_unknown_count; ++i)
    for (int n = 0; n < patch.padded; ++n) patch.residual[n] -= static_cast<float>(step(i)) * rows[i][n];
  OddGrid grid{};
  spread(patch.residual, patch.count, grid);
  const Eigen::Vector2i twice = twice_from(centre, model.position);
  const OddGrid odd =
      odd_part(grid, reach, twice, 0.5 * twice.cast<double>() - (model.position - centre.cast<double>()));
  system.chequer = measure_chequer(image, centre, reach);
  const double unknowns = odd_unknown_count - (information.array() * inverse.diagonal().array()).sum();
  settle(shifted_product(odd, reach, {0, 0}) / std::max(0.5 * weights - unknowns, 4.0));
  system.variance_ratio = system.variance / first;
  OddGrid by_u{}, by_v{};
  spread(patch.odd[0], patch.count, by_u), spread(patch.odd[1], patch.count, by_v);
  for (int k = 0; k < neighbour_count; ++k) {
    const double alike_u = shifted_product(by_u, reach, step_list[k]) / std::max(system.hessian(0, 0), 1e-9);
    const double alike_v = shifted_product(by_v, reach, step_list[k]) / std::max(system.hessian(1, 1), 1e-9);
    system.influence[k] = static_cast<float>(0.5 * (alike_u + alike_v));
    // A fit takes from white noise what its unknowns explain, and so makes neighbours unlike.
    const double taken = unknowns * system.influence[k];
    system.products[k] =
        static_cast<float>((shifted_product(odd, reach, step_list[k]) / system.variance + taken) / (0.5 * weights));
  }
  return system;
}

void scale_variance(OddSystem& system, double factor) {
  system.variance *= factor;
  for (double& variance : system.seen_variance) variance *= factor;
}

OddVector usual_information(double variance, double added, double bend) {
  OddVector information = OddVector::Zero();
  information.segment<2>(2).setConstant(variance / (shade_sigma * shade_sigma));
  information.segment<2>(4).setConstant(variance / (added * added));
  information.segment<2>(6).setConstant(variance / (bend * bend));
  return information;
}

bool invert_odd(OddMatrix& matrix) { return invert_simd(matrix); }

}  // namespace handsight
