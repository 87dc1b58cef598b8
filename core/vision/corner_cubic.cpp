// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_cubic.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace handsight {
namespace {

constexpr int kTerms = 10;
constexpr int kLeastRadius = 4;  // px
using Basis = std::array<CornerPatch::Row, kTerms>;

// Orthonormal polynomials up to the third degree on the pixels of each disc.
const Basis& basis(int radius) {
  static const std::vector<Basis> made = [] {
    std::vector<Basis> all(kMostPatchRadius - kLeastRadius + 1);
    for (int r = kLeastRadius; r <= kMostPatchRadius; ++r) {
      const int count = pixels_in_disc(r);
      Eigen::MatrixXd terms(count, kTerms);
      for (int n = 0; n < count; ++n) {
        const Eigen::Vector2d x = offset_of_pixel(n).cast<double>() / r;
        for (int degree = 0, k = 0; degree <= 3; ++degree)
          for (int i = 0; i <= degree; ++i, ++k) terms(n, k) = std::pow(x.x(), degree - i) * std::pow(x.y(), i);
      }
      const Eigen::MatrixXd q = terms.householderQr().householderQ() * Eigen::MatrixXd::Identity(count, kTerms);
      for (int k = 0; k < kTerms; ++k) {
        CornerPatch::Row& row = all[r - kLeastRadius][k];
        row.fill(0);
        for (int n = 0; n < count; ++n) row[n] = static_cast<float>(q(n, k));
      }
    }
    return all;
  }();
  return made[radius - kLeastRadius];
}

}  // namespace

double cubic_over_model(const Image& image, const CornerModel& model, int radius, CornerPatch& patch) {
  const Eigen::Vector2i centre = (model.position.array() + 0.5).floor().cast<int>();
  gather(image, centre, radius, patch);
  evaluate(model, radius + 2, 0, patch.count, patch);  // so far out that all pixels have their full weight
  const int count = patch.count;
  const auto level = static_cast<float>(model.level);
  float all = 0, left = 0;
  for (int n = 0; n < count; ++n) {
    const float value = patch.value[n] - level;
    all += value * value, left += patch.residual[n] * patch.residual[n];
  }
  for (const CornerPatch::Row& term : basis(radius)) {
    float part = 0;
    for (int n = 0; n < count; ++n) part += term[n] * (patch.value[n] - level);
    all -= part * part;
  }
  // Rounding to whole grey levels leaves as much anyhow.
  return all / std::max(left, static_cast<float>(count) / 12);
}

}  // namespace handsight
