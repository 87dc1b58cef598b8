// SPDX-License-Identifier: GPL-3.0-or-later
#include "workbench/actions.h"

#include <QMenu>
#include <QShortcut>
#include <QStringList>
#include <algorithm>

#include "base/error.h"

namespace handsight::app {

QString Action::plain_text() const { return QString(text).remove('&'); }

QString Action::keys_text() const {
  if (keys.empty()) return gesture;
  const QString key = keys.front().toString(QKeySequence::NativeText);
  return gesture.isEmpty() ? key : key + ", " + gesture;
}

QString Action::tool_tip() const {
  const QString what = tip.isEmpty() ? plain_text() : tip;
  const QString key = keys_text();
  return key.isEmpty() ? what : QObject::tr("%1 (%2)").arg(what, key);
}

Actions::Actions(QWidget* window) : QObject(window), window_(window) {}

void Actions::add(Action action) {
  std::erase_if(action.keys, [](const QKeySequence& key) { return key.isEmpty(); });  // this desktop has none for it
  for (const Action& other : all_) {
    check(other.id != action.id, "two actions are called {}", action.id.toStdString());
    for (const QKeySequence& key : action.keys)
      check(std::find(other.keys.begin(), other.keys.end(), key) == other.keys.end(), "{} and {} share a key",
            other.id.toStdString(), action.id.toStdString());
  }
  for (const QKeySequence& key : action.keys)
    connect(new QShortcut(key, window_), &QShortcut::activated, this, [this, id = action.id] { run(id); });
  all_.push_back(std::move(action));
}

const Action& Actions::of(const QString& id) const {
  const auto found = std::find_if(all_.begin(), all_.end(), [&](const Action& a) { return a.id == id; });
  check(found != all_.end(), "no action is called {}", id.toStdString());
  return *found;
}

void Actions::run(const QString& id) const {
  const Action& action = of(id);
  if (action.run && (!action.is_possible || action.is_possible())) action.run();
}

void Actions::fill(QMenu& menu) const {
  int last = 0;
  for (const Action& action : all_) last = std::max(last, action.section);
  for (int section = 1; section <= last; ++section) {
    if (section > 1) menu.addSeparator()->setObjectName(QString("before_section_%1").arg(section));
    for (const Action& action : all_) {
      if (action.section != section) continue;
      // The key is reported in the menu and listened to by the shortcut alone.
      const QString key =
          action.keys.empty() ? QString() : '\t' + action.keys.front().toString(QKeySequence::NativeText);
      QAction* entry = menu.addAction(action.text + key, &menu, [this, id = action.id] { run(id); });
      entry->setObjectName(action.id);
      connect(&menu, &QMenu::aboutToShow, entry, [this, entry, id = action.id] {
        const Action& now = of(id);
        entry->setEnabled(!now.is_possible || now.is_possible());
        entry->setVisible(!now.is_offered || now.is_offered());
      });
    }
  }
}

std::vector<Actions::Row> Actions::sheet() const {
  QStringList groups;
  for (const Action& action : all_)
    if (action.in_sheet && !action.keys_text().isEmpty() && !groups.contains(action.group)) groups << action.group;
  std::vector<Row> rows;
  for (const QString& group : groups) {
    rows.push_back({group, {}});
    for (const Action& action : all_)
      if (action.in_sheet && action.group == group && !action.keys_text().isEmpty())
        rows.push_back({action.keys_text(), action.tip.isEmpty() ? action.plain_text() : action.tip});
  }
  return rows;
}

}  // namespace handsight::app
