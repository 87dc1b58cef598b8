// SPDX-License-Identifier: GPL-3.0-or-later
// The wizard's three questions, and what their answers change in what else it asks for.
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "widgets/base/picture_choice.h"
#include "widgets/scene/robot_view.h"
#include "wizard/session_wizard.h"
#include "wizard/target_form.h"
#include "wizard/wizard_scene.h"
#include "words/counted.h"
#include "workbench/heading.h"

namespace handsight::app {

QWidget* SessionWizard::make_questions() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  camera_place_ = new widgets::PictureChoice(
      "camera_place",
      {{"camera_on_stand", tr("On a stand"), tr("It stands beside the robot and does not move.")},
       {"camera_on_link", tr("On the robot"), tr("On its head or any other link that is not the one with the target.")},
       {"camera_on_hand", tr("On the hand"), tr("It moves with the hand and looks at a target that stands still.")},
       {"touch_things", tr("I touch things"), tr("No camera: a probe's tip touches plates, sockets, gauges.")}},
      4);
  target_place_ = new widgets::PictureChoice(
      "target_place",
      {{"target_on_hand", tr("On the hand"), tr("It is held or mounted; the hand carries it.")},
       {"target_on_table", tr("On the table"), tr("It stands still beside the robot.")}},
      4);
  known_ = new widgets::PictureChoice(
      "known",
      {{"known_markers", tr("Markers without numbers"), tr("Corners of two colours that you click once; two cameras.")},
       {"known_chessboard", tr("Chessboard"), tr("Found by itself where the whole board is in sight.")},
       {"known_charuco", tr("ChArUco board"), tr("Found by itself, also where a part of it is hidden.")},
       {"known_aprilgrid", tr("AprilGrid"), tr("A grid of AprilTags, as Kalibr prints it.")},
       {"known_tags", tr("Tags"), tr("ArUco or AprilTags, each where you put it.")},
       {"known_printed", tr("Printed from here"), tr("A good board for a start, as a PDF to print.")},
       {"known_poses", tr("Poses from another program"), tr("A table of where the target is, in place of images.")},
       {"known_circles", tr("Grid of circles"), tr("Found by itself where the whole grid is in sight.")}},
      4);
  column->addWidget(heading(tr("Where is the camera?")));
  column->addWidget(camera_place_);
  column->addSpacing(6);
  column->addWidget(heading(tr("Where is the target?")));
  column->addWidget(target_place_);
  column->addSpacing(6);
  column->addWidget(heading(tr("What do you know of it?")));
  column->addWidget(known_);
  form_ = new TargetForm;
  column->addWidget(form_);
  column->addSpacing(6);
  camera_place_->choose(on_link);
  connect(camera_place_, &widgets::PictureChoice::chosen, this, &SessionWizard::ask_camera_place);
  connect(target_place_, &widgets::PictureChoice::chosen, this, &SessionWizard::ask_target_place);
  connect(known_, &widgets::PictureChoice::chosen, this, &SessionWizard::ask_known);
  return page;
}

QWidget* SessionWizard::make_scene() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  scene_ = new widgets::RobotView;
  scene_->setObjectName("wizard_scene");
  scene_->set_empty_text(tr("The robot stands here as soon as its URDF is named."));
  links_said_ = new QLabel;
  links_said_->setObjectName("wizard_links");
  links_said_->setWordWrap(true);
  column->addWidget(scene_, 1);
  column->addWidget(links_said_);
  return page;
}

SessionWizard::Known SessionWizard::known() const { return static_cast<Known>(known_->current()); }

bool SessionWizard::is_flange_only() const { return flange_only_->isChecked(); }

int SessionWizard::look_up_link(const QComboBox* box) const {
  return read_robot_ ? find_link(*read_robot_, box->currentText().toStdString()) : -1;
}

/// A flange has no links between it and the base: the camera stands, or is on it.
void SessionWizard::ask_flange_only() {
  const bool is_flange = is_flange_only();
  camera_place_->set_possible(on_link, !is_flange);
  if (is_flange && camera_place_->current() == on_link)
    camera_place_->choose(target_place_->current() == on_table ? on_hand : on_stand);
  show_part(robot_, !is_flange);
  angles_.caption->setText(is_flange ? tr("Poses of the flange") : tr("Joint angles"));
  angles_.path->setPlaceholderText(is_flange ? tr("CSV or YAML: x y z qx qy qz qw in the base's frame")
                                             : tr("CSV: a line for each instant, rad"));
  read_robot();
}

