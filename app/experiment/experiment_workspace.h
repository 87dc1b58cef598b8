// SPDX-License-Identifier: GPL-3.0-or-later
// The Experiment workspace: a robot that is driven by the program, to measure it or to ask a calibration whether it
// still holds.
#pragma once

#include "experiment/experiment_run.h"
#include "workbench/workspace.h"

class QTabWidget;

namespace handsight::app {

class ControlBar;
class ExperimentPage;
class RecheckPage;

class ExperimentWorkspace : public Workspace {
  Q_OBJECT

 public:
  explicit ExperimentWorkspace(Workbench& workbench, QWidget* parent = nullptr);
  ~ExperimentWorkspace() override;

  WorkStatus status() const override;
  Panel panel() const override { return Panel::folded; }
  void activate() override;
  bool key(QKeyEvent* event) override;
  std::vector<Action> own_actions() const override;
  ExperimentRun& run() { return run_; }
  ExperimentPage& page() { return *page_; }

 protected:
  /// Esc stops a robot that moves, whatever has the focus in the window.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make_layout();
  void connect_run();
  void set_session();
  void begin();
  void ask();
  void try_it();
  bool is_recheck() const;

  ExperimentRun run_;
  ControlBar* bar_;
  QTabWidget* tabs_;
  ExperimentPage* page_;
  RecheckPage* recheck_;
  bool begun_as_recheck_ = false;
  int measured_ = 0;  // since the session was opened
};

}  // namespace handsight::app
