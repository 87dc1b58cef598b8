// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/failing_pane.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "document/effect_words.h"
#include "widgets/base/theme.h"
#include "widgets/explain/what_if_slider.h"
#include "widgets/plots/scatter_plot.h"
#include "workbench/link_selection.h"

namespace handsight::app {

using widgets::PatternPage;
using widgets::ScatterPlot;

FailingPane::FailingPane(Workbench& workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {
  make_layout();
  connect_all();
  say_proof();
}

void FailingPane::make_layout() {
  title_ = new QLabel(tr("Where it fails"), this);
  title_->setObjectName("failing_title");
  title_->setFixedHeight(widgets::control_height);
  title_->setFont(widgets::text_font(widgets::TextRole::title));
  const auto tab = [this](const QString& text, const char* name) {
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setText(text);
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->hide();
    return button;
  };
  tab_proof_ = tab(tr("The proof"), "tab_proof");
  tab_patterns_ = tab(tr("Other patterns"), "tab_patterns");
  resort_ = new QPushButton(tr("Show strongest first"), this);
  resort_->setObjectName("resort_plots");
  resort_->hide();
  large_ = new ScatterPlot(this);
  large_->setObjectName("pattern_large");
  large_->setMinimumHeight(110);
  large_->set_empty_text(tr("Waits for a fit."));
  hint_ = new QLabel(this);
  hint_->setObjectName("proof_sentence");
  hint_->setFont(widgets::text_font(widgets::TextRole::small));
  hint_->setWordWrap(true);
  common_ = new QPushButton(this);
  common_->setObjectName("common");
  common_->setFlat(true);
  common_->setStyleSheet("text-align: left; padding: 2px 4px;");
  common_->hide();
  what_if_ = new widgets::WhatIfSlider(this);
  what_if_->setObjectName("what_if");
  what_if_->hide();
  page_ = new PatternPage(this);
  page_->setObjectName("pattern_page");
  page_->set_empty_text(tr("The residuals against what they may follow come here."));
  auto* head = new QHBoxLayout;
  head->addWidget(title_);
  head->addStretch(1);
  head->addWidget(resort_);
  head->addWidget(tab_proof_);
  head->addWidget(tab_patterns_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addLayout(head);
  layout->addWidget(large_, 5);
  layout->addWidget(hint_);
  layout->addWidget(common_);
  layout->addWidget(page_, 4);
  setMinimumSize(420, 330);  // what comes and goes inside must not make the window grow
}

/// With little height three plots that can be read are more than six that cannot.
void FailingPane::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  lay_out_page();
}

/// What one row of plots does not need is the large one's: a proof of three plots leaves no empty row.
void FailingPane::lay_out_page() {
  constexpr int high_enough = 460, lowest_row = 108, highest_row = 160;
  const bool has_room = height() >= high_enough;
  const bool one_row = !has_room || (shows_proof() && proof_.plots.size() <= 3);
  const int row = has_room ? std::clamp(height() / 5, lowest_row, highest_row) : lowest_row;
  page_->setMaximumHeight(one_row ? row : QWIDGETSIZE_MAX);
  page_->set_rows(one_row ? 1 : 2);
}

void FailingPane::connect_all() {
  shows_timer_.setInterval(0);
  falling_.setDuration(600);
  falling_.setStartValue(0.0);
  falling_.setEndValue(1.0);
  falling_.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&falling_, &QVariantAnimation::valueChanged, this, [this](const QVariant& v) { set_added(v.toDouble()); });
  leaving_.setSingleShot(true);
  leaving_.setInterval(300);
  connect(&leaving_, &QTimer::timeout, this, [this] {
    if (!underMouse()) end_proof();
  });
  moment_.setSingleShot(true);
  moment_.setInterval(2500);
  connect(&moment_, &QTimer::timeout, this, [this] {
    if (std::exchange(is_waiting_, false)) return show_proof(std::exchange(waiting_, {}));
    if (!lead_.is_empty() && !is_tried_) leaving_.start();
  });
  connect(tab_proof_, &QToolButton::clicked, this, [this] { choose_patterns(false); });
  connect(tab_patterns_, &QToolButton::clicked, this, [this] { choose_patterns(true); });
  connect(&shows_timer_, &QTimer::timeout, this, &FailingPane::find_next_shows);
  connect(page_, &PatternPage::plot_selected, this, &FailingPane::choose_plot);
  connect(resort_, &QPushButton::clicked, this, &FailingPane::resort);
  link_selection(page_, workbench_);
  link_selection(large_, workbench_);
  connect(common_, &QPushButton::clicked, this, [this] { show_variable(common_variable_); });
  connect(&workbench_.diagnosing, &Diagnosing::diagnosis_changed, this, &FailingPane::say_proof);
  connect(&workbench_, &Workbench::blunders_changed, this, &FailingPane::refresh_shows);
  connect(&workbench_.selection, &Selection::changed, this, [this] {
    if (isVisible()) refresh_selection();
  });
  connect(&workbench_.selection, &Selection::hover_changed, this, [this] {
    const auto id = workbench_.selection.hovered().observation.value_or(widgets::no_observation);
    large_->set_hovered(id);
    page_->set_hovered(id);
  });
}

std::vector<widgets::PatternPlot> FailingPane::plots(const ModelResiduals& residuals,
                                                     const std::vector<Eigen::VectorXd>* values) {
  std::vector<widgets::PatternPlot> list;
  for (const PlotKey& key : places_) {
    auto plot = pattern_plot(key, residuals, workbench_, values);
    if (!plot) continue;
    if (!values && &residuals == residuals_.get()) {
      const auto found = shows_.find(key);
      if (found == shows_.end() && named_cause() && !shows_timer_.isActive()) shows_timer_.start();
      if (found != shows_.end()) plot->shows = found->second;
    }
    list.push_back(std::move(*plot));
  }
  return list;
}

void FailingPane::show_residuals(std::shared_ptr<const ModelResiduals> residuals, bool fresh) {
  residuals_ = std::move(residuals);
  shows_.clear();
  is_instead_ = is_other_version_ = false;
  if (fresh) {
    places_.clear();
    resort_->hide();
    chosen_ = 0;
    wants_patterns_ = false;
  }
  predictions_.clear();
  if (fresh || !residuals_) {
    moment_.stop();
    falling_.stop();
    is_waiting_ = false;
    proof_ = lead_ = {};
    added_ = 0;
    say_proof();
  }
  if (!residuals_) {
    large_->set_points({});
    large_->set_trend({});
    large_->set_title({});
    page_->set_plots({});
    return;
  }
  say_proof();
  const std::vector<PlotKey> strongest = strongest_plots(*residuals_);
  const bool is_sorted = has_to_be_sorted();
  if (is_sorted) sort_places();
  const bool is_other = !is_sorted && replace_missing(strongest);
  const bool same_first = follows_by_chance(*residuals_) || strongest.empty() ||
                          std::find(places_.begin(), places_.end(), strongest.front()) != places_.end();
  resort_->setVisible(!same_first && !shows_proof());
  // The axes stay while the user looks, as long as they hold what is shown.
  refill(is_sorted || is_other);
  refresh_selection();
}

/// Nothing jumps while somebody looks. But what was sorted by what a later model left (the session was opened so, and
/// the model was taken back) or where nothing followed anything is no order of what fails now.
bool FailingPane::has_to_be_sorted() const {
  if (places_.empty()) return true;
  const bool was_taken_back = workbench_.document.undo_stack().index() < order_of_;
  return was_taken_back || (is_order_of_chance_ && !follows_by_chance(*residuals_));
}

/// With other effects in the model another motion may be looked at: what is not there any more gives its place to the
/// strongest that has none.
bool FailingPane::replace_missing(const std::vector<PlotKey>& strongest) {
  const std::size_t before = places_.size();
  std::erase_if(places_, [this](const PlotKey& key) { return !pattern_plot(key, *residuals_, workbench_); });
  if (places_.size() == before) return false;
  for (const PlotKey& key : strongest)
    if (places_.size() < before && std::find(places_.begin(), places_.end(), key) == places_.end())
      places_.push_back(key);
  chosen_ = 0;
  return true;
}

void FailingPane::sort_places() {
  places_ = strongest_plots(*residuals_);
  order_of_ = workbench_.document.undo_stack().index();
  is_order_of_chance_ = follows_by_chance(*residuals_);
  chosen_ = 0;
}

void FailingPane::resort() {
  if (!residuals_) return;
  sort_places();
  refill(true);
  resort_->hide();
}

void FailingPane::refresh_shows() {
  shows_.clear();
  shows_timer_.start();
}

/// What the verdict names: other names beside it would be another story. Of a session with a mistake it names none.
const StoryCause* FailingPane::named_cause() const {
  return workbench_.blunders().empty() ? workbench_.story().lead() : nullptr;
}

void FailingPane::find_next_shows() {
  const StoryCause* lead = named_cause();
  for (const PlotKey& key : places_)
    if (residuals_ && lead && !shows_.contains(key)) {
      shows_[key] =
          shows_there(key, *residuals_, workbench_.diagnosing, lead->id) ? effect_text(lead->id, {}) : QString();
      return;
    }
  shows_timer_.stop();
  if (residuals_ && !is_instead_) page_->update_plots(all_plots(*residuals_, nullptr));
}

void FailingPane::refresh_units() {
  if (!residuals_ || places_.empty()) return;
  refill(true);
  refresh_selection();
}

std::vector<widgets::PatternPlot> FailingPane::all_plots(const ModelResiduals& residuals,
                                                         const std::vector<Eigen::VectorXd>* values) {
  std::vector<widgets::PatternPlot> list;
  if (shows_proof()) {
    for (const ProofPlot& p : proof_.plots) list.push_back(proof_plot(p, workbench_, added_));
    return list;
  }
  list = plots(residuals, values);
  for (std::size_t i = 0; i < std::min(list.size(), predictions_.size()); ++i) list[i].candidate = predictions_[i];
  return list;
}

void FailingPane::refill(bool fit_axes) {
  if (!residuals_) return;
  is_proof_drawn_ = shows_proof();
  lay_out_page();
  if (fit_axes) {
    page_->set_plots(all_plots(*residuals_, nullptr));
  } else {
    page_->update_plots(all_plots(*residuals_, nullptr));
  }
  page_->set_selected_plot(chosen_);
  fill_large();
  fit_axes ? large_->fit() : large_->fit_if_outgrown();
}

const PlotKey* FailingPane::key_at(int place) const {
  const auto pattern = static_cast<std::size_t>(place);
  return place >= 0 && !shows_proof() && pattern < places_.size() ? &places_[pattern] : nullptr;
}

std::optional<widgets::PatternPlot> FailingPane::plot_at(int place) const {
  if (!residuals_ || place < 0) return std::nullopt;
  if (shows_proof())
    return static_cast<std::size_t>(place) < proof_.plots.size()
               ? std::optional(proof_plot(proof_.plots[static_cast<std::size_t>(place)], workbench_, added_))
               : std::nullopt;
  const PlotKey* key = key_at(place);
  if (!key) return std::nullopt;
  auto plot = pattern_plot(*key, *residuals_, workbench_);
  const auto at = static_cast<std::size_t>(key - places_.data());
  if (plot && at < predictions_.size()) plot->candidate = predictions_[at];
  return plot;
}

void FailingPane::choose_plot(int place) {
  if (!plot_at(place)) return;
  chosen_ = place;
  fill_large();
  large_->fit();
  say_proof();
}

void FailingPane::fill_large() {
  const auto plot = plot_at(chosen_);
  if (!plot) return;
  const bool is_proof = shows_proof();
  large_->set_axes(plot->against, plot->x_unit, is_proof ? plot->what : tr("residual"), plot->y_unit);
  const QString title = tr("%1 against %2").arg(plot->what.left(1).toUpper() + plot->what.mid(1), plot->against);
  large_->set_title(is_proof && added_ >= 1 ? tr("In the model: %1").arg(title) : title);
  large_->set_noise_band(plot->noise, !is_proof || added_ >= 1);
  large_->set_points(plot->points);
  large_->set_trend(plot->trend);
  large_->set_candidate(plot->candidate);
}

void FailingPane::put_points(const std::optional<widgets::PatternPlot>& plot, const QString& title) {
  if (!plot) return;
  large_->set_points(plot->points);
  large_->set_trend(plot->trend);
  large_->set_title(title);
}

void FailingPane::show_noise(std::uint64_t seed, const QString& title) {
  if (!residuals_ || places_.empty()) return;
  is_instead_ = true;
  if (!shows_proof()) {
    const auto values = noise_alone(residuals_->views, seed);
    page_->update_plots(all_plots(*residuals_, &values));
    const PlotKey* key = key_at(chosen_);
    return put_points(key ? pattern_plot(*key, *residuals_, workbench_, &values) : std::nullopt, title);
  }
  std::vector<widgets::PatternPlot> list;
  for (const ProofPlot& p : proof_.plots) list.push_back(proof_plot(put_noise_in_place(p, seed), workbench_, 0));
  put_points(list[static_cast<std::size_t>(chosen_)], title);
  page_->update_plots(std::move(list));
}

void FailingPane::show_instead(const ModelResiduals& residuals, const QString& title) {
  if (places_.empty()) return;
  const bool was_proof = shows_proof();
  is_instead_ = is_other_version_ = true;
  if (was_proof) {
    chosen_ = 0;
    refill(true);  // the axes are those of the model that is shown, for both
  }
  page_->update_plots(all_plots(residuals, nullptr));
  const PlotKey* key = key_at(chosen_);
  put_points(key ? pattern_plot(*key, residuals, workbench_) : std::nullopt, title);
}

void FailingPane::show_measured_again() {
  is_instead_ = false;
  const bool comes_back = std::exchange(is_other_version_, false) && shows_proof();
  if (!residuals_ || places_.empty()) return;
  if (comes_back) chosen_ = 0;
  if (comes_back) return refill(true);
  page_->update_plots(all_plots(*residuals_, nullptr));
  fill_large();
}

void FailingPane::set_prediction(const EffectView* view, const Eigen::VectorXd& numbers) {
  follow_mode();
  predictions_.clear();
  const auto unit = workbench_.units.unit();
  if (view && residuals_)
    for (const PlotKey& key : places_) predictions_.push_back(predicted_trend(key, *residuals_, *view, numbers, unit));
  std::vector<std::vector<widgets::TrendPoint>> all = predictions_;
  if (shows_proof()) {
    all.clear();
    for (const ProofPlot& p : proof_.plots) all.push_back(proof_plot(p, workbench_, added_).candidate);
  }
  page_->set_candidates(all);
  if (const auto plot = plot_at(chosen_)) large_->set_candidate(plot->candidate);
}

void FailingPane::set_progress(const QString& text) { page_->set_progress(text); }

void FailingPane::show_variable(const std::string& variable) {
  if (!residuals_ || places_.empty()) return;
  choose_patterns(true);
  const auto choose = [&](int place) {
    page_->set_selected_plot(place);
    choose_plot(place);
  };
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (places_[i].variable == variable) return choose(static_cast<int>(i));
  // A variable that has no place yet takes the last one.
  for (const Pattern& p : residuals_->patterns) {
    if (residuals_->views.variables[p.variable].name.english() != variable) continue;
    places_.back() = {residuals_->views.series[p.series].name, variable};
    page_->update_plots(all_plots(*residuals_, nullptr));
    return choose(static_cast<int>(places_.size()) - 1);
  }
}

}  // namespace handsight::app
