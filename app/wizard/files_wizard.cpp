// SPDX-License-Identifier: GPL-3.0-or-later
#include "wizard/files_wizard.h"

#include <QCheckBox>
#include <QCloseEvent>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <QUrl>
#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "readers/bag_contents.h"
#include "readers/bags/bag.h"
#include "readers/robots/robot_file.h"
#include "session/new_session.h"
#include "widgets/base/theme.h"
#include "wizard/target_form.h"
#include "wizard/touch_form.h"
#include "wizard/wizard_paths.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::app {
namespace {

enum Shown { markers, chessboard, charuco, aprilgrid, tags, circles };

QString shown_name(const std::filesystem::path& path) {
  return QString::fromStdString((path.filename().empty() ? path.parent_path() : path).filename().string());
}

/// A folder that is not there yet, beside the first of the files.
std::filesystem::path free_folder(const std::filesystem::path& first) {
  const std::filesystem::path clean = first.filename().empty() ? first.parent_path() : first;
  const std::filesystem::path base = clean.parent_path() / (clean.stem().string() + "_session");
  std::filesystem::path folder = base;
  std::error_code error;
  for (int n = 2; std::filesystem::exists(folder, error); ++n) folder = base.string() + "_" + std::to_string(n);
  return folder;
}

QString lines_of(const std::vector<Message>& texts, const QString& mark) {
  QStringList lines;
  for (const Message& text : texts) lines << mark + translated(text);
  return lines.join('\n');
}

}  // namespace

FilesWizard* FilesWizard::run(QWidget& window, Jobs& jobs, std::vector<std::filesystem::path> files,
                              std::function<void(const QString& path)> open) {
  auto* wizard = new FilesWizard(window, jobs, std::move(open));
  wizard->setAttribute(Qt::WA_DeleteOnClose);
  wizard->add(files);
  wizard->open();
  return wizard;
}

void FilesWizard::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls() && !is_busy_) event->acceptProposedAction();
}

void FilesWizard::dropEvent(QDropEvent* event) {
  std::vector<std::filesystem::path> files;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) files.emplace_back(url.toLocalFile().toStdString());
  add(files);
  event->acceptProposedAction();
}

FilesWizard::~FilesWizard() {
  if (is_stopped_) *is_stopped_ = true;
}

/// Esc: while a session is being made, that alone is stopped.
void FilesWizard::reject() { is_busy_ ? stop_making() : QDialog::reject(); }

/// Closed, or cancelled: nobody waits for what is being made.
void FilesWizard::closeEvent(QCloseEvent* event) {
  if (is_busy_) {
    stop_making();
    is_busy_ = false;
  }
  QDialog::closeEvent(event);
}

void FilesWizard::add(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& path : files) {
    const bool is_known = std::any_of(files_.begin(), files_.end(), [&](const Named& n) { return n.path == path; });
    if (!is_known) files_.push_back({path, {}, {}});
  }
  read();
}

void FilesWizard::remove_chosen() {
  std::vector<int> rows;
  for (const QListWidgetItem* item : list_->selectedItems()) rows.push_back(list_->row(item));
  std::sort(rows.rbegin(), rows.rend());
  for (const int row : rows) files_.erase(files_.begin() + row);
  read();
}

bool FilesWizard::has(FileKind kind) const {
  return std::any_of(files_.begin(), files_.end(), [&](const Named& n) { return n.kind == kind; });
}

/// Folders of images, or a bag, in which there may be some.
bool FilesWizard::shows_images() const {
  return has(FileKind::images) || (has(FileKind::bag) && frame_->text().trimmed().isEmpty());
}

/// Of all tables of touches together.
QStringList FilesWizard::fixtures() const {
  QStringList names;
  if (robot_)
    for (const Named& n : files_)
      if (n.kind != FileKind::robot)
        for (const QString& name : fixtures_in(n.path, robot_->robot))
          if (!names.contains(name)) names << name;
  return names;
}

bool FilesWizard::are_touches() const { return !touches_->fixtures().isEmpty(); }

