// SPDX-License-Identifier: GPL-3.0-or-later
// "Find the missing effect": a small panel that says the next thing to look at or to do, and points at it.
#pragma once

#include <QFrame>
#include <QPointer>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace handsight::app {

struct TourStep {
  QString text;
  std::function<QWidget*()> target;    // null: nothing is pointed at
  std::function<bool()> is_done = {};  // the step goes on by itself then; absent: by Next
};

class Tour : public QFrame {
  Q_OBJECT

 public:
  explicit Tour(QWidget* window);
  void start(std::vector<TourStep> steps);
  void stop();
  bool is_running() const { return !steps_.empty(); }
  int step() const { return step_; }
  /// Where the window stands changed: looks whether the step is done, and stays beside its target.
  void look();

 signals:
  void ended();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void go(int step);
  void place();

  std::vector<TourStep> steps_;
  int step_ = 0;
  QLabel *text_, *count_;
  QPushButton *next_, *close_;
  QFrame* ring_;
};

}  // namespace handsight::app
