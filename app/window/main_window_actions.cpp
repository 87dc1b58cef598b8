// SPDX-License-Identifier: GPL-3.0-or-later
// What can be done in the window: the registry is filled here, and menu and Ctrl+K are made of it.
#include <QMenu>

#include "start/session_places.h"
#include "widgets/lists/model_panel.h"
#include "window/blunder_bar.h"
#include "window/centre_fill.h"
#include "window/key_list.h"
#include "window/main_window.h"
#include "window/workspaces.h"

namespace handsight::app {
namespace {

enum Section { of_session = 1, of_actions, of_help };

}  // namespace

void MainWindow::add_session_actions() {
  const QString everywhere = tr("Everywhere");
  const auto is_open = [this] { return workbench_.document.is_open(); };
  const auto can_add = [this] { return workbench_.document.is_open() && !workbench_.document.session().is_touch(); };
  const auto is_collection = [this] { return workbench_.document.is_open() && workbench_.sessions.is_any(); };
  actions_.add({.id = "open",
                .group = everywhere,
                .text = tr("&Open a session…"),
                .keys = {QKeySequence::Open},
                .run = [this] { choose_session(); },
                .section = of_session});
  actions_.add({.id = "new",
                .group = everywhere,
                .text = tr("&New session from images…"),
                .keys = {QKeySequence::New},
                .run = [this] { run_wizard(); },
                .section = of_session});
  actions_.add({.id = "new_from_files",
                .group = everywhere,
                .text = tr("New session from a &bag or other files…"),
                .tip = tr("a new session from a ROS 2 bag, Kalibr, camera_info, easy_handeye or tables"),
                .run = [this] { bring_files({}); },
                .section = of_session});
  actions_.add({.id = "add_session",
                .group = everywhere,
                .text = tr("&Add a session of this robot…"),
                .tip = tr("another hand, another camera or another day of this robot: fitted together, told apart"),
                .run = [this] { choose_added(); },
                .is_possible = can_add,
                .section = of_session});
  actions_.add({.id = "shared",
                .group = everywhere,
                .text = tr("What is s&hared…"),
                .tip = tr("which sessions of the collection have the same cameras, which the same hand"),
                .run = [this] { show_shared(); },
                .is_possible = is_collection,
                .is_offered = is_collection,
                .section = of_session});
  actions_.add({.id = "save",
                .group = everywhere,
                .text = tr("&Save"),
                .keys = {QKeySequence::Save},
                .run = [this] { save(); },
                .is_possible = is_open,
                .section = of_session});
  actions_.add({.id = "compare",
                .group = everywhere,
                .text = tr("Com&pare with another session…"),
                .tip = tr("compare with another session of this robot, or with a calibration"),
                .run = [this] { compare_with({}); },
                .is_possible = is_open,
                .section = of_session});
  actions_.add({.id = "blunders",
                .group = everywhere,
                .text = tr("Look for &mistakes of a whole kind"),
                .tip = tr("a joint that counts the other way, readings paired one off, another unit"),
                .run = [this] { blunders_->look(); },
                .is_possible = is_open,
                .section = of_session});
  const auto collides = [this] { return !workbench_.document.collisions().empty(); };
  actions_.add({.id = "collisions",
                .group = everywhere,
                .text = tr("What another program &wrote…"),
                .run = [this] { show_collisions(); },
                .is_possible = collides,
                .is_offered = collides,
                .section = of_session});
  actions_.add({.id = "fit",
                .group = everywhere,
                .text = tr("&Fit again"),
                .tip = tr("fit again what was stopped"),
                .keys = {QKeySequence(Qt::Key_F5)},
                .run = [this] { workbench_.refit.again(); },
                .is_possible =
                    [this] {
                      return workbench_.document.is_open() && !workbench_.document.model() &&
                             !workbench_.refit.is_pending();
                    },
                .section = of_session});
  actions_.add({.id = "undo_all",
                .group = everywhere,
                .text = tr("&Undo everything"),
                .run = [this] { workbench_.document.undo_all(); },
                .is_possible = is_open,
                .section = of_actions});
  const auto is_sample = [this] {
    return workbench_.document.is_open() && !take_sample(workbench_.document.file()).empty();
  };
  actions_.add({.id = "anew",
                .group = everywhere,
                .text = tr("Start this sample &anew"),
                .run =
                    [this] {
                      const std::string name = take_sample(workbench_.document.file());
                      workbench_.document.close();
                      open_sample(QString::fromStdString(name), true);
                    },
                .is_possible = is_sample,
                .is_offered = is_sample,
                .section = of_actions});
  actions_.add({.id = "find",
                .group = everywhere,
                .text = tr("&Find…"),
                .tip = tr("find an action, observation, joint, effect or key"),
                .keys = {QKeySequence(Qt::CTRL | Qt::Key_K)},
                .run = [this] { find(); },
                .section = of_help});
  actions_.add({.id = "keys",
                .group = everywhere,
                .text = tr("&Keys"),
                .keys = {QKeySequence(Qt::Key_Question), QKeySequence(Qt::Key_F1)},
                .run = [this] { show_keys(); },
                .section = of_help});
  actions_.add({.id = "close",
                .group = everywhere,
                .text = tr("&Close the session"),
                .keys = {QKeySequence::Close},
                .run = [this] { workbench_.document.close(); },
                .is_possible = is_open,
                .section = of_help});
  actions_.add({.id = "quit",
                .group = everywhere,
                .text = tr("&Quit"),
                .keys = {QKeySequence::Quit},
                .run = [this] { close(); },
                .section = of_help});
}

void MainWindow::add_view_actions() {
  const QString everywhere = tr("Everywhere");
  const auto is_open = [this] { return workbench_.document.is_open(); };
  for (const WorkspaceKind& kind : workspace_kinds())
    actions_.add({.id = "workspace_" + kind.id,
                  .group = everywhere,
                  .text = kind.name(),
                  .keys = {QKeySequence(Qt::CTRL | kind.key)},
                  .run = [this, place = kind.place] { show_workspace(place); },
                  .is_possible = is_open});
  const auto can_undo = [this] { return workbench_.document.undo_stack().canUndo(); };
  const auto can_redo = [this] { return workbench_.document.undo_stack().canRedo(); };
  actions_.add({.id = "undo",
                .group = everywhere,
                .text = tr("Undo"),
                .keys = {QKeySequence::Undo},
                .run = [this] { workbench_.document.undo(); },
                .is_possible = can_undo});
  actions_.add({.id = "redo",
                .group = everywhere,
                .text = tr("Do again"),
                .keys = {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)},
                .run = [this] { workbench_.document.redo(); },
                .is_possible = can_redo});
  actions_.add({.id = "previous",
                .group = everywhere,
                .text = tr("Previous observation"),
                .gesture = QString::fromUtf8("←"),
                .run = [this] { step(-1); },
                .is_possible = is_open});
  actions_.add({.id = "next",
                .group = everywhere,
                .text = tr("Next observation"),
                .gesture = QString::fromUtf8("→"),
                .run = [this] { step(1); },
                .is_possible = is_open});
  actions_.add({.id = "up",
                .group = everywhere,
                .text = tr("Selection one up"),
                .gesture = tr("Esc"),
                .run = [this] { workbench_.selection.up(); },
                .is_possible = is_open});
  actions_.add({.id = "back",
                .group = everywhere,
                .text = tr("The selection before"),
                .keys = {QKeySequence(Qt::ALT | Qt::Key_Left)},
                .run = [this] { workbench_.selection.back(); },
                .is_possible = is_open});
  actions_.add({.id = "fold_model",
                .group = everywhere,
                .text = tr("Fold the model panel"),
                .gesture = "M",
                .run =
                    [this] {
                      panel_->set_folded(!panel_->is_folded());
                      panel_choice_ = panel_->is_folded();
                    },
                .is_possible = is_open});
  actions_.add({.id = "fill_centre",
                .group = everywhere,
                .text = tr("One panel fills the centre"),
                .tip = tr("one panel fills the centre (double click on its title)"),
                .keys = {QKeySequence(Qt::SHIFT | Qt::Key_Space)},
                .run = [this] { fill_->toggle(); },
                .is_possible = is_open});
  actions_.add({.id = "next_unit",
                .group = everywhere,
                .text = tr("Next unit of sizes"),
                .tip = tr("sizes in px, in mm at the hand, in σ"),
                .keys = {QKeySequence(Qt::Key_U)},
                .run = [this] { workbench_.units.next(); },
                .is_possible = is_open});
  const std::tuple<const char*, DisplayUnits::Unit, QString> units[] = {
      {"px", DisplayUnits::Unit::pixel, tr("Sizes in px")},
      {"mm", DisplayUnits::Unit::millimetre, tr("Sizes in mm at the hand")},
      {"sigma", DisplayUnits::Unit::sigma, tr("Sizes in σ (sigma), residual over noise")}};
  for (const auto& [id, unit, text] : units)
    actions_.add(
        {.id = QString("unit_%1").arg(id),
         .group = everywhere,
         .text = text,
         .gesture = "U",
         .run = [this, unit = unit] { workbench_.units.choose(unit); },
         .is_possible = [this, unit = unit] { return workbench_.document.is_open() && workbench_.units.has(unit); },
         .in_sheet = false});
}

