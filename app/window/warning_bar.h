// SPDX-License-Identifier: GPL-3.0-or-later
// What is odd in the session that was opened, above the workspaces until it is put away.
#pragma once

#include <QFrame>

#include "workbench/workbench.h"

class QLabel;

namespace handsight::app {

class WarningBar : public QFrame {
  Q_OBJECT

 public:
  explicit WarningBar(Workbench& workbench, QWidget* parent = nullptr);
  const QStringList& sentences() const { return sentences_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void look_through();
  void look_at_model();
  void refresh();

  Workbench& workbench_;
  QStringList sentences_;
  QString of_model_;
  bool is_put_away_ = false;
  QLabel* label_;
};

}  // namespace handsight::app
