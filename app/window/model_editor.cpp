// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/model_editor.h"

#include "document/effect_words.h"
#include "document/model_edits.h"

namespace handsight::app {

void ModelEditor::tick(const QString& id, bool in_model) {
  const std::string name = id.toStdString();
  const auto perform = [this](Edit edit) { bench_.document.perform(std::move(edit)); };
  if (!in_model) return perform(without_effect(bench_.document, name));
  if (const auto diagnosis = bench_.diagnosing.diagnosis())
    for (const DiagnosisCandidate& c : diagnosis->candidates)
      if (c.id == name && !c.terms.empty()) return perform(with_effect(bench_.document, c.terms));
  const std::int64_t revision = bench_.document.revision();
  bench_.jobs.start<std::vector<EffectTerm>>(
      "places", tr("Looking where %1 would act").arg(effect_of(name, {})),
      [session = bench_.document.shared_session(), settings = bench_.document.settings(), name](JobControl&) {
        return best_places(*session, settings, name);
      },
      [this, revision, name](const std::vector<EffectTerm>& terms) {
        if (revision != bench_.document.revision()) return;
        if (terms.empty())
          emit bench_.document.noticed(tr("Not added: %1 has no place in this session.").arg(effect_of(name, {})));
        bench_.document.perform(with_effect(bench_.document, terms));
      },
      [this](const QString& sentence) { emit bench_.document.noticed(sentence); });
}

void ModelEditor::hold(const QString& id, bool held) {
  bench_.document.perform(with_effect_held(bench_.document, id.toStdString(), held));
}

void ModelEditor::hold_number(const QString& id, int number, bool held) {
  if (number < 0) return;
  bench_.document.perform(with_number_held(bench_.document, id.toStdString(), static_cast<std::size_t>(number), held));
}

void ModelEditor::type(const QString& id, int number, double value) {
  if (number < 0) return;
  const auto place = static_cast<std::size_t>(number);
  const double scale = shown_scale(bench_.document, id.toStdString(), place);
  bench_.document.perform(with_value(bench_.document, id.toStdString(), place, value / scale));
}

}  // namespace handsight::app
