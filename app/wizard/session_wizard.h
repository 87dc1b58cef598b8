// SPDX-License-Identifier: GPL-3.0-or-later
// A new session from image folders, URDF, joint angles and an OpenCV stereo calibration: every part is read as it is
// named, and what does not fit is said beside it.
#pragma once

#include <QDialog>
#include <optional>

#include "session/new_session.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace handsight::app {

class MainWindow;

class SessionWizard : public QDialog {
  Q_OBJECT

 public:
  /// Opens it over the window; the session that is made is opened there.
  static void run(MainWindow& window);

 private:
  explicit SessionWizard(MainWindow& window);
  /// A line with a name, a path, a button to choose it, and a sentence below.
  struct Part {
    QLineEdit* path = nullptr;
    QLabel* sentence = nullptr;
  };
  enum class Choice { folder, file, files };
  Part add_part(const char* name, const QString& label, const QString& hint, Choice choice, const QString& filter = {});
  void add_robot_rows();
  void add_mount_rows();
  void add_target_rows();
  void read_robot();
  void read_images();
  void read_angles();
  void read_calibration();
  void read_target();
  void refresh();
  std::optional<Rigid> mount() const;
  std::optional<NewSession> parts() const;
  void make();
  static void say(const Part& part, const QString& sentence, bool is_refusal);

  MainWindow& window_;
  QGridLayout* grid_;
  Part left_, right_, angles_, robot_, calibration_, target_;
  QComboBox *tcp_, *mount_link_;
  QCheckBox* mount_is_known_;
  QLineEdit *mount_xyz_, *mount_rpy_, *title_;
  QSpinBox* markers_;
  QLabel* refusal_;
  QPushButton* make_;

  std::vector<ImageFiles> pairs_;
  std::optional<Robot> read_robot_;
  std::optional<StereoRig> rig_;
  std::vector<std::string> joints_;  // of the table of angles
  std::vector<Eigen::VectorXd> positions_;
};

}  // namespace handsight::app
