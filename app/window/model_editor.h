// SPDX-License-Identifier: GPL-3.0-or-later
// What the model panel's check boxes and numbers do.
#pragma once

#include <QObject>

#include "workbench/workbench.h"

namespace handsight::app {

class ModelEditor : public QObject {
  Q_OBJECT

 public:
  explicit ModelEditor(Workbench& workbench, QObject* parent = nullptr) : QObject(parent), workbench_(workbench) {}

  /// Adds an effect, estimated, where it explains most, or takes it out everywhere.
  void tick(const QString& id, bool in_model);
  void hold(const QString& id, bool held);
  /// One of all the effect's numbers, as the panel counts them.
  void hold_number(const QString& id, int number, bool held);
  /// A held number, in the unit that the panel shows.
  void type(const QString& id, int number, double value);

 private:
  Workbench& workbench_;
};

}  // namespace handsight::app
