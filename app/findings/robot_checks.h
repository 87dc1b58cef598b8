// SPDX-License-Identifier: GPL-3.0-or-later
// Checks with the real robot in words: what is predicted, what was measured, what that says.
#pragma once

#include "document/document.h"
#include "widgets/explain/candidate_card.h"

namespace handsight::app {

/// "1.40 ± 0.20 mm", from the catalogue's unit.
QString check_number_text(double value, double sigma, const std::string& unit);

/// What a card shows of a check; `reading` may be null. Absent without a prediction.
std::optional<widgets::CardCheck> card_check(const std::optional<CheckPrediction>& prediction,
                                             const RobotReading* reading);

/// "Predicted 1.40 ± 0.20 mm, measured 1.30 ± 0.05 mm. Inside: ..."
QString reading_text(const RobotReading& reading);

/// Takes what was typed for a candidate of a diagnosis: an action; empty text forgets what was measured. Returns a
/// sentence where it is no number.
QString take_reading(Document& document, const Diagnosis& diagnosis, const std::string& effect, const QString& text);

}  // namespace handsight::app
