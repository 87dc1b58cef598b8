// SPDX-License-Identifier: GPL-3.0-or-later
// What Explain says: the verdict, cards, verdicts on every effect.
#pragma once

#include <set>

#include "bench/workbench.h"
#include "diagnosis/evidence/weighing.h"
#include "document/refusal.h"
#include "widgets/explain/candidate_card.h"
#include "widgets/explain/effect_table.h"
#include "widgets/explain/verdict_line.h"

namespace handsight::app {

/// "The model misses by 9.1 px (12 mm at the hand) where the cameras' noise is 0.2 px."
QString comparison_sentence(const ModelVersion& model, widgets::SizeUnit unit = widgets::SizeUnit::pixel);

/// Shares of what exceeds the noise over all used observations; nothing where nothing stands out.
std::optional<widgets::Blame> session_blame(const Inspection& all);

/// The whole session in a sentence. `diagnosis` may be null: only what the fit says. `refused`: ids that were tried on
/// this model and not taken; none of them is said to be missing.
widgets::SessionVerdict session_verdict(const ModelVersion& model, const Diagnosis* diagnosis, bool is_running,
                                        widgets::SizeUnit unit, const std::set<std::string>& refused = {});

/// The cards, best first; the first is an honest one where there is nothing to add.
std::vector<widgets::CardState> candidate_cards(const Workbench& bench, const ModelVersion& model,
                                                const Diagnosis& diagnosis, const std::vector<Refusal>& refused);

/// One verdict for every effect of the catalogue.
std::vector<widgets::EffectRow> effect_rows(const Workbench& bench, const ModelVersion& model,
                                            const Diagnosis& diagnosis, const std::vector<Refusal>& refused);

/// "about 12 to one", "about 32000 to one" (two digits of it), "more than a million to one".
QString odds_text(double ln_odds);

/// "0.24 px", "3.1 mm": an error as the session measures it, from px or m.
QString error_with_unit(double error, bool in_pixels);

}  // namespace handsight::app
