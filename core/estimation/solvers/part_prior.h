// SPDX-License-Identifier: Apache-2.0
// What is known of a body whose parts (tags) are firm things that were put on it within sigmas.
#pragma once

#include "session/session.h"

namespace handsight {

/// Rows whose squares are the misfit: `off` (as many as coordinates) and how they follow the markers' coordinates
/// (square), both in sigmas.
struct PartRows {
  Eigen::MatrixXd by_markers;
  Eigen::VectorXd off;
};

/// The misfit of markers (m, TCP frame, those of all parts in order) to a shape with parts: each part is off by a
/// shift and a turn within its sigmas, each coordinate of a marker by `sigma` (m) beside; the body as a whole lies
/// where this is least.
PartRows part_rows(const KnownShape& shape, const std::vector<Vector3>& markers, double sigma);

}  // namespace handsight
