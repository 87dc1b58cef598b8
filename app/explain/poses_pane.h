// SPDX-License-Identifier: GPL-3.0-or-later
// Poses that would tell two effects apart, or make the estimate surer: planned, shown, written as a table.
#pragma once

#include <QWidget>

#include "diagnosis/planning/planning.h"
#include "workbench/workbench.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace handsight::app {

class PosesPane : public QWidget {
  Q_OBJECT

 public:
  explicit PosesPane(Workbench& workbench, QWidget* parent = nullptr);

  /// Plans poses that tell a candidate of the present diagnosis from the first that it cannot be distinguished from;
  /// without an id, poses for precision.
  void plan_for(const std::string& id);
  const std::optional<Plan>& plan_shown() const { return plan_; }

 signals:
  void pose_chosen(const Eigen::VectorXd& position);
  void closed();

 private:
  void show_plan(const Plan& plan, const QString& what);
  void save();

  Workbench& workbench_;
  std::optional<Plan> plan_;
  QLabel *title_, *sentence_, *said_;
  QTableWidget* table_;
  QLineEdit* path_;
  QPushButton *save_, *back_;
};

}  // namespace handsight::app