/// The robot first: its joints tell a table of joints from any other.
void FilesWizard::read_robot() {
  robot_.reset();
  for (Named& n : files_) {
    n.refusal.clear();
    n.kind.reset();
  }
  for (Named& n : files_) try {
      const FileKind kind = file_kind(n.path, nullptr);
      if (kind == FileKind::robot && !robot_) robot_ = robot_of_file(n.path);
    } catch (const std::exception& error) {
      n.refusal = translated_error(error);  // of a table it may be learned otherwise once the robot is known
    }
  if (!robot_)
    for (const Named& n : files_) try {
        if (!is_bag(n.path)) continue;
        const std::string text = find_robot_description(open_bag(n.path));
        if (!text.empty()) robot_ = field_urdf(text, "robot_description");
      } catch (const std::exception&) {
        // A bag that cannot be read says so itself, below.
      }
}

void FilesWizard::read() {
  made_.clear();
  report_->hide();
  read_robot();
  list_->clear();
  for (Named& n : files_) {
    try {
      n.kind = file_kind(n.path, robot_ ? &robot_->robot : nullptr);
      n.refusal.clear();
    } catch (const std::exception& error) {
      // As the others are named; the tool tip has the whole path.
      n.refusal = in_words_of_window(translated_error(error))
                      .replace(QString::fromStdString(n.path.string()), shown_name(n.path));
    }
    const bool has_touches = robot_ && !fixtures_in(n.path, robot_->robot).isEmpty();
    if (has_touches) n.kind = FileKind::joints;
    auto* item = new QListWidgetItem(has_touches ? tr("%1: a table of touches").arg(shown_name(n.path))
                                     : n.kind    ? tr("%1: %2").arg(shown_name(n.path), translated(kind_text(*n.kind)))
                                                 : QString::fromUtf8("✗ ") + n.refusal);
    item->setToolTip(QString::fromStdString(n.path.string()));
    if (!n.kind) item->setForeground(widgets::colors().bad);
    list_->addItem(item);
  }
  remove_->setEnabled(false);
  if (!files_.empty() && !names_folder_)
    out_->setText(QString::fromStdString(free_folder(files_.front().path).string()));
  offer_links();
  touches_->ask(fixtures());
  show_questions();
}

void FilesWizard::offer_links() {
  const std::vector<std::string> links = robot_ ? link_names(robot_->robot) : std::vector<std::string>{};
  if (links == offered_) return;
  offered_ = links;
  const std::vector<std::string> ends = robot_ ? end_links(robot_->robot) : std::vector<std::string>{};
  for (QComboBox* box : {tcp_, mount_}) {
    const QSignalBlocker silent(box);
    box->clear();
    for (const std::string& link : links) box->addItem(QString::fromStdString(link));
    if (box == tcp_ && !ends.empty()) box->setCurrentText(QString::fromStdString(ends.back()));
  }
}

void FilesWizard::show_questions() {
  const bool has_robot = robot_.has_value(), is_bag_there = has(FileKind::bag),
             images = shows_images() && !has(FileKind::target);
  const bool is_flange = !has_robot && (has(FileKind::poses) || has(FileKind::samples));
  questions_->setRowVisible(tcp_, has_robot);
  questions_->setRowVisible(mount_, has_robot && !are_touches());
  questions_->setRowVisible(shown_, images);
  questions_->setRowVisible(markers_, images && shown_->currentIndex() == markers);
  questions_->setRowVisible(degrees_, has(FileKind::joints));
  questions_->setRowVisible(eye_on_base_, is_flange);
  questions_->setRowVisible(frame_, is_bag_there || has(FileKind::mocap));
  touches_->setVisible(are_touches());
  questions_->setRowVisible(still_, has_robot && !are_touches() && (is_bag_there || has(FileKind::joints)));
  questions_->setRowVisible(find_lag_, has_robot && !are_touches() && (is_bag_there || has(FileKind::joints)));
  questions_->setRowVisible(title_, !files_.empty());
  questions_->setRowVisible(out_, !files_.empty());
  target_->setVisible(images && shown_->currentIndex() != markers);
  const TargetKind kinds[] = {TargetKind::charuco, TargetKind::chessboard, TargetKind::charuco, TargetKind::aprilgrid,
                              TargetKind::tags};
  if (images && shown_->currentIndex() == circles)
    target_->ask_circles();
  else if (images && shown_->currentIndex() != markers)
    target_->ask(kinds[shown_->currentIndex()], false);
  refresh();
}

