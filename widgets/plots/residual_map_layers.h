// SPDX-License-Identifier: GPL-3.0-or-later
// What a ResidualMap draws with. Internal to residual_map*.cpp.
#pragma once

#include <qcustomplot.h>

#include <array>
#include <vector>

namespace handsight::widgets {

inline constexpr int column_count = 6, row_count = 4, direction_count = 16;

struct ResidualMapLayers {
  std::array<QCPGraph*, 6> discs{};
  std::array<QCPCurve*, 6> arrows{};
  std::array<QCPGraph*, direction_count> directions{};
  QCPCurve* means = nullptr;
  QCPGraph *selected = nullptr, *hovered = nullptr;
  QCPItemRect* frame = nullptr;
  std::vector<QCPItemText*> counts;
  QCPItemLine* bar = nullptr;
  QCPItemText* bar_text = nullptr;
};

}  // namespace handsight::widgets
