// SPDX-License-Identifier: Apache-2.0
// The body's shape as the average of all observations, by principal component analysis (thesis 4.19-4.23).
#pragma once

#include "estimation/problem/problem.h"

namespace handsight {

struct BodyShape {
  std::vector<Vector3> markers;         // m, in the frame of the principal components
  std::vector<char> is_known;           // per marker: some observation saw it as a point together with two others
  std::vector<Matrix3> covariances;     // m^2, of the average positions, from the observations' scatter
  Vector3 variances = Vector3::Zero();  // m^2 along the principal components, largest first
};

/// Every observation's triangulated markers are laid onto the shape found so far, starting with the one that shows the
/// most markers, and averaged, each weighed alike; twice, so that the first one counts no more than the others. The
/// frame is that of the principal components of all points (4.20-4.22, the centroid divided by their number), the
/// eigenvectors signed so that the largest component of each is positive, the third completing a right-handed frame.
/// Nothing where no observation shows three markers as points.
std::optional<BodyShape> average_shape(const Problem& problem);

}  // namespace handsight
