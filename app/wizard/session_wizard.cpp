// SPDX-License-Identifier: GPL-3.0-or-later
#include "wizard/session_wizard.h"

#include <QCheckBox>
#include <QComboBox>
#include <QImageReader>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

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
      QString sentence = counted(whole, "%n pair(s)");
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
