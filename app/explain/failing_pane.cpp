// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/failing_pane.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "diagnosis/common.h"
#include "widgets/explain/what_if_slider.h"
#include "widgets/scatter_plot.h"
#include "widgets/theme.h"

namespace handsight::app {

using widgets::PatternPage;
using widgets::ScatterPlot;

FailingPane::FailingPane(Workbench& bench, QWidget* parent) : QWidget(parent), bench_(bench) {
  make_layout();
  connect_all();
}

void FailingPane::make_layout() {
  title_ = new QLabel(tr("Where it fails"), this);
  title_->setFixedHeight(widgets::kControlHeight);
  title_->setFont(widgets::text_font(widgets::TextRole::title));
  resort_ = new QPushButton(tr("Order changed, sort again"), this);
  resort_->setObjectName("resort_plots");
  resort_->hide();
  large_ = new ScatterPlot(this);
  large_->setObjectName("pattern_large");
  large_->setMinimumHeight(110);
  large_->set_empty_text(tr("Waits for a fit."));
  hint_ = new QLabel(tr("Hold N: noise alone    Hold B: before and after    Shift + drag: what have these in common?"),
                     this);
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

/// With little height three plots that can be read are more than nine that cannot.
void FailingPane::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  constexpr int high_enough = 460, one_row = 108;
  const int rows = height() < high_enough ? 1 : 3;
  page_->setMaximumHeight(rows == 1 ? one_row : QWIDGETSIZE_MAX);
  page_->set_rows(rows);
}

void FailingPane::connect_all() {
  shows_timer_.setInterval(0);
  connect(&shows_timer_, &QTimer::timeout, this, &FailingPane::find_next_shows);
  connect(page_, &PatternPage::plot_selected, this, &FailingPane::choose_plot);
  connect(resort_, &QPushButton::clicked, this, &FailingPane::resort);
  const auto hover = [this](qint64 id) { bench_.selection.hover(id < 0 ? Selected{} : Selected{.observation = id}); };
  const auto brush = [this](const std::vector<qint64>& ids) { bench_.selection.select_many({ids.begin(), ids.end()}); };
  connect(page_, &PatternPage::observation_hovered, this, hover);
  connect(page_, &PatternPage::observations_selected, this, brush);
  connect(page_, &PatternPage::read_out, &bench_, &Workbench::pointed_at);
  connect(large_, &ScatterPlot::observation_selected, this,
          [this](qint64 id) { bench_.selection.select_observation(id); });
  connect(large_, &ScatterPlot::observation_hovered, this, hover);
  connect(large_, &ScatterPlot::observations_selected, this, brush);
  connect(large_, &ScatterPlot::read_out, &bench_, &Workbench::pointed_at);
  connect(common_, &QPushButton::clicked, this, [this] { show_variable(common_variable_); });
  connect(&bench_.selection, &Selection::changed, this, [this] {
    if (isVisible()) refresh_selection();
  });
  connect(&bench_.selection, &Selection::hover_changed, this, [this] {
    const auto id = bench_.selection.hovered().observation.value_or(widgets::kNoObservation);
    large_->set_hovered(id);
    page_->set_hovered(id);
  });
}

std::vector<widgets::PatternPlot> FailingPane::plots(const ModelResiduals& residuals,
                                                     const std::vector<Eigen::VectorXd>* values) {
  std::vector<widgets::PatternPlot> list;
  for (const PlotKey& key : places_) {
    auto plot = pattern_plot(key, residuals, bench_, values);
    if (!plot) continue;
    if (!values && &residuals == residuals_.get()) {
      const auto found = shows_.find(key);
      if (found == shows_.end() && !shows_timer_.isActive()) shows_timer_.start();
      if (found != shows_.end()) plot->shows = found->second;
    }
    list.push_back(std::move(*plot));
  }
  return list;
}

void FailingPane::show_residuals(std::shared_ptr<const ModelResiduals> residuals, bool fresh) {
  residuals_ = std::move(residuals);
  shows_.clear();
  is_instead_ = false;
  if (fresh) {
    places_.clear();
    resort_->hide();
    chosen_ = 0;
  }
  predictions_.clear();
  if (!residuals_) {
    large_->set_points({});
    large_->set_trend({});
    large_->set_title({});
    page_->set_plots({});
    return;
  }
  const std::vector<PlotKey> strongest = strongest_plots(*residuals_);
  const bool first = places_.empty();
  if (first) places_ = strongest;
  const auto diagnosis = bench_.diagnosing.diagnosis();
  const bool is_chance = (diagnosis && diagnosis->verdict == Verdict::adequate) || residuals_->patterns.empty() ||
                         residuals_->patterns.front().p_value > 1e-3;
  const bool same_first =
      is_chance || strongest.empty() || std::find(places_.begin(), places_.end(), strongest.front()) != places_.end();
  resort_->setVisible(!same_first);
  if (first) {
    page_->set_plots(plots(*residuals_, nullptr));
  } else {
    page_->update_plots(plots(*residuals_, nullptr));
  }
  page_->set_selected_plot(chosen_);
  fill_large();
  // The axes stay while the user looks, as long as they hold what is shown.
  first ? large_->fit() : large_->fit_if_outgrown();
  refresh_selection();
}

void FailingPane::resort() {
  if (!residuals_) return;
  places_ = strongest_plots(*residuals_);
  chosen_ = 0;
  page_->set_plots(plots(*residuals_, nullptr));
  page_->set_selected_plot(0);
  fill_large();
  large_->fit();
  resort_->hide();
}

void FailingPane::refresh_shows() {
  shows_.clear();
  shows_timer_.start();
}

void FailingPane::find_next_shows() {
  for (const PlotKey& key : places_)
    if (residuals_ && !shows_.contains(key)) {
      shows_[key] = effects_that_show(key, *residuals_, bench_.diagnosing);
      return;
    }
  shows_timer_.stop();
  if (residuals_ && !is_instead_) page_->update_plots(plots(*residuals_, nullptr));
}

void FailingPane::refresh_units() {
  if (!residuals_ || places_.empty()) return;
  page_->set_plots(plots(*residuals_, nullptr));
  page_->set_selected_plot(chosen_);
  fill_large();
  large_->fit();
  refresh_selection();
}

void FailingPane::choose_plot(int place) {
  if (place < 0 || place >= static_cast<int>(places_.size())) return;
  chosen_ = place;
  fill_large();
  large_->fit();
}

void FailingPane::fill_large() {
  if (!residuals_ || places_.empty()) return;
  const auto plot = pattern_plot(places_[static_cast<std::size_t>(chosen_)], *residuals_, bench_);
  if (!plot) return;
  large_->set_axes(plot->against, plot->x_unit, tr("residual"), plot->y_unit);
  large_->set_title(tr("%1 against %2").arg(plot->what.left(1).toUpper() + plot->what.mid(1), plot->against));
  large_->set_noise_band(plot->noise);
  large_->set_points(plot->points);
  large_->set_trend(plot->trend);
  const auto c = static_cast<std::size_t>(chosen_);
  large_->set_candidate(c < predictions_.size() ? predictions_[c] : std::vector<widgets::TrendPoint>{});
}

void FailingPane::show_instead(const ModelResiduals& residuals, const std::vector<Eigen::VectorXd>* values,
                               const QString& title) {
  if (places_.empty()) return;
  is_instead_ = true;
  page_->update_plots(plots(residuals, values));
  const auto plot = pattern_plot(places_[static_cast<std::size_t>(chosen_)], residuals, bench_, values);
  if (!plot) return;
  large_->set_points(plot->points);
  large_->set_trend(plot->trend);
  large_->set_title(title);
}

void FailingPane::show_measured_again() {
  is_instead_ = false;
  if (!residuals_ || places_.empty()) return;
  page_->update_plots(plots(*residuals_, nullptr));
  fill_large();
}

void FailingPane::set_prediction(const EffectView* view, const Eigen::VectorXd& numbers) {
  predictions_.clear();
  const auto unit = bench_.units.unit();
  if (view && residuals_)
    for (const PlotKey& key : places_) predictions_.push_back(predicted_trend(key, *residuals_, *view, numbers, unit));
  page_->set_candidates(predictions_);
  const auto c = static_cast<std::size_t>(chosen_);
  large_->set_candidate(c < predictions_.size() ? predictions_[c] : std::vector<widgets::TrendPoint>{});
}

void FailingPane::set_progress(const QString& text) { page_->set_progress(text); }

void FailingPane::show_variable(const std::string& variable) {
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (places_[i].variable == variable) {
      page_->set_selected_plot(static_cast<int>(i));
      return choose_plot(static_cast<int>(i));
    }
  // A variable that has no place yet takes the last one.
  if (!residuals_ || places_.empty()) return;
  for (const Pattern& p : residuals_->patterns) {
    if (residuals_->views.variables[p.variable].name != variable) continue;
    places_.back() = {residuals_->views.series[p.series].name, variable};
    page_->update_plots(plots(*residuals_, nullptr));
    page_->set_selected_plot(static_cast<int>(places_.size()) - 1);
    return choose_plot(static_cast<int>(places_.size()) - 1);
  }
}

void FailingPane::refresh_selection() {
  const auto id = bench_.selection.current().observation.value_or(widgets::kNoObservation);
  const auto& many = bench_.selection.many();
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
  const auto& many = bench_.selection.many();
  if (!residuals_ || many.size() < 2) return;
  const ResidualViews& v = residuals_->views;
  std::vector<char> chosen;
  for (const ProblemObservation& o : v.problem.observations)
    chosen.push_back(many.contains(id_at(bench_.document.session(), o.index)) ? 1 : 0);
  auto list = what_is_common(v.variables, chosen);
  // What was dragged over is no news.
  if (list.size() > 1 && !places_.empty())
    std::erase_if(list, [&](const Common& c) {
      return v.variables[c.variable].name == places_[static_cast<std::size_t>(chosen_)].variable;
    });
  if (list.empty()) return;
  const Variable& variable = v.variables[list.front().variable];
  common_variable_ = variable.name;
  common_->setText(QString::fromStdString(common_text(list.front(), variable)));
  common_->setToolTip(tr("Shows the plot against it"));
  common_->show();
}

}  // namespace handsight::app
