// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/error.h"
#include "print/circle_grid.h"
#include "print/target.h"

namespace handsight {

bool is_circle_grid(const Target& target) {
  return target.kind == TargetKind::chessboard &&
         (target.dictionary == "symmetric" || target.dictionary == "asymmetric");
}

bool is_asymmetric(const Target& target) { return target.dictionary == "asymmetric"; }

std::vector<TargetPoint> circle_points(const Target& target) {
  std::vector<TargetPoint> points;
  for (int row = 0; row < target.rows; ++row)
    for (int column = 0; column < target.columns; ++column) {
      const int across = is_asymmetric(target) ? 2 * column + row % 2 : column;
      points.push_back({Vector3(across * target.square, row * target.square, 0), 0});
    }
  return points;
}

void check_circles(const Target& target, std::string_view where) {
  const double step = is_asymmetric(target) ? std::sqrt(2.0) * target.square : target.square;
  if (!(target.tag > 0) || !(target.tag < 0.95 * step))
    throw InputError(message(
        "{}: diameter is {:g} m; expected more than 0 and less than the {:g} m between two circles, so that they do "
        "not touch.",
        where, target.tag, step));
}

Message circles_description(const Target& target) {
  return message("{} grid of {} x {} circles of {:g} mm, {} {:g} mm", target.dictionary, target.columns, target.rows,
                 1e3 * target.tag, is_asymmetric(target) ? "unit" : "steps of", 1e3 * target.square);
}

}  // namespace handsight
