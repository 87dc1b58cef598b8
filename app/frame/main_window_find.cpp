// SPDX-License-Identifier: GPL-3.0-or-later
#include <QMenu>

#include "frame/find_entries.h"
#include "frame/key_list.h"
#include "frame/main_window.h"
#include "widgets/model_panel.h"

namespace handsight::app {

void MainWindow::find() {
  std::vector<FindEntry> entries;
  const auto action = [&](const QString& text, const QString& hint, std::function<void()> run) {
    entries.push_back({tr("action"), text, hint, std::move(run)});
  };
  if (bench_.document.is_open()) {
    for (int i = 0; i < static_cast<int>(workspaces_.size()); ++i)
      action(workspaces_[static_cast<std::size_t>(i)]->name(), tr("Ctrl+%1").arg(i + 1),
             [this, i] { show_workspace(i); });
    action(tr("Undo"), tr("Ctrl+Z"), [this] { bench_.document.undo(); });
    action(tr("Do again"), tr("Ctrl+Shift+Z"), [this] { bench_.document.redo(); });
    action(tr("Exclude the chosen observations"), tr("Delete"), [this] {
      const auto& many = bench_.selection.many();
      bench_.exclude({many.begin(), many.end()});
    });
    action(tr("Include the chosen observations"), tr("Insert"), [this] {
      const auto& many = bench_.selection.many();
      bench_.include({many.begin(), many.end()});
    });
    const std::pair<DisplayUnits::Unit, QString> units[] = {
        {DisplayUnits::Unit::pixel, tr("Sizes in px")},
        {DisplayUnits::Unit::millimetre, tr("Sizes in mm at the hand")},
        {DisplayUnits::Unit::sigma, tr("Sizes in σ (sigma), residual over noise")}};
    for (const auto& [unit, text] : units)
      if (bench_.units.has(unit)) action(text, tr("U"), [this, unit = unit] { bench_.units.choose(unit); });
    action(tr("Fold the model panel"), tr("M"), [this] { panel_->set_folded(!panel_->is_folded()); });
  }
  for (QAction* a : menu_->actions()) {
    if (a->isSeparator() || !a->isVisible()) continue;
    const QString text = a->text().remove('&');
    if (a->menu()) {
      for (QAction* choice : a->menu()->actions())
        action(tr("%1: %2").arg(text, choice->text().remove('&').toLower()), {}, [choice] { choice->trigger(); });
    } else {
      action(text, a->shortcut().toString(QKeySequence::NativeText), [a] { a->trigger(); });
    }
  }
  for (const auto& [keys, what] : KeyList::keys()) entries.push_back({tr("key"), what, keys, [this] { show_keys(); }});
  for (FindEntry& e : session_entries(bench_)) entries.push_back(std::move(e));
  FindBox::show_over(this, std::move(entries));
}

}  // namespace handsight::app