/// Something must move between the two: an answer that leaves nothing to move changes the other.
void SessionWizard::ask_camera_place() {
  if (camera_place_->current() == by_touch) {  // tables, not images
    reject();
    return bring_();
  }
  if (camera_place_->current() == on_hand) target_place_->choose(on_table);
  if (camera_place_->current() == on_stand) target_place_->choose(with_hand);
  choose_links();
  refresh();
}

void SessionWizard::ask_target_place() {
  if (target_place_->current() == with_hand && camera_place_->current() == on_hand)
    camera_place_->choose(is_flange_only() ? on_stand : on_link);
  if (target_place_->current() == on_table && camera_place_->current() == on_stand) camera_place_->choose(on_hand);
  choose_links();
  refresh();
}

void SessionWizard::choose_links() {
  const bool stands = camera_place_->current() == on_stand, lies = target_place_->current() == on_table;
  if (read_robot_) {
    const int last = mount_link_->count() - 1;
    const QSignalBlocker a(mount_link_), b(tcp_);
    if (stands) mount_link_->setCurrentIndex(0);
    if (camera_place_->current() == on_hand && mount_link_->currentIndex() == 0) mount_link_->setCurrentIndex(last);
    if (lies) tcp_->setCurrentIndex(0);
    if (!lies && tcp_->currentIndex() == 0) tcp_->setCurrentIndex(last);
  }
  mount_link_->setEnabled(read_robot_.has_value() && !stands && !is_flange_only());
  tcp_->setEnabled(read_robot_.has_value() && !lies && !is_flange_only());
}

void SessionWizard::ask_known() {
  const Known what = known();
  const bool is_board = what != markers && what != poses;
  const TargetKind kinds[] = {TargetKind::charuco, TargetKind::chessboard, TargetKind::charuco, TargetKind::aprilgrid,
                              TargetKind::tags,    TargetKind::charuco,    TargetKind::charuco};
  const bool are_circles = what == circles;
  form_->setVisible(is_board);
  if (are_circles) form_->ask_circles();
  if (is_board && !are_circles) form_->ask(kinds[what], what == printed);
  left_.caption->setText(is_board ? tr("Images") : tr("Left images"));
  right_.caption->setText(is_board ? tr("Second camera") : tr("Right images"));
  right_.path->setPlaceholderText(is_board ? tr("folder; if there is one") : tr("folder; may be the same"));
  calibration_.caption->setText(is_board ? tr("Camera calibration") : tr("Stereo calibration"));
  for (const Part* part : {&left_, &right_, &calibration_}) show_part(*part, what != poses);
  show_part(more_, is_board);
  show_part(poses_, what == poses);
  markers_->setVisible(what == markers);
  markers_caption_->setVisible(what == markers);
  mount_is_known_->setText(what == poses ? tr("I know where the sensor sits on its link")
                           : is_board    ? tr("I know where the first camera sits on its link")
                                         : tr("I know where the left camera sits on its link"));
  read_images();
  read_poses_of_target();
}

QString SessionWizard::links_sentence() const {
  if (!read_robot_) return {};
  const QString camera = mount_link_->currentText(), target = tcp_->currentText();
  const int moving = joints_between(*read_robot_, look_up_link(mount_link_), look_up_link(tcp_));
  QString sentence = is_flange_only()
                         ? tr("Camera on %1, target on %2: the flange moves, its poses are known.").arg(camera, target)
                         : tr("Camera on %1, target on %2: %3 between them.")
                               .arg(camera, target, counted(moving, "%n moving joint(s)"));
  if (!mount_is_known_->isChecked()) sentence += " " + tr("Where exactly the two sit is found from the observations.");
  return sentence;
}

void SessionWizard::show_robot() {
  scene_->set_robot(read_robot_.value_or(Robot{}),
                    std::filesystem::path(robot_.path->text().trimmed().toStdString()).parent_path());
}

void SessionWizard::refresh_scene() {
  links_said_->setText(links_sentence());
  if (!read_robot_ || mount_link_->currentIndex() < 0 || tcp_->currentIndex() < 0) return;
  WizardScene scene{.robot = &*read_robot_,
                    .joints = joints_,
                    .camera_link = mount_link_->currentText().toStdString(),
                    .target_link = tcp_->currentText().toStdString(),
                    .is_on_table = target_place_->current() == on_table};
  if (!positions_.empty()) scene.position = positions_.front();
  if (mount_is_known_->isChecked()) scene.mount_from_camera = mount();
  if (rig_.count() > 0) scene.camera = rig_.at(0).camera;
  if (scene.camera.width == 0)
    scene.camera = {.width = 1280, .height = 960, .fx = 1100, .fy = 1100, .cx = 640, .cy = 480};
  show_scene(scene, *scene_);
  scene_->look(widgets::StandardView::all);
}

}  // namespace handsight::app
