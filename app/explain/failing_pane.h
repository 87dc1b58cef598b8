// SPDX-License-Identifier: GPL-3.0-or-later
// "Where it fails": the strongest pattern large, small plots in fixed places, what a brushed set has in common, the
// proof plots of the card that is looked at or was added, and the what-if slider.
#pragma once

#include <QTimer>
#include <QVariantAnimation>
#include <QWidget>
#include <map>

#include "findings/pattern_plots.h"
#include "findings/proof_plots.h"

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
  /// The proof plots of a card instead of the strongest pattern; the patterns stand beside them. Empty: it is no longer
  /// looked at, and patterns come again, but not while the pointer is here: who looks at the proof may touch it.
  void show_proof(const Proof& proof);
  /// The same plots on the same axes once it is in the model: the points go down to the level line, and stay there
  /// until another card is looked at, though for a moment at least.
  void show_proof_added(Proof proof);
  /// Patterns again, whatever was shown.
  void end_proof();
  const Proof& proof() const { return proof_; }
  bool is_proof_added() const { return added_ > 0; }
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
  void leaveEvent(QEvent* event) override;

 private:
  void make_layout();
  void connect_all();
  void choose_plot(int place);
  void fill_large();
  /// The plot in this place, as things are: of the proof, else of the patterns; nothing where there is none.
  std::optional<widgets::PatternPlot> plot_at(int place) const;
  std::vector<widgets::PatternPlot> all_plots(const ModelResiduals& residuals,
                                              const std::vector<Eigen::VectorXd>* values);
  const PlotKey* key_at(int place) const;
  void refill(bool fit_axes);
  void say_proof();
  void put_proof(const Proof& proof);
  void set_added(double share);
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
  Proof proof_, waiting_;             // shown; looked at while what was added still has its moment
  bool is_waiting_ = false, is_tried_ = false;
  double added_ = 0;  // share of the proof's curve that is taken off: 1 where it is in the model
  QVariantAnimation falling_;
  QTimer moment_, leaving_;
  int chosen_ = 0;  // of the plots as they are shown
  std::string common_variable_;
  widgets::ScatterPlot* large_;
  widgets::PatternPage* page_;
  widgets::WhatIfSlider* what_if_;
  QLabel *title_, *hint_;
  QPushButton* patterns_;  // back to the patterns
  QPushButton *common_, *resort_;
};

}  // namespace handsight::app
