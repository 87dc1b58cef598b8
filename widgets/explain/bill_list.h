// SPDX-License-Identifier: GPL-3.0-or-later
// The bill of a model: a row a cause, with what it is worth at the hand, how sure that is and what is to be doubted.
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

class QLabel;
class QListView;

namespace handsight::widgets {

struct BillEntry {
  QString id;        // of the effect
  QString cause;     // "joint elasticity of arm_2 and arm_4"
  QString worth;     // "5.81 ± 0.02 mm"
  QString sure;      // "sure to 99.9 %"; empty: nobody has looked
  QString built;     // "plausible", or why it stands in for another cause
  QString reported;  // "told from all others", "not given from payload"; empty: nobody has looked
  bool is_stand_in = false;

  /// "sure to 99.9 %; plausible; told from all others", what is to be doubted first.
  QString remarks() const;
};

/// What is worth most first.
class BillList : public QWidget {
  Q_OBJECT
 public:
  explicit BillList(QWidget* parent = nullptr);
  void set_entries(std::vector<BillEntry> entries);
  const std::vector<BillEntry>& entries() const { return entries_; }
  /// A sentence below the last row; empty: none.
  void set_note(const QString& sentence);
  QListView* view() const { return view_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  std::vector<BillEntry> entries_;
  QListView* view_ = nullptr;
  QLabel *title_, *empty_, *note_;
};

}  // namespace handsight::widgets
