// SPDX-License-Identifier: GPL-3.0-or-later
// "Where it fails": the proof of the cause that leads, or of the card that is looked at or was added; in a second tab,
// and alone where no cause leads, the strongest patterns in fixed places. What a brushed set has in common, and the
// what-if slider.
#pragma once

#include <QTimer>
#include <QVariantAnimation>
#include <QWidget>
#include <map>

#include "findings/pattern_plots.h"
#include "findings/proof_plots.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace handsight::widgets {
class ScatterPlot;
class WhatIfSlider;
}  // namespace handsight::widgets

namespace handsight::app {

class FailingPane : public QWidget {
  Q_OBJECT

 public:
  explicit FailingPane(Workbench& workbench, QWidget* parent = nullptr);

  /// The residuals that are shown (null: none yet). `fresh`: of another session; else places and axes stay.
  void show_residuals(std::shared_ptr<const ModelResiduals> residuals, bool fresh);
  /// Other points while a key is held, `title` says what they are: noise alone on the same axes; the patterns of
  /// another version.
  void show_noise(std::uint64_t seed, const QString& title);
  void show_instead(const ModelResiduals& residuals, const QString& title);
  void show_measured_again();
  /// What a candidate with these numbers would show; null: nothing is tried.
  void set_prediction(const EffectView* view, const Eigen::VectorXd& numbers);
  /// The proof of the cause that leads: it is shown while no other card is looked at. Empty: none leads.
  void show_lead(const Proof& proof);
  /// The proof plots of a card that is looked at. Empty: it is no longer, and what leads comes again, or the patterns,
  /// but not while the pointer is here: who looks at the proof may touch it.
  void show_proof(const Proof& proof);
  /// The same plots on the same axes once it is in the model: the points go down to the level line, and stay there
  /// until another card is looked at, though for a moment at least.
  void show_proof_added(Proof proof);
  /// What leads again, or the patterns, whatever was shown.
  void end_proof();
  const Proof& proof() const { return proof_; }
  bool is_proof_added() const { return added_ > 0; }
  /// Are the plots those of a proof, not the patterns?
  bool shows_proof() const;
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
  void lay_out_page();
  void connect_all();
  void choose_plot(int place);
  void fill_large();
  /// The plot in this place, as things are: of the proof, else of the patterns; nothing where there is none.
  std::optional<widgets::PatternPlot> plot_at(int place) const;
  std::vector<widgets::PatternPlot> all_plots(const ModelResiduals& residuals,
                                              const std::vector<Eigen::VectorXd>* values);
  const PlotKey* key_at(int place) const;
  void put_points(const std::optional<widgets::PatternPlot>& plot, const QString& title);
  void refill(bool fit_axes);
  void say_proof();
  void say_patterns();
  void choose_patterns(bool wanted);
  bool is_lead_shown() const;
  /// Draws proof or patterns anew where the other of them is to be shown now.
  void follow_mode();
  /// The strongest first, as these residuals have them.
  void sort_places();
  bool replace_missing(const std::vector<PlotKey>& strongest);
  bool has_to_be_sorted() const;
  void put_proof(const Proof& proof);
  void set_added(double share);
  const StoryCause* named_cause() const;
  void find_next_shows();
  void resort();
  void look_for_common();
  std::vector<widgets::PatternPlot> plots(const ModelResiduals& residuals, const std::vector<Eigen::VectorXd>* values);

  Workbench& workbench_;
  std::shared_ptr<const ModelResiduals> residuals_;
  std::vector<PlotKey> places_;
  std::vector<std::vector<widgets::TrendPoint>> predictions_;
  std::map<PlotKey, QString> shows_;  // the effects that show there
  bool is_instead_ = false;           // other points are shown while a key is held
  bool is_other_version_ = false;     // they are those of another version
  bool is_order_of_chance_ = false;   // the places were sorted where nothing followed anything
  int order_of_ = 0;                  // and after so many actions
  QTimer shows_timer_;                // finds them, one plot a turn: with a thousand observations it takes a while
  Proof lead_, proof_, waiting_;      // leads; shown; looked at while what was added still has its moment
  bool wants_patterns_ = false;       // the user has chosen their tab
  bool is_proof_drawn_ = false;
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
  QToolButton *tab_proof_, *tab_patterns_;
  QPushButton *common_, *resort_;
};

}  // namespace handsight::app
