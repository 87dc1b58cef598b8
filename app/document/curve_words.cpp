// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/curve_words.h"

#include <QObject>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnosis/ranking/curves.h"
#include "document/effect_words.h"
#include "effects/own_effect.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

/// "shifts along x, z and turns about rz" of the sites with this prefix; empty: none has it.
QString motions_of(const EffectDefinition& definition, const QString& prefix) {
  QStringList shifts, turns;
  for (const DefinedMove& m : definition.moves) {
    const QString site = QString::fromStdString(m.site);
    if (!site.startsWith(prefix)) continue;
    const QString axis = site.mid(prefix.size());
    (axis.startsWith('r') ? turns : shifts) << axis.right(1);
  }
  QStringList parts;
  if (!shifts.isEmpty()) parts << QObject::tr("shifts along %1").arg(shifts.join(", "));
  if (!turns.isEmpty()) parts << QObject::tr("turns about %1").arg(turns.join(", "));
  return parts.join(QObject::tr(" and "));
}

QString what_moves(const EffectDefinition& definition, const std::string& place) {
  const std::pair<const char*, QString> frames[] = {{"hand_", QObject::tr("The hand")},
                                                    {"mount_", QObject::tr("The sensor's mount")},
                                                    {"body_", QObject::tr("The marker body")}};
  for (const auto& [prefix, name] : frames)
    if (const QString motions = motions_of(definition, prefix); !motions.isEmpty()) return name + ' ' + motions;
  if (!place.empty()) return QObject::tr("The angle of %1 moves").arg(QString::fromStdString(place));
  return QObject::tr("Something moves");
}

/// "sin(3.3 q) of arm_4" of "y_sine*sin(3.3*q_arm_4) + ...": the first part without its number.
QString make_shape(const EffectDefinition& definition, const std::string& place, const Robot& robot) {
  QString text = QString::fromStdString(definition.moves.front().formula).section(" + ", 0, 0).section('*', 1);
  // What follows a place has a formula too long for a title.
  if (text.contains("tcp_")) return QObject::tr("a curve of the %1").arg(translated(followed_variable(definition)));
  QStringList of;
  const auto put = [&](const QString& name, const QString& shown, const QString& joint) {
    const QRegularExpression word("\\b" + QRegularExpression::escape(name) + "\\b");
    if (!text.contains(word)) return;
    text.replace(word, shown);
    if (!joint.isEmpty() && !of.contains(joint)) of << joint;
  };
  for (const Joint& joint : robot.joints) {
    const QString name = QString::fromStdString(joint.name);
    put(QString::fromStdString("q_" + formula_name(joint.name)), "q", name);
    put(QString::fromStdString("tau_" + formula_name(joint.name)), "torque", name);
  }
  put("tau", "torque", QString::fromStdString(place));
  if (of.isEmpty() && !place.empty()) of << QString::fromStdString(place);
  text.replace('*', ' ');
  const bool is_of_joint = text.contains('q');
  return is_of_joint && !of.isEmpty() ? QObject::tr("%1 of %2").arg(text, of.join(QObject::tr(" and "))) : text;
}

/// A wave of a joint's own angle: what engineers know as an error that repeats with every turn.
struct Wave {
  QString joint, times;  // "three times"
  QString amplitude;     // "1.5 mrad"; empty: not estimated yet
};

QString times_text(double times) {
  constexpr double nearly = 0.1;  // of a turn: what repeats with the turn repeats so many whole times
  const long whole = std::lround(times);
  if (std::abs(times - static_cast<double>(whole)) > nearly) return QObject::tr("%1 times").arg(short_number(times));
  if (whole == 1) return QObject::tr("once");
  if (whole == 2) return QObject::tr("twice");
  return whole == 3 ? QObject::tr("three times") : QObject::tr("%1 times").arg(whole);
}

