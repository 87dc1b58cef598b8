// SPDX-License-Identifier: GPL-3.0-or-later
// What several widgets say about an observation, in plain data.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>

namespace handsight::widgets {

using ObservationId = std::int64_t;
inline constexpr ObservationId kNoObservation = -1;

/// waiting: no markers yet (or not yet decided); used: part of the fit.
enum class CellState { waiting, used, rejected, excluded };

/// One observation in strip and plots.
struct ObservationCell {
  ObservationId id = kNoObservation;
  CellState state = CellState::waiting;
  std::optional<double> rms_over_sigma;  // rms per coordinate over the noise; absent: not known
  std::optional<double> predicted;       // the same with a candidate that is being tried; absent: none
  int coordinates = 12;                  // averaged: 4 a marker seen by both cameras
  QString note;                          // a reason or a remark, for the read-out and tool tip
};

enum class ImageSide { left, right };

}  // namespace handsight::widgets
