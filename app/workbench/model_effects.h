// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "document/document.h"
#include "widgets/lists/model_panel.h"

namespace handsight::app {

/// What the model panel shows: TCP->Body, the mount where it is estimated, and every effect of the catalogue. Of the
/// effects in the model the numbers of the shown fit; `diagnosis` (may be null) says what these poses cannot show.
std::vector<widgets::ModelEffect> model_effects(const Document& document, const Diagnosis* diagnosis);

/// The numbers of terms as rows with their prior sigmas; `sigmas` per term, may be empty.
std::vector<widgets::ModelParameter> effect_parameters(const Session& session, const std::vector<EffectTerm>& terms,
                                                       const std::vector<std::vector<double>>& sigmas);

/// "Observation 8 is left out: alone it is off by 131 px."; empty where none is.
QString lone_sentence(const ModelVersion& model);

/// "3 wrong points left out: observation 12, marker 1, left image, 5.2 px off; ..."
QString wrong_points_text(const ModelVersion& model, std::size_t most_named);

}  // namespace handsight::app
