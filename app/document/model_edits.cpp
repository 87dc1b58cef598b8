// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/model_edits.h"

#include <algorithm>

#include "diagnosis/refitting.h"
#include "document/effect_words.h"

namespace handsight::app {
namespace {

/// The settings with the values of the last fit of just these settings, where there is one.
ModelSettings settings_with_values(const Document& document) {
  const ModelVersionPointer model = document.model();
  return model && model->fit && model->settings == document.settings() ? with_values_of(*model->fit, model->settings)
                                                                       : document.settings();
}

Edit edit_to(const Document& document, ModelSettings after, const QString& sentence) {
  Edit edit{.sentence = sentence};
  if (!(after == document.settings())) edit.settings = SettingsEdit{document.settings(), std::move(after)};
  return edit;
}

/// Takes an effect out of the estimated ones.
void erase_estimated(ModelSettings& settings, const std::string& id) {
  const auto by_hand = settings.estimated.begin() + settings.by_hand;
  settings.by_hand -= static_cast<int>(
      std::count_if(settings.estimated.begin(), by_hand, [&](const EffectTerm& t) { return t.id == id; }));
  std::erase_if(settings.estimated, [&](const EffectTerm& t) { return t.id == id; });
}

void insert_by_hand(ModelSettings& settings, const std::vector<EffectTerm>& terms) {
  settings.estimated.insert(settings.estimated.begin() + settings.by_hand, terms.begin(), terms.end());
  settings.by_hand += static_cast<int>(terms.size());
}

}  // namespace

Edit with_effect(const Document& document, const std::vector<EffectTerm>& terms) {
  if (terms.empty()) return {};
  ModelSettings after = settings_with_values(document);
  insert_by_hand(after, terms);
  return edit_to(document, after,
                 QObject::tr("added %1").arg(effect_of(terms.front().id, places_of(terms, document.session()))));
}

ModelSettings with_estimated(ModelSettings after, const std::vector<EffectTerm>& estimated) {
  after.estimated = estimated;
  after.by_hand = std::min(after.by_hand, static_cast<int>(estimated.size()));
  after.objective = Objective::image;
  after.fix_markers = false;
  return after;
}

Edit without_effect(const Document& document, const std::string& id) {
  ModelSettings after = document.settings();
  std::vector<EffectTerm> gone = terms_of_effect(after.held, id);
  for (const EffectTerm& term : terms_of_effect(after.estimated, id)) gone.push_back(term);
  erase_estimated(after, id);
  std::erase_if(after.held, [&](const EffectTerm& t) { return t.id == id; });
  return edit_to(document, after, QObject::tr("took out %1").arg(effect_of(id, places_of(gone, document.session()))));
}

Edit with_effect_held(const Document& document, const std::string& id, bool held) {
  ModelSettings after = settings_with_values(document);
  const std::vector<EffectTerm> terms = terms_of_effect(held ? after.estimated : after.held, id);
  if (terms.empty()) return {};
  if (held) {
    erase_estimated(after, id);
    after.held.insert(after.held.end(), terms.begin(), terms.end());
  } else {
    std::erase_if(after.held, [&](const EffectTerm& t) { return t.id == id; });
    insert_by_hand(after, terms);
  }
  const QString name = effect_of(id, places_of(terms, document.session()));
  return edit_to(document, after,
                 held ? QObject::tr("held %1").arg(name) : QObject::tr("estimated %1 again").arg(name));
}

Edit with_value(const Document& document, const std::string& id, std::size_t number, double value) {
  ModelSettings after = document.settings();
  std::size_t first = 0;
  for (EffectTerm& term : after.held) {
    if (term.id != id) continue;
    if (number < first + term.values.size()) {
      term.values[number - first] = value;
      const Effect& effect = *find_effect(id);
      const EffectParameter& p = effect.parameters[number - first];
      const ShownUnit shown = shown_unit(p.unit);
      return edit_to(document, after,
                     QObject::tr("held %1 at %2 %3 %4")
                         .arg(effect_of(id, places_of({term}, document.session())), QString::fromStdString(p.name))
                         .arg(shown.scale * value, 0, 'g', 4)
                         .arg(shown.unit)
                         .trimmed());
    }
    first += term.values.size();
  }
  return {};
}

std::vector<EffectTerm> best_places(const Session& session, const ModelSettings& settings, const std::string& id) {
  DiagnosisOptions options;
  options.effects = settings.held;
  options.estimated = settings.estimated;
  options.refitted = 0;
  options.with_held_out = false;
  options.threshold = 4;
  const Diagnosis d = diagnose(session, options);
  for (const DiagnosisCandidate& c : d.candidates)
    if (c.id == id && !c.terms.empty()) return c.terms;
  const Chain chain = chain_of(session);
  if (effect_places(*find_effect(id), chain).empty()) return {};
  return best_choices(session, effect_terms(id, chain));
}

}  // namespace handsight::app
