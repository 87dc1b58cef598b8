// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/export_texts.h"

#include <Eigen/Geometry>
#include <cmath>

#include "base/degrees.h"
#include "base/numbers.h"
#include "diagnosis/verdict/stand_in.h"
#include "document/curve_words.h"
#include "document/effect_words.h"
#include "effects/units.h"
#include "findings/explain_texts.h"
#include "widgets/base/number_text.h"
#include "words/core_words.h"
#include "workbench/model_effects.h"

namespace handsight::app {
namespace {

QString number(double value) {
  return std::isfinite(value) ? QString::fromStdString(format_number(value)) : QObject::tr("unknown");
}

/// By how much (m, rms over the observations) the effects move the hand before the cameras.
double moved_by_effects(const Fit& fit) {
  Problem without = fit.problem;
  without.terms.clear();
  hold_effects(without);
  place_observations(without);
  const Rigid mount = estimate(fit).mount_from_sensor;
  double squares = 0;
  for (std::size_t i = 0; i < without.observations.size(); ++i)
    squares += (sensor_from_tcp_at(fit.problem.observations[i], mount).translation -
                sensor_from_tcp_at(without.observations[i], mount).translation)
                   .squaredNorm();
  return without.observations.empty() ? 0 : std::sqrt(squares / static_cast<double>(without.observations.size()));
}

QString effects_text(const Session& session, const Fit& fit) {
  const std::vector<EffectTerm> terms = list_terms(fit);
  QStringList names;
  for (const std::string& id : list_ids(terms)) names << display_name(terms_of_effect(terms, id), session);
  return names.join(QObject::tr(", "));
}

}  // namespace

std::vector<MotionLine> effect_lines(const Session& session, const Fit& fit) {
  std::vector<MotionLine> lines;
  for (const FittedEffect& f : fit.effects) {
    const Effect& effect = term_effect(f.term);
    const std::string place = place_name(effect, f.term.place, session.robot);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      const ShownUnit unit = shown_unit(unit_at(effect, p, f.term.place, session.robot));
      const bool is_held = !(f.sigmas[p] > 0);
      const QStringList parts =
          widgets::with_sigma_text(unit.scale * f.term.values[p],
                                   is_held ? std::nullopt : std::optional(unit.scale * f.sigmas[p]))
              .split(QString(" ± "));
      const QString name = display_name({f.term}, session) +
                           (effect.parameters.size() > 1 ? ", " + number_title(effect.parameters[p].name) : QString());
      lines.push_back({name, parts.value(0), is_held ? QObject::tr("held") : parts.value(1), unit.unit});
    }
  }
  return lines;
}

const Rigid& tcp_from_body(const ModelVersion& model, std::size_t hand) {
  return hand < model.hands.size() ? model.hands[hand].tcp_from_body : model.fit->tcp_from_body;
}

const Calibration& calibration_of_hand(const ModelVersion& model, std::size_t hand) {
  const std::vector<Calibration>& all = model.calibration->sessions;
  return hand < all.size() ? all[hand] : *model.calibration;
}

std::vector<MotionLine> motion_lines(const ModelVersion& model, MotionForm form, std::size_t hand) {
  const Rigid& m = tcp_from_body(model, hand);
  const Vector6 sigma = hand < model.hands.size() ? model.hands[hand].sigma : origin_sigma(*model.fit);
  std::vector<MotionLine> lines;
  const auto split = [](const QString& name, double value, double s, const QString& unit) {
    if (!std::isfinite(s)) return MotionLine{name, QObject::tr("not determined"), {}, {}};
    const QStringList parts = widgets::with_sigma_text(value, s).split(QString(" ± "));
    return MotionLine{name, parts.value(0), parts.value(1), unit};
  };
  if (form == MotionForm::matrix) {
    const Matrix4 rows = matrix_from_rigid(m);
    for (int r = 0; r < 4; ++r) {
      QStringList cells;
      for (int c = 0; c < 4; ++c) cells << widgets::fixed_text(rows(r, c), 6).rightJustified(10);
      lines.push_back({QString(), cells.join("  "), QString(), r < 3 ? QObject::tr("m") : QString()});
    }
    return lines;
  }
  const char* axes[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) lines.push_back(split(axes[i], 1e3 * m.translation[i], 1e3 * sigma[i], "mm"));
  if (form == MotionForm::xyz_rpy) {
    const Vector3 rpy = degrees * rpy_from_rotation(m.rotation);
    const QString names[] = {QObject::tr("roll"), QObject::tr("pitch"), QObject::tr("yaw")};
    for (int i = 0; i < 3; ++i) lines.push_back(split(names[i], rpy[i], degrees * sigma[i + 3], QObject::tr("deg")));
    return lines;
  }
  const Eigen::Quaterniond q(m.rotation);
  const double values[] = {q.x(), q.y(), q.z(), q.w()};
  const char* names[] = {"qx", "qy", "qz", "qw"};
  for (int i = 0; i < 4; ++i) lines.push_back({names[i], widgets::fixed_text(values[i], 6), QString(), QString()});
  return lines;
}

