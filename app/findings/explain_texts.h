// SPDX-License-Identifier: GPL-3.0-or-later
// What Explain says: the verdict, cards, verdicts on every effect.
#pragma once

#include "diagnosis/evidence/noise_model.h"
#include "document/refusal.h"
#include "widgets/explain/candidate_card.h"
#include "widgets/explain/effect_table.h"
#include "widgets/explain/verdict_line.h"
#include "workbench/workbench.h"

namespace handsight::app {

/// "Error on observations that the fit has not seen: 9.1 px (12 mm); noise: 0.20 px.": what the window's header shows,
/// for pages without one. Empty where no error is known.
QString figures_sentence(const ModelVersion& model, widgets::SizeUnit unit);

/// "The model misses by more than the noise.": how error and noise compare; their figures stand in the header.
QString comparison_sentence(const ModelVersion& model);

/// The whole session in a sentence, as its story says. `diagnosis` is what the story goes by; null: only what the fit
/// says.
widgets::SessionVerdict session_verdict(const ModelVersion& model, const Story& story, const Diagnosis* diagnosis,
                                        bool is_running, widgets::SizeUnit unit);
widgets::SessionVerdict session_verdict(const Workbench& workbench, const ModelVersionPointer& model);

/// What is wrong with the session: a sentence a mistake.
QString mistake_sentence(const std::vector<Blunder>& blunders);

/// The cards, best first; the first is an honest one where there is nothing to add.
std::vector<widgets::CardState> candidate_cards(const Workbench& workbench, const ModelVersionPointer& model,
                                                const Diagnosis& diagnosis, const std::vector<Refusal>& refused);

/// The one card of a session with a mistake of a whole kind: nothing can be added before it is put right.
widgets::CardState mistake_card();

/// Why nobody can say whose fault an error is where there is one marker alone.
QString cannot_be_split_text();

/// One verdict for every effect of the catalogue.
std::vector<widgets::EffectRow> effect_rows(const Workbench& workbench, const ModelVersion& model,
                                            const Diagnosis& diagnosis, const std::vector<Refusal>& refused);

/// "about 12 to one", "about 32000 to one" (two digits of it), "more than a million to one".
QString odds_text(double ln_odds);

/// "0.24 px", "3.1 mm": an error as the session measures it, from px or m.
QString error_with_unit(double error, bool in_pixels);

}  // namespace handsight::app
