// SPDX-License-Identifier: GPL-3.0-or-later
// "Where it fails": the strongest pattern large, nine small plots in fixed places, what a brushed set has in common,
// and the what-if slider.
#pragma once

#include <QTimer>
#include <QWidget>
#include <map>

#include "explain/pattern_plots.h"

class QLabel;
class QPushButton;

namespace handsight::widgets {
class ScatterPlot;
class WhatIfSlider;
}  // namespace handsight::widgets

namespace handsight::app {

class FailingPane : public QWidget {
  Q_OBJECT

 public:
  explicit FailingPane(Workbench& bench, QWidget* parent = nullptr);

  /// The residuals that are shown (null: none yet). `fresh`: of another session; else places and axes stay.
  void show_residuals(std::shared_ptr<const ModelResiduals> residuals, bool fresh);
  /// Other points on the same axes while a key is held: noise alone, or another version. `title` says what they are.
  void show_instead(const ModelResiduals& residuals, const std::vector<Eigen::VectorXd>* values, const QString& title);
  void show_measured_again();
  /// What a candidate with these numbers would show; null: nothing is tried.
  void set_prediction(const EffectView* view, const Eigen::VectorXd& numbers);
  void set_progress(const QString& text);
  void refresh_shows();
  /// The same plots in another unit, on axes of their own.
  void refresh_units();
  /// Chooses the plot against this variable, where there is one.
  void show_variable(const std::string& variable);
  widgets::WhatIfSlider* what_if() const { return what_if_; }
  const ModelResiduals* residuals() const { return residuals_.get(); }
  const std::vector<PlotKey>& places() const { return places_; }
  void refresh_selection();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_layout();
  void connect_all();
  void choose_plot(int place);
  void fill_large();
  void find_next_shows();
  void resort();
  void look_for_common();
  std::vector<widgets::PatternPlot> plots(const ModelResiduals& residuals, const std::vector<Eigen::VectorXd>* values);

  Workbench& bench_;
  std::shared_ptr<const ModelResiduals> residuals_;
  std::vector<PlotKey> places_;
  std::vector<std::vector<widgets::TrendPoint>> predictions_;
  std::map<PlotKey, QString> shows_;  // the effects that show there
  bool is_instead_ = false;           // other points are shown while a key is held
  QTimer shows_timer_;                // finds them, one plot a turn: with a thousand observations it takes a while
  int chosen_ = 0;
  std::string common_variable_;
  widgets::ScatterPlot* large_;
  widgets::PatternPage* page_;
  widgets::WhatIfSlider* what_if_;
  QLabel *title_, *hint_;
  QPushButton *common_, *resort_;
};

}  // namespace handsight::app
