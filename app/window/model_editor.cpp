// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/model_editor.h"

#include "document/effect_words.h"
#include "document/model_edits.h"

namespace handsight::app {

void ModelEditor::tick(const QString& id, bool in_model) {
  const std::string name = id.toStdString();
  const auto perform = [this](Edit edit) { workbench_.document.perform(std::move(edit)); };
  if (!in_model) return perform(without_effect(workbench_.document, name));
  if (const auto diagnosis = workbench_.diagnosing.diagnosis())
    for (const DiagnosisCandidate& c : diagnosis->candidates)
      if (c.id == name && !c.terms.empty()) return perform(with_effect(workbench_.document, c.terms));
  const std::int64_t revision = workbench_.document.revision();
  workbench_.jobs.start<std::vector<EffectTerm>>(
      "places", tr("Looking where %1 would act").arg(effect_text(name, {})),
      [session = workbench_.document.shared_session(), settings = workbench_.document.settings(), name](JobControl&) {
        return best_places(*session, settings, name);
      },
      [this, revision, name](const std::vector<EffectTerm>& terms) {
        if (revision != workbench_.document.revision()) return;
        if (terms.empty())
          emit workbench_.document.noticed(
              tr("Not added: %1 has no place in this session.").arg(effect_text(name, {})));
        workbench_.document.perform(with_effect(workbench_.document, terms));
      },
      [this](const QString& sentence) { emit workbench_.document.noticed(sentence); });
}

void ModelEditor::hold(const QString& id, bool held) {
  workbench_.document.perform(with_effect_held(workbench_.document, id.toStdString(), held));
}

void ModelEditor::hold_number(const QString& id, int number, bool held) {
  if (number < 0) return;
  workbench_.document.perform(
      with_number_held(workbench_.document, id.toStdString(), static_cast<std::size_t>(number), held));
}

void ModelEditor::type(const QString& id, int number, double value) {
  if (number < 0) return;
  const auto place = static_cast<std::size_t>(number);
  const double scale = shown_scale(workbench_.document, id.toStdString(), place);
  workbench_.document.perform(with_value(workbench_.document, id.toStdString(), place, value / scale));
}

}  // namespace handsight::app
