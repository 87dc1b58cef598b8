// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/observation_rows.h"

#include <cmath>

#include "estimation/solvers/normal_equations.h"

namespace handsight {

Eigen::MatrixXd by_columns(const Problem& p, const ProblemObservation& o, const Sighting& s, const Vector3& x,
                           const SightingResidual& r, const Matrix3& sensor_from_tcp,
                           const Eigen::Matrix<double, 6, Eigen::Dynamic>& motion) {
  Eigen::MatrixXd j = Eigen::MatrixXd::Zero(r.rows, p.columns());
  j.middleCols(3 * s.marker, 3) = r.by_point * sensor_from_tcp;
  j.rightCols(motion.cols()) += by_motion(r.by_point, x) * motion;
  if (p.effect_count() > 0)
    j.rightCols(p.effect_count()) += direct_by_effects(p, o, s, r, x, sensor_from_tcp).leftCols(p.effect_count());
  return j;
}

ObservationRows observation_rows(const Problem& p, const ProblemObservation& o, const Unknowns& u) {
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u);
  const Eigen::Matrix<double, 6, Eigen::Dynamic> motion = motion_by_columns(p, o, u);
  Eigen::Index count = 0, next = 0;
  for (const Sighting& s : o.sightings) count += row_count(s);
  ObservationRows rows{Eigen::VectorXd(count), Eigen::MatrixXd(count, p.columns())};
  for (std::size_t i = 0; i < o.sightings.size(); ++i) {
    const Sighting& s = o.sightings[i];
    const Vector3 x = sensor_from_tcp * marker_at(o, u, s.marker);
    const SightingResidual r = sighting_residual(p.rig_or_null(), s, x);
    const double weight = o.weights.empty() ? 1 : std::sqrt(o.weights[i]);
    rows.error.segment(next, r.rows) = weight * r.error.head(r.rows);
    rows.by_columns.middleRows(next, r.rows) = weight * by_columns(p, o, s, x, r, sensor_from_tcp.rotation, motion);
    next += r.rows;
  }
  return rows;
}

}  // namespace handsight
