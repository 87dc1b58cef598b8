// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/main_window.h"

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QScreen>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "collection/sessions_bar.h"
#include "compare/compare_page.h"
#include "merge/merge_page.h"
#include "start/start_page.h"
#include "widgets/base/read_out_line.h"
#include "widgets/base/unit_switch.h"
#include "widgets/lists/model_panel.h"
#include "widgets/lists/observation_strip.h"
#include "window/appearance.h"
#include "window/blunder_bar.h"
#include "window/centre_fill.h"
#include "window/centre_room.h"
#include "window/foreign_bar.h"
#include "window/header.h"
#include "window/input_manners.h"
#include "window/rail.h"
#include "window/warning_bar.h"
#include "window/workspaces.h"
#include "workbench/link_selection.h"
#include "workbench/model_effects.h"
#include "workbench/observation_views.h"
#include "workbench/preferences.h"

namespace handsight::app {

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent) {
  setWindowTitle(tr("Handsight"));
  setAcceptDrops(true);
  menu_ = new QMenu(this);
  menu_->setObjectName("menu");
  make_pages();
  make_actions();
  connect_strip();
  connect_read_out();
  connect_units();
  connect(&workbench_.document, &Document::opened, this, &MainWindow::session_opened);
  connect(&workbench_.document, &Document::closed, this, &MainWindow::session_closed);
  connect(&workbench_, &Workbench::workspace_requested, this, &MainWindow::show_workspace);
  connect(&workbench_, &Workbench::relabel_requested, this, [this] { show_workspace(Place::label); });
  session_closed();
  open_in_size();
  new InputManners(this);
}

MainWindow::~MainWindow() {
  hide();  // while what the workspaces talk to is still there
  disconnect(&workbench_.document, nullptr, this, nullptr);
  workbench_.document.close();
}

void MainWindow::make_pages() {
  pages_ = new QStackedWidget(this);
  setCentralWidget(pages_);
  start_ = new StartPage(pages_);
  pages_->addWidget(start_);
  connect(start_, &StartPage::open_requested, this, &MainWindow::choose_session);
  connect(start_, &StartPage::new_requested, this, [this] { run_wizard(); });
  connect(start_, &StartPage::session_chosen, this, &MainWindow::open);
  connect(start_, &StartPage::sample_chosen, this, [this](const QString& name) { open_sample(name); });

  auto* session = new QWidget(pages_);
  header_ = new Header(workbench_, actions_, menu_, session);
  header_->setFixedHeight(44);
  make_workspaces(session);
  rail_ = new Rail(workspace_kinds(), session);
  panel_ = new widgets::ModelPanel(session);
  panel_->setObjectName("model_panel");
  read_out_ = new widgets::ReadOutLine(session);
  read_out_->setObjectName("read_out");
  units_ = new widgets::UnitSwitch(session);
  read_out_->add_at_end(units_);
  strip_ = new widgets::ObservationStrip(session);
  strip_->setObjectName("strip");
  strip_->setFixedHeight(strip_->sizeHint().height());

  auto* middle = new QHBoxLayout;
  middle->setSpacing(0);
  middle->addWidget(rail_);
  // What a workspace needs is not to push header, model panel or strip off a small screen.
  middle->addWidget(new CentreRoom(centre_, session), 1);
  middle->addWidget(panel_);
  auto* rows = new QVBoxLayout(session);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  rows->addWidget(header_);
  rows->addWidget(new WarningBar(workbench_, session));
  blunders_ = new BlunderBar(workbench_, session);
  connect(blunders_, &BlunderBar::open_wanted, this, &MainWindow::open);
  rows->addWidget(blunders_);
  auto* foreign = new ForeignBar(workbench_, session);
  connect(foreign, &ForeignBar::save_requested, this, &MainWindow::save);
  rows->addWidget(foreign);
  rows->addLayout(middle, 1);
  auto* sessions = new SessionsBar(workbench_, session);
  connect(sessions, &SessionsBar::add_wanted, this, &MainWindow::choose_added);
  connect(sessions, &SessionsBar::shared_wanted, this, &MainWindow::show_shared);
  connect(&workbench_.sessions, &SessionFilter::changed, this, &MainWindow::refresh_strip);
  rows->addWidget(sessions);
  rows->addWidget(read_out_);
  rows->addWidget(strip_);
  pages_->addWidget(session);
  connect(rail_, &Rail::chosen, this, &MainWindow::show_workspace);
  connect(panel_, &widgets::ModelPanel::folded_changed, this, [this](bool folded) { panel_choice_ = folded; });
  link_selection(panel_, workbench_);
}

void MainWindow::make_workspaces(QWidget* parent) {
  centre_ = new QStackedWidget(parent);
  for (const WorkspaceKind& kind : workspace_kinds()) {
    workspaces_.push_back(kind.make(workbench_, parent));
    centre_->addWidget(workspaces_.back());
    connect(workspaces_.back(), &Workspace::status_changed, this, &MainWindow::refresh_rail);
  }
  compare_ = new ComparePage(workbench_, parent);
  centre_->addWidget(compare_);
  connect(compare_, &ComparePage::close_requested, this, [this] { show_workspace(place_); });
  merge_ = new MergePage(workbench_, parent);
  centre_->addWidget(merge_);
  connect(merge_, &MergePage::done, this, [this] { show_workspace(place_); });
  connect(&workbench_.document, &Document::collided, this, &MainWindow::show_collisions);
  fill_ = new CentreFill(centre_);
}

void MainWindow::offer(Appearance& appearance) { appearance.add_to(*menu_, after_choices_); }

