// SPDX-License-Identifier: GPL-3.0-or-later
// What another program wrote into the session where it collides with what was done here: both, side by side, and which
// of the two counts. It takes the place of a workspace until it is decided or put off.
#pragma once

#include "workbench/workspace.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace handsight::app {

class MergePage : public Workspace {
  Q_OBJECT

 public:
  MergePage(Workbench& workbench, QWidget* parent);

  WorkStatus status() const override { return {}; }
  Panel panel() const override { return Panel::folded; }
  void activate() override { refresh(); }
  bool key(QKeyEvent* event) override;

 signals:
  /// It is put off, or nothing is left to decide.
  void done();

 private:
  void make_layout();
  void refresh();
  void choose(int row, bool mine);
  void choose_all(bool mine);
  void show_choices();
  void decide();

  std::vector<bool> mine_;  // by collision
  QLabel *title_, *sentence_, *refusal_;
  QTableWidget* table_;
  QPushButton *all_mine_, *all_theirs_, *decide_, *later_;
};

/// One side of a collision in words: "3 markers by hand", "excluded: by the user", "removed".
QString collision_text(const Collision& collision, bool mine);

}  // namespace handsight::app
