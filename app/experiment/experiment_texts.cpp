// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/experiment_texts.h"

#include <QObject>
#include <cmath>

#include "document/effect_words.h"
#include "experiment/paths/collision_world.h"
#include "findings/explain_texts.h"
#include "words/core_words.h"
#include "words/counted.h"
#include "workbench/session_parts.h"

namespace handsight::app {
namespace {

constexpr std::size_t causes_shown = 2;

}  // namespace

QString why_no_experiment(const Session& session) {
  if (is_joined(session))
    return QObject::tr("Several sessions are open together. An experiment adds to one: open it by itself.");
  if (session.robot.is_of_poses)
    return QObject::tr("Of this session's robot only the flange's poses are known, and an experiment moves joints.");
  if (session.observations.empty())
    return QObject::tr("An experiment begins with one observation at least: add it, and it goes on from there.");
  if (const auto need = what_paths_need()) return translated(*need);
  return {};
}

namespace {

/// What a driver calls itself; the simulated one in the reader's language.
QString shown_driver(const QString& name) {
  const QString simulated = "a simulated ";
  return name.startsWith(simulated) ? QObject::tr("a simulated %1").arg(name.mid(simulated.size())) : name;
}

}  // namespace

QString state_text(RunState state, const QString& driver, bool is_of_touches) {
  switch (state) {
    case RunState::resting:
      return QObject::tr("No robot is connected.");
    case RunState::greeting:
      return QObject::tr("The driver is started and asked where the robot stands ...");
    case RunState::thinking:
      return QObject::tr("What was measured is fitted and diagnosed, and the next poses are chosen ...");
    case RunState::asking:
      return QObject::tr("Connected: %1. These poses come first; nothing has moved.").arg(shown_driver(driver));
    case RunState::moving:
      return QObject::tr("The robot moves.");
    case RunState::looking:
      return is_of_touches ? QObject::tr("The robot feels for the fixture and goes back.")
                           : QObject::tr("The robot looks.");
    case RunState::stopping:
      return QObject::tr("Stopping ...");
    case RunState::halted:
      return QObject::tr("The robot was told to stop and stands still; what was measured is summed up ...");
  }
  return {};
}

QString reason_in_words(PoseReason reason) {
  switch (reason) {
    case PoseReason::spread:
      return QObject::tr("to settle the estimate");
    case PoseReason::near_seen:
      return QObject::tr("a small step from where it was seen");
    case PoseReason::precision:
      return QObject::tr("precision of the hand");
    case PoseReason::cause:
      return QObject::tr("to find what is missing");
    case PoseReason::between:
      return QObject::tr("to tell two causes apart");
    case PoseReason::region:
      return QObject::tr("where it has not been measured yet");
    case PoseReason::repeat:
      return QObject::tr("a repeat, for scatter");
  }
  return {};
}

QString hand_text(const Knowledge& known, bool has_box, bool is_of_touches) {
  if (!known.hand_limit) return QObject::tr("not known yet");
  const QString limit = QObject::tr("within %1 mm").arg(short_number(1e3 * *known.hand_limit));
  QString text = has_box         ? QObject::tr("%1 in the box (95 %)")
                 : is_of_touches ? QObject::tr("%1 wherever it can touch (95 %)")
                                 : QObject::tr("%1 wherever it can be seen (95 %)");
  return text.arg(limit).replace(QStringLiteral("95 %"), QStringLiteral("95\u00a0%"));  // no line ends there
}

QString verdict_in_words(const Knowledge& known) {
  if (!known.diagnosis) return QObject::tr("asked from %1 observations on").arg(least_to_diagnose);
  if (!known.settled) return translated(verdict_text(known.diagnosis->verdict));
  const QString odds = odds_text(std::log(std::max(known.settled->odds, 1.0)));
  if (!known.settled->id.empty())
    return QObject::tr("%1, %2").arg(effect_text(known.settled->id, known.settled->where), odds);
  if (known.settled->follows)
    return QObject::tr("something without a name that follows the %1, %2")
        .arg(translated(*known.settled->follows), odds);
  return known.settled->odds > 1 ? QObject::tr("nothing that these poses can show, %1").arg(odds)
                                 : QObject::tr("nothing is sure yet");
}

std::vector<CauseInWords> likeliest_causes(const Knowledge& known) {
  std::vector<CauseInWords> causes;
  if (!known.diagnosis) return causes;
  for (const DiagnosisCandidate& c : known.diagnosis->candidates) {
    if (c.id.empty() || c.unnamed || c.terms.empty()) continue;
    causes.push_back({effect_text(c.id, c.where), c.ln_bayes_factor > 0
                                                      ? QObject::tr("%1 against none").arg(odds_text(c.ln_bayes_factor))
                                                      : QObject::tr("less likely than none")});
    if (causes.size() == causes_shown) break;
  }
  return causes;
}

QString step_text(const ExperimentStep& step) {
  QString reason = translated(step.reason);
  if (step.id < 0) return reason;
  if (step.accepted) return QObject::tr("taken");
  return QObject::tr("rejected: %1").arg(reason);
}

QString touched_by(const ChosenPose& pose, const Session& session) {
  const auto place = static_cast<std::size_t>(pose.fixture);
  return pose.fixture >= 0 && place < session.fixtures.size() ? QString::fromStdString(session.fixtures[place].id)
                                                              : QString();
}

QString way_text(const PlannedMove& move) {
  const QString length = QObject::tr("%1 rad away").arg(short_number(move.length));
  return move.way.size() > 1 ? QObject::tr("%1, round what is in the way").arg(length) : length;
}

QString question_text(std::size_t poses, double speed, bool is_of_touches) {
  return (is_of_touches
              ? QObject::tr(
                    "The robot moves now and feels for its fixtures: %1 at first, the first move at a tenth of %2 "
                    "rad/s. Is nobody within its reach, and is the emergency stop at hand?")
              : QObject::tr(
                    "The robot moves now: %1 at first, the first one at a tenth of %2 rad/s. Is nobody within its "
                    "reach, and is the emergency stop at hand?"))
      .arg(counted(static_cast<qint64>(poses), "%n pose(s)"))
      .arg(short_number(speed, 3));
}

}  // namespace handsight::app
