// SPDX-License-Identifier: GPL-3.0-or-later
// One box that finds actions, observations, joints, effects and help by their words (Ctrl+K).
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

class QLineEdit;
class QListWidget;

namespace handsight::app {

struct FindEntry {
  QString kind;  // "action", "observation", "joint", "effect", "key"
  QString text;  // what is searched and shown
  QString hint;  // at the right: a key, a reason
  std::function<void()> run;
};

/// The entries that hold every word of `words`, best first: those whose text begins with them, then the others in
/// their order. No words: the actions. At most `most`.
std::vector<const FindEntry*> found(const std::vector<FindEntry>& entries, const QString& words, std::size_t most);

class FindBox : public QWidget {
  Q_OBJECT

 public:
  /// Lays the box over the window and takes the focus; it goes with Esc, a click elsewhere, or a choice.
  static void show_over(QWidget* window, std::vector<FindEntry> entries);

 protected:
  FindBox(QWidget* window, std::vector<FindEntry> entries);
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refresh();
  void run(int row);

  std::vector<FindEntry> entries_;
  std::vector<const FindEntry*> shown_;
  QWidget* sheet_;
  QLineEdit* words_;
  QListWidget* list_;
};

}  // namespace handsight::app
