// SPDX-License-Identifier: GPL-3.0-or-later
// What the wizard reads of the files that are named, each as soon as it is.
#include <QComboBox>
#include <QLineEdit>
#include <algorithm>

#include "base/error.h"
#include "convert/brought.h"
#include "readers/csv.h"
#include "readers/stereo_calibration.h"
#include "robot/urdf.h"
#include "widgets/base/number_text.h"
#include "wizard/session_wizard.h"
#include "wizard/wizard_paths.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::app {
namespace {

QString with_notes(QString sentence, const std::vector<Message>& notes) {
  for (const Message& note : notes) sentence += " " + translated(note);
  return sentence;
}

}  // namespace

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
      say(where, translated_error(error), true);
    }
  refresh();
}

void SessionWizard::read_robot() {
  read_robot_.reset();
  say(robot_, {}, false);
  if (is_flange_only()) {
    read_robot_ = poses_robot();
  } else if (!robot_.path->text().isEmpty()) {
    try {
      read_robot_ = read_urdf(path_of(robot_.path));
      say(robot_,
          tr("%1 links, %2 joints that move by themselves.")
              .arg(read_robot_->links.size())
              .arg(joint_names(*read_robot_).size()),
          false);
    } catch (const InputError& error) {
      say(robot_, translated_error(error), true);
    }
  }
  offer_links();
  show_robot();
  choose_links();
  read_angles();
}

void SessionWizard::offer_links() {
  for (QComboBox* box : {tcp_, mount_link_}) {
    const QSignalBlocker silent(box);
    box->clear();
    if (!read_robot_) continue;
    const std::vector<std::string> links =
        is_flange_only() ? std::vector<std::string>{"base", "flange"} : link_names(*read_robot_);
    for (const std::string& link : links) box->addItem(QString::fromStdString(link));
    box->setCurrentIndex(box == tcp_ ? box->count() - 1 : 0);
  }
}

void SessionWizard::read_angles() {
  joints_.clear();
  positions_.clear();
  say(angles_, {}, false);
  if (angles_.path->text().isEmpty()) return refresh();
  if (!read_robot_) {
    say(angles_, tr("Waits for the robot, which names the joints."), false);
    return refresh();
  }
  try {
    std::vector<Message> notes;
    if (is_flange_only())
      read_flange(notes);
    else
      read_joints(notes);
  } catch (const InputError& error) {
    say(angles_, translated_error(error), true);
  }
  refresh();
}

void SessionWizard::read_joints(std::vector<Message>& notes) {
  joints_ = joints_of_table(path_of(angles_.path), *read_robot_);
  positions_ = read_poses(path_of(angles_.path), joints_, &notes);
  say(angles_, with_notes(tr("%1 poses of %2 joints.").arg(positions_.size()).arg(joints_.size()), notes), false);
}

void SessionWizard::read_flange(std::vector<Message>& notes) {
  NewSession flange;
  set_flange_poses(flange, poses_in(angles_, PosesOf::flange, notes));
  joints_ = flange.joints;
  positions_ = flange.positions;
  say(angles_, with_notes(counted(static_cast<int>(positions_.size()), "%n pose(s) of the flange") + ".", notes),
      false);
}

/// Those of a table or list of poses, or of samples of easy_handeye, which have both.
std::vector<Rigid> SessionWizard::poses_in(const Part& part, PosesOf of_what, std::vector<Message>& notes) const {
  const Brought brought = bring({path_of(part.path)}, nullptr, false);
  notes = brought.notes;
  if (brought.samples)
    return of_what == PosesOf::flange ? brought.samples->base_from_effector : brought.samples->camera_from_target;
  if (brought.poses.empty())
    throw InputError(verbatim(tr("%1: holds no poses; expected columns x y z qx qy qz qw, a line for each instant.")
                                  .arg(part.path->text())
                                  .toStdString()));
  if (brought.poses.size() != 2) return settled_series(brought.poses.front()).poses;
  const auto [flange, target] = flange_and_target(brought.poses);
  return settled_series(of_what == PosesOf::flange ? flange : target).poses;
}

void SessionWizard::read_calibration() {
  rig_.cameras.clear();
  say(calibration_, {}, false);
  if (!calibration_.path->text().isEmpty()) try {
      std::vector<Message> notes;
      rig_ = rig_of_files(list_paths(calibration_.path), notes);
      const QString sentence =
          rig_.count() == 1 ? tr("One camera of %1 px focal length.").arg(widgets::fixed_text(rig_.at(0).camera.fx, 0))
          : rig_.count() == 2 ? tr("Cameras %1 mm apart.")
                                    .arg(widgets::fixed_text(1e3 * rig_.at(1).camera_from_first.translation.norm(), 1))
                              : tr("%1 cameras.").arg(rig_.count());
      say(calibration_, with_notes(sentence, notes), false);
    } catch (const InputError& error) {
      say(calibration_, translated_error(error), true);
    }
  refresh();
}

void SessionWizard::read_poses_of_target() {
  target_poses_.clear();
  say(poses_, {}, false);
  if (known() == poses && !poses_.path->text().isEmpty()) try {
      std::vector<Message> notes;
      target_poses_ = poses_in(poses_, PosesOf::target, notes);
      say(poses_, with_notes(counted(static_cast<int>(target_poses_.size()), "%n pose(s) of the target") + ".", notes),
          false);
    } catch (const InputError& error) {
      say(poses_, translated_error(error), true);
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

}  // namespace handsight::app
