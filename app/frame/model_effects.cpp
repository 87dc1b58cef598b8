// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame/model_effects.h"

#include <algorithm>

#include "document/counted.h"
#include "document/effect_words.h"
#include "widgets/number_text.h"

namespace handsight::app {
namespace {

constexpr double degrees = 57.29577951308232;

/// x y z in mm, then roll pitch yaw in degrees.
std::vector<widgets::ModelParameter> six_parameters(const Rigid& motion, const Vector6& sigma) {
  const char* names[] = {"x", "y", "z", "roll", "pitch", "yaw"};
  const Vector3 rpy = rpy_from_rotation(motion.rotation);
  std::vector<widgets::ModelParameter> list;
  for (int i = 0; i < 6; ++i) {
    const double scale = i < 3 ? 1e3 : degrees;
    widgets::ModelParameter p{.name = names[i], .unit = i < 3 ? "mm" : "deg"};
    p.value = scale * (i < 3 ? motion.translation[i] : rpy[i - 3]);
    p.sigma = scale * sigma[i];
    list.push_back(p);
  }
  return list;
}

/// An effect of the catalogue, in the model or not.
widgets::ModelEffect catalogue_effect(const Effect& e, const Document& document, const Chain& chain,
                                      const Diagnosis* diagnosis) {
  const Session& session = document.session();
  const ModelSettings& settings = document.settings();
  widgets::ModelEffect shown{.id = QString::fromStdString(e.id), .title = QString::fromStdString(e.title)};
  shown.help = QString::fromStdString(e.cause + "\n\n" + e.visibility);
  std::vector<EffectTerm> terms = terms_of_effect(settings.held, e.id);
  shown.is_held = !terms.empty();
  for (const EffectTerm& term : terms_of_effect(settings.estimated, e.id)) terms.push_back(term);
  shown.is_in_model = !terms.empty();
  if (shown.is_in_model) {
    shown.can_hold = true;
    std::vector<std::vector<double>> sigmas;
    const ModelVersionPointer model = document.shown_model();
    if (model && model->fit && !shown.is_held)
      for (EffectTerm& term : terms)
        for (const FittedEffect& fitted : model->fit->effects)
          if (fitted.term.id == term.id && fitted.term.joint == term.joint) {
            for (std::size_t p = 0; p < term.values.size(); ++p)
              if (is_free(e, term, p)) term.values[p] = fitted.term.values[p];  // those that are held may be newer
            sigmas.push_back(fitted.sigmas);
          }
    if (sigmas.size() != terms.size()) sigmas.clear();
    shown.parameters = effect_parameters(session, terms, sigmas);
    for (widgets::ModelParameter& p : shown.parameters) {
      p.can_hold = !p.is_choice;
      p.is_held = !p.is_choice && (p.is_held || shown.is_held);
    }
    const bool is_beyond = std::any_of(shown.parameters.begin(), shown.parameters.end(), [](const auto& p) {
      return p.value && p.plausible && std::abs(*p.value) > 3 * *p.plausible;
    });
    if (is_beyond) {
      shown.note = QObject::tr("More than three times what is plausible. Probably another cause.");
      shown.note_is_warning = true;
    }
    return shown;
  }
  if (effect_places(e, chain).empty()) {
    shown.can_change = false;
    shown.note = e.scope == EffectScope::mimic_joint ? QObject::tr("No joint of this robot follows another.")
                                                     : QObject::tr("It has no place in this session.");
  } else if (diagnosis &&
             std::find(diagnosis->invisible.begin(), diagnosis->invisible.end(), e.id) != diagnosis->invisible.end()) {
    shown.note = QObject::tr("Cannot be seen on these poses.");
  }
  return shown;
}

}  // namespace

std::vector<widgets::ModelParameter> effect_parameters(const Session& session, const std::vector<EffectTerm>& terms,
                                                       const std::vector<std::vector<double>>& sigmas) {
  std::vector<widgets::ModelParameter> list;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const Effect& effect = effect_of(terms[t]);
    const QString of = QString::fromStdString(place_name(effect, terms[t].joint, session.robot));
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      const EffectParameter& number = effect.parameters[p];
      const ShownUnit unit = shown_unit(number.unit);
      widgets::ModelParameter row{.of = of, .name = QString::fromStdString(number.name), .unit = unit.unit};
      row.value = unit.scale * terms[t].values[p];
      row.is_choice = number.is_choice;
      row.is_held = !number.is_choice && !is_free(effect, terms[t], p);
      if (!number.is_choice) row.plausible = unit.scale * number.sigma;
      if (t < sigmas.size() && sigmas[t][p] > 0) row.sigma = unit.scale * sigmas[t][p];
      list.push_back(row);
    }
  }
  return list;
}

