// SPDX-License-Identifier: GPL-3.0-or-later
#include "workbench/display_units.h"

#include <algorithm>

#include "widgets/base/number_text.h"
#include "workbench/preferences.h"

namespace handsight::app {
namespace {

using widgets::SizeUnit;

const QString preference_name = QStringLiteral("unit");

QString find_word(SizeUnit unit) {
  return unit == SizeUnit::pixel ? QStringLiteral("px") : unit == SizeUnit::millimetre ? "mm" : "sigma";
}

std::optional<double> over(std::optional<double> value, std::optional<double> noise) {
  return value && noise && *noise > 0 ? std::optional(*value / *noise) : std::nullopt;
}

}  // namespace

std::optional<double> ResidualSize::in(SizeUnit unit) const {
  return unit == SizeUnit::pixel ? pixel : unit == SizeUnit::millimetre ? millimetre : sigma;
}

ResidualSize measure_size(const ErrorSummary& e, bool in_pixels, std::optional<double> noise) {
  return {.pixel = in_pixels ? e.rms_pixel : std::nullopt,
          .millimetre = scaled(in_pixels ? e.hand_m : e.rms_m, 1e3),
          .sigma = in_pixels ? over(e.rms_pixel, noise) : over(scaled(e.rms_m, 1 / as_reported(1, false)), noise)};
}

ResidualSize measure_size(const InspectionRow& row) {
  const bool in_pixels = std::any_of(row.markers.begin(), row.markers.end(), [](const auto& m) { return m.is_seen(); });
  return {.pixel = in_pixels ? row.rms : std::nullopt,
          .millimetre = scaled(in_pixels ? row.hand_m : row.rms_m, 1e3),
          .sigma = row.ratio};
}

ResidualSize measure_size(const MarkerResidual& marker, const Inspection& all) {
  ResidualSize size;
  double squares = 0;
  int rows = 0;
  for (const ImageCorner& c : marker.corners) {
    if (!c.is_compared()) continue;
    const double length = (*c.measured - *c.predicted).norm();
    size.pixel = std::max(size.pixel.value_or(0), length);
    squares += length * length;
    rows += 2;
  }
  if (marker.measured_in_sensor) {
    const double length = (*marker.measured_in_sensor - marker.predicted_in_sensor).norm();
    size.millimetre = 1e3 * length;
    if (rows == 0) squares = length * length, rows = 3;
  }
  if (rows > 0) size.sigma = over(std::sqrt(squares / rows), all.noise);
  return size;
}

std::optional<Vector2> corner_in(SizeUnit unit, const MarkerResidual& marker, int camera, const Rig& rig,
                                 std::optional<double> noise) {
  if (static_cast<std::size_t>(camera) >= marker.corners.size()) return std::nullopt;
  const ImageCorner& corner = marker.corners[static_cast<std::size_t>(camera)];
  if (!corner.is_compared()) return std::nullopt;
  const Vector2 residual = *corner.measured - *corner.predicted;
  if (unit == SizeUnit::pixel) return residual;
  if (unit == SizeUnit::sigma) return noise && *noise > 0 ? std::optional<Vector2>(residual / *noise) : std::nullopt;
  const Camera& seen_by = rig.at(camera).camera;
  const Vector3 in_camera = rig.at(camera).camera_from_first * marker.predicted_in_sensor;
  return 1e3 * in_camera.z() * residual.cwiseQuotient(Vector2(seen_by.fx, seen_by.fy));
}

ResidualSize size_of_corner(const MarkerResidual& marker, int camera, const Rig& rig, std::optional<double> noise) {
  const auto length = [&](SizeUnit unit) {
    const auto v = corner_in(unit, marker, camera, rig, noise);
    return v ? std::optional(v->norm()) : std::nullopt;
  };
  // Sigma is of a coordinate, of which a corner has two.
  return {length(SizeUnit::pixel), length(SizeUnit::millimetre), scaled(length(SizeUnit::sigma), std::sqrt(0.5))};
}

VersionSizes list_sizes(const FitReport& report, bool in_pixels, std::optional<double> own_noise,
                        std::optional<double> noise) {
  VersionSizes sizes;
  sizes.fitted = measure_size(report.fitted, in_pixels, noise);
  sizes.held_out = measure_size(report.held_out, in_pixels, noise);
  sizes.noise = {.pixel = in_pixels ? own_noise : std::nullopt,
                 .millimetre = scaled(in_pixels ? report.noise_of_hand_m : report.rms_of_noise_m, 1e3),
                 .sigma = over(own_noise, noise)};
  // A reading is one coordinate, a point three: what noise alone makes of them together is the report's.
  if (!in_pixels && report.rms_of_noise_m && *report.rms_of_noise_m > 0)
    for (ResidualSize* size : {&sizes.fitted, &sizes.held_out})
      if (size->millimetre && own_noise)
        size->sigma = over(1e-3 * *size->millimetre * *own_noise / *report.rms_of_noise_m, noise);
  return sizes;
}

VersionSizes list_sizes(const ModelVersion& version, std::optional<double> noise) {
  if (!version.fit) return {};
  VersionSizes sizes = list_sizes(*version.report, version.inspection->in_pixels, version.fit->noise, noise);
  if (version.report->used < fewest_that_tell) sizes.fitted = sizes.held_out = {};
  return sizes;
}

ResidualSize size_of_error(double error, bool in_pixels, std::optional<double> noise) {
  ErrorSummary summary;
  (in_pixels ? summary.rms_pixel : summary.rms_m) = error;
  return measure_size(summary, in_pixels, noise);
}

widgets::ShownSize shown_in(SizeUnit unit, const ResidualSize& size) {
  if (const auto value = size.in(unit)) return {value, unit};
  for (const SizeUnit own : {SizeUnit::pixel, SizeUnit::millimetre})
    if (const auto value = size.in(own)) return {value, own};
  return {std::nullopt, unit};
}

QString text_in(SizeUnit unit, const ResidualSize& size, int digits) {
  return widgets::size_text(shown_in(unit, size), digits);
}

std::optional<double> noise_in(SizeUnit unit, const Inspection& all) {
  if (!all.noise || *all.noise <= 0) return std::nullopt;
  if (unit == SizeUnit::millimetre) return scaled(all.noise_m, 1e3);
  return unit == SizeUnit::sigma ? std::optional(1.0) : all.noise;
}

DisplayUnits::DisplayUnits(QObject* parent) : QObject(parent) {
  const QString chosen = preference(preference_name);
  for (const Unit unit : all)
    if (find_word(unit) == chosen) chosen_ = unit;
}

QString DisplayUnits::why_not(Unit unit) const {
  if (unit == Unit::pixel && !has_pixels_) return tr("A tracker or a probe measures in space, not in images.");
  if (unit == Unit::sigma && !knows_noise_) return tr("The noise is not known, so nothing can be told in units of it.");
  return {};
}

DisplayUnits::Unit DisplayUnits::unit() const {
  if (has(chosen_)) return chosen_;
  return has_pixels_ ? Unit::pixel : Unit::millimetre;
}

void DisplayUnits::set(Unit chosen, bool has_pixels, bool knows_noise) {
  const Unit before = unit();
  const bool is_other = has_pixels != has_pixels_ || knows_noise != knows_noise_;
  chosen_ = chosen;
  has_pixels_ = has_pixels;
  knows_noise_ = knows_noise;
  if (unit() != before || is_other) emit changed();
}

void DisplayUnits::choose(Unit chosen) {
  remember_preference(preference_name, find_word(chosen));
  set(chosen, has_pixels_, knows_noise_);
}

void DisplayUnits::next() {
  const auto at = static_cast<std::size_t>(unit());
  for (std::size_t i = 1; i <= all.size(); ++i)
    if (const Unit unit = all[(at + i) % all.size()]; has(unit)) return choose(unit);
}

void DisplayUnits::set_session(bool has_pixels, bool knows_noise) { set(chosen_, has_pixels, knows_noise); }

}  // namespace handsight::app