/// What can be said before it is tried; empty: nothing is missing.
QString FilesWizard::what_is_missing() const {
  if (files_.empty()) return tr("Nothing is there yet.");
  for (const Named& n : files_)
    if (!n.kind) return tr("One of them is nothing that a session is made from: remove it, or bring another one.");
  if (!robot_ && has(FileKind::bag)) return tr("The bag publishes no robot_description: add the robot's URDF.");
  if (!robot_ && !has(FileKind::samples) && !has(FileKind::poses))
    return tr("There is no robot among them: add its URDF, or a table of its flange's poses.");
  const bool is_measured = has(FileKind::images) || has(FileKind::bag) || has(FileKind::samples) ||
                           has(FileKind::poses) || has(FileKind::points) || has(FileKind::mocap) || are_touches();
  if (!is_measured) return tr("What a sensor measured is missing: images, points, or poses of a target.");
  const auto poses =
      std::count_if(files_.begin(), files_.end(), [](const Named& n) { return n.kind == FileKind::poses; });
  if (robot_ && !are_touches() && !has(FileKind::bag) && !has(FileKind::joints) && !has(FileKind::samples) &&
      poses != 2)
    return tr("The joint readings are missing: add a table of them, a column for each joint.");
  const bool has_camera =
      std::any_of(files_.begin(), files_.end(), [](const Named& n) { return n.kind && is_one_camera(*n.kind); });
  if (has(FileKind::images) && !has_camera && !has(FileKind::camchain) && !has(FileKind::storage))
    return tr("The cameras' calibration is missing: add camera_info of ROS, a camchain of Kalibr, or OpenCV's.");
  if (target_->isVisibleTo(this) && !target_->target()) return tr("The numbers of the target are of none.");
  if (out_->text().trimmed().isEmpty()) return tr("The new session needs a folder.");
  std::error_code error;
  if (std::filesystem::exists(path_of(out_) / "session.xml", error))
    return tr("There is a session already. Take another folder, or open it.");
  return {};
}

void FilesWizard::refresh() {
  const QString missing = what_is_missing();
  if (!is_busy_ && made_.isEmpty()) {
    said_->setText(missing);
    make_->setText(tr("Make the session"));
  }
  make_->setEnabled(!is_busy_ && missing.isEmpty());
}

ConvertOptions FilesWizard::options() const {
  ConvertOptions o;
  o.out = path_of(out_);
  if (robot_) {
    o.tcp = tcp_->currentText().toStdString();
    o.mount = mount_->currentText().toStdString();
  }
  o.title = title_->text().trimmed().toStdString();
  o.degrees = degrees_->isChecked();
  o.eye_on_base = eye_on_base_->isChecked();
  o.markers = markers_->value();
  if (target_->isVisibleTo(this)) o.target = target_->target();
  if (are_touches()) {
    o.fixtures = touches_->described();
    o.apart = touches_->apart();
    o.sigma = touches_->sigma();
  }
  o.target_frame = frame_->text().trimmed().toStdString();
  o.estimate_lag = find_lag_->isChecked();
  o.pairing.still_for = still_->value();
  return o;
}

