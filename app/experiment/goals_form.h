// SPDX-License-Identifier: GPL-3.0-or-later
// When an experiment has found out enough, how fast it moves, and where: a small form.
#pragma once

#include <QWidget>

#include "experiment/loop/experiment.h"

class QCheckBox;
class QDoubleSpinBox;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace handsight::app {

class GoalsForm : public QWidget {
  Q_OBJECT

 public:
  explicit GoalsForm(QWidget* parent = nullptr);

  Goals until() const;
  double speed() const;  // rad/s (m/s)
  bool has_box() const;
  /// Goals, speed, box and cell. InputError where the box is no box or the cell's file cannot be read.
  ExperimentOptions options() const;
  /// What decides which poses there are stays as it is while an experiment is on.
  void set_places_enabled(bool enabled);

 private:
  void choose_cell();
  std::optional<WorkBox> box() const;

  QCheckBox *hand_, *odds_, *count_, *time_;
  QDoubleSpinBox *hand_mm_, *odds_value_, *minutes_, *speed_;
  QSpinBox* poses_;
  QLineEdit *box_, *cell_;
  QPushButton* choose_;
};

}  // namespace handsight::app
