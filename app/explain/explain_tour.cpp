// SPDX-License-Identifier: GPL-3.0-or-later
// The tour "Find the missing effect".
#include "explain/explain_workspace.h"
#include "explain/missing_pane.h"
#include "widgets/explain/candidate_list.h"

namespace handsight::app {

Tour* ExplainWorkspace::tour() {
  if (!tour_) tour_ = new Tour(window());
  return tour_;
}

void ExplainWorkspace::start_tour() { tour()->start(tour_steps()); }

std::vector<TourStep> ExplainWorkspace::tour_steps() {
  const auto widget = [this](const char* name) { return [this, name] { return window()->findChild<QWidget*>(name); }; };
  const auto card = [this]() -> QWidget* {
    return missing_->cards()->count() > 0 ? missing_->cards()->card(0) : nullptr;
  };
  const auto index = workbench_.document.undo_stack().index();
  return {
      {tr("This line says what is most likely missing, what it would bring, and whose fault the error is. How large "
          "the "
          "error is, on poses that the model has not seen, and the noise beside it stand above, at the right."),
       widget("verdict")},
      {tr("Where does it fail, and why? Every observation against what the likeliest cause follows: the points lie on "
          "its "
          "curve. Hold N to see how noise alone would look."),
       widget("pattern_large")},
      {tr("Other patterns of the same residuals are in this tab. Click one to see it large; Shift and drag to ask what "
          "some observations have in common."),
       widget("tab_patterns")},
      {tr("What is missing? The likeliest cause comes first. Rest the pointer on the card: purple, dashed, everywhere, "
          "is "
          "what the model would do with it."),
       card},
      {tr("Add it: press the blue button. The fit runs before your eyes."), widget("add_first"),
       [this, index] { return workbench_.document.undo_stack().index() > index && !adding_.is_running(); }},
      {tr("The step down is the error on unseen poses. When it reaches the hatched floor, only noise is left. Ctrl+Z "
          "takes the step back."),
       widget("staircase")},
      {tr("The residuals of all corners, before and after. Hold B to blink between the two on the same axes."),
       widget("cloud")},
      {tr("The sizes that were found stand in the model panel, with what is plausible."), widget("model_panel")},
      {tr("A sample session knows what was hidden in it: Reveal the truth, in the session's menu, compares."),
       widget("session_menu")},
  };
}

}  // namespace handsight::app
