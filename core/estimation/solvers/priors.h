// SPDX-License-Identifier: Apache-2.0
// What is known of a problem's unknowns beside its observations: the markers' shape, the sizes of effects, cameras from
// images of a board.
#pragma once

#include "estimation/problem/problem.h"
#include "estimation/solvers/equation_sums.h"

namespace handsight {

/// Half the second derivative of a cost by some columns, half the first with the sign turned, and the cost.
struct Prior {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  double cost = 0;
};

/// The markers' shape by the markers' columns, in the problem's units: |x - T p|^2 (noise / sigma)^2 with T the motion
/// that lays the known places p best onto the markers, piece by piece; what is known exactly is taken as known to 1 um.
/// Of a body with parts (KnownShape::parts) each part may be off as a whole within its sigmas. Empty where no shape is
/// known.
Prior shape_prior(const Problem& problem, const std::vector<Vector3>& markers_in_tcp);

/// The same as rows whose squares make the cost: information = by_markers^T by_markers, gradient = -by_markers^T off.
struct PriorRows {
  Eigen::MatrixXd by_markers;  // 3m x 3m
  Eigen::VectorXd off;
};
PriorRows shape_prior_rows(const Problem& problem, const std::vector<Vector3>& markers_in_tcp);

/// Does Problem::camera_images say something of a number that is estimated?
inline bool learns_from_camera_images(const Problem& p) {
  return p.camera_images && p.rig && p.effect_count() > 0 && p.cameras_by_effect.cols() == p.effect_count();
}

/// What Problem::camera_images say where the problem's rig stands, by the effects' columns and in units of their
/// sigmas. Empty where they say nothing.
Prior camera_prior(const Problem& problem);

/// Where the measurements tell no length: the robot is as large as described within robot_scale_sigma, where the
/// problem stands; by the effects' columns, in units of that. Empty elsewhere.
Prior robot_scale_prior(const Problem& problem);

/// How far two mounts are apart: off in units of the sigma, and by the two mounts' origins (m^-1).
struct DistanceRow {
  double off = 0;
  Vector3 by_of, by_from;  // of the origins in their link's frame
};
DistanceRow distance_row(const MountDistance& distance, const Vector3& of, const Vector3& from);

/// What a mount's place is off what is known of it, in units of the sigma, and by the mount's small motion M exp(v).
struct PlaceRow {
  double off = 0;
  Vector6 by_motion;
};
PlaceRow place_row(const MountPlace& place, const Rigid& mount);

/// Is anything of the problem a touch?
bool has_fixtures(const Problem& problem);

/// Adds these and the priors of the effects' sizes to the normal equations of all columns.
void add_priors(const Problem& problem, const Unknowns& unknowns, NormalEquations& normal);

}  // namespace handsight
