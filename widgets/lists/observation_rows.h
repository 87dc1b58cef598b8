// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the table of observations, and which of them are shown.
#pragma once

#include <QString>
#include <optional>

#include "widgets/base/cells.h"

namespace handsight::widgets {

struct ObservationRow {
  ObservationId id = no_observation;
  CellState state = CellState::waiting;
  std::optional<double> rms_pixel, rms_mm, angle_deg;
  std::optional<double> rms_over_sigma;
  int coordinates = 12;
  QString worst;  // "2, right": the worst marker
  std::optional<double> worst_over_sigma;
  bool is_odd = false;  // stands out: what the filter "odd" shows
  QString reason;
  int session = -1;  // of a collection: its number (session_mark.h)
};

enum class RowFilter { all, odd, excluded, rejected };

}  // namespace handsight::widgets
