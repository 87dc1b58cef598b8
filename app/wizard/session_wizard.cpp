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
#include "ways/brought.h"
#include "widgets/theme.h"
#include "wizard/target_form.h"
#include "wizard/wizard_scene.h"

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

QString with_notes(QString sentence, const std::vector<std::string>& notes) {
  for (const std::string& note : notes) sentence += " " + QString::fromStdString(note);
  return sentence;
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
  part.sentence->setVisible(!sentence.isEmpty() && !part.path->isHidden());
  part.sentence->setText(is_refusal ? QString::fromUtf8("✗ ") + sentence : sentence);
}

std::vector<std::filesystem::path> SessionWizard::image_folders() const {
  std::vector<std::filesystem::path> folders;
  for (const Part* part : {&left_, &right_})
    if (!part->path->text().trimmed().isEmpty()) folders.push_back(path_of(part->path));
  if (known() != markers)
    for (const auto& folder : paths_of(more_.path)) folders.push_back(folder);
  return folders;
}

QString SessionWizard::images_sentence() const {
  int whole = 0;
  QStringList alone;
  for (const InstantImages& instant : images_) {
    const auto there = std::find_if_not(instant.files.begin(), instant.files.end(),
                                        [](const std::filesystem::path& file) { return file.empty(); });
    const bool is_whole =
        std::none_of(instant.files.begin(), instant.files.end(), [](const auto& file) { return file.empty(); });
    whole += is_whole;
    if (!is_whole) alone << QString::fromStdString(there->filename().string());
  }
  const std::size_t cameras = images_.empty() ? 0 : images_.front().files.size();
  QString sentence = cameras == 1   ? counted(whole, "%n image(s)")
                     : cameras == 2 ? counted(whole, "%n pair(s)")
                                    : counted(whole, "%n instant(s) that all cameras saw");
  if (!alone.isEmpty())
    sentence += tr("; without a partner: %1").arg(alone.mid(0, 3).join(", ") + (alone.size() > 3 ? " …" : ""));
  return sentence + ".";
}

void SessionWizard::read_images() {
  images_.clear();
  for (const Part* part : {&left_, &right_, &more_}) say(*part, {}, false);
  const auto folders = image_folders();
  const bool are_enough = known() == markers ? folders.size() == 2 : !folders.empty();
  const Part& where = !more_.path->text().isEmpty() && known() != markers ? more_
                      : right_.path->text().isEmpty()                     ? left_
                                                                          : right_;
  if (known() != poses && are_enough) try {
      images_ = find_images(folders);
      say(where, images_sentence(), false);
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
    if (!read_robot_) continue;
    for (const std::string& link : link_names(*read_robot_)) box->addItem(QString::fromStdString(link));
    box->setCurrentIndex(box == tcp_ ? box->count() - 1 : 0);
  }
  show_robot();
  choose_links();
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
        say(angles_, with_notes(tr("%1 poses of %2 joints.").arg(positions_.size()).arg(joints_.size()), notes), false);
      } catch (const InputError& error) {
        say(angles_, QString::fromStdString(error.what()), true);
      }
    }
  }
  refresh();
}

void SessionWizard::read_calibration() {
  rig_.cameras.clear();
  say(calibration_, {}, false);
  if (!calibration_.path->text().isEmpty()) try {
      std::vector<std::string> notes;
      rig_ = read_rig_calibration(paths_of(calibration_.path), &notes);
      const QString sentence =
          rig_.count() == 1 ? tr("One camera of %1 px focal length.").arg(rig_.at(0).camera.fx, 0, 'f', 0)
          : rig_.count() == 2
              ? tr("Cameras %1 mm apart.").arg(1e3 * rig_.at(1).camera_from_first.translation.norm(), 0, 'f', 1)
              : tr("%1 cameras.").arg(rig_.count());
      say(calibration_, with_notes(sentence, notes), false);
    } catch (const InputError& error) {
      say(calibration_, QString::fromStdString(error.what()), true);
    }
  refresh();
}

