// SPDX-License-Identifier: GPL-3.0-or-later
#include "findings/robot_checks.h"

#include <algorithm>

#include "document/effect_words.h"
#include "widgets/base/number_text.h"
#include "words/core_words.h"

namespace handsight::app {

QString check_number_text(double value, double sigma, const std::string& unit) {
  const ShownUnit shown = shown_unit(unit);
  const QString number = widgets::with_sigma_text(shown.scale * value, shown.scale * sigma);
  return shown.unit.isEmpty() ? number : number + QChar(0x00A0) + shown.unit;
}

std::optional<widgets::CardCheck> card_check(const std::optional<CheckPrediction>& now, const RobotReading* reading) {
  // What was predicted before it was measured stays beside what was measured.
  const CheckPrediction* p = reading ? &reading->predicted : now ? &*now : nullptr;
  if (!p) return std::nullopt;
  widgets::CardCheck check;
  check.prediction = translated(p->before) + ' ' + check_number_text(p->value, p->sigma, p->unit) +
                     (p->after.empty() ? QString() : ' ' + translated(p->after)) + '.';
  const ShownUnit unit = shown_unit(p->unit);
  check.unit = unit.unit;
  if (!reading) return check;
  const CheckAnswer answer = answer_check(*p, reading->value, reading->sigma);
  check.measured = widgets::with_sigma_text(unit.scale * reading->value, unit.scale * reading->sigma);
  check.answer = translated(answer.text);
  check.is_inside = answer.is_inside;
  return check;
}

QString reading_text(const RobotReading& r) {
  return QObject::tr("Predicted %1, measured %2. %3")
      .arg(check_number_text(r.predicted.value, r.predicted.sigma, r.predicted.unit),
           check_number_text(r.value, r.sigma, r.predicted.unit),
           translated(answer_check(r.predicted, r.value, r.sigma).text));
}

QString take_reading(Document& document, const Diagnosis& d, const std::string& effect, const QString& text) {
  const RobotReading* known = document.find_reading(effect);
  std::optional<RobotReading> reading;
  if (!text.trimmed().isEmpty()) {
    const auto typed = parse_reading(text);
    if (!typed) return QObject::tr("That is no number. Write it like 1.3 or 1.3 ± 0.1.");
    const auto candidate = std::find_if(d.candidates.begin(), d.candidates.end(),
                                        [&](const DiagnosisCandidate& c) { return !c.unnamed && c.id == effect; });
    if (!known && (candidate == d.candidates.end() || !candidate->check)) return {};
    const CheckPrediction& predicted = known ? known->predicted : *candidate->check;
    const double scale = shown_unit(predicted.unit).scale;
    reading = RobotReading{effect, typed->value / scale, typed->sigma / scale, predicted};
  }
  document.perform(document.edit_of_reading(effect, reading));
  return {};
}

}  // namespace handsight::app
