// SPDX-License-Identifier: GPL-3.0-or-later
// A new session: three questions with drawings (where is the camera, where is the target, what is known of it), then
// what there is of files. Each is read as it is named, and what does not fit is said beside it; a view shows the robot
// with camera and target on the links that were chosen.
#pragma once

#include <QDialog>
#include <optional>

#include "base/message.h"
#include "session/new_session.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace handsight::widgets {
class PictureChoice;
class RobotView;
}  // namespace handsight::widgets

namespace handsight::app {

class TargetForm;

class SessionWizard : public QDialog {
  Q_OBJECT

 public:
  /// Over `window`; the session that it makes is handed to `open`.
  /// `bring`: asked for where there is a bag or other files instead.
  static void run(QWidget& window, std::function<void(const QString& path)> open, std::function<void()> bring);

 private:
  SessionWizard(QWidget& window, std::function<void(const QString& path)> open, std::function<void()> bring);
  /// A line with a name, a path, a button to choose it, and a sentence below.
  struct Part {
    QLabel* caption = nullptr;
    QLineEdit* path = nullptr;
    QPushButton* browse = nullptr;
    QLabel* sentence = nullptr;
  };
  enum class Choice { folder, file, files };
  enum CameraPlace { on_stand, on_link, on_hand, by_touch };
  enum TargetPlace { with_hand, on_table };
  enum Known { markers, chessboard, charuco, aprilgrid, tags, printed, poses, circles };

  QWidget* make_questions();
  QWidget* make_scene();
  QLabel* add_heading(const QString& text);
  Part add_part(const char* name, const QString& label, const QString& hint, Choice choice, const QString& filter = {});
  void add_files();
  void add_flange_row();
  void add_robot_rows();
  void add_mount_rows();
  void add_markers_row();
  void add_session_rows();
  void connect_all();
  void show_part(const Part& part, bool visible);

  Known known() const;
  bool is_flange_only() const;
  int look_up_link(const QComboBox* box) const;
  void ask_camera_place();
  void ask_target_place();
  void ask_known();
  void choose_links();
  void ask_flange_only();
  void read_robot();
  void offer_links();
  void read_images();
  void read_angles();
  void read_joints(std::vector<Message>& notes);
  void read_flange(std::vector<Message>& notes);
  void read_calibration();
  enum class PosesOf { flange, target };
  std::vector<Rigid> poses_in(const Part& part, PosesOf of_what, std::vector<Message>& notes) const;
  void read_poses_of_target();
  void read_target();
  void refresh();
  void show_robot();
  void refresh_scene();
  std::vector<std::filesystem::path> image_folders() const;
  QString images_sentence() const;
  QString what_does_not_fit() const;
  QString links_sentence() const;
  std::optional<Rigid> mount() const;
  std::optional<NewSession> parts() const;
  void make();
  static void say(const Part& part, const QString& sentence, bool is_refusal);

  std::function<void(const QString& path)> open_made_;
  std::function<void()> bring_;
  QGridLayout* grid_;
  widgets::PictureChoice *camera_place_, *target_place_, *known_;
  TargetForm* form_;
  Part left_, right_, more_, angles_, robot_, calibration_, poses_, target_;
  QComboBox *tcp_, *mount_link_;
  QCheckBox *flange_only_, *mount_is_known_;
  QLineEdit *mount_xyz_, *mount_rpy_, *title_;
  QLabel* markers_caption_;
  QSpinBox* markers_;
  QLabel *refusal_, *links_said_;
  QPushButton* make_;
  widgets::RobotView* scene_;

  std::vector<InstantImages> images_;
  std::optional<Robot> read_robot_;
  Rig rig_;
  std::vector<std::string> joints_;  // of the table of angles, or those that stand for the flange's pose
  std::vector<Eigen::VectorXd> positions_;
  std::vector<Rigid> target_poses_;
};

}  // namespace handsight::app
