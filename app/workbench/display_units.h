// SPDX-License-Identifier: GPL-3.0-or-later
// In what the sizes of residuals are reported: px, mm at the hand, or sigma. One choice for the whole window.
#pragma once

#include <QObject>
#include <array>
#include <optional>

#include "document/model_version.h"
#include "widgets/base/cells.h"

namespace handsight::app {

inline std::optional<double> scaled(std::optional<double> value, double scale) {
  return value ? std::optional(scale * *value) : std::nullopt;
}

/// A residual in every unit in which it has an honest value.
struct ResidualSize {
  std::optional<double> pixel;       // rms of an image coordinate; of one corner how far off it is
  std::optional<double> millimetre;  // rms of the markers' distances in space; of one corner across its line of sight
  std::optional<double> sigma;       // rms of a coordinate over the noise of one: what the colours mean

  std::optional<double> in(widgets::SizeUnit unit) const;
};

ResidualSize measure_size(const ErrorSummary& error, bool in_pixels, std::optional<double> noise);
ResidualSize measure_size(const InspectionRow& row);
/// One marker of it: in px the worst of its corners.
ResidualSize measure_size(const MarkerResidual& marker, const Inspection& all);
/// One corner: its residual (px), seen by this camera.
ResidualSize size_of_corner(const MarkerResidual& marker, int camera, const Rig& rig, std::optional<double> noise);
/// The same as a vector in the image (right, down); nothing where it has no value in this unit.
std::optional<Vector2> corner_in(widgets::SizeUnit unit, const MarkerResidual& marker, int camera, const Rig& rig,
                                 std::optional<double> noise);

/// The errors of a version of the model, and what noise alone would make of them. `noise` of one coordinate (px or m)
/// is what sigma means.
struct VersionSizes {
  ResidualSize fitted, held_out, noise;
  /// Held out where that is known, else fitted.
  const ResidualSize& error() const { return held_out.millimetre || held_out.pixel ? held_out : fitted; }
};
VersionSizes list_sizes(const ModelVersion& version, std::optional<double> noise);
/// The same of a report; `own_noise` (px or m, of one coordinate) is what its fit found.
VersionSizes list_sizes(const FitReport& report, bool in_pixels, std::optional<double> own_noise,
                        std::optional<double> noise);

/// An error as it is reported (px, m; as_reported); in mm it is known of trackers alone, which measure in space.
ResidualSize size_of_error(double error, bool in_pixels, std::optional<double> noise);

/// A size in a unit; where it has none there, in its own, which the answer names.
widgets::ShownSize shown_in(widgets::SizeUnit unit, const ResidualSize& size);
QString text_in(widgets::SizeUnit unit, const ResidualSize& size, int digits = 2);

/// What noise alone makes of an observation's size, in a unit.
std::optional<double> noise_in(widgets::SizeUnit unit, const Inspection& all);

class DisplayUnits : public QObject {
  Q_OBJECT

 public:
  using Unit = widgets::SizeUnit;
  static constexpr std::array<Unit, 3> all = {Unit::pixel, Unit::millimetre, Unit::sigma};

  /// Takes up what was chosen in an earlier window.
  explicit DisplayUnits(QObject* parent = nullptr);

  /// The unit in force: the one that was chosen, or the nearest that this session has.
  Unit unit() const;
  bool has(Unit unit) const { return why_not(unit).isEmpty(); }
  /// Why this session has no sizes in a unit; empty: it has.
  QString why_not(Unit unit) const;
  void choose(Unit unit);
  /// px, mm, sigma, px, ...
  void next();
  void set_session(bool has_pixels, bool knows_noise);

  /// In the unit in force, or in its own.
  widgets::ShownSize shown(const ResidualSize& size) const { return shown_in(unit(), size); }
  QString text(const ResidualSize& size, int digits = 2) const { return text_in(unit(), size, digits); }

 signals:
  void changed();

 private:
  void set(Unit chosen, bool has_pixels, bool knows_noise);

  Unit chosen_ = Unit::pixel;
  bool has_pixels_ = true, knows_noise_ = true;
};

}  // namespace handsight::app
