// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_accuracy.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "vision/corner_lanes.h"
#include "vision/corner_patch.h"
#include "vision/corner_products.h"
#include "vision/corner_solve.h"

namespace handsight {
namespace {

using Hessian = Eigen::Matrix<double, kOddUnknowns, kOddUnknowns>;
using Vector = Eigen::Matrix<double, kOddUnknowns, 1>;

constexpr double kAddedSigma = 0.03;    // grey levels per px: glare over most of an image
constexpr double kWide = 10;            // times that, where a corner tells its own
constexpr double kBendSigma = 3e-4;     // 1/px: a radius of 3000 px
constexpr double kMostBend = 0.01;      // 1/px
constexpr double kToldAdded = 0.1;      // grey levels per px: where a corner's own is known as well, all of it counts
constexpr double kPlainAdded = 0.2;     // grey levels per px, of all corners together: there is glare
constexpr double kFewCorners = 4;       // that the usual bend counts as; fewer tell nothing of the noise
constexpr double kFewPixels = 400;      // that white noise counts as
constexpr double kLargeDisc = 200;      // pixels: on smaller ones the next cells make neighbours alike
constexpr double kSmallDiscs = 0.5;     // of what seems alike on them is the noise's doing
constexpr double kMeasured = 0.80;      // of the variance, that rendered boards of all kinds show
constexpr double kFreedomOfImage = 30;  // of the variance that the image's corners tell together
constexpr double kPlain = 30;  // chi-squared of added light and bends, four numbers, that noise and the pixels' grid
                               // do not make: below it the position is better off without them
constexpr double kMostAlike = 0.1;   // of neighbouring pixels: what interpolates colours makes edges look bent
constexpr double kPlainBend = 5e-4;  // 1/px, of all corners together: the lens bends edges
constexpr double kSmoothedShare = 70.0 * 70 / (256 * 256);  // of white noise's variance, that smoothing leaves
constexpr double kMeasuredSmoothed = 0.22;  // of the variance by the smoothed residuals, measured as kMeasured
constexpr double kMosaicSigma = 0.003;      // px an axis, what is left of the pattern's own errors
// What a colour filter samples at every other pixel it cannot tell from what is coarser: px, across an edge that meets
// the pattern in one phase all along, times what blur leaves at half a cycle a pixel; px, along which phases differ.
constexpr double kAlias = 0.11, kPhases = 0.7;
constexpr double kInterpolated = 0.36;                   // px^2, of the fitted blur: the interpolation's own
constexpr double kLeastChequer = 0.1, kSureChequer = 4;  // the latter in standard errors
constexpr double kLeastFactor = 0.7, kMostFactor = 12;
constexpr std::array<std::array<int, 2>, kNeighbours> kSteps{{{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {2, 0}, {0, 2}}};

constexpr int kRows = kOddUnknowns + 1;
using Products = RowProducts<kRows>;

HANDSIGHT_LANES void products_in_lanes(const float* const* rows, int count, Products& products) {
  all_products<Lanes, kRows>(rows, count, products);
}
HANDSIGHT_WIDE void products_in_wide(const float* const* rows, int count, Products& products) {
  all_products<WideLanes, kRows>(rows, count, products);
}

HANDSIGHT_LANES bool invert_in_lanes(Hessian& m) { return invert<kOddUnknowns>(m); }

// Derivatives by added light and bends, from those by level and by the edges' directions.
struct MoreRows {
  alignas(64) std::array<CornerPatch::Row, 4> rows;
};

HANDSIGHT_LANES void fill_more(const CornerModel& model, const CornerPatch& patch, MoreRows& more) {
  const float *const all_u = pixel_columns(), *const all_v = pixel_rows();
  const auto pu = static_cast<float>(model.position.x() - patch.centre.x());
  const auto pv = static_cast<float>(model.position.y() - patch.centre.y());
  const auto first = static_cast<float>(model.edges[0]), second = static_cast<float>(model.edges[1]);
  const float s1 = std::sin(first), c1 = std::cos(first), s2 = std::sin(second), c2 = std::cos(second);
  for (int n = 0; n < patch.padded; n += kLanes) {
    Lanes u, v, level, turn;
    load(all_u + n, u), load(all_v + n, v), load(&patch.even[3][n], level);
    const Lanes x = u - pu, y = v - pv;
    store(level * x, &more.rows[0][n]);
    store(level * y, &more.rows[1][n]);
    load(&patch.even[0][n], turn);
    store(-0.5f * (c1 * x + s1 * y) * turn, &more.rows[2][n]);
    load(&patch.even[1][n], turn);
    store(-0.5f * (c2 * x + s2 * y) * turn, &more.rows[3][n]);
  }
}

// Rows of the patch as an image, with a margin so that neighbours need no care.
constexpr int kMargin = 3, kSide = 32, kMiddle = kMostPatchRadius + 1 + kMargin;
using Grid = std::array<float, kSide * kSide + kLanes>;

int place(const Eigen::Vector2i& offset) { return (offset.y() + kMiddle) * kSide + offset.x() + kMiddle; }

const std::array<int, kMostPatchPixels>& places() {
  static const std::array<int, kMostPatchPixels> all = [] {
    std::array<int, kMostPatchPixels> made{};
    for (int n = 0; n < pixels_in_disc(kMostPatchRadius + 1); ++n) made[n] = place(offset_of_pixel(n));
    return made;
  }();
  return all;
}

void spread(const CornerPatch::Row& row, int count, Grid& grid) {
  const auto& all = places();
  for (int n = 0; n < count; ++n) grid[all[n]] = row[n];
}

HANDSIGHT_LANES float product(const float* a, const float* b, int rows) {
  Lanes sum{}, x, y;
  for (int n = 0; n < rows * kSide; n += kLanes) load(a + n, x), load(b + n, y), sum += x * y;
  return total(sum);
}

// Sum over all pixels of a grid times itself, shifted.
float shifted_product(const Grid& grid, int reach, const std::array<int, 2>& step) {
  const float* const first = &grid[static_cast<std::size_t>((kMiddle - reach) * kSide)];
  return product(first, first + step[1] * kSide + step[0], 2 * reach + 1);
}

// Half the difference to the point reflected at the corner, which is a half or whole pixel off by `aside` (px): what
// that makes of the even part is taken away.
Grid odd_part(const Grid& grid, int reach, const Eigen::Vector2i& twice, const Eigen::Vector2d& aside) {
  Grid odd{}, even{};
  const auto first = [&](int at) { return std::max(-reach, at - reach); };
  const auto last = [&](int at) { return std::min(reach, at + reach); };
  for (int v = first(twice.y()); v <= last(twice.y()); ++v) {
    const float* const from = &grid[static_cast<std::size_t>(place({0, v}))];
    const float* const mirrored = &grid[static_cast<std::size_t>(place({twice.x(), twice.y() - v}))];
    float* const to = &odd[static_cast<std::size_t>(place({0, v}))];
    float* const sum = &even[static_cast<std::size_t>(place({0, v}))];
    for (int u = first(twice.x()); u <= last(twice.x()); ++u)
      to[u] = 0.5f * (from[u] - mirrored[-u]), sum[u] = 0.5f * (from[u] + mirrored[-u]);
  }
  const auto across = static_cast<float>(0.5 * aside.x()), down = static_cast<float>(0.5 * aside.y());
  for (int v = first(twice.y()); v <= last(twice.y()); ++v) {
    const float* const at = &even[static_cast<std::size_t>(place({0, v}))];
    float* const to = &odd[static_cast<std::size_t>(place({0, v}))];
    for (int u = first(twice.x()); u <= last(twice.x()); ++u)
      to[u] -= across * (at[u + 1] - at[u - 1]) + down * (at[u + kSide] - at[u - kSide]);
  }
  return odd;
}

Vector usual_information(double variance, double added, double bend) {
  Vector information = Vector::Zero();
  information.segment<2>(2).setConstant(variance / (kShadeSigma * kShadeSigma));
  information.segment<2>(4).setConstant(variance / (added * added));
  information.segment<2>(6).setConstant(variance / (bend * bend));
  return information;
}

// The patch of a fit with all rows: the odd unknowns' in their order, then residuals, as often as a tile reads them.
struct Rows {
  CornerPatch patch;
  MoreRows more;
  int reach = 0;
  Eigen::Vector2i centre{0, 0};
  std::array<const float*, kRows + kTileOfRows - 1> rows;
};

bool fill_rows(const Image& image, const CornerFit& fit, Rows& all) {
  all.reach = static_cast<int>(fit.radius) + 1, all.centre = pixel_of(fit.model.position);
  if (!is_inside(image, all.centre, all.reach)) return false;
  gather(image, all.centre, all.reach, all.patch);
  evaluate(fit.model, fit.radius, 0, all.patch.count, all.patch);
  fill_more(fit.model, all.patch, all.more);
  all.rows.fill(all.patch.residual.data());
  for (int i = 0; i < 4; ++i) all.rows[i] = all.patch.odd[i].data(), all.rows[i + 4] = all.more.rows[i].data();
  return true;
}

void set_equations(const float* const* rows, int count, OddSystem& system) {
  Products products;
  (has_wide_lanes() ? products_in_wide : products_in_lanes)(rows, count, products);
  for (int i = 0; i < kOddUnknowns; ++i) {
    for (int j = 0; j <= i; ++j) system.hessian(i, j) = system.hessian(j, i) = products[i][j];
    system.side(i) = products[kOddUnknowns][i];
  }
}

Eigen::Vector2i twice_from(const Eigen::Vector2i& centre, const Eigen::Vector2d& position) {
  return (2 * (position - centre.cast<double>())).array().round().cast<int>();
}

// Of a colour filter every other pixel is a measured green one: what is interpolated is the smoother.
double chequer_of(const Image& image, const Eigen::Vector2i& centre, int reach) {
  std::array<double, 2> squares{1, 1};
  const int left = std::max(centre.x() - reach, 1), right = std::min(centre.x() + reach, image.width - 2);
  const int top = std::max(centre.y() - reach, 1), bottom = std::min(centre.y() + reach, image.height - 2);
  for (int v = top; v <= bottom; ++v) {
    const std::uint8_t *up = image.row(v - 1), *at = image.row(v), *down = image.row(v + 1);
    for (int u = left; u <= right; ++u) {
      const int rough =
          up[u - 1] + up[u + 1] + down[u - 1] + down[u + 1] - 2 * (up[u] + at[u - 1] + at[u + 1] + down[u]) + 4 * at[u];
      squares[(u + v) & 1] += rough * rough;
    }
  }
  return std::log(squares[0] / squares[1]);
}

// Edges that run along rows or columns meet the pattern in one phase, and what that does to them does not average out.
Eigen::Matrix2d alias_of(const CornerModel& model, double radius) {
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity() * (kMosaicSigma * kMosaicSigma);
  const double blur_squared = std::max(model.blur * model.blur - kInterpolated, 1 / 12.0);
  const double across = kAlias * std::exp(-0.5 * M_PI * M_PI * blur_squared);
  for (int i = 0; i < 2; ++i) {
    const double angle = model.edges[i], other = model.edges[1 - i];
    const double aside = radius * std::min(std::abs(std::sin(angle)), std::abs(std::cos(angle))) / kPhases;
    const Eigen::Vector2d along_other(std::cos(other), std::sin(other));  // there the position moves
    const Eigen::Vector2d move = along_other * across / std::sin(other - angle);
    covariance += std::exp(-aside * aside) * move * move.transpose();
  }
  return covariance;
}

HANDSIGHT_LANES void smooth(Grid& grid) {
  Grid across{};
  constexpr int kEnd = kSide * (kSide - 1);
  for (int n = 1; n < kSide * kSide; ++n) across[n] = 0.25f * (grid[n - 1] + 2 * grid[n] + grid[n + 1]);
  for (int n = kSide; n < kEnd; ++n) grid[n] = 0.25f * (across[n - kSide] + 2 * across[n] + across[n + kSide]);
}

}  // namespace

std::optional<OddSystem> smoothed_odd_system(const Image& image, const CornerFit& fit) {
  Rows all;
  if (!fill_rows(image, fit, all)) return std::nullopt;
  std::array<Grid, kRows> grids{};
  std::array<const float*, kRows + kTileOfRows - 1> rows;
  const int reach = all.reach + 1, first = (kMiddle - reach) * kSide;
  for (int i = 0; i < kRows; ++i) {
    CornerPatch::Row row;
    std::copy_n(all.rows[i], all.patch.count, row.begin());
    spread(row, all.patch.count, grids[i]);
    smooth(grids[i]), smooth(grids[i]);
    rows[i] = &grids[i][static_cast<std::size_t>(first)];
  }
  std::fill(rows.begin() + kRows, rows.end(), rows[kRows - 1]);
  OddSystem system;
  system.is_smoothed = true, system.alias = alias_of(fit.model, fit.radius);
  set_equations(rows.data(), (2 * reach + 1) * kSide, system);
  system.shade = fit.model.shade;
  system.weights = squared_weights(all.patch);
  const double variance = std::max(fit.noise * fit.noise, kLeastNoise * kLeastNoise);
  Hessian inverse = system.hessian;
  const Vector information = usual_information(variance, kWide * kAddedSigma, kMostBend);
  inverse.diagonal() += information;
  if (!invert_in_lanes(inverse)) return std::nullopt;
  const Vector step = inverse * system.side;
  Grid& left = grids[kOddUnknowns];
  for (int i = 0; i < kOddUnknowns; ++i)
    for (std::size_t n = 0; n < left.size(); ++n) left[n] -= static_cast<float>(step(i)) * grids[i][n];
  const Grid odd = odd_part(left, reach, twice_from(all.centre, fit.model.position), Eigen::Vector2d::Zero());
  const double unknowns = kOddUnknowns - (information.array() * inverse.diagonal().array()).sum();
  const double freedom = std::max(0.5 * kSmoothedShare * system.weights - unknowns, 2.0);
  system.variance = std::max(shifted_product(odd, reach, {0, 0}) / freedom, kLeastNoise * kLeastNoise);
  system.variance_ratio = system.variance / variance;
  for (int i = 0; i < kOddUnknowns; ++i)
    system.seen[i] = step(i), system.seen_variance[i] = system.variance * inverse(i, i);
  return system;
}

std::optional<OddSystem> odd_system(const Image& image, const CornerFit& fit, bool with_neighbours) {
  const CornerModel& model = fit.model;
  Rows all;
  if (!fill_rows(image, fit, all)) return std::nullopt;
  auto& [patch, more, reach, centre, rows] = all;
  OddSystem system;
  set_equations(rows.data(), patch.padded, system);
  system.shade = model.shade;
  const double weights = squared_weights(patch);
  system.weights = weights;
  const double first = std::max(fit.noise * fit.noise, kLeastNoise * kLeastNoise);
  Hessian informed = system.hessian;
  const Vector information = usual_information(first, kWide * kAddedSigma, kMostBend);
  informed.diagonal() += information;
  if (!invert_in_lanes(informed)) return std::nullopt;
  const Hessian& inverse = informed;
  const Vector step = inverse * system.side;
  const auto settle = [&](double variance) {
    system.variance = std::max(variance, kLeastNoise * kLeastNoise);
    for (int i = 0; i < kOddUnknowns; ++i)
      system.seen[i] = step(i), system.seen_variance[i] = system.variance * inverse(i, i);
  };
  settle(first);
  if (!with_neighbours) return system;
  // What is left when the odd unknowns are as they would be by themselves.
  for (int i = 0; i < kOddUnknowns; ++i)
    for (int n = 0; n < patch.padded; ++n) patch.residual[n] -= static_cast<float>(step(i)) * rows[i][n];
  Grid grid{};
  spread(patch.residual, patch.count, grid);
  const Eigen::Vector2i twice = twice_from(centre, model.position);
  const Grid odd = odd_part(grid, reach, twice, 0.5 * twice.cast<double>() - (model.position - centre.cast<double>()));
  system.chequer = chequer_of(image, centre, reach);
  const double unknowns = kOddUnknowns - (information.array() * inverse.diagonal().array()).sum();
  settle(shifted_product(odd, reach, {0, 0}) / std::max(0.5 * weights - unknowns, 4.0));
  system.variance_ratio = system.variance / first;
  Grid by_u{}, by_v{};
  spread(patch.odd[0], patch.count, by_u), spread(patch.odd[1], patch.count, by_v);
  for (int k = 0; k < kNeighbours; ++k) {
    const double alike_u = shifted_product(by_u, reach, kSteps[k]) / std::max(system.hessian(0, 0), 1e-9);
    const double alike_v = shifted_product(by_v, reach, kSteps[k]) / std::max(system.hessian(1, 1), 1e-9);
    system.influence[k] = static_cast<float>(0.5 * (alike_u + alike_v));
    // A fit takes from white noise what its unknowns explain, and so makes neighbours unlike.
    const double taken = unknowns * system.influence[k];
    system.products[k] =
        static_cast<float>((shifted_product(odd, reach, kSteps[k]) / system.variance + taken) / (0.5 * weights));
  }
  return system;
}

void scale_variance(OddSystem& system, double factor) {
  system.variance *= factor;
  for (double& variance : system.seen_variance) variance *= factor;
}

double pooling(double variance, double weights, double of_image) {
  const double own = std::max(0.5 * weights - kOddUnknowns, 0.0);
  return (own + kFreedomOfImage * of_image / variance) / (own + kFreedomOfImage);
}

Habits habits_of(std::span<const OddSystem> systems) {
  Habits habits;
  double bends = kFewCorners * kBendSigma * kBendSigma, corners = kFewCorners, pixels = kFewPixels;
  double added = 0, lit = kFewCorners;
  double ratios = 0, chequer = 0, chequer_squares = 0;
  int looked_at = 0;
  const bool has_large = std::count_if(systems.begin(), systems.end(), [](const OddSystem& s) {
                           return s.weights > kLargeDisc && s.influence[0] != 0;
                         }) >= kFewCorners;
  for (const OddSystem& system : systems) {
    for (int i = 4; i < 6; ++i) {
      const double own = system.seen_variance[i], trust = 1 / (1 + own / (kToldAdded * kToldAdded));
      added += 0.5 * trust * (system.seen[i] * system.seen[i] - own), lit += 0.5 * trust;
    }
    for (int i = 6; i < 8; ++i) {
      const double own = system.seen_variance[i], trust = 1 / (1 + own / 1e-6);
      bends += 0.5 * trust * (system.seen[i] * system.seen[i] - own), corners += 0.5 * trust;
    }
    if (system.influence[0] == 0) continue;
    const double pixels_of = has_large && system.weights < kLargeDisc ? 0 : system.weights;
    pixels += pixels_of, ++looked_at;
    ratios += system.variance_ratio;
    chequer += system.chequer, chequer_squares += system.chequer * system.chequer;
    for (int k = 0; k < kNeighbours; ++k) {
      habits.correlation[k] += pixels_of * system.products[k];
      habits.influence[k] += system.influence[k];
    }
  }
  if (looked_at > 0) habits.variance = ratios / looked_at;
  if (looked_at > 2) {
    const double mean = chequer / looked_at, variance = chequer_squares / looked_at - mean * mean;
    const double error = std::sqrt(std::max(variance, 1e-6) / (looked_at - 1));
    habits.is_mosaic = std::abs(mean) > kLeastChequer && std::abs(mean) > kSureChequer * error;
  }
  for (float& influence : habits.influence) influence /= static_cast<float>(std::max(looked_at, 1));
  habits.added = std::max(std::sqrt(std::max(added, 0.0) / lit), kAddedSigma);
  habits.bend = std::clamp(std::sqrt(std::max(bends, 0.0) / corners), 0.3 * kBendSigma, kMostBend);
  const bool all_small = !has_large && looked_at >= kFewCorners;
  for (double& correlation : habits.correlation) correlation *= (all_small ? kSmallDiscs : 1) / pixels;
  return habits;
}

double correlation_factor(const OddSystem& system, const Habits& habits) {
  if (system.is_smoothed) return 1;
  const auto& influence = system.influence[0] != 0 ? system.influence : habits.influence;
  double factor = 1;
  for (int k = 0; k < kNeighbours; ++k) factor += 2 * habits.correlation[k] * influence[k];
  return std::clamp(factor, kLeastFactor, kMostFactor);
}

bool are_bent(const Habits& habits) {
  const auto most = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const double alike = *std::max_element(habits.correlation.begin(), habits.correlation.end(), most);
  return habits.bend > kPlainBend && std::abs(alike) < kMostAlike;
}

bool are_glared(const Habits& habits) { return habits.added > kPlainAdded; }

bool is_plain(const OddSystem& system) {
  double chi2 = 0;
  for (int i = 4; i < kOddUnknowns; ++i) chi2 += system.seen[i] * system.seen[i] / system.seen_variance[i];
  return chi2 * std::min(system.variance_ratio, 1.0) > kPlain;  // in terms of all that the fit leaves
}

std::optional<LastStep> last_step(const OddSystem& system, const Habits& habits) {
  const double variance = system.variance * correlation_factor(system, habits);
  Vector information = usual_information(variance, habits.added, habits.bend);
  for (int i = 4; i < 6; ++i) {  // light may be added by as much as it seems to be here
    const double seen = std::max(system.seen[i] * system.seen[i] - system.seen_variance[i], 0.0);
    information(i) = variance / (habits.added * habits.added + seen);
  }
  Vector side = system.side;
  side.segment<2>(2) -= information.segment<2>(2).cwiseProduct(system.shade);
  Hessian inverse = system.hessian;
  inverse.diagonal() += information;
  if (!invert_in_lanes(inverse)) return std::nullopt;
  const Vector step = inverse * side;
  LastStep last;
  last.is_needed = system.is_smoothed || is_plain(system) || are_bent(habits) || are_glared(habits);
  last.move = step.head<2>(),
  last.covariance = (system.is_smoothed ? kMeasuredSmoothed : kMeasured) * variance * inverse.topLeftCorner<2, 2>();
  if (system.is_smoothed) last.covariance += system.alias;
  if (!(last.covariance(0, 0) > 0 && last.covariance.determinant() > 0)) return std::nullopt;
  return last;
}

}  // namespace handsight
