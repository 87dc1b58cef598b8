// SPDX-License-Identifier: GPL-3.0-or-later
// Reveal the truth: what was hidden in a sample session, beside what the model has found. Nothing else reads it.
#pragma once

#include "widgets/explain/truth_panel.h"
#include "workbench/workbench.h"

namespace handsight::app {

struct Truth {
  std::vector<EffectTerm> effects;
  std::vector<std::pair<std::string, std::string>> curves;  // joint, formula: what no effect of the catalogue describes
};

bool knows_truth(const Session& session);
/// InputError where truth.xml cannot be read.
Truth read_truth(const Session& session);

struct TruthComparison {
  std::vector<widgets::TruthRow> rows;
  QString sentence;
};

/// `diagnosis` (may be null) says whether an unnamed curve is known to be left.
TruthComparison compare_with_truth(const Session& session, const Truth& truth, const Fit& fit,
                                   const Diagnosis* diagnosis);

}  // namespace handsight::app
