// SPDX-License-Identifier: GPL-3.0-or-later
// The versions of the model as a list; two of them can be compared.
#pragma once

#include <QWidget>
#include <vector>

#include "widgets/explain/version_entry.h"

class QLabel;
class QListView;
class QPushButton;

namespace handsight::widgets {

class VersionListModel;

/// Oldest first. A click shows a version; A and B (keys, or the letters in the row) pick two to compare.
class VersionList : public QWidget {
  Q_OBJECT
 public:
  explicit VersionList(QWidget* parent = nullptr);
  void set_versions(std::vector<VersionEntry> versions, const QString& unit);
  void set_current(int version);                 // shown in the window; -1: the last
  void set_compared(int a, int b);               // -1: none
  void set_comparison(const QString& sentence);  // "A to B: 9.1 -> 0.24 px, TCP->Body moves 3.2 mm"
  void set_empty_text(const QString& sentence);
  QListView* view() const { return view_; }
  QPushButton* take_back_button() const { return take_back_; }
  int count() const;
  QRect letter_rect(int version, bool is_b) const;  // in the viewport

 signals:
  void version_selected(int version);
  void compared(int a, int b);
  void take_back_requested(int version);  // "Take back to here"

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void pick(int version, bool as_b);
  void refresh();

  VersionListModel* model_;
  QListView* view_ = nullptr;
  QLabel *comparison_, *empty_;
  QPushButton* take_back_;
};

}  // namespace handsight::widgets
