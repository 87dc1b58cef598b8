// SPDX-License-Identifier: GPL-3.0-or-later
// The sessions of a collection, each with its mark, its error and a switch that shows or hides it everywhere; hidden
// where one session is open.
#pragma once

#include <QFrame>
#include <vector>

#include "workbench/workbench.h"

class QHBoxLayout;
class QToolButton;

namespace handsight::app {

class SessionsBar : public QFrame {
  Q_OBJECT

 public:
  explicit SessionsBar(Workbench& workbench, QWidget* parent = nullptr);

 signals:
  void add_wanted();
  void shared_wanted();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void rebuild();
  void refresh();
  void fit_names();
  QToolButton* button(const char* name, const QString& text, const QString& tip);

  Workbench& workbench_;
  QHBoxLayout* row_;
  std::vector<QToolButton*> sessions_;
  QStringList names_;  // with their errors, in full
  QToolButton *marks_, *shared_, *add_;
};

}  // namespace handsight::app
