// SPDX-License-Identifier: GPL-3.0-or-later
// The fit follows the document: every change of state is fitted in the background, stale fits are dropped.
#pragma once

#include <QObject>
#include <QTimer>

#include "document/document.h"
#include "jobs/jobs.h"

namespace handsight::app {

class Refit : public QObject {
  Q_OBJECT

 public:
  Refit(Document& document, Jobs& jobs, QObject* parent = nullptr);

  /// While held (a session is played, a marker dragged) nothing is fitted; what was missed is fitted at release.
  void hold();
  void release();
  /// Fits a state whose fit was stopped.
  void again() { schedule(); }
  bool is_pending() const { return timer_.isActive() || jobs_.is_busy("fit"); }

 private:
  void schedule();
  void start();
  void show(const ModelVersionPointer& known);

  Document& document_;
  Jobs& jobs_;
  QTimer timer_;
  int holds_ = 0;
};

}  // namespace handsight::app
