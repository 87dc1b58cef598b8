// SPDX-License-Identifier: GPL-3.0-or-later
#include "workbench/touch_views.h"

#include <algorithm>

#include "session/fixtures/fixture_kind.h"
#include "session/touch_xml.h"
#include "widgets/base/number_text.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

const Fixture* fixture_of(const Session& s, int part) {
  if (part < 0 || static_cast<std::size_t>(part) >= s.parts.size()) return nullptr;
  const int fixture = s.parts[static_cast<std::size_t>(part)].fixture;
  return fixture < 0 ? nullptr : &s.fixtures[static_cast<std::size_t>(fixture)];
}

QString what_was_touched(const Fixture& fixture, const Sighting& s) {
  const double value = touch_value(s);
  return translated(fixture.kind->touched(fixture.id, widgets::fixed_text(1e3 * value, 3).toStdString(), value == 0));
}

}  // namespace

const Fixture* touched_fixture(const Session& session, const Observation& observation) {
  return fixture_of(session, observation.part);
}

QString touched_text(const Session& session, const Observation& o, const InspectionRow* row,
                     const DisplayUnits& units) {
  const Fixture* fixture = touched_fixture(session, o);
  if (!fixture || o.sightings.empty() || !o.sightings.front().point)
    return QObject::tr("Nothing was touched in this observation.");
  QStringList lines{what_was_touched(*fixture, o.sightings.front())};
  if (session.marker_count > 1) lines << QObject::tr("By tip %1.").arg(o.sightings.front().marker);
  if (row && row->rms)
    lines << (measures_place(*fixture->kind) ? QObject::tr("Off by %1 in space.")
                                             : QObject::tr("Off by %1 along what was read."))
                 .arg(units.text(measure_size(*row)));
  return lines.join('\n');
}

ResidualSize as_read(ResidualSize predicted, const ModelVersion& model) {
  if (!model.fit || !model.fit->problem.source || !model.fit->problem.source->chain.is_touch) return predicted;
  const double noise = as_reported(model.fit->noise.value_or(0), false);
  if (predicted.millimetre && model.report->rms_of_noise_m && noise > 0)
    *predicted.millimetre *= *model.report->rms_of_noise_m / noise;
  return predicted;
}

TouchResidual touch_residual(const InspectionRow& row) {
  TouchResidual residual;
  if (row.markers.empty()) return residual;
  residual.tip = row.root_from_sensor * row.markers.front().predicted_in_sensor;
  for (const MarkerResidual& m : row.markers)  // of an edge two, across each other
    if (m.measured_in_sensor)
      residual.off += row.root_from_sensor.rotation * Vector3(*m.measured_in_sensor - m.predicted_in_sensor);
  return residual;
}

widgets::SceneArrow touch_arrow(const InspectionRow& row) {
  const TouchResidual residual = touch_residual(row);
  return {.observation = row.id,
          .from = residual.tip,
          .residual = residual.off,
          .rms_over_sigma = row.ratio,
          .coordinates = row.coordinates};
}

namespace {

/// Between which corners of its frame (m) the tip was at a fixture, as the model has it; of one that was not touched,
/// or before there is a model, a hand's breadth round its origin.
struct Extent {
  Vector3 low{-0.1, -0.1, -0.1}, high{0.1, 0.1, 0.1};
  bool is_known = false;

  void add(const Vector3& tip) {
    low = is_known ? Vector3(low.cwiseMin(tip)) : tip;
    high = is_known ? Vector3(high.cwiseMax(tip)) : tip;
    is_known = true;
  }
};

std::vector<Extent> extents_of(const Session& s, const Inspection* inspection) {
  std::vector<Extent> extents(s.parts.size());
  if (!inspection) return extents;
  for (const InspectionRow& row : inspection->rows) {
    const auto at = static_cast<std::size_t>(row.index);  // of a session that may have grown or shrunk since
    const int part = at < s.observations.size() ? s.observations[at].part : -1;
    if (fixture_of(s, part) && !row.markers.empty())
      extents[static_cast<std::size_t>(part)].add(row.markers.front().predicted_in_sensor);
  }
  return extents;
}

/// `tip` in the fixture's frame where it is the one that is touched.
void set_extent(FixtureShape shape, const Extent& extent, const std::optional<Vector3>& tip,
                widgets::SceneFixture& fixture) {
  constexpr double margin = 0.04, arrow = 0.1;  // m
  const Vector3 middle = (extent.low + extent.high) / 2;
  fixture.shape = shape;
  switch (shape) {
    case FixtureShape::patch:
      fixture.from = extent.low - Vector3(margin, margin, extent.low.z());
      fixture.to = extent.high + Vector3(margin, margin, -extent.high.z());
      return;
    case FixtureShape::ring:
      return;
    case FixtureShape::rod:
      fixture.from = {0, 0, extent.low.z() - margin};
      fixture.to = {0, 0, extent.high.z() + margin};
      return;
    case FixtureShape::arrow: {  // along its axis, where it is touched: across the axis it has no place of its own
      const Vector3 at = tip.value_or(middle);
      fixture.from = {at.x(), at.y(), -arrow};
      fixture.to = {at.x(), at.y(), 0};
      return;
    }
    case FixtureShape::bar:
      fixture.to = tip.value_or(extent.is_known ? middle : Vector3(0, 0, arrow));
      return;
  }
}

}  // namespace

std::vector<widgets::SceneFixture> scene_fixtures(const Document& document, const Observation& shown,
                                                  const std::vector<Rigid>& root_from_link) {
  const Session& s = document.session();
  const ModelVersionPointer model = document.shown_model();
  const bool has_fit = model && model->fit;
  const Inspection* inspection = has_fit ? model->inspection.get() : nullptr;
  std::vector<widgets::SceneFixture> fixtures;
  if (s.fixtures.empty()) return fixtures;
  const std::vector<Extent> extents = extents_of(s, inspection);
  for (std::size_t p = 0; p < s.parts.size(); ++p) {
    const Fixture* of = fixture_of(s, static_cast<int>(p));
    const Mount& mount = find_mount(s, s.parts[p].mount);
    const int link = find_link(s.robot, mount.link);
    if (!of || link < 0 || (!has_fit && !mount.known)) continue;
    widgets::SceneFixture& f = fixtures.emplace_back();
    f.name = QString::fromStdString(s.parts[p].title);
    f.root_from_fixture = root_from_link[static_cast<std::size_t>(link)] *
                          (has_fit ? estimate(*model->fit).mount(s.parts[p].mount) : mount.mount_from_sensor);
    f.is_touched = shown.part == static_cast<int>(p);
    const int index = document.find_index(shown.id);
    std::optional<Vector3> tip;
    if (f.is_touched && inspection && index >= 0 && static_cast<std::size_t>(index) < inspection->rows.size())
      if (const auto& markers = inspection->rows[static_cast<std::size_t>(index)].markers; !markers.empty())
        tip = markers.front().predicted_in_sensor;
    set_extent(of->kind->shape, extents[p], tip, f);
  }
  return fixtures;
}

}  // namespace handsight::app