void MainWindow::show_workspace(Place place) {
  if (!workbench_.document.is_open()) return;
  place_ = place;
  rail_->set_current(place);
  bring_to_front(page_of(place));
}

void MainWindow::bring_to_front(Workspace& page) {
  fill_->put_back();
  centre_->setCurrentWidget(&page);
  fit_panel_to_workspace();
  // Keys are the workspace's from now on: Space plays, and does not press a button of the header again.
  const QWidget* focus = focusWidget();
  if (!focus || !focus->isVisible() || header_->isAncestorOf(focus)) page.setFocus(Qt::OtherFocusReason);
  page.activate();
}

Workspace& MainWindow::page_in_front() const { return *static_cast<Workspace*>(centre_->currentWidget()); }

bool MainWindow::is_comparing() const { return &page_in_front() == compare_; }

bool MainWindow::is_beside_work() const { return &page_in_front() != &page_of(place_); }

void MainWindow::show_collisions() {
  if (workbench_.document.collisions().empty()) return;
  rail_->set_none();
  bring_to_front(*merge_);
}

void MainWindow::compare_with(const QString& path) {
  if (!workbench_.document.is_open()) return;
  rail_->set_none();
  bring_to_front(*compare_);
  if (!path.isEmpty()) return compare_->compare_with(path.toStdString());
  if (!compare_->has_other()) compare_->choose();
}

void MainWindow::fit_panel_to_workspace() {
  const auto wanted = page_in_front().panel();
  panel_->setVisible(wanted != Workspace::Panel::absent);
  constexpr int wide_enough = 1400;  // px: the panel beside plots that can still be read
  panel_->set_folded(wanted == Workspace::Panel::folded || panel_choice_.value_or(width() < wide_enough));
}

void MainWindow::refresh_panel() {
  if (workbench_.document.is_open())
    panel_->set_effects(model_effects(workbench_.document, workbench_.diagnosing.diagnosis().get()));
}

void MainWindow::refresh_strip() {
  if (!workbench_.document.is_open()) return;
  strip_->set_session_names(workbench_.sessions.names());
  strip_->set_cells(workbench_.shown_cells());
}

void MainWindow::refresh_rail() {
  if (!workbench_.document.is_open()) return;
  for (const WorkspaceKind& kind : workspace_kinds()) rail_->set_status(kind.place, page_of(kind.place).status());
}

void MainWindow::refresh_crumbs() {
  const Selected& s = workbench_.selection.current();
  QStringList crumbs;
  if (s.observation) crumbs << tr("obs %1").arg(*s.observation);
  if (s.marker) crumbs << tr("marker %1").arg(*s.marker);
  const auto& rig = workbench_.document.session().rig;
  if (s.camera && rig && *s.camera < rig->count()) crumbs << camera_name(*rig, *s.camera);
  if (s.joint) crumbs << QString::fromStdString(*s.joint);
  const InspectionRow* row = workbench_.selected_row();
  if (!crumbs.isEmpty() && row && row->rms) {
    const Inspection& all = *workbench_.inspection();
    ResidualSize size = measure_size(*row);
    for (const MarkerResidual& m : row->markers) {
      if (!s.marker || m.marker != *s.marker) continue;
      size = s.camera && rig ? size_of_corner(m, *s.camera, *rig, all.noise) : measure_size(m, all);
    }
    crumbs.last() += "  " + workbench_.units.text(size);
  }
  read_out_->set_crumbs(crumbs);
}

void MainWindow::step(int by) {
  const auto& observations = workbench_.document.session().observations;
  if (observations.empty()) return;
  const int count = static_cast<int>(observations.size());
  const int now = workbench_.selection.current().observation
                      ? workbench_.document.find_index(*workbench_.selection.current().observation)
                      : (by > 0 ? -1 : count);
  workbench_.selection.select_observation(
      observations[static_cast<std::size_t>(std::clamp(now + by, 0, count - 1))].id);
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (!workbench_.document.is_open()) return QMainWindow::keyPressEvent(event);
  if (page_in_front().key(event)) return;
  if (event->modifiers() != Qt::NoModifier && event->modifiers() != Qt::KeypadModifier)
    return QMainWindow::keyPressEvent(event);
  switch (event->key()) {
    case Qt::Key_Left:
      return step(-1);
    case Qt::Key_Right:
      return step(1);
    case Qt::Key_Escape:
      return fill_->put_back() ? void() : is_beside_work() ? show_workspace(place_) : workbench_.selection.up();
    case Qt::Key_M:
      return actions_.run("fold_model");
    default:
      QMainWindow::keyPressEvent(event);
  }
}

/// In the size it last had, never larger than the screen.
void MainWindow::open_in_size() {
  const QRect screen = QMainWindow::screen()->availableGeometry();
  const QStringList last = preference("window size").split('x');
  QSize size(1440, 900);
  if (last.size() == 2 && last[0].toInt() >= 640 && last[1].toInt() >= 400) size = {last[0].toInt(), last[1].toInt()};
  constexpr int title_bar = 32;  // px, of the frame that the desktop puts round it
  const QSize room(screen.width(), screen.height() - title_bar);
  const bool is_cut = size.width() >= room.width() || size.height() >= room.height();
  resize(size.boundedTo(room));
  if (is_cut) move(screen.topLeft());
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  constexpr int wide_enough = 1400;
  const bool crosses = (event->oldSize().width() < wide_enough) != (event->size().width() < wide_enough);
  if (crosses && workbench_.document.is_open() && !panel_choice_) fit_panel_to_workspace();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!isMaximized() && !isFullScreen())
    remember_preference("window size", QString("%1x%2").arg(width()).arg(height()));
  workbench_.document.close();
  event->accept();
}

}  // namespace handsight::app
