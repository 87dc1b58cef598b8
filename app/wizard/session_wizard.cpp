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
#include "live/live_watch.h"
#include "widgets/base/theme.h"
#include "wizard/target_form.h"
#include "wizard/wizard_paths.h"
#include "wizard/wizard_scene.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::app {
namespace {

std::optional<Vector3> three_numbers(const QLineEdit* edit) {
  const auto numbers = parse_numbers(edit->text().replace(',', ' ').toStdString());
  if (!numbers || numbers->size() != 3) return std::nullopt;
  return Vector3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

}  // namespace

void SessionWizard::run(QWidget& window, std::function<void(const QString& path)> open, std::function<void()> bring) {
  auto* wizard = new SessionWizard(window, std::move(open), std::move(bring));
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
    for (const auto& folder : list_paths(more_.path)) folders.push_back(folder);
  return folders;
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
  if (!is_flange_only()) s.urdf = path_of(robot_.path);
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
  if (read_robot_ && joints_between(*read_robot_, look_up_link(mount_link_), look_up_link(tcp_)) == 0)
    return tr("No joint moves between camera and target: choose other links.");
  if (measured > 0 && !positions_.empty() && measured != positions_.size())
    return (is_flange_only()
                ? (known() == poses ? tr("There are %1 poses of the flange for %2 poses of the target: each instant "
                                         "needs one of each, in the same order.")
                                    : tr("There are %1 poses of the flange for %2 images: each instant needs one of "
                                         "each, in the same order."))
            : known() == poses ? tr("There are %1 lines of joint angles for %2 poses: each instant needs one of each, "
                                    "in the same order.")
                               : tr("There are %1 lines of joint angles for %2 images: each instant needs one of "
                                    "each, in the same order."))
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
    if (made.rig && !is_flange_only()) remember_live_sources(made.file, {image_folders(), path_of(angles_.path)});
    accept();
    open_made_(QString::fromStdString(made.file.string()));
  } catch (const std::exception& error) {
    refusal_->setText(translated_error(error));
  }
}

}  // namespace handsight::app
