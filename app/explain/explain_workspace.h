// SPDX-License-Identifier: GPL-3.0-or-later
// Explain: compare, see where the model fails, learn what is missing, add it and watch.
#pragma once

#include <map>

#include "explain/adding.h"
#include "explain/tour.h"
#include "workbench/workspace.h"

namespace handsight::widgets {
class VerdictLine;
}

namespace handsight::app {

class FailingPane;
class MissingPane;
class WatchingPane;

class ExplainWorkspace : public Workspace {
  Q_OBJECT

 public:
  explicit ExplainWorkspace(Workbench& workbench, QWidget* parent = nullptr);

  std::vector<Action> own_actions() const override;
  WorkStatus status() const override;
  void activate() override;
  Adding& adding() { return adding_; }
  Tour* tour();

 protected:
  void hideEvent(QHideEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make_layout();
  void connect_panes();
  void connect_workbench();
  void refresh_all();
  /// The same one pane after the other, so that the window answers in between.
  void refresh_in_turns();
  void refresh_next();
  void refresh_plots();
  void refresh_lead();
  void refresh_units();
  void refresh_verdict();
  void try_candidate(const QString& id);
  void try_numbers(const CandidateView& view, const Eigen::VectorXd& numbers, const QString& name);
  QString title_of_candidate(const std::string& id) const;
  void stop_trying();
  void open_what_if(const QString& id, int place = -1);
  void renew_what_if();
  void slide_what_if(double value);
  void hold_noise(bool held);
  void hold_blink(bool held);
  void blink();
  void start_tour();
  std::vector<TourStep> tour_steps();

  Adding adding_;
  widgets::VerdictLine* verdict_;
  FailingPane* failing_;
  MissingPane* missing_;
  WatchingPane* watching_;
  Tour* tour_ = nullptr;
  bool is_fresh_ = true;
  QString trying_;
  ModelVersionPointer proof_model_;  // the model that the proof of what was added is of
  // What if: the effect, where it may sit, and how it would show there.
  std::string what_if_id_;
  std::vector<EffectTerm> what_if_places_;
  int what_if_place_ = 0, what_if_parameter_ = 0;
  CandidateView what_if_view_;
  std::uint64_t noise_seed_ = 1;
  bool shows_noise_ = false;
  QTimer blink_, in_turns_;
  int turn_ = 0;
  bool blink_phase_ = false;
};

}  // namespace handsight::app
