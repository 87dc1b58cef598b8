// SPDX-License-Identifier: GPL-3.0-or-later
// The window: header, rail, the workspaces, model panel, read-out line, observation strip; or the start page.
#pragma once

#include <QMainWindow>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "window/model_editor.h"
#include "workbench/workbench.h"
#include "workbench/workspace.h"

class QAction;
class QMenu;
class QSplitter;
class QStackedWidget;

namespace handsight::widgets {
class ModelPanel;
class ObservationStrip;
class ReadOutLine;
class UnitSwitch;
}  // namespace handsight::widgets

namespace handsight::app {

class Appearance;
class BlunderBar;
class CentreFill;
class ComparePage;
class FilesWizard;
class Header;
class MergePage;
class Rail;
class StartPage;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Opens a session; where it cannot be opened the sentence is shown on the page at hand. True where it was;
  /// of a collection, which is read in the background, whether it can be opened is shown then.
  bool open(const QString& path);
  bool open_sample(const QString& name, bool fresh = false);
  Workbench& workbench() { return workbench_; }
  const Actions& registry() const { return actions_; }
  void show_workspace(Place place);
  /// Opens another session of the same robot, or a calibration, beside the one that is open. Empty: the user is asked.
  void compare_with(const QString& path);
  /// The wizard of files, with these to begin with.
  FilesWizard* bring_files(const std::vector<std::filesystem::path>& files);
  /// Takes the choices of theme and motion into its menu.
  void offer(Appearance& appearance);
  /// The one in front; while sessions are compared the one before.
  Place workspace() const { return place_; }
  bool is_comparing() const;
  /// Is another page in front than that of a workspace?
  bool is_beside_work() const;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  Workspace& page_of(Place place) const { return *workspaces_.at(static_cast<std::size_t>(place)); }
  Workspace& page_in_front() const;
  void bring_to_front(Workspace& page);
  void make_pages();
  void make_workspaces(QWidget* parent);
  void make_actions();
  void add_session_actions();
  void add_view_actions();
  void add_observation_actions();
  void connect_strip();
  void connect_read_out();
  void connect_units();
  void show_collisions();
  void choose_session();
  void choose_added();
  bool open_beside(const std::filesystem::path& file);
  void show_not_opened(const QString& sentence);
  void open_new(const QString& path);
  bool is_same_robot(const std::filesystem::path& path) const;
  bool is_another(const std::filesystem::path& path) const;
  /// Asks what the session shares with what is open.
  void add_session(const QString& path);
  void show_shared();
  void run_wizard();
  void save();
  void show_keys();
  void find();
  void session_opened();
  void session_closed();
  void remember_state();
  void refresh_panel();
  void refresh_strip();
  void refresh_crumbs();
  void refresh_rail();
  void fit_panel_to_workspace();
  void open_in_size();
  void step(int by);

  Workbench workbench_;
  Actions actions_{this};
  ModelEditor editor_{workbench_};
  QMenu* menu_;
  QAction* after_choices_;  // of the menu: before it stand theme and motion
  QStackedWidget* pages_;   // start page, or the session
  StartPage* start_;
  Header* header_;
  Rail* rail_;
  QStackedWidget* centre_;
  ComparePage* compare_;
  MergePage* merge_;
  Place place_ = Place::label;
  BlunderBar* blunders_;
  CentreFill* fill_;
  QSplitter* splitter_;
  widgets::ModelPanel* panel_;
  widgets::ReadOutLine* read_out_;
  widgets::ObservationStrip* strip_;
  widgets::UnitSwitch* units_;
  std::vector<Workspace*> workspaces_;  // as workspace_kinds()
  QTimer strip_timer_;                  // a play edits many times a second
  QTimer state_timer_;                  // what is remembered need not be of this moment
  QTimer panel_timer_;                  // one action may tell several times
  std::optional<bool> panel_choice_;    // folded by the user, or unfolded; absent: as the window's width has it
};

}  // namespace handsight::app
