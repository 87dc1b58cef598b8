// SPDX-License-Identifier: GPL-3.0-or-later
// Proof plots as the window shows and tells them.
#pragma once

#include "diagnosis/proof/proof.h"
#include "widgets/explain/pattern_page.h"
#include "workbench/workbench.h"

namespace handsight::app {

/// The proof plots of one effect, or of a curve, by the name under which they are shown.
struct Proof {
  QString name;        // "joint elasticity of arm_2"
  bool leads = false;  // it is the cause that the story goes by: the plot is its proof where the points follow it
  std::vector<ProofPlot> plots;

  bool is_empty() const { return plots.empty(); }
};

/// The points as they lie on the curve (`added` 0: the candidate, dashed, with the noise about it), on the way, or
/// level once it is in the model (`added` 1).
widgets::PatternPlot proof_plot(const ProofPlot& plot, const Workbench& workbench, double added);

/// "right_arm_2 gives way by 149.51 ± 0.59 µrad for each N m: 44 N m at most here, so 6.6 mrad, 5.8 mm at the hand."
QString proof_sentence(const ProofPlot& plot);

/// Does the cause do the same in every pose? Then the points follow nothing, they lie on a level line.
bool is_level(const ProofPlot& plot);

/// The same plot with what noise alone would put in the place of its points: the cause does nothing.
ProofPlot put_noise_in_place(ProofPlot plot, std::uint64_t seed);

/// The plots of `after` in the order of `before`, so that each stays in its place.
std::vector<ProofPlot> in_same_order(const std::vector<ProofPlot>& before, std::vector<ProofPlot> after);

}  // namespace handsight::app
