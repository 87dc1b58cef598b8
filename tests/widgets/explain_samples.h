// SPDX-License-Identifier: Apache-2.0
// What the widgets of the Explain workspace show in tests and in the gallery: invented, but as a session would give it.
#pragma once

#include <vector>

#include "widgets/explain/candidate_card.h"
#include "widgets/explain/effect_table.h"
#include "widgets/explain/pattern_page.h"
#include "widgets/explain/residual_cloud.h"
#include "widgets/explain/staircase.h"
#include "widgets/explain/truth_panel.h"
#include "widgets/explain/verdict_line.h"
#include "widgets/explain/version_list.h"
#include "widgets/explain/what_if_slider.h"

namespace handsight::test {

widgets::SessionVerdict missing_verdict();
/// Nine plots of so many observations each; the first ones follow, the last ones do not.
std::vector<widgets::PatternPlot> nine_patterns(int observations);
/// Six corners an observation; `size` in px is what the model misses by, 0: noise of 0.2 px alone.
std::vector<widgets::CloudPoint> cloud(int observations, double size);
widgets::CardState elasticity_card();
widgets::CardState predicted_card();
widgets::CardState unnamed_card();
std::vector<widgets::CardState> honest_cards();
widgets::StaircaseState four_versions();
std::vector<widgets::VersionEntry> version_entries();
std::vector<widgets::EffectRow> effect_rows();
widgets::WhatIfState eccentricity();
std::vector<widgets::TruthRow> truth_rows();

}  // namespace handsight::test