void SessionWizard::read_poses_of_target() {
  target_poses_.clear();
  say(poses_, {}, false);
  if (known() == poses && !poses_.path->text().isEmpty()) try {
      const Brought brought = bring({path_of(poses_.path)}, nullptr, false);
      if (brought.poses.empty())
        throw InputError(tr("%1: holds no poses; expected columns x y z qx qy qz qw, a line for each instant.")
                             .arg(poses_.path->text())
                             .toStdString());
      target_poses_ = brought.poses.front().series.poses;
      say(poses_,
          with_notes(counted(static_cast<int>(target_poses_.size()), "%n pose(s) of the target") + ".", brought.notes),
          false);
    } catch (const InputError& error) {
      say(poses_, QString::fromStdString(error.what()), true);
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
  const bool has_cameras = known() != poses;
  if (!read_robot_ || positions_.empty() || target_.path->text().isEmpty() || !mount()) return std::nullopt;
  if (has_cameras ? images_.empty() || rig_.count() == 0 : target_poses_.empty()) return std::nullopt;
  const bool has_target = has_cameras && known() != markers;
  if (has_target && !form_->target()) return std::nullopt;
  NewSession s;
  s.folder = path_of(target_.path);
  s.title = title_->text().trimmed().toStdString();
  s.urdf = path_of(robot_.path);
  s.tcp = tcp_->currentText().toStdString();
  s.mount = mount_link_->currentText().toStdString();
  s.mount_is_known = mount_is_known_->isChecked();
  s.mount_from_sensor = *mount();
  s.joints = joints_;
  s.positions = positions_;
  s.marker_count = markers_->value();
  if (has_target) s.target = form_->target();
  if (!has_cameras) {
    s.target_poses = target_poses_;
    return s;
  }
  s.rig = rig_;
  s.images = images_;
  // A calibration without the images' size takes that of the first image.
  for (const InstantImages& instant : images_)
    for (std::size_t c = 0; c < std::min(s.rig.cameras.size(), instant.files.size()); ++c) {
      Camera& camera = s.rig.cameras[c].camera;
      if (camera.width > 0 || instant.files[c].empty()) continue;
      const QSize size = QImageReader(QString::fromStdString(instant.files[c].string())).size();
      camera.width = size.width();
      camera.height = size.height();
    }
  return s;
}

QString SessionWizard::what_does_not_fit() const {
  const std::size_t measured = known() == poses ? target_poses_.size() : images_.size();
  if (mount_is_known_->isChecked() && !mount()) return tr("The camera's place is three numbers in m and three in rad.");
  if (read_robot_ && joints_between(*read_robot_, mount_link_->currentIndex(), tcp_->currentIndex()) == 0)
    return tr("No joint moves between camera and target: choose other links.");
  if (measured > 0 && !positions_.empty() && measured != positions_.size())
    return (known() == poses
                ? tr("There are %1 lines of joint angles for %2 poses: each instant needs one of each, in "
                     "the same order.")
                : tr("There are %1 lines of joint angles for %2 images: each instant needs one of each, in "
                     "the same order."))
        .arg(positions_.size())
        .arg(measured);
  if (known() == poses || images_.empty() || rig_.count() == 0) return {};
  const auto cameras = static_cast<int>(images_.front().files.size());
  if (cameras != rig_.count())
    return tr("There are images of %1 and a calibration of %2.")
        .arg(counted(cameras, "%n camera(s)"), counted(rig_.count(), "%n camera(s)"));
  return {};
}

void SessionWizard::refresh() {
  const QString sentence = what_does_not_fit();
  refusal_->setText(sentence);
  make_->setEnabled(sentence.isEmpty() && parts().has_value());
  refresh_scene();
}

void SessionWizard::make() {
  const auto all = parts();
  if (!all) return;
  try {
    const Session made = make_session(*all);
    // What arrives there later belongs to this session too.
    if (made.rig) remember_live_sources(made.file, {image_folders(), path_of(angles_.path)});
    accept();
    window_.open(QString::fromStdString(made.file.string()));
  } catch (const std::exception& error) {
    refusal_->setText(QString::fromStdString(error.what()));
  }
}

}  // namespace handsight::app
