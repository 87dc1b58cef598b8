// SPDX-License-Identifier: GPL-3.0-or-later
#include "findings/inspection_rows.h"

#include <Eigen/Dense>

#include "base/degrees.h"
#include "document/effect_words.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "words/core_words.h"
#include "workbench/display_units.h"
#include "workbench/observation_views.h"
#include "workbench/touch_views.h"

namespace handsight::app {
namespace {

/// The reason that is shown: the decision's own, else whose fault it is where the observation is odd.
QString reason_of(const Observation& o, const InspectionRow* row, bool is_touch) {
  if (!o.reason.empty()) return translated(o.reason);
  if (!row || !row->outlier) return {};
  if (is_touch) return QObject::tr("Far off along what was read: touched or read wrongly?");
  return translated(row->what_would_mend);
}

}  // namespace

std::vector<widgets::ObservationRow> table_rows(const Workbench& workbench) {
  std::vector<widgets::ObservationRow> list;
  const auto cells = workbench.cells();
  const auto& observations = workbench.document.session().observations;
  const bool pixels = !workbench.document.session().is_tracker();
  const auto& rig = workbench.document.session().rig;
  const bool are_touches = workbench.document.session().is_touch();
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const Observation& o = observations[i];
    const InspectionRow* row = workbench.row(o.id);
    if (!workbench.sessions.is_observation_shown(o.id)) continue;
    widgets::ObservationRow r{.id = o.id, .state = cells[i].state};
    r.session = workbench.sessions.find_session(o.id);
    if (row) {
      if (pixels) r.rms_pixel = row->rms;
      r.rms_mm = scaled(pixels ? row->hand_m : row->rms_m, 1e3);
      r.angle_deg = scaled(row->angle, degrees);
      r.rms_over_sigma = row->ratio;
      r.coordinates = row->coordinates;
      if (row->worst_marker >= 0) {
        r.worst = QString::number(row->worst_marker);
        if (rig && rig->count() > 1 && row->worst_camera >= 0) r.worst += ", " + camera_name(*rig, row->worst_camera);
      }
      if (workbench.inspection()->noise && *workbench.inspection()->noise > 0)
        r.worst_over_sigma = row->worst_size / std::sqrt(pixels ? 2.0 : 3.0) / *workbench.inspection()->noise;
      if (are_touches) r.worst_over_sigma = row->ratio;
    }
    const Fixture* fixture = touched_fixture(workbench.document.session(), o);
    if (fixture && are_touches) r.worst = QString::fromStdString(fixture->id);
    r.is_odd = (row && row->outlier) || o.decision == Decision::rejected;
    r.reason = reason_of(o, row, fixture != nullptr);
    list.push_back(std::move(r));
  }
  return list;
}

std::vector<widgets::MapPoint> map_points(const Workbench& workbench) {
  std::vector<widgets::MapPoint> points;
  const Inspection* all = workbench.inspection();
  const auto& rig = workbench.document.session().rig;
  if (!all || !rig) return points;
  for (const InspectionRow& row : all->rows) {
    if (!row.is_used || !workbench.sessions.is_observation_shown(row.id)) continue;
    for (const MarkerResidual& m : row.markers)
      for (int camera = 0; camera < rig->count(); ++camera) {
        const auto residual = corner_in(workbench.units.unit(), m, camera, *rig, all->noise);
        if (!residual) continue;
        points.push_back({.observation = row.id,
                          .marker = m.marker,
                          .camera = camera,
                          .position = *m.corners[static_cast<std::size_t>(camera)].measured,
                          .residual = *residual,
                          .rms_over_sigma = size_of_corner(m, camera, *rig, all->noise).sigma});
      }
  }
  return points;
}

std::optional<widgets::ErrorAttribution> shown_attribution(const Workbench& workbench, const InspectionRow& row) {
  const bool of_tracker = workbench.document.session().is_tracker();
  if (workbench.document.session().is_touch()) return std::nullopt;
  const ErrorAttribution& own = row.attribution;
  switch (own.cause) {
    case ErrorCause::cameras:
      return widgets::ErrorAttribution{1, 0, 0, of_tracker};
    case ErrorCause::body:
      return widgets::ErrorAttribution{own.cameras, own.body + own.robot, 0, of_tracker};
    case ErrorCause::robot: {
      const ErrorAttribution b = workbench.attribute_error(row);
      return widgets::ErrorAttribution{b.cameras, b.body, b.robot, of_tracker};
    }
    default:
      return std::nullopt;
  }
}