void MainWindow::add_observation_actions() {
  const QString inspect = tr("Inspect");
  const auto has_chosen = [this] { return workbench_.document.is_open() && !workbench_.selection.many().empty(); };
  const auto chosen = [this] {
    const auto& many = workbench_.selection.many();
    return std::vector<std::int64_t>(many.begin(), many.end());
  };
  actions_.add({.id = "exclude",
                .group = inspect,
                .text = tr("Exclude the chosen observations"),
                .gesture = tr("Delete"),
                .run = [this, chosen] { workbench_.exclude(chosen()); },
                .is_possible = has_chosen,
                .in_sheet = false});
  actions_.add({.id = "include",
                .group = inspect,
                .text = tr("Include the chosen observations"),
                .gesture = tr("Insert"),
                .run = [this, chosen] { workbench_.include(chosen()); },
                .is_possible = has_chosen,
                .in_sheet = false});
}

void MainWindow::make_actions() {
  add_view_actions();
  add_session_actions();
  for (const Workspace* workspace : workspaces_)
    for (Action& action : workspace->own_actions()) actions_.add(std::move(action));
  add_observation_actions();
  actions_.add({.id = "views_3d",
                .group = tr("3D view"),
                .text = tr("all, standard views, from the camera"),
                .gesture = tr("F, 1 … 6, 0")});
  actions_.fill(*menu_);
  after_choices_ = menu_->findChild<QAction*>(QString("before_section_%1").arg(static_cast<int>(of_help)));
  menu_->insertSeparator(after_choices_);
}

void MainWindow::show_keys() { KeyList::show_over(this, actions_.sheet()); }

}  // namespace handsight::app
