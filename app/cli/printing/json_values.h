// SPDX-License-Identifier: Apache-2.0
// Values as JSON: numbers that read back bit for bit, null for what is not known.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "command.h"
#include "geometry/rigid.h"

namespace handsight::cli {

inline Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
inline Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

template <class Derived>
Json numbers(const Eigen::MatrixBase<Derived>& vector) {
  Json list = Json::array();
  for (Eigen::Index i = 0; i < vector.size(); ++i) list.push_back(number(vector(i)));
  return list;
}

/// Row by row.
template <class Derived>
Json matrix(const Eigen::MatrixBase<Derived>& m) {
  Json rows = Json::array();
  for (Eigen::Index r = 0; r < m.rows(); ++r) rows.push_back(numbers(m.row(r)));
  return rows;
}

inline Json motion(const Rigid& rigid) { return matrix(matrix_from_rigid(rigid)); }

/// x y z (m), roll pitch yaw (rad, XYZ fixed angles).
inline Json six(const Rigid& rigid) {
  Vector6 v;
  v << rigid.translation, rpy_from_rotation(rigid.rotation);
  return numbers(v);
}

}  // namespace handsight::cli
