// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/body_rows.h"

#include "chain/sighting.h"

namespace handsight {

BodyRows body_rows(const Problem& problem, const ProblemObservation& o, const Unknowns& u) {
  Eigen::Index count = 0;
  for (const Sighting& s : o.sightings) count += row_count(s);
  BodyRows rows{Eigen::MatrixXd(count, 6), Eigen::VectorXd(count)};
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u);
  Eigen::Index row = 0;
  for (const Sighting& s : o.sightings) {
    const Vector3 x = sensor_from_tcp * marker_at(o, u, s.marker);
    const SightingResidual r = sighting_residual(problem.rig_or_null(), s, x);
    rows.by_body.middleRows(row, r.rows) = by_motion(r.by_point, x);
    rows.error.segment(row, r.rows) = r.error;
    row += r.rows;
  }
  return rows;
}

}  // namespace handsight
