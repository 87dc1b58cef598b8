// SPDX-License-Identifier: GPL-3.0-or-later
// The line at the top: session menu, undo and redo, what runs, the three numbers.
#pragma once

#include <QTimer>
#include <QWidget>

#include "workbench/actions.h"
#include "workbench/workbench.h"

class QLabel;
class QMenu;
class QProgressBar;
class QToolButton;

namespace handsight::widgets {
class ThreeNumbers;
}

namespace handsight::app {

class Header : public QWidget {
  Q_OBJECT

 public:
  Header(Workbench& workbench, const Actions& actions, QMenu* session_menu, QWidget* parent = nullptr);
  widgets::ThreeNumbers* numbers() const { return numbers_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void share_room();
  void refresh_session();
  Jobs& shown_jobs() const;
  void refresh_job();
  void refresh_numbers();

  Workbench& workbench_;
  const Actions& actions_;
  QToolButton *session_, *undo_, *redo_, *cancel_;
  QLabel* job_;
  QProgressBar* progress_;
  widgets::ThreeNumbers* numbers_;
  std::vector<ModelVersionPointer> stairs_;  // as they are drawn there
  QTimer poll_;
};

}  // namespace handsight::app