QString motion_text(const Rigid& motion, MotionForm form) {
  const auto joined = [](std::initializer_list<double> values) {
    QStringList list;
    for (const double v : values) list << number(v);
    return list.join(' ');
  };
  const Vector3& t = motion.translation;
  if (form == MotionForm::xyz_rpy) {
    const Vector3 rpy = rpy_from_rotation(motion.rotation);
    return joined({t.x(), t.y(), t.z(), rpy.x(), rpy.y(), rpy.z()});
  }
  if (form == MotionForm::quaternion) {
    const Eigen::Quaterniond q(motion.rotation);
    return joined({t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()});
  }
  const Matrix4 m = matrix_from_rigid(motion);
  QStringList rows;
  for (int r = 0; r < 4; ++r) rows << joined({m(r, 0), m(r, 1), m(r, 2), m(r, 3)});
  return rows.join('\n');
}

namespace {

/// What is asked for with the camera on the hand: where it sits.
QString mount_text(const Session& session, const Fit& fit) {
  if (session.is_touch())
    return QObject::tr("Right only together with where the fixtures stand, which was estimated with it.");
  const Rigid& mount = estimate(fit).mount_from_sensor;
  const auto three = [](const Vector3& x, int decimals) {
    return QStringList{widgets::fixed_text(x.x(), decimals), widgets::fixed_text(x.y(), decimals),
                       widgets::fixed_text(x.z(), decimals)}
        .join(' ');
  };
  return (session.rig ? QObject::tr("Right only together with the camera mount that was estimated with it: on %1 at %2 "
                                    "mm, rpy %3 deg (mount_from_sensor in the XML).")
          : session.pose_sensor
              ? QObject::tr("Right only together with the mount of the sensor that was estimated with it: on %1 at %2 "
                            "mm, rpy %3 deg (mount_from_sensor in the XML).")
              : QObject::tr("Right only together with the mount of the tracker that was estimated with it: on %1 "
                            "at %2 mm, rpy %3 deg (mount_from_sensor in the XML)."))
      .arg(QString::fromStdString(session.mount.link), three(1e3 * mount.translation, 3),
           three(180 / M_PI * rpy_from_rotation(mount.rotation), 4));
}

/// What belongs to TCP->Body, and what it is worth alone.
QString together_text(const Session& session, const Fit& fit) {
  constexpr double nothing = 1e-7;  // m: what effects move that sit in the cameras or in the target
  const double moved = moved_by_effects(fit);
  if (moved < nothing)
    return QObject::tr("Estimated together with: %1. The hand is not moved by it: TCP→Body holds without it, too.")
        .arg(effects_text(session, fit));
  return QObject::tr("Right only together with: %1. Used alone, TCP→Body misses by %2 mm on these poses.")
      .arg(effects_text(session, fit), widgets::short_text(1e3 * moved));
}

}  // namespace

ExportRemark verdict_remark(const widgets::SessionVerdict& verdict, const ModelVersion& model) {
  using widgets::SessionState;
  const auto ratio = error_and_noise(model).ratio();
  switch (verdict.state) {
    case SessionState::adequate:
    case SessionState::repeatability:  // nothing is to be mended before it is used, but for what stands in for another
                                       // cause
      return {verdict.sentence, !stand_ins(*model.fit).empty()};
    case SessionState::waiting:
    case SessionState::looking:
      return {verdict.sentence, !ratio || *ratio >= most_beside_repeatability ||
                                    model.fit->covariance_kind == CovarianceKind::repeatability};
    default:
      return {verdict.sentence, true};
  }
}

std::vector<ExportRemark> export_remarks(const Document& document, const ModelVersion& model) {
  std::vector<ExportRemark> remarks;
  if (!model.fit->converged())
    remarks.push_back({QObject::tr("The fit has not converged: more observations, or look at Inspect."), true});
  if (model.fit->covariance_kind == CovarianceKind::repeatability)
    remarks.push_back(
        {QObject::tr("The uncertainties come from how the observations differ, not from the noise alone: they hold for "
                     "poses like these."),
         false});
  if (!model.fit->effects.empty()) remarks.push_back({together_text(document.session(), *model.fit), false});
  if (!model.wrong_points.empty()) remarks.push_back({wrong_points_text(model, 3), false});
  if (document.session().mount.estimate) remarks.push_back({mount_text(document.session(), *model.fit), false});
  for (const Message& note : model.fit->notes) remarks.push_back({translated(note), true});
  return remarks;
}

}  // namespace handsight::app
