// SPDX-License-Identifier: GPL-3.0-or-later
// The rows above an experiment: the driver's command, what is going on, and the buttons that begin, confirm and stop.
#pragma once

#include <QWidget>

#include "experiment/experiment_run.h"

class QComboBox;
class QFrame;
class QLabel;
class QPushButton;

namespace handsight::app {

class StopButton;

class ControlBar : public QWidget {
  Q_OBJECT

 public:
  explicit ControlBar(ExperimentRun& run, QWidget* parent = nullptr);

  QString command() const;
  void set_command(const QString& command);
  /// Why the session cannot be measured by a driver; empty: it can.
  void set_hindrance(const QString& sentence);
  /// A recheck is begun in place of an experiment.
  void set_recheck(bool recheck);
  /// What is said while no robot is connected: why the last one ended. Empty: what to do first.
  void set_said(const QString& sentence, bool is_bad);
  /// Asks whether the robot may move; the answer is start_wanted, or the question goes again.
  void ask(const QString& question);
  bool is_asking() const { return is_asking_; }
  void take_back();
  void refresh();

 signals:
  void begin_wanted();
  void question_wanted();
  void start_wanted();
  void disconnect_wanted();
  void try_wanted();

 private:
  void make_layout();
  void fill_recent();

  ExperimentRun& run_;
  QComboBox* driver_;
  QPushButton *try_, *begin_, *end_, *yes_, *no_;
  StopButton* stop_;
  QFrame* state_box_;
  QLabel* state_;
  QString hindrance_, said_;
  bool is_recheck_ = false, is_asking_ = false, is_bad_ = false;
};

}  // namespace handsight::app
