// SPDX-License-Identifier: Apache-2.0
#include "session/session.h"

#include <algorithm>
#include <cmath>

namespace handsight {

std::filesystem::path folder(const Session& session) {
  const std::filesystem::path parent = session.file.parent_path();
  return parent.empty() ? "." : parent;
}

bool is_used(const Observation& observation) {
  return !observation.sightings.empty() && observation.decision != Decision::rejected &&
         observation.decision != Decision::excluded;
}

double usual_sigma(const Session& session) {
  const std::optional<double>& declared = session.is_tracker() ? session.sigma_point : session.sigma_pixel;
  std::vector<double> told;
  for (const Observation& o : session.observations)
    for (const Sighting& s : o.sightings) {
      for (const auto& pixel : {s.left_sigma, s.right_sigma})
        if (pixel) told.push_back(std::sqrt((pixel->u * pixel->u + pixel->v * pixel->v) / 2));
      if (s.point_sigma) told.push_back(*s.point_sigma);
    }
  if (told.empty()) return 0;
  if (declared) return *declared;
  const auto middle = told.begin() + static_cast<std::ptrdiff_t>(told.size() / 2);
  std::nth_element(told.begin(), middle, told.end());
  return *middle;
}

PixelSigma pixel_sigma(const Eigen::Matrix2d& covariance) {
  return {std::sqrt(covariance(0, 0)), std::sqrt(covariance(1, 1)), covariance(0, 1)};
}

Eigen::Matrix2d covariance_of(const PixelSigma& sigma) {
  return (Eigen::Matrix2d() << sigma.u * sigma.u, sigma.uv, sigma.uv, sigma.v * sigma.v).finished();
}

}  // namespace handsight
