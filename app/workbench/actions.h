// SPDX-License-Identifier: GPL-3.0-or-later
// The one registry of what can be done in the window. Menu, shortcuts, the sheet of keys, Ctrl+K and tool tips are made
// of it.
#pragma once

#include <QKeySequence>
#include <QObject>
#include <functional>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace handsight::app {

struct Action {
  QString id;                              // "undo"; unique
  QString group;                           // heading in the sheet of keys: "Everywhere", "Label"
  QString text;                            // "&Save"; & marks its letter in the menu
  QString tip;                             // a sentence more, for tool tips; may be empty
  std::vector<QKeySequence> keys;          // that the window listens to; the first is reported
  QString gesture;                         // what a page listens to itself, or the mouse does: "Shift+drag"
  std::function<void()> run = {};          // none: only explained
  std::function<bool()> is_possible = {};  // none: always
  std::function<bool()> is_offered = {};   // in the menu; none: always
  int section = 0;                         // of the menu, from 1 on; 0: not in it
  bool in_sheet = true;                    // where it has keys or a gesture

  /// The text without the mark.
  QString plain_text() const;
  /// "Ctrl+Z" or the gesture; empty where there is neither.
  QString keys_text() const;
  /// "Undo (Ctrl+Z)", or the tip with the keys.
  QString tool_tip() const;
};

class Actions : public QObject {
  Q_OBJECT

 public:
  explicit Actions(QWidget* window);

  /// Takes it in, and listens to its keys from now on. An id or a key that is taken is a mistake of the program.
  void add(Action action);
  const std::vector<Action>& all() const { return all_; }
  /// Must be there.
  const Action& of(const QString& id) const;
  /// Does it, where it is possible.
  void run(const QString& id) const;
  /// The actions of the menu, section by section; what stands in it is refreshed as it opens. The separator after this
  /// section is returned where it is asked for.
  void fill(QMenu& menu) const;

  /// A row of the sheet: keys and what they do; a heading where `what` is empty.
  struct Row {
    QString keys, what;
    bool is_heading() const { return what.isEmpty(); }
  };
  /// Group by group, in the order in which groups came.
  std::vector<Row> sheet() const;

 private:
  QWidget* window_;
  std::vector<Action> all_;
};

}  // namespace handsight::app
