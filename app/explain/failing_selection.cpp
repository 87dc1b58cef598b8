// SPDX-License-Identifier: GPL-3.0-or-later
// "Where it fails": the observations that are chosen, and what they have in common.
#include <QPushButton>

#include "diagnosis/attribution/common.h"
#include "explain/failing_pane.h"
#include "widgets/plots/scatter_plot.h"
#include "words/core_words.h"

namespace handsight::app {

void FailingPane::refresh_selection() {
  const auto id = workbench_.selection.current().observation.value_or(widgets::no_observation);
  const auto& many = workbench_.selection.many();
  const std::vector<widgets::ObservationId> ids = many.size() > 1
                                                      ? std::vector<widgets::ObservationId>(many.begin(), many.end())
                                                      : std::vector<widgets::ObservationId>{};
  large_->set_selected(id);
  large_->set_highlighted(ids);
  page_->set_selected(id);
  page_->set_highlighted(ids);
  look_for_common();
}

void FailingPane::look_for_common() {
  common_->hide();
  common_variable_.clear();
  const auto& many = workbench_.selection.many();
  if (!residuals_ || many.size() < 2) return;
  const ResidualViews& v = residuals_->views;
  std::vector<char> chosen;
  for (const ProblemObservation& o : v.problem.observations)
    chosen.push_back(many.contains(id_at(workbench_.document.session(), o.index)) ? 1 : 0);
  auto list = what_is_common(v.variables, chosen);
  // What was dragged over is no news.
  if (const auto plot = plot_at(chosen_); plot && list.size() > 1)
    std::erase_if(list, [&](const Common& c) { return translated(v.variables[c.variable].name) == plot->against; });
  if (list.empty()) return;
  const Variable& variable = v.variables[list.front().variable];
  common_variable_ = variable.name.english();
  common_->setText(translated(common_text(list.front(), variable)));
  common_->setToolTip(tr("Shows the plot against it"));
  common_->show();
}

}  // namespace handsight::app