void FilesWizard::make() {
  std::vector<std::filesystem::path> files;
  for (const Named& n : files_) files.push_back(n.path);
  is_busy_ = true;
  is_stopped_ = std::make_shared<std::atomic<bool>>(false);
  content_->setEnabled(false);
  stop_->setEnabled(true);
  working_->show();
  stop_->setFocus();
  said_->setText(tr("The session is being made …"));
  refresh();
  using Made = std::shared_ptr<const MadeOfFiles>;
  jobs_.start<Made>(
      "convert", tr("Making a session"),
      [files, options = options(), is_open = mount_->currentIndex() <= 0,
       is_stopped = is_stopped_](JobControl& control) mutable -> Made {
        options.goes_on = [&] { return !*is_stopped && !control.is_cancelled(); };
        try {
          return std::make_shared<const MadeOfFiles>(made_of_files(files, options, is_open));
        } catch (const ConversionStopped&) {
          return nullptr;
        }
      },
      [self = QPointer(this)](const Made& made) {
        if (!self) return;
        self->end_making();
        made ? self->show_made(*made) : self->said_->setText(tr("Stopped; nothing was made."));
      },
      [self = QPointer(this)](const QString& sentence) {
        if (!self) return;
        self->end_making();
        self->said_->setText(QString::fromUtf8("✗ ") + self->in_words_of_window(sentence));
      });
}

/// Only when the worker has taken back what it wrote nothing was made.
void FilesWizard::stop_making() {
  *is_stopped_ = true;
  stop_->setEnabled(false);
  said_->setText(tr("Stopping …"));
  if (!jobs_.is_waiting("convert")) return;
  jobs_.cancel("convert");
  end_making();
  said_->setText(tr("Stopped; nothing was made."));
}

void FilesWizard::end_making() {
  is_busy_ = false;
  content_->setEnabled(true);
  working_->hide();
  refresh();
  make_->setFocus();
}

/// The engine speaks of the command line's options; here they are called as the questions are.
QString FilesWizard::in_words_of_window(QString sentence) const {
  const auto asked = [this](QWidget* field) { return static_cast<QLabel*>(questions_->labelForField(field))->text(); };
  // Of two that begin alike the longer one first.
  const std::pair<const char*, QString> words[] = {{"--target-frame", asked(frame_)},
                                                   {"--target", asked(shown_)},
                                                   {"--tcp", asked(tcp_)},
                                                   {"--mount", asked(mount_)},
                                                   {"--still", asked(still_)},
                                                   {"--estimate-lag", find_lag_->text()},
                                                   {"--lag", find_lag_->text()},
                                                   {"--eye-on-base", eye_on_base_->text()},
                                                   {"--degrees", degrees_->text()},
                                                   {"--fixture", tr("What is known of %1").arg(tr("the fixture"))},
                                                   {"--apart", tr("Known distances, m; a semicolon between them")},
                                                   {"--sigma", tr("How exactly a touch tells (sigma)")},
                                                   {"--robot", tr("Add files…")}};
  // The noise of a sensor of poses is not asked for here.
  static const QRegularExpression not_asked("--sigma \\(m\\), --sigma-angle \\(rad\\), \\w+ ");
  sentence.remove(not_asked);
  for (const auto& [option, word] : words) sentence.replace(QLatin1String(option), tr("“%1”").arg(word));
  return sentence;
}

/// What was understood and what was left out stands there before the session opens.
void FilesWizard::show_made(const MadeOfFiles& made) {
  made_ = QString::fromStdString(made.file.string());
  QString what = counted(static_cast<qint64>(made.observations), "%n observation(s)");
  if (made.sessions > 1)
    what = tr("%1 with %2").arg(counted(static_cast<qint64>(made.sessions), "a collection of %n session(s)"), what);
  said_->setText((*is_stopped_ ? tr("It was made before it could be stopped: %1 in %2.") : tr("Made: %1 in %2."))
                     .arg(what, QString::fromStdString(made.file.parent_path().string())));
  report_->setPlainText(made.notes.empty() ? tr("Nothing was left out.")
                                           : in_words_of_window(lines_of(made.notes, QString::fromUtf8("• "))));
  report_->show();
  make_->setText(tr("Open it"));
  make_->setEnabled(true);
  make_->setFocus();
}

void FilesWizard::open_made() {
  const QString path = made_;
  accept();
  open_made_(path);
}

}  // namespace handsight::app