std::optional<Wave> wave_of(const EffectTerm& term, const Robot& robot) {
  const Effect& effect = term_effect(term);
  const std::string joint = place_name(effect, term.place, robot);
  if (joint.empty() || !effect.is_unnamed() || effect.definition->moves.size() != 1) return std::nullopt;
  const DefinedMove& move = effect.definition->moves.front();
  static const QRegularExpression form("^sine\\*sin\\(([0-9.]+)\\*q(_\\w+)?\\) \\+ cosine\\*cos\\(\\1\\*q(_\\w+)?\\)$");
  const auto match = form.match(QString::fromStdString(move.formula));
  if (move.site != "angle" || !match.hasMatch()) return std::nullopt;
  const QString of = match.captured(2);
  if (!of.isEmpty() && of != QString::fromStdString("_" + formula_name(joint))) return std::nullopt;
  double squares = 0;
  for (const double value : term.values) squares += value * value;
  const ShownUnit unit = shown_unit(effect.parameters.front().unit);
  return Wave{QString::fromStdString(joint), times_text(match.captured(1).toDouble()),
              squares > 0 ? short_number(unit.scale * std::sqrt(squares)) + QChar(0x00A0) + unit.unit : QString()};
}

}  // namespace

QString curve_sentence(const EffectTerm& term, const Robot& robot) {
  if (const auto wave = wave_of(term, robot)) {
    const QString text = QObject::tr("%1 has an error that repeats %2 a turn").arg(wave->joint, wave->times);
    return wave->amplitude.isEmpty() ? text : QObject::tr("%1 (± %2)").arg(text, wave->amplitude);
  }
  const QString title = make_title(term, robot);
  return title.left(1).toUpper() + title.mid(1);
}

std::vector<EffectTerm> list_curves(const Fit& fit) {
  std::vector<EffectTerm> curves;
  for (const EffectTerm& term : list_terms(fit))
    if (term_effect(term).is_unnamed()) curves.push_back(term);
  return curves;
}

QString curve_title(const EffectDefinition& definition, const std::string& place, const Robot& robot) {
  return QObject::tr("%1 with %2").arg(what_moves(definition, place), make_shape(definition, place, robot));
}

QString make_title(const EffectTerm& term, const Robot& robot) {
  const Effect& effect = term_effect(term);
  if (const auto wave = wave_of(term, robot)) {
    const QString text = QObject::tr("An error of %1 that repeats %2 a turn").arg(wave->joint, wave->times);
    return wave->amplitude.isEmpty() ? text : QObject::tr("%1 (± %2)").arg(text, wave->amplitude);
  }
  if (effect.is_unnamed()) return curve_title(*effect.definition, place_name(effect, term.place, robot), robot);
  return effect.title.empty() ? QString::fromStdString(effect.id) : translated(effect.title);
}

QString display_name(const std::vector<EffectTerm>& terms, const Session& session) {
  if (terms.empty()) return {};
  QString title = within_sentence(make_title(terms.front(), session.robot));
  if (term_effect(terms.front()).is_unnamed()) return title;
  return of_places(title, list_places(terms, session));
}

namespace {

bool are_told_as_sentence(const std::vector<EffectTerm>& terms, const Robot& robot) {
  return !terms.empty() && term_effect(terms.front()).is_unnamed() && !wave_of(terms.front(), robot);
}

}  // namespace

QString addition_text(const std::vector<EffectTerm>& terms, const Session& session) {
  return (are_told_as_sentence(terms, session.robot) ? QObject::tr("added: %1") : QObject::tr("added %1"))
      .arg(display_name(terms, session));
}

QString removal_text(const std::vector<EffectTerm>& terms, const Session& session) {
  return (are_told_as_sentence(terms, session.robot) ? QObject::tr("took out: %1") : QObject::tr("took out %1"))
      .arg(display_name(terms, session));
}

QString display_name(const DiagnosisCandidate& c, const Session& session) {
  return c.terms.empty() ? effect_text(c.id, c.where) : display_name(c.terms, session);
}

}  // namespace handsight::app
