// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/model_edits.h"

#include <algorithm>

#include "diagnosis/ranking/refitting.h"
#include "document/curve_words.h"
#include "document/effect_words.h"
#include "effects/units.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

/// The settings with the values of the last fit of just these settings, where there is one.
ModelSettings settings_with_values(const Document& document) {
  const ModelVersionPointer model = document.model();
  return model && model->fit && model->settings == document.settings()
             ? with_fitted_values(*model->fit, model->settings)
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
  return edit_to(document, after, addition_text(terms, document.session()));
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
  return edit_to(document, after, removal_text(gone, document.session()));
}

Edit with_effect_held(const Document& document, const std::string& id, bool held) {
  ModelSettings after = settings_with_values(document);
  std::vector<EffectTerm> terms = terms_of_effect(held ? after.estimated : after.held, id);
  if (terms.empty()) return {};
  for (EffectTerm& term : terms) term.held.clear();  // all of them or none
  if (held) {
    erase_estimated(after, id);
    after.held.insert(after.held.end(), terms.begin(), terms.end());
  } else {
    std::erase_if(after.held, [&](const EffectTerm& t) { return t.id == id; });
    insert_by_hand(after, terms);
  }
  const QString name = display_name(terms, document.session());
  return edit_to(document, after,
                 held ? QObject::tr("held %1").arg(name) : QObject::tr("estimated %1 again").arg(name));
}

namespace {

/// One number of an effect, by its place among all its numbers, term by term.
struct NumberPlace {
  EffectTerm* term;
  std::size_t parameter;
};

std::optional<NumberPlace> find_number(ModelSettings& settings, const std::string& id, std::size_t number) {
  for (auto* terms : {&settings.held, &settings.estimated})
    for (EffectTerm& term : *terms) {
      if (term.id != id) continue;
      if (number < term.values.size()) return NumberPlace{&term, number};
      number -= term.values.size();
    }
  return std::nullopt;
}

ShownUnit shown_unit_of(const Document& document, const NumberPlace& n) {
  return shown_unit(unit_at(term_effect(*n.term), n.parameter, n.term->place, document.session().robot));
}

bool holds_all(const EffectTerm& term) {
  const Effect& effect = term_effect(term);
  for (std::size_t p = 0; p < effect.parameters.size(); ++p)
    if (is_free(effect, term, p)) return false;
  return true;
}

/// All terms of an effect among those that are estimated by hand, in their order; whole effects that were held hold
/// every number now.
void bring_by_hand(ModelSettings& settings, const std::string& id) {
  std::vector<EffectTerm> terms = terms_of_effect(settings.held, id);
  for (EffectTerm& term : terms) term.held.assign(term.values.size(), 1);
  for (const EffectTerm& term : terms_of_effect(settings.estimated, id)) terms.push_back(term);
  std::erase_if(settings.held, [&](const EffectTerm& t) { return t.id == id; });
  erase_estimated(settings, id);
  insert_by_hand(settings, terms);
}

QString number_text(const Document& document, const NumberPlace& place) {
  const Effect& effect = term_effect(*place.term);
  return QObject::tr("the %1 of %2")
      .arg(number_title(effect.parameters[place.parameter].name), display_name({*place.term}, document.session()));
}

}  // namespace

Edit with_number_held(const Document& document, const std::string& id, std::size_t number, bool held) {
  ModelSettings after = settings_with_values(document);
  bring_by_hand(after, id);
  const auto place = find_number(after, id, number);
  if (!place || term_effect(*place->term).parameters[place->parameter].is_choice) return {};
  place->term->held.resize(place->term->values.size(), 0);
  place->term->held[place->parameter] = held ? 1 : 0;
  const QString name = number_text(document, *place);
  std::vector<EffectTerm> terms = terms_of_effect(after.estimated, id);
  if (std::all_of(terms.begin(), terms.end(), holds_all)) {
    erase_estimated(after, id);
    for (EffectTerm& term : terms) term.held.clear();
    after.held.insert(after.held.end(), terms.begin(), terms.end());
  }
  return edit_to(document, after,
                 held ? QObject::tr("held %1").arg(name) : QObject::tr("estimated %1 again").arg(name));
}

double shown_scale(const Document& document, const std::string& id, std::size_t number) {
  ModelSettings settings = document.settings();
  const auto place = find_number(settings, id, number);
  return place ? shown_unit_of(document, *place).scale : 1;
}

Edit with_value(const Document& document, const std::string& id, std::size_t number, double value) {
  ModelSettings after = settings_with_values(document);
  const auto place = find_number(after, id, number);
  if (!place) return {};
  const Effect& effect = term_effect(*place->term);
  const bool is_in_held = !terms_of_effect(after.held, id).empty();
  if (effect.parameters[place->parameter].is_choice || (!is_in_held && is_free(effect, *place->term, place->parameter)))
    return {};
  place->term->values[place->parameter] = value;
  const ShownUnit shown = shown_unit_of(document, *place);
  return edit_to(document, after,
                 QObject::tr("held %1 at %2 %3")
                     .arg(number_text(document, *place), short_number(shown.scale * value, 4), shown.unit)
                     .trimmed());
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
  const Chain chain = make_chain(session);
  const Effect* effect = find_effect(id);
  if (!effect || effect_places(*effect, chain).empty()) return {};
  return best_choices(session, effect_terms(id, chain));
}

}  // namespace handsight::app
