// SPDX-License-Identifier: GPL-3.0-or-later
// The rail of workspaces on the left: name, mark and one line of state each.
#pragma once

#include <QWidget>
#include <vector>

#include "frame/workspace.h"

namespace handsight::app {

class RailButton;

/// What a button of the rail shows.
struct RailEntry {
  QString name, icon, tip;
};

class Rail : public QWidget {
  Q_OBJECT

 public:
  explicit Rail(const std::vector<RailEntry>& entries, QWidget* parent = nullptr);
  void set_status(int index, const WorkStatus& status);
  void set_current(int index);
  int current() const { return current_; }

 signals:
  void chosen(int index);

 private:
  std::vector<RailButton*> buttons_;
  int current_ = 0;
};

}  // namespace handsight::app
