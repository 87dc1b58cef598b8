// SPDX-License-Identifier: GPL-3.0-or-later
// What several widgets say about an observation, in plain data.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>

namespace handsight::widgets {

using ObservationId = std::int64_t;
inline constexpr ObservationId no_observation = -1;

/// waiting: no markers yet (or not yet decided); used: part of the fit.
enum class CellState { waiting, used, rejected, excluded };

/// What the size of a residual is reported in. Colours never follow it: they are always residual over noise.
enum class SizeUnit { pixel, millimetre, sigma };

inline QString unit_name(SizeUnit unit) {
  return unit == SizeUnit::pixel        ? QStringLiteral("px")
         : unit == SizeUnit::millimetre ? QStringLiteral("mm")
                                        : QStringLiteral("σ");
}

/// A size told in some unit; no value: it has none in this unit.
struct ShownSize {
  std::optional<double> value;
  SizeUnit unit = SizeUnit::sigma;
};

/// What noise alone makes of a size: its root mean square, and of how many equal coordinates it is the root mean square
/// (not always a whole number: depth counts for more than height and width).
struct NoiseShape {
  double size = 1;
  double coordinates = 12;
};

/// One observation in strip and plots.
struct ObservationCell {
  ObservationId id = no_observation;
  CellState state = CellState::waiting;
  std::optional<double> rms_over_sigma;  // rms per coordinate over the noise; absent: not known
  std::optional<double> predicted;       // the same with a candidate that is being tried; absent: none
  int coordinates = 12;                  // averaged: 4 a marker seen by both cameras
  QString note;                          // a reason or a remark, for the read-out and tool tip
  std::optional<ShownSize> size;         // the rms as it is to be reported; absent: reported as rms_over_sigma
  std::optional<NoiseShape> noise;       // what noise alone makes of `size`, in its unit; absent: not known
  int session = -1;                      // of a collection: its number (session_mark.h); -1: there is one alone
};

/// The size that is reported of a cell.
inline ShownSize reported_size(const ObservationCell& cell) {
  return cell.size ? *cell.size : ShownSize{cell.rms_over_sigma, SizeUnit::sigma};
}

}  // namespace handsight::widgets
