// SPDX-License-Identifier: GPL-3.0-or-later
// "Where it fails": the proof plots of what is looked at, and how they fall level once it is in the model.
#include <QLabel>
#include <QToolButton>

#include "explain/failing_pane.h"
#include "widgets/base/motion.h"
#include "widgets/explain/what_if_slider.h"
#include "widgets/plots/scatter_plot.h"

namespace handsight::app {

void FailingPane::say_proof() {
  const bool is_proof = shows_proof(), has_tabs = !proof_.is_empty() || !lead_.is_empty();
  for (QToolButton* tab : {tab_proof_, tab_patterns_}) tab->setVisible(has_tabs);
  tab_proof_->setChecked(is_proof);
  tab_proof_->setText((proof_.is_empty() ? lead_ : proof_).leads || added_ > 0 ? tr("The proof") : tr("Its plot"));
  tab_patterns_->setChecked(!is_proof);
  // One plot is the large one; a small copy of it would say nothing.
  page_->setVisible(!is_proof || proof_.plots.size() > 1);
  if (!is_proof) return say_patterns();
  const auto place = static_cast<std::size_t>(std::max(chosen_, 0));
  const ProofPlot* plot = place < proof_.plots.size() ? &proof_.plots[place] : nullptr;
  const bool is_followed = plot && followed(*plot) > least_followed;
  const QString title = added_ > 0                    ? tr("Where it failed")
                        : proof_.leads && is_followed ? tr("Where it fails: the proof")
                        : is_followed                 ? tr("What it would explain")
                                                      : tr("Tried: the points do not follow it");
  title_->setText(residuals_ ? titled(title, *residuals_) : title);
  hint_->setText(plot ? proof_sentence(*plot) : proof_.name);
}

void FailingPane::say_patterns() {
  const auto diagnosis = workbench_.find_diagnosis(workbench_.document.shown_model());
  const StoryState state = workbench_.story().state;
  const bool agrees = diagnosis && (state == StoryState::at_the_noise || state == StoryState::unnamed_at_the_noise ||
                                    state == StoryState::repeatability);
  const QString title = agrees ? tr("What is left") : tr("Where it fails");
  title_->setText(residuals_ ? titled(title, *residuals_) : title);
  const PlotKey* key = key_at(chosen_);
  const QString alone = agrees && key ? as_if_alone(*key, diagnosis->repeatability) : QString();
  hint_->setText(alone.isEmpty()
                     ? tr("Hold N: noise alone    Hold B: before and after    Shift + drag: what have these in common?")
                     : alone);
}

void FailingPane::choose_patterns(bool wanted) {
  if (wants_patterns_ == wanted) return say_proof();
  wants_patterns_ = wanted;
  if (!wanted && proof_.is_empty()) proof_ = lead_;
  chosen_ = 0;
  refill(true);
  say_proof();
}

/// A slider moves what the patterns would be.
bool FailingPane::shows_proof() const {
  return !proof_.is_empty() && !wants_patterns_ && !is_other_version_ && what_if_->isHidden();
}

void FailingPane::follow_mode() {
  if (!residuals_ || places_.empty() || is_proof_drawn_ == shows_proof()) return;
  chosen_ = 0;
  refill(true);
  say_proof();
}

bool FailingPane::is_lead_shown() const {
  return !lead_.is_empty() && added_ <= 0 && proof_.name == lead_.name && proof_.plots.size() == lead_.plots.size();
}

void FailingPane::show_lead(const Proof& proof) {
  const bool was_shown = is_lead_shown() || (proof_.is_empty() && lead_.is_empty());
  lead_ = proof;
  if (was_shown && !is_tried_ && !moment_.isActive()) put_proof(lead_);
  say_proof();
}

void FailingPane::show_proof(const Proof& proof) {
  if (moment_.isActive()) {
    waiting_ = proof;
    is_waiting_ = true;
    return;
  }
  is_tried_ = !proof.is_empty();
  if (is_tried_) return put_proof(proof);
  // What was added stays until something else is looked at, or leads.
  if (proof_.is_empty() || is_lead_shown() || (added_ > 0 && lead_.is_empty())) return follow_mode();
  say_proof();
  leaving_.start();
}

void FailingPane::leaveEvent(QEvent*) {
  if (!proof_.is_empty() && !is_tried_ && !is_lead_shown() && (added_ <= 0 || !lead_.is_empty()) && !moment_.isActive())
    leaving_.start();
}

void FailingPane::end_proof() {
  moment_.stop();
  leaving_.stop();
  is_waiting_ = is_tried_ = false;
  if (!proof_.is_empty() || !lead_.is_empty()) put_proof(lead_);
}

void FailingPane::put_proof(const Proof& proof) {
  falling_.stop();
  leaving_.stop();
  const bool is_same = added_ <= 0 && proof.name == proof_.name && proof.plots.size() == proof_.plots.size();
  proof_ = proof;
  added_ = 0;
  if (!is_same && !wants_patterns_) chosen_ = 0;
  refill(!is_same && !wants_patterns_);
  say_proof();
}

void FailingPane::show_proof_added(Proof proof) {
  lead_ = {};
  if (proof.is_empty()) return end_proof();
  const bool is_same = proof.name == proof_.name && !proof_.is_empty();
  proof.plots = in_same_order(proof_.plots, std::move(proof.plots));
  proof_ = std::move(proof);
  added_ = 0;
  wants_patterns_ = false;
  if (!is_same || static_cast<std::size_t>(chosen_) >= proof_.plots.size()) chosen_ = 0;
  refill(!is_same);
  is_waiting_ = false;
  moment_.start();
  if (widgets::motion_is_reduced()) return set_added(1);
  falling_.start();
}

/// On the axes of before: one sees it fall.
void FailingPane::set_added(double share) {
  added_ = share;
  if (residuals_) {
    page_->update_plots(all_plots(*residuals_, nullptr));
    fill_large();
  }
  say_proof();
}

}  // namespace handsight::app