QString wrong_points_text(const ModelVersion& model, std::size_t most_named) {
  const auto& wrong = model.wrong_points;
  if (wrong.empty()) return {};
  const bool pixels = model.inspection->in_pixels;
  QStringList named;
  for (std::size_t i = 0; i < std::min(most_named, wrong.size()); ++i) {
    const WrongPoint& w = wrong[i];
    const auto& rig = model.fit->problem.rig;
    const QString side = w.camera != by_tracker && rig
                             ? QObject::tr(", %1 image").arg(QString::fromStdString(rig->at(w.camera).name))
                             : QString();
    named << QObject::tr("observation %1, marker %2%3, %4 off")
                 .arg(w.id)
                 .arg(w.marker)
                 .arg(side, widgets::with_unit_text((pixels ? 1 : 1e3) * w.distance,
                                                    pixels ? QObject::tr("px") : QObject::tr("mm")));
  }
  if (named.size() < static_cast<qsizetype>(wrong.size())) named << QObject::tr("and others");
  return QObject::tr("%1 left out of the fit: %2.")
      .arg(counted(static_cast<qint64>(wrong.size()), "wrong point", "wrong points"), named.join("; "));
}

std::vector<widgets::ModelEffect> model_effects(const Document& document, const Diagnosis* diagnosis) {
  const ModelVersionPointer model = document.shown_model();
  if (!model || !model->fit) return {};
  const Fit& fit = *model->fit;
  std::vector<widgets::ModelEffect> list;
  widgets::ModelEffect body{.id = "tcp_from_body", .title = QObject::tr("TCP→Body"), .is_in_model = true};
  body.is_permanent = true;
  body.help = QObject::tr(
      "Where the marker body sits on the hand. Sigma is that of the body's origin, and of the "
      "rotations about the TCP's axes.");
  body.parameters = six_parameters(fit.tcp_from_body, origin_sigma(fit));
  if (fit.covariance_kind == CovarianceKind::scatter) {
    body.note =
        QObject::tr("Sigmas from how the observations differ: the model does not agree with them to the noise.");
    body.note_is_warning = true;
  }
  if (!model->wrong_points.empty()) {
    body.note += (body.note.isEmpty() ? QString() : QString(" ")) + wrong_points_text(*model, 2);
    body.help += "\n\n" + wrong_points_text(*model, 40);
  }
  list.push_back(std::move(body));
  if (document.session().mount.estimate) {
    widgets::ModelEffect mount{.id = "mount", .title = QObject::tr("Camera mount"), .is_in_model = true};
    mount.is_permanent = true;
    mount.help = QObject::tr("Where the cameras sit on %1, estimated with the rest.")
                     .arg(QString::fromStdString(document.session().mount.link));
    mount.parameters =
        six_parameters(estimate(fit).mount_from_sensor,
                       fit.parameter_covariance.block<6, 6>(fit.problem.mount_column(), fit.problem.mount_column())
                           .diagonal()
                           .cwiseMax(0)
                           .cwiseSqrt());
    list.push_back(std::move(mount));
  }
  const Chain chain = chain_of(document.session());
  std::vector<widgets::ModelEffect> out;
  for (const Effect& e : catalogue()) {
    widgets::ModelEffect shown = catalogue_effect(e, document, chain, diagnosis);
    (shown.is_in_model ? list : out).push_back(std::move(shown));
  }
  list.insert(list.end(), out.begin(), out.end());
  return list;
}

}  // namespace handsight::app
