// SPDX-License-Identifier: GPL-3.0-or-later
#include "workbench/model_effects.h"

#include <algorithm>
#include <array>
#include <set>

#include "base/degrees.h"
#include "diagnosis/verdict/stand_in.h"
#include "document/curve_words.h"
#include "document/effect_words.h"
#include "effects/units.h"
#include "session/fixtures/fixture_kind.h"
#include "widgets/base/number_text.h"
#include "words/core_words.h"
#include "words/counted.h"
#include "workbench/session_parts.h"

namespace handsight::app {
namespace {

/// x y z in mm, then roll pitch yaw in degrees.
std::vector<widgets::ModelParameter> six_parameters(const Rigid& motion, const Vector6& sigma) {
  const QString names[] = {"x", "y", "z", QObject::tr("roll"), QObject::tr("pitch"), QObject::tr("yaw")};
  const Vector3 rpy = rpy_from_rotation(motion.rotation);
  std::vector<widgets::ModelParameter> list;
  for (int i = 0; i < 6; ++i) {
    const double scale = i < 3 ? 1e3 : degrees;
    widgets::ModelParameter p{.name = names[i], .unit = i < 3 ? "mm" : QObject::tr("deg")};
    p.value = scale * (i < 3 ? motion.translation[i] : rpy[i - 3]);
    p.sigma = scale * sigma[i];
    list.push_back(p);
  }
  return list;
}

/// Where in the machine an effect acts, by what it moves.
QString group_of(const Effect& e, const Chain& chain) {
  const std::vector<int> places = effect_places(e, chain);
  ObservationState c = states_at(chain, Eigen::VectorXd::Constant(static_cast<Eigen::Index>(chain.joints.size()), 0.3));
  c.velocity.setOnes();
  c.approach.setOnes();
  std::vector<double> values;
  for (const EffectParameter& p : e.parameters)
    values.push_back(!p.is_choice ? 1e-3 : p.choices.empty() ? 0 : p.choices.front());
  Sites s = unmoved_sites(chain);
  const int place = places.empty() ? (e.scope == EffectScope::session ? -1 : 0) : places.front();
  const bool has_site =
      e.scope == EffectScope::tag ||
      place < static_cast<int>(e.scope == EffectScope::marker ? s.markers.size() : s.robot.joints.size());
  if (has_site) e.move(c, place, values, s);
  const auto any = [&](auto&& is_moved) { return std::any_of(s.robot.joints.begin(), s.robot.joints.end(), is_moved); };
  if (e.definition) return QObject::tr("Own");
  if (e.id.starts_with("target_") || e.scope == EffectScope::tag)
    return QObject::tr("Target");  // of a pose sensor its size moves what is seen
  const bool moves_cameras =
      std::any_of(s.cameras.begin(), s.cameras.end(), [](const CameraChange& one) { return !one.is_zero(); });
  if (moves_cameras || !s.mount.isZero() || !s.drift.isZero()) return QObject::tr("Cameras");
  if (any([](const JointChange& j) { return !j.frame.isZero() || !j.after.isZero() || j.lateral_compliance != 0; }))
    return QObject::tr("Links");
  if (any([](const JointChange& j) {
        return j.angle != 0 || j.compliance != 0 || j.gap != 0 || j.multiplier_error != 0 || j.share != 0;
      }))
    return QObject::tr("Joints");
  if (s.robot.tilt_x != 0 || !s.robot.base_compliance.isZero()) return QObject::tr("Base");
  // A first joint has none before it that it could turn with.
  return moves_one_joint(e) ? QObject::tr("Joints") : QObject::tr("Hand");
}

/// An effect, in the model or not.
widgets::ModelEffect shown_effect(const Effect& e, const Document& document, const Chain& chain,
                                  const Diagnosis* diagnosis) {
  const Session& session = document.session();
  const ModelSettings& settings = document.settings();
  widgets::ModelEffect shown{.id = QString::fromStdString(e.id), .title = translated(e.title)};
  shown.help = translated(e.cause) + "\n\n" + translated(e.visibility);
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
          if (fitted.term.id == term.id && fitted.term.place == term.place) {
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
    const bool is_unusual = std::any_of(shown.parameters.begin(), shown.parameters.end(), [](const auto& p) {
      return p.value && p.plausible && std::abs(*p.value) > largest_plausible * *p.plausible;
    });
    if (is_unusual) shown.note = QObject::tr("More than three times what is usual.");
    if (std::any_of(terms.begin(), terms.end(), [&](const EffectTerm& t) { return is_too_large(t, chain); })) {
      shown.note = QObject::tr("Larger than robots are built. Probably another cause.");
      shown.note_is_warning = true;
    }
    return shown;
  }
  shown.group = group_of(e, chain);
  if (effect_places(e, chain).empty()) {
    shown.can_change = false;
    shown.group = QObject::tr("Not in this session");
    shown.is_out_of_sight = true;
    shown.note = e.scope == EffectScope::mimic_joint ? QObject::tr("No joint of this robot follows another.")
                                                     : QObject::tr("It has no place in this session.");
  } else if (diagnosis &&
             std::find(diagnosis->invisible.begin(), diagnosis->invisible.end(), e.id) != diagnosis->invisible.end()) {
    shown.group = QObject::tr("Invisible on these poses");
    shown.is_out_of_sight = true;
  }
  return shown;
}

/// One term of every effect by formula in the model: a user's own, curves without a name.
std::vector<EffectTerm> own_terms(const ModelSettings& settings) {
  std::vector<EffectTerm> own;
  for (const auto* terms : {&settings.held, &settings.estimated})
    for (const EffectTerm& term : *terms)
      if (term.own && std::none_of(own.begin(), own.end(), [&](const EffectTerm& t) { return t.id == term.id; }))
        own.push_back(term);
  return own;
}

}  // namespace

std::vector<widgets::ModelParameter> effect_parameters(const Session& session, const std::vector<EffectTerm>& terms,
                                                       const std::vector<std::vector<double>>& sigmas) {
  std::vector<widgets::ModelParameter> list;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const Effect& effect = term_effect(terms[t]);
    const QString of = place_text(place_name(effect, terms[t].place, session.robot));
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      const EffectParameter& number = effect.parameters[p];
      const ShownUnit unit = shown_unit(unit_at(effect, p, terms[t].place, session.robot));
      widgets::ModelParameter row{.of = of, .name = number_title(number.name), .unit = unit.unit};
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

QString lone_sentence(const ModelVersion& model) {
  if (model.lone.empty() || !model.inspection) return {};
  const bool pixels = model.inspection->in_pixels;
  const QString size = widgets::with_unit_text((pixels ? 1 : 1e3) * model.lone.front().error,
                                               pixels ? QObject::tr("px") : QObject::tr("mm"));
  if (model.lone.size() == 1)
    return QObject::tr("Observation %1 is left out: alone it is off by %2.").arg(model.lone.front().id).arg(size);
  QStringList ids;
  for (const LoneObservation& l : model.lone) ids << QString::number(l.id);
  return QObject::tr("Observations %1 are left out: they alone are far off.").arg(ids.join(", "));
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
      .arg(counted(static_cast<qint64>(wrong.size()), "%n wrong point(s)"), named.join("; "));
}

namespace {

QString hand_title(const Session& session, std::size_t part) {
  return QObject::tr("TCP→Body, %1").arg(QString::fromStdString(session.parts[part].title));
}

/// Of a collection; a hand that several sessions share stands once.
void add_other_hands(const Session& session, const std::vector<HandModel>& hands,
                     std::vector<widgets::ModelEffect>& list) {
  std::set<int> known;
  for (std::size_t p = 0; p < hands.size(); ++p) {
    if (!known.insert(session.parts[p].body).second || p == 0) continue;
    widgets::ModelEffect hand{.id = QString("tcp_from_body:%1").arg(p), .title = hand_title(session, p)};
    hand.is_in_model = hand.is_permanent = true;
    hand.parameters = six_parameters(hands[p].tcp_from_body, hands[p].sigma);
    list.push_back(std::move(hand));
  }
}

/// Of a collection: each place that is estimated, under the name of the first session that looks from it.
void add_mounts(const Session& session, const std::vector<PartReport>& parts, std::vector<widgets::ModelEffect>& list) {
  std::set<int> known;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const auto& covariance = parts[p].found.mount_covariance;
    if (!covariance || !known.insert(session.parts[p].mount).second) continue;
    widgets::ModelEffect mount{.id = QString("mount:%1").arg(p)};
    mount.title = QObject::tr("Mount, %1").arg(QString::fromStdString(session.parts[p].title));
    mount.is_in_model = mount.is_permanent = true;
    mount.parameters = six_parameters(parts[p].found.mount_from_sensor, covariance->diagonal().cwiseMax(0).cwiseSqrt());
    list.push_back(std::move(mount));
  }
}

/// What touches tell of where a fixture stands: a point's place; how far out along its axis another one is.
std::vector<widgets::ModelParameter> place_of_fixture(FixturePlace told, const Rigid& place,
                                                      const Matrix6& covariance) {
  const auto in_mm = [](const QString& name, double value, double variance) {
    widgets::ModelParameter p{.name = name, .unit = "mm"};
    p.value = 1e3 * value;
    constexpr double unknown = 1;  // m: of more nothing is known, as of a pose (UndeterminedMotions)
    p.sigma = variance > unknown ? std::nan("") : 1e3 * std::sqrt(std::max(variance, 0.0));
    return p;
  };
  const Vector3 z = place.rotation.col(2);
  if (told == FixturePlace::height)
    return {in_mm(QObject::tr("along its normal"), z.dot(place.translation), covariance(2, 2))};
  const Matrix3 of_place = place.rotation * covariance.topLeftCorner<3, 3>() * place.rotation.transpose();
  std::vector<widgets::ModelParameter> list;
  const std::array<const char*, 3> names{"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    list.push_back(in_mm(names[static_cast<std::size_t>(i)], place.translation[i], of_place(i, i)));
    // An edge may be shifted along itself.
    if (told == FixturePlace::axis && std::abs(z[i]) > 1e-3) list.back().sigma = std::nan("");
  }
  return list;
}

/// The fixtures whose places are estimated.
void add_fixtures(const Session& session, const Fit& fit, std::vector<widgets::ModelEffect>& list) {
  for (const SessionPart& part : session.parts) {
    const Eigen::Index column = fit.problem.column_of_mount(part.mount);
    if (part.fixture < 0 || column < 0) continue;
    widgets::ModelEffect shown{.id = QString("fixture:%1").arg(part.fixture)};
    shown.title = QString::fromStdString(part.title);
    shown.is_in_model = shown.is_permanent = true;
    shown.help = QObject::tr("Where it stands on %1, estimated with the rest.")
                     .arg(QString::fromStdString(find_mount(session, part.mount).link));
    shown.parameters =
        place_of_fixture(session.fixtures[static_cast<std::size_t>(part.fixture)].kind->place,
                         estimate(fit).mount(part.mount), fit.parameter_covariance.block<6, 6>(column, column));
    list.push_back(std::move(shown));
  }
}

}  // namespace

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
  const std::vector<HandModel>& hands = model->hands;
  body.parameters = hands.empty() ? six_parameters(fit.tcp_from_body, origin_sigma(fit))
                                  : six_parameters(hands[0].tcp_from_body, hands[0].sigma);
  if (!hands.empty()) body.title = hand_title(document.session(), 0);
  if (fit.covariance_kind == CovarianceKind::repeatability) {
    body.note = QObject::tr("Sigmas from how the observations differ, not from the noise alone.");
    body.note_is_warning = true;
  }
  if (const QString alone = lone_sentence(*model); !alone.isEmpty())
    body.note += (body.note.isEmpty() ? QString() : QString(" ")) + alone;
  if (!model->wrong_points.empty()) {
    body.note += (body.note.isEmpty() ? QString() : QString(" ")) + wrong_points_text(*model, 2);
    body.help += "\n\n" + wrong_points_text(*model, 40);
  }
  list.push_back(std::move(body));
  add_other_hands(document.session(), hands, list);
  if (is_joined(document.session())) {
    add_mounts(document.session(), model->parts, list);
  } else if (document.session().is_touch()) {
    add_fixtures(document.session(), fit, list);
  } else if (document.session().mount.estimate) {
    const bool of_cameras = document.session().rig.has_value();
    widgets::ModelEffect mount{.id = "mount",
                               .title = of_cameras ? QObject::tr("Camera mount") : QObject::tr("Mount of the tracker"),
                               .is_in_model = true};
    mount.is_permanent = true;
    mount.help = (of_cameras ? QObject::tr("Where the cameras sit on %1, estimated with the rest.")
                             : QObject::tr("Where the tracker sits on %1, estimated with the rest."))
                     .arg(QString::fromStdString(document.session().mount.link));
    mount.parameters =
        six_parameters(estimate(fit).mount_from_sensor,
                       fit.parameter_covariance.block<6, 6>(fit.problem.mount_column(), fit.problem.mount_column())
                           .diagonal()
                           .cwiseMax(0)
                           .cwiseSqrt());
    list.push_back(std::move(mount));
  }
  const Chain chain = make_chain(document.session());
  std::vector<widgets::ModelEffect> out;
  const OwnEffects none, &own = fit.problem.source ? fit.problem.source->own_effects : none;
  std::vector<const Effect*> known = catalogue_beside(own);
  for (const std::shared_ptr<const Effect>& effect : own) known.push_back(effect.get());
  for (const Effect* e : known) {
    widgets::ModelEffect shown = shown_effect(*e, document, chain, diagnosis);
    (shown.is_in_model ? list : out).push_back(std::move(shown));
  }
  for (const EffectTerm& term : own_terms(document.settings())) {
    if (find_effect(term.id, own)) continue;  // stands above
    widgets::ModelEffect shown = shown_effect(*term.own, document, chain, diagnosis);
    shown.title = make_title(term, document.session().robot);
    if (term.own->is_unnamed()) shown.help = QString::fromStdString(term.own->cause);
    list.push_back(std::move(shown));
  }
  // Groups in the order in which one mends a robot; what cannot be seen last.
  const QStringList groups = {QObject::tr("Joints"), QObject::tr("Links"), QObject::tr("Base"), QObject::tr("Cameras"),
                              QObject::tr("Target"), QObject::tr("Hand"),  QObject::tr("Own")};
  const auto place = [&](const widgets::ModelEffect& e) {
    const auto at = groups.indexOf(e.group);
    return at < 0 ? groups.size() + (e.can_change ? 0 : 1) : at;
  };
  std::stable_sort(out.begin(), out.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
  list.insert(list.end(), out.begin(), out.end());
  return list;
}

}  // namespace handsight::app
