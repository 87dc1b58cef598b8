// SPDX-License-Identifier: GPL-3.0-or-later
// The read-out line: what is selected as crumbs, what is under the pointer, and the last thing that was done.
#pragma once

#include <QStringList>
#include <QWidget>

class QLabel;
class QTimer;

namespace handsight::widgets {

/// 24 px high. "Selected: obs 37 > marker 2 > left 6.4 px" | "Pointer: obs 41 ...". A message takes the pointer's slot
/// for a few seconds and stays until the pointer says something.
class ReadOutLine : public QWidget {
  Q_OBJECT
 public:
  explicit ReadOutLine(QWidget* parent = nullptr);
  void set_crumbs(const QStringList& crumbs);  // outermost first; empty: "Nothing selected"
  void set_pointer(const QString& text);       // empty: nothing under the pointer
  void show_message(const QString& sentence);
  /// Something small at the right end, for good.
  void add_at_end(QWidget* widget);
  QString pointer_text() const;
  const QString& message() const { return message_; }  // the last one, while it is shown
  QSize sizeHint() const override;

 signals:
  void crumb_clicked(int index);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;  // the slot's new width

 private:
  void rebuild();
  void show_right();
  void elide_right();

  QStringList crumbs_;
  QString pointer_, message_, reported_;  // what stands at the right, whole
  QWidget* left_;
  QLabel* right_;
  QTimer* timer_;
};

}  // namespace handsight::widgets