namespace {

/// What the hand's place alone would put on the robot, and the session's cause puts elsewhere.
QString in_the_light_of_the_cause(const Workbench& workbench, ErrorCause at_fault) {
  const StoryCause& cause = workbench.story().causes.front();
  const QString name = effect_text(cause.id, cause.where);
  const bool in_pixels = workbench.document.session().rig.has_value();
  return (at_fault == ErrorCause::body
              ? QObject::tr("The marker body, as in the whole session: what is missing (%1) explains most of it. ")
          : in_pixels ? QObject::tr("The cameras, as in the whole session: what is missing (%1) explains most of it. ")
                      : QObject::tr("The tracker, as in the whole session: what is missing (%1) explains most of it. "))
      .arg(name);
}

/// Of what agrees, or is off without anybody whose fault it can be said to be.
QString without_blame(const InspectionRow& row) {
  if (*row.ratio < widgets::noise_limit(row.coordinates))
    return QObject::tr("Agrees with the model down to the noise. ");
  return QObject::tr("It is %1 times the noise from where the model has it. ").arg(widgets::short_text(*row.ratio));
}

/// A touch says how far off it is, and no more.
QString touch_sentence(const InspectionRow* row, const Observation& o) {
  if (o.sightings.empty()) return QObject::tr("Nothing was touched in this observation.");
  if (!row) return QObject::tr("Waits for a fit.");
  if (!row->ratio) return QObject::tr("The noise is not known, so nothing can be said about this observation.");
  if (*row->ratio < widgets::noise_limit(row->coordinates))
    return QObject::tr("Agrees with the model down to the noise. ").trimmed();
  return QObject::tr("The reading is %1 times the noise from where the model has the tip.")
      .arg(widgets::short_text(*row->ratio));
}

}  // namespace

QString attribution_sentence(const Workbench& workbench, const InspectionRow* row, const Observation* observation) {
  const bool in_pixels = workbench.document.session().rig.has_value();
  if (!observation) return QObject::tr("Choose an observation in the strip, a plot or the 3D view.");
  if (workbench.document.session().is_touch()) return touch_sentence(row, *observation);
  if (!row) {
    if (observation->sightings.empty() && observation->decision == Decision::rejected)
      return QObject::tr("Its markers were not found, at a second look neither: %1")
          .arg(translated(observation->reason));
    return observation->sightings.empty() ? QObject::tr("No marker is labelled in this observation.")
                                          : QObject::tr("Waits for a fit.");
  }
  if (!row->ratio) return QObject::tr("The noise is not known, so nothing can be said about this observation.");
  QString text;
  const ErrorCause cause = workbench.attribute_error(*row).cause;
  switch (row->attribution.cause) {
    case ErrorCause::cameras:
      text = in_pixels ? QObject::tr("The cameras: the two images do not agree with each other. ")
                       : QObject::tr("The tracker: its points do not agree with each other. ");
      break;
    case ErrorCause::body:
      text = QObject::tr("The marker body: the markers are not where they sit on the hand. ");
      break;
    case ErrorCause::robot:
      text = cause == ErrorCause::robot ? QObject::tr("The robot: the hand is not where the joints say. ")
                                        : in_the_light_of_the_cause(workbench, cause);
      break;
    default:
      text = without_blame(*row);
  }
  if (!row->what_would_mend.empty())
    text += QObject::tr("What would make it right: %1").arg(within_sentence(translated(row->what_would_mend)));
  if (row->smallest_visible && row->attribution.cause != ErrorCause::robot)
    text = text.trimmed() + ' ' +
           QObject::tr("An error of one corner under %1 here could not be seen.")
               .arg(in_pixels ? QObject::tr("%1 px").arg(widgets::fixed_text(*row->smallest_visible, 1))
                              : QObject::tr("%1 mm").arg(widgets::fixed_text(1e3 * *row->smallest_visible, 1)));
  if (row->at_second_look) text += QObject::tr(" (Markers from a second look with wider gates; not part of the fit.)");
  return text;
}

QString exclusion_sentence(const ModelVersion& now, const ModelVersion& then, std::size_t excluded, std::size_t of,
                           const DisplayUnits& units) {
  QString text = QObject::tr("%1 of %2.").arg(excluded).arg(of);
  if (!then.fit) return text + " " + then.refusal;
  if (!now.fit) return text;
  const widgets::ShownSize a = units.shown(list_sizes(now, now.fit->noise).error());
  const widgets::ShownSize b = units.shown(list_sizes(then, now.fit->noise).error());
  if (a.value && b.value && a.unit == b.unit)
    text += QObject::tr(" Error %1 → %2").arg(widgets::short_text(a.value, 3), widgets::size_text(b, 3));
  const Vector6 xi = small_motion_between(now.fit->tcp_from_body, then.fit->tcp_from_body);
  const Eigen::LDLT<Matrix6> covariance(now.fit->covariance);
  const double sigmas = std::sqrt(std::max(0.0, xi.dot(covariance.solve(xi))) / 6);
  if (std::isfinite(sigmas)) text += QObject::tr("; TCP→Body moves %1 sigma").arg(widgets::short_text(sigmas));
  return text + ".";
}

}  // namespace handsight::app
