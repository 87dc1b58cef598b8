// SPDX-License-Identifier: GPL-3.0-or-later
// Does a calibration still hold? The e-value and each number over time, from the log of recheck, and one more recheck.
#pragma once

#include <QWidget>

#include "experiment/experiment_run.h"
#include "experiment/recheck/recheck_log.h"

class QComboBox;
class QLayout;
class QLabel;
class QLineEdit;

namespace handsight::widgets {
class HistoryPlot;
}

namespace handsight::app {

class RecheckPage : public QWidget {
  Q_OBJECT

 public:
  explicit RecheckPage(Workbench& workbench, QWidget* parent = nullptr);

  void set_session();
  /// Adds what a recheck needs: the poses that tell most, and the log. InputError where no calibration is chosen.
  void complete(RunWish& wish) const;
  /// Reads the log anew and shows it.
  void refresh();
  const std::vector<RecheckEntry>& entries() const { return entries_; }

 private:
  void make_layout();
  QLayout* make_fields();
  QWidget* make_plots();
  void choose(QLineEdit* field, const QString& title, const QString& filter);
  void show_entries();
  void show_number();
  int telling_number() const;

  Workbench& workbench_;
  QLineEdit *calibration_, *log_;
  QLabel *said_, *more_;
  widgets::HistoryPlot *e_values_, *history_;
  QComboBox* number_;
  bool is_number_chosen_ = false;  // by the user: else the one that tells what has changed is shown
  std::vector<RecheckEntry> entries_;
  Jobs jobs_;  // after what its work reports to: it dies first
};

}  // namespace handsight::app
