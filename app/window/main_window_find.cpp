// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl+K: what the registry of actions, the choices of the menu, the sheet of keys and the session have to offer.
#include <QMenu>

#include "window/find_entries.h"
#include "window/main_window.h"

namespace handsight::app {

void MainWindow::find() {
  std::vector<FindEntry> entries;
  const auto offer = [&](const QString& text, const QString& hint, std::function<void()> run) {
    entries.push_back({tr("action"), text, hint, std::move(run)});
  };
  for (const Action& a : actions_.all())
    if (a.run && a.id != "find" && (!a.is_possible || a.is_possible())) offer(a.plain_text(), a.keys_text(), a.run);
  for (QAction* a : menu_->actions()) {
    if (!a->menu()) continue;
    for (QAction* choice : a->menu()->actions())
      offer(tr("%1: %2").arg(a->text().remove('&'), choice->text().remove('&').toLower()), {},
            [choice] { choice->trigger(); });
  }
  for (const Actions::Row& row : actions_.sheet())
    if (!row.is_heading()) entries.push_back({tr("key"), row.what, row.keys, [this] { show_keys(); }});
  for (FindEntry& e : session_entries(workbench_)) entries.push_back(std::move(e));
  FindBox::show_over(this, std::move(entries));
}

}  // namespace handsight::app
