// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions: opened, saved, closed, and where the window begins with one.
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QMimeData>
#include <QStackedWidget>
#include <QUrl>
#include <algorithm>

#include "base/error.h"
#include "collection/share_dialog.h"
#include "session/session_xml.h"
#include "start/session_places.h"
#include "start/start_page.h"
#include "widgets/base/read_out_line.h"
#include "widgets/lists/model_panel.h"
#include "widgets/lists/observation_strip.h"
#include "window/main_window.h"
#include "wizard/files_wizard.h"
#include "wizard/session_wizard.h"
#include "words/core_words.h"
#include "workbench/session_parts.h"

namespace handsight::app {

namespace {

/// Where a dialog for sessions begins: beside the session that is open, else beside the last one.
QString folder_of_sessions(const Document& document) {
  std::filesystem::path file = document.file();
  if (const auto recent = recent_sessions(); file.empty() && !recent.empty()) file = recent.front().file;
  return QString::fromStdString(file.parent_path().parent_path().string());
}

bool is_decided(const Session& s) {
  return std::any_of(s.observations.begin(), s.observations.end(),
                     [](const Observation& o) { return o.decision == Decision::accepted; });
}

/// Is there nothing that a play could start from: no labels, or images of which none is labelled?
bool wants_labels(const Session& s) {
  if (s.target || s.pose_sensor) return false;
  bool any_labels = false, any_images = false;
  for (const Observation& o : s.observations) {
    if (!o.images[0].empty() && !o.sightings.empty()) return false;
    any_labels = any_labels || !o.sightings.empty();
    any_images = any_images || !o.images[0].empty();
  }
  return any_images ? !is_decided(s) : !any_labels;
}

/// Labels without images, enough to ask what is missing: there is nothing to label, and play would only repeat it.
bool wants_explaining(const Session& s) {
  constexpr std::ptrdiff_t fewest = 10;
  const bool any_images = std::any_of(s.observations.begin(), s.observations.end(),
                                      [](const Observation& o) { return !o.images[0].empty(); });
  return !any_images && std::count_if(s.observations.begin(), s.observations.end(), is_used) >= fewest;
}

/// Where the work goes on.
Place first_place(const Session& s) {
  if (!is_joined(s) && wants_labels(s)) return Place::label;
  if (wants_explaining(s)) return Place::explain;
  if (is_joined(s)) return Place::inspect;
  return is_decided(s) ? Place::inspect : Place::calibrate;
}

}  // namespace

/// Another session than the one that is open, which is not one of touches.
bool MainWindow::is_another(const std::filesystem::path& path) const {
  std::error_code error;
  const auto open = session_folder(workbench_.document.file());
  return !workbench_.document.session().is_touch() && session_folder(path) != open;
}

bool MainWindow::open(const QString& path) {
  const std::filesystem::path file = path.toStdString();
  workbench_.background.cancel("opening");
  if (is_collection(file)) return open_beside(file);
  try {
    workbench_.document.open(file);
    return true;
  } catch (const std::exception& error) {
    show_not_opened(translated_error(error));
    return false;
  }
}

/// A collection is many files: they are read and joined beside the window, and what is open stays so long.
bool MainWindow::open_beside(const std::filesystem::path& file) {
  using Read = std::shared_ptr<OpenedSession>;
  read_out_->show_message(tr("Opening %1 …").arg(QString::fromStdString(file.string())));
  workbench_.background.start<Read>(
      "opening", tr("Opening the collection"),
      [file](JobControl&) { return std::make_shared<OpenedSession>(open_files(file)); },
      [this](const Read& read) {
        try {
          workbench_.document.open(std::move(*read));
          read_out_->show_message({});  // it is there: nothing is being opened any more
        } catch (const std::exception& error) {
          show_not_opened(translated_error(error));
        }
      },
      [this](const QString& sentence) { show_not_opened(sentence); });
  return true;
}

void MainWindow::show_not_opened(const QString& sentence) {
  start_->set_refusal(sentence);
  read_out_->show_message(sentence);
}

bool MainWindow::open_sample(const QString& name, bool fresh) {
  try {
    for (const SampleSession& sample : sample_sessions())
      if (QString::fromStdString(sample.name) == name)
        return open(QString::fromStdString((fresh ? fresh_copy(sample) : working_copy(sample)).string()));
    throw InputError(message("There is no sample session \"{}\".", name.toStdString()));
  } catch (const InputError& error) {
    start_->set_refusal(translated_error(error));
    return false;
  }
}

void MainWindow::choose_session() {
  auto* dialog =
      new QFileDialog(this, tr("Open a session"), folder_of_sessions(workbench_.document), tr("Sessions (*.xml)"));
  dialog->setObjectName("open_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::open);
  dialog->open();
}

void MainWindow::choose_added() {
  auto* dialog = new QFileDialog(this, tr("Add a session of this robot"), folder_of_sessions(workbench_.document),
                                 tr("Sessions (*.xml)"));
  dialog->setObjectName("add_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::add_session);
  dialog->open();
}

void MainWindow::add_session(const QString& path) {
  auto* dialog = new ShareDialog(workbench_, path.toStdString(), this);
  connect(dialog, &ShareDialog::written, this, &MainWindow::open);
  connect(dialog, &ShareDialog::open_wanted, this, &MainWindow::open);
  dialog->open();
}

/// One that was just made: another hand, camera or day of the robot that is open is offered to be added to it.
void MainWindow::open_new(const QString& path) {
  is_same_robot(path.toStdString()) ? add_session(path) : static_cast<void>(open(path));
}

bool MainWindow::is_same_robot(const std::filesystem::path& path) const {
  if (!workbench_.document.is_open() || !is_another(path) || workbench_.document.session().robot.is_of_poses)
    return false;
  try {
    require_same_robot(workbench_.document.session(), read_session(path));
    return true;
  } catch (const InputError&) {
    return false;  // opening it says what is the matter
  }
}

void MainWindow::show_shared() { (new ShareDialog(workbench_, this))->open(); }

void MainWindow::run_wizard() {
  SessionWizard::run(
      *this, [this](const QString& path) { open_new(path); }, [this] { bring_files({}); });
}

FilesWizard* MainWindow::bring_files(const std::vector<std::filesystem::path>& files) {
  return FilesWizard::run(*this, workbench_.background, files, [this](const QString& path) { open_new(path); });
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

/// A session is opened; of anything else one may be made.
void MainWindow::dropEvent(QDropEvent* event) {
  std::vector<std::filesystem::path> files;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) files.emplace_back(url.toLocalFile().toStdString());
  event->acceptProposedAction();
  if (files.empty()) return;
  std::error_code error;
  const std::filesystem::path& first = files.front();
  const bool is_session =
      files.size() == 1 && (first.filename() == "session.xml" || std::filesystem::exists(first / "session.xml", error));
  if (is_session && workbench_.document.is_open() && is_another(first)) {
    add_session(QString::fromStdString(first.string()));
  } else if (is_session || (files.size() == 1 && is_collection(first))) {
    open(QString::fromStdString(first.string()));
  } else {
    bring_files(files);
  }
}

void MainWindow::save() {
  if (!workbench_.document.is_open()) return;
  try {
    workbench_.document.save();
  } catch (const InputError& error) {
    read_out_->show_message(translated_error(error));
  }
}

void MainWindow::session_opened() {
  const Session& s = workbench_.document.session();
  setWindowTitle(tr("%1 - Handsight").arg(display_name(s)));
  if (workbench_.document.is_rejoining()) {  // the same work goes on
    refresh_strip();
    show_workspace(place_);
    return refresh_rail();
  }
  remember_session(workbench_.document.file(), written_title(s));
  start_->set_refusal({});
  pages_->setCurrentIndex(1);
  strip_->set_selected(widgets::no_observation);
  refresh_strip();
  panel_->set_effects({});
  panel_->set_empty_text(tr("Not yet fitted."));
  workbench_.selection.select_observation(s.observations.front().id);
  show_workspace(first_place(s));
  refresh_rail();
}

/// What the start page says of it next time; also what a killed window leaves.
void MainWindow::remember_state() {
  const ModelVersionPointer model = workbench_.document.model();
  if (!workbench_.document.is_open() || !model || !model->fit) return;
  constexpr std::size_t most = 60;
  std::vector<double> all;
  for (const InspectionRow& row : model->inspection->rows)
    if (row.ratio && row.is_used) all.push_back(*row.ratio);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(all.size(), most); ++i)
    ratios.push_back(all[i * all.size() / std::min(all.size(), most)]);
  const VersionSizes sizes = list_sizes(*model, model->fit->noise);
  const auto unit =
      workbench_.document.session().is_tracker() ? widgets::SizeUnit::millimetre : widgets::SizeUnit::pixel;
  QString state = tr("Error %1, noise %2").arg(text_in(unit, sizes.error()), text_in(unit, sizes.noise));
  const QString explained = page_of(Place::explain).status().line;
  if (!explained.isEmpty()) state += tr(": %1").arg(explained);
  handsight::app::remember_state(workbench_.document.file(), state, ratios);
}

void MainWindow::session_closed() {
  setWindowTitle(tr("Handsight"));
  start_->refresh();
  pages_->setCurrentIndex(0);
  strip_->set_cells({});
}

}  // namespace handsight::app
