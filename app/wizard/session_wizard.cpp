// SPDX-License-Identifier: GPL-3.0-or-later
#include "wizard/session_wizard.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QImageReader>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QVBoxLayout>

#include "base/error.h"
#include "base/numbers.h"
#include "document/counted.h"
#include "frame/main_window.h"
#include "live/live_watch.h"
#include "robot/urdf.h"
#include "session/csv.h"
#include "session/stereo_calibration.h"
#include "widgets/theme.h"

namespace handsight::app {
namespace {

std::filesystem::path path_of(const QLineEdit* edit) { return edit->text().trimmed().toStdString(); }

std::vector<std::filesystem::path> paths_of(const QLineEdit* edit) {
  std::vector<std::filesystem::path> list;
  for (const QString& part : edit->text().split(';'))
    if (!part.trimmed().isEmpty()) list.emplace_back(part.trimmed().toStdString());
  return list;
}

std::optional<Vector3> three_numbers(const QLineEdit* edit) {
  const auto numbers = parse_numbers(edit->text().replace(',', ' ').toStdString());
  if (!numbers || numbers->size() != 3) return std::nullopt;
  return Vector3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

}  // namespace

void SessionWizard::run(MainWindow& window) {
  auto* wizard = new SessionWizard(window);
  wizard->setAttribute(Qt::WA_DeleteOnClose);
  wizard->open();
}

SessionWizard::SessionWizard(MainWindow& window) : QDialog(&window), window_(window) {
  setObjectName("wizard");
  setWindowTitle(tr("New session from images"));
  resize(760, 680);
  auto* content = new QWidget;
  grid_ = new QGridLayout(content);
  grid_->setHorizontalSpacing(8);
  grid_->setVerticalSpacing(4);
  grid_->setColumnStretch(1, 1);
  left_ = add_part("wizard_left", tr("Left images"), tr("folder"), Choice::folder);
  right_ = add_part("wizard_right", tr("Right images"), tr("folder; may be the same"), Choice::folder);
  robot_ = add_part("wizard_robot", tr("Robot"), tr("URDF file"), Choice::file, tr("URDF (*.urdf *.xml)"));
  add_robot_rows();
  angles_ = add_part("wizard_angles", tr("Joint angles"), tr("CSV: a line for each image pair, rad"), Choice::file,
                     tr("Tables (*.csv *.txt)"));
  calibration_ = add_part("wizard_calibration", tr("Stereo calibration"), tr("OpenCV's YAML or XML; several by ;"),
                          Choice::files, tr("OpenCV (*.yml *.yaml *.xml *.json)"));
  add_mount_rows();
  add_target_rows();
  grid_->setRowStretch(grid_->rowCount(), 1);

  auto* scroll = new QScrollArea(this);
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  refusal_ = new QLabel(this);
  refusal_->setObjectName("wizard_refusal");
  refusal_->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(this);
  make_ = buttons->addButton(tr("Make the session"), QDialogButtonBox::ActionRole);
  make_->setObjectName("wizard_make");
  make_->setDefault(true);
  buttons->addButton(QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(make_, &QPushButton::clicked, this, &SessionWizard::make);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(scroll, 1);
  layout->addWidget(refusal_);
  layout->addWidget(buttons);
  connect(left_.path, &QLineEdit::textChanged, this, &SessionWizard::read_images);
  connect(right_.path, &QLineEdit::textChanged, this, &SessionWizard::read_images);
  connect(robot_.path, &QLineEdit::textChanged, this, &SessionWizard::read_robot);
  connect(angles_.path, &QLineEdit::textChanged, this, &SessionWizard::read_angles);
  connect(calibration_.path, &QLineEdit::textChanged, this, &SessionWizard::read_calibration);
  connect(target_.path, &QLineEdit::textChanged, this, &SessionWizard::read_target);
  refresh();
}

SessionWizard::Part SessionWizard::add_part(const char* name, const QString& label, const QString& hint, Choice choice,
                                            const QString& filter) {
  Part part;
  const int row = grid_->rowCount();
  part.path = new QLineEdit;
  part.path->setObjectName(name);
  part.path->setPlaceholderText(hint);
  part.path->setMinimumHeight(widgets::kControlHeight);
  part.sentence = new QLabel;
  part.sentence->setObjectName(QString(name) + "_sentence");
  part.sentence->setWordWrap(true);
  part.sentence->setFont(widgets::text_font(widgets::TextRole::small));
  auto* browse = new QPushButton(tr("Choose…"));
  browse->setAutoDefault(false);
  auto* caption = new QLabel(label);
  caption->setBuddy(part.path);
  grid_->addWidget(caption, row, 0);
  grid_->addWidget(part.path, row, 1);
  grid_->addWidget(browse, row, 2);
  grid_->addWidget(part.sentence, row + 1, 1, 1, 2);
  connect(browse, &QPushButton::clicked, this, [this, part, label, choice, filter] {
    QStringList chosen;
    if (choice == Choice::folder) {
      chosen << QFileDialog::getExistingDirectory(this, label, part.path->text());
    } else if (choice == Choice::file) {
      chosen << QFileDialog::getOpenFileName(this, label, part.path->text(), filter);
    } else {
      chosen = QFileDialog::getOpenFileNames(this, label, {}, filter);
    }
    if (!chosen.join("").isEmpty()) part.path->setText(chosen.join(";"));
  });
  return part;
}

void SessionWizard::add_robot_rows() {
  const int row = grid_->rowCount();
  tcp_ = new QComboBox;
  tcp_->setObjectName("wizard_tcp");
  mount_link_ = new QComboBox;
  mount_link_->setObjectName("wizard_mount");
  for (QComboBox* box : {tcp_, mount_link_}) {
    box->setEnabled(false);
    box->setFocusPolicy(Qt::StrongFocus);
    connect(box, &QComboBox::currentIndexChanged, this, &SessionWizard::refresh);
  }
  grid_->addWidget(new QLabel(tr("TCP link")), row, 0);
  grid_->addWidget(tcp_, row, 1);
  grid_->addWidget(new QLabel(tr("Camera link")), row + 1, 0);
  grid_->addWidget(mount_link_, row + 1, 1);
}

void SessionWizard::add_mount_rows() {
  const int row = grid_->rowCount();
  mount_is_known_ = new QCheckBox(tr("I know where the left camera sits on its link"));
  mount_is_known_->setObjectName("wizard_mount_known");
  mount_is_known_->setToolTip(tr("Left out, it is found from the observations."));
  mount_xyz_ = new QLineEdit;
  mount_xyz_->setObjectName("wizard_mount_xyz");
  mount_xyz_->setPlaceholderText(tr("x y z, m"));
  mount_rpy_ = new QLineEdit;
  mount_rpy_->setObjectName("wizard_mount_rpy");
  mount_rpy_->setPlaceholderText(tr("roll pitch yaw, rad"));
  grid_->addWidget(mount_is_known_, row, 1, 1, 2);
  grid_->addWidget(mount_xyz_, row + 1, 1);
  grid_->addWidget(mount_rpy_, row + 2, 1);
  for (QLineEdit* edit : {mount_xyz_, mount_rpy_}) {
    edit->setVisible(false);
    connect(edit, &QLineEdit::textChanged, this, &SessionWizard::refresh);
  }
  connect(mount_is_known_, &QCheckBox::toggled, this, [this](bool on) {
    mount_xyz_->setVisible(on);
    mount_rpy_->setVisible(on);
    refresh();
  });
}

void SessionWizard::add_target_rows() {
  const int row = grid_->rowCount();
  markers_ = new QSpinBox;
  markers_->setObjectName("wizard_markers");
  markers_->setRange(1, 64);
  markers_->setValue(3);
  markers_->setFocusPolicy(Qt::StrongFocus);
  title_ = new QLineEdit;
  title_->setObjectName("wizard_title");
  title_->setPlaceholderText(tr("Right hand, 12 March"));
  grid_->addWidget(new QLabel(tr("Markers on the hand")), row, 0);
  grid_->addWidget(markers_, row, 1, Qt::AlignLeft);
  grid_->addWidget(new QLabel(tr("Title")), row + 1, 0);
  grid_->addWidget(title_, row + 1, 1);
  target_ = add_part("wizard_target", tr("Session folder"), tr("made where it is not there"), Choice::folder);
}

void SessionWizard::say(const Part& part, const QString& sentence, bool is_refusal) {
  QPalette palette = part.sentence->palette();
  palette.setColor(QPalette::WindowText, is_refusal ? widgets::colors().bad : widgets::colors().ink2);
  part.sentence->setPalette(palette);
  part.sentence->setText(is_refusal ? "✗ " + sentence : sentence);
}

void SessionWizard::read_images() {
  pairs_.clear();
  const Part& where = right_.path->text().isEmpty() ? left_ : right_;
  say(left_, {}, false);
  say(right_, {}, false);
  if (!left_.path->text().isEmpty() && !right_.path->text().isEmpty()) try {
      pairs_ = find_image_pairs(path_of(left_.path), path_of(right_.path));
      QStringList alone;
      for (const ImageFiles& pair : pairs_)
        if (pair.left.empty() || pair.right.empty())
          alone << QString::fromStdString((pair.left.empty() ? pair.right : pair.left).filename().string());
      const int whole = static_cast<int>(pairs_.size()) - static_cast<int>(alone.size());
      QString sentence = counted(whole, "pair", "pairs");
      if (!alone.isEmpty())
        sentence += tr("; without a partner: %1").arg(alone.mid(0, 3).join(", ") + (alone.size() > 3 ? " …" : ""));
      say(where, sentence + ".", false);
    } catch (const InputError& error) {
      say(where, QString::fromStdString(error.what()), true);
    }
  refresh();
}

void SessionWizard::read_robot() {
  read_robot_.reset();
  if (robot_.path->text().isEmpty()) {
    say(robot_, {}, false);
  } else {
    try {
      read_robot_ = read_urdf(path_of(robot_.path));
      say(robot_,
          tr("%1 links, %2 joints that move by themselves.")
              .arg(read_robot_->links.size())
              .arg(joint_names(*read_robot_).size()),
          false);
    } catch (const InputError& error) {
      say(robot_, QString::fromStdString(error.what()), true);
    }
  }
  for (QComboBox* box : {tcp_, mount_link_}) {
    const QSignalBlocker silent(box);
    box->clear();
    box->setEnabled(read_robot_.has_value());
    if (!read_robot_) continue;
    for (const std::string& link : link_names(*read_robot_)) box->addItem(QString::fromStdString(link));
    box->setCurrentIndex(box == tcp_ ? box->count() - 1 : 0);
  }
  read_angles();
}

void SessionWizard::read_angles() {
  positions_.clear();
  say(angles_, {}, false);
  if (!angles_.path->text().isEmpty()) {
    if (!read_robot_) {
      say(angles_, tr("Waits for the robot, which names the joints."), false);
    } else {
      try {
        std::vector<std::string> notes;
        joints_ = joints_of_table(path_of(angles_.path), *read_robot_);
        positions_ = read_poses(path_of(angles_.path), joints_, &notes);
        QString sentence = tr("%1 poses of %2 joints.").arg(positions_.size()).arg(joints_.size());
        for (const std::string& note : notes) sentence += " " + QString::fromStdString(note);
        say(angles_, sentence, false);
      } catch (const InputError& error) {
        say(angles_, QString::fromStdString(error.what()), true);
      }
    }
  }
  refresh();
}

void SessionWizard::read_calibration() {
  rig_.reset();
  say(calibration_, {}, false);
  if (!calibration_.path->text().isEmpty()) try {
      std::vector<std::string> notes;
      rig_ = read_stereo_calibration(paths_of(calibration_.path), &notes);
      QString sentence = tr("Cameras %1 mm apart.").arg(1e3 * rig_->right_from_left.translation.norm(), 0, 'f', 1);
      for (const std::string& note : notes) sentence += " " + QString::fromStdString(note);
      say(calibration_, sentence, false);
    } catch (const InputError& error) {
      say(calibration_, QString::fromStdString(error.what()), true);
    }
  refresh();
}

void SessionWizard::read_target() {
  const auto folder = path_of(target_.path);
  std::error_code error;
  if (!folder.empty() && std::filesystem::exists(folder / "session.xml", error)) {
    say(target_, tr("There is a session already. Take another folder, or open it."), true);
  } else {
    say(target_, {}, false);
  }
  refresh();
}

std::optional<Rigid> SessionWizard::mount() const {
  if (!mount_is_known_->isChecked()) return Rigid{};
  const auto xyz = three_numbers(mount_xyz_), rpy = three_numbers(mount_rpy_);
  if (!xyz || !rpy) return std::nullopt;
  return Rigid{rotation_from_rpy(*rpy), *xyz};
}

std::optional<NewSession> SessionWizard::parts() const {
  if (pairs_.empty() || !read_robot_ || !rig_ || positions_.empty() || target_.path->text().isEmpty() || !mount())
    return std::nullopt;
  NewSession s;
  s.folder = path_of(target_.path);
  s.title = title_->text().trimmed().toStdString();
  s.urdf = path_of(robot_.path);
  s.tcp = tcp_->currentText().toStdString();
  s.mount = mount_link_->currentText().toStdString();
  s.mount_is_known = mount_is_known_->isChecked();
  s.mount_from_left = *mount();
  s.rig = *rig_;
  for (const ImageFiles& pair : pairs_) {
    // A calibration without the images' size takes that of the first pair.
    if (s.rig.left.width == 0 && !pair.left.empty()) {
      const QSize size = QImageReader(QString::fromStdString(pair.left.string())).size();
      s.rig.left.width = size.width();
      s.rig.left.height = size.height();
    }
    if (s.rig.right.width == 0 && !pair.right.empty()) {
      const QSize size = QImageReader(QString::fromStdString(pair.right.string())).size();
      s.rig.right.width = size.width();
      s.rig.right.height = size.height();
    }
  }
  s.marker_count = markers_->value();
  s.joints = joints_;
  s.positions = positions_;
  s.images = pairs_;
  return s;
}

void SessionWizard::refresh() {
  QString sentence;
  if (!pairs_.empty() && !positions_.empty() && pairs_.size() != positions_.size())
    sentence =
        tr("There are %1 lines of joint angles for %2 images: each instant needs one of each, in the same order.")
            .arg(positions_.size())
            .arg(pairs_.size());
  if (mount_is_known_->isChecked() && !mount())
    sentence = tr("The camera's place is three numbers in m and three in rad.");
  refusal_->setText(sentence);
  make_->setEnabled(sentence.isEmpty() && parts().has_value());
}

void SessionWizard::make() {
  const auto all = parts();
  if (!all) return;
  try {
    const Session made = make_session(*all);
    // What arrives there later belongs to this session too.
    remember_live_sources(made.file, {path_of(left_.path), path_of(right_.path), path_of(angles_.path)});
    accept();
    window_.open(QString::fromStdString(made.file.string()));
  } catch (const std::exception& error) {
    refusal_->setText(QString::fromStdString(error.what()));
  }
}

}  // namespace handsight::app
