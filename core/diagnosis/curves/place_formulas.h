// SPDX-License-Identifier: Apache-2.0
// What the sensor sees of the TCP's place, as formulas of tcp_x, tcp_y, tcp_z (effects/own_effect.h) in which the
// sensor stands where it is now.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimation/problem/problem.h"

namespace handsight {

/// A formula, and what it gives in each observation of the problem.
struct PlaceFormula {
  std::string text;
  Eigen::VectorXd values;
};

/// The nominal TCP in the frame of the sensor's link, m, an observation a column.
Eigen::Matrix3Xd tcp_places(const Problem& problem);

/// Along the first camera's axis, or from the tracker's origin, m: "(tcp_x - 0.9986*tcp_z + 0.412)".
PlaceFormula distance_formula(const Problem& problem, const Eigen::Matrix3Xd& places, const Rigid& mount_from_sensor);

/// Where the first camera's image has the TCP without its lens's distortion, px; axis 0: the column, 1: the row. Places
/// nearer than half of the nearest are taken for as near as that, so that it is finite everywhere.
PlaceFormula image_formula(const Problem& problem, const Eigen::Matrix3Xd& places, const Rigid& mount_from_sensor,
                           int axis);

/// A place from the middle of those of a session, in units of how far they reach: "((0.2 + 0.98*tcp_z - 1.31)/0.42)".
std::string centred_text(const std::string& place, double middle, double reach);

/// The first part of a formula that centred_text has made; empty: there is none.
std::string centred_part(const std::string& formula);

/// What the first of the curve's formulas follows, without its middle and reach; none where it follows no place.
std::optional<PlaceFormula> followed_place(const Problem& problem, const EffectDefinition& curve);

}  // namespace handsight
