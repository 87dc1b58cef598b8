// SPDX-License-Identifier: GPL-3.0-or-later
// One observation against the model, as image overlays and as a 3D scene; shared by Calibrate and Inspect.
#pragma once

#include "widgets/images/image_view.h"
#include "widgets/scene/robot_view.h"
#include "workbench/workbench.h"

namespace handsight::app {

/// "left", "right" in the user's language, else as the session names the camera.
QString camera_name(const Rig& rig, int camera);
/// The same as a title: "Left".
QString camera_title(const Rig& rig, int camera);
/// All of them, by camera.
QStringList camera_names_in_words(const Rig& rig);

/// Measured and predicted markers of one image.
std::vector<widgets::ImageMark> image_marks(const InspectionRow& row, int camera, const Rig& rig,
                                            std::optional<double> noise, const DisplayUnits& units);
/// Residual arrows of one image.
std::vector<widgets::ImageArrow> image_arrows(const InspectionRow& row, int camera, std::optional<double> noise);
/// TCP and, where it is known, TCPest, with axes of 5 cm.
std::vector<widgets::ImageAxes> image_axes(const InspectionRow& row, const Rig& rig, int camera);

/// Labels alone, where there is no estimate yet.
std::vector<widgets::ImageMark> label_marks(const Observation& observation, int camera);

/// A camera's image and where it is shown.
struct ShownCamera {
  widgets::ImageView* view = nullptr;
  int camera = 0;
};

/// Images of an observation with everything that is known of it; `row` may be null. One that is still being read stands
/// as an empty frame until then, unless it is wanted `at_once`.
void show_images(Workbench& workbench, const Observation& observation, const InspectionRow* row,
                 const std::vector<ShownCamera>& shown, bool with_axes, bool at_once = false);

/// The robot in the observation's pose with its cameras, TCP, TCPest and markers; `row` may be null. The ghost is the
/// hand where it was measured.
void show_pose(const Document& document, const Observation& observation, const InspectionRow* row,
               widgets::RobotView& view);

/// Residual arrows at every TCP of an inspection, and of touches at every tip; above a thousand observations, of every
/// n-th and of the outliers.
std::vector<widgets::SceneArrow> scene_arrows(const Session& session, const Inspection& inspection,
                                              const SessionFilter& shown);

/// The robot's links in a posture given in the order of Session::joints.
std::vector<Rigid> link_motions(const Session& session, const Eigen::VectorXd& position);

/// 1, 2, 5, 10, ...: how much arrows of this size are to be magnified to be about `wanted` long.
double round_magnification(double size, double wanted);

/// The same where `size` may be noise (its sigma, 0: unknown, in the same unit): what is wanted holds six sigma at
/// least, so that what noise alone makes stays as small as noise is.
double magnification_over_noise(double size, std::optional<double> noise, double wanted);

/// For the arrows of all observations in 3D: the largest of those that count is about 10 cm long.
double arrow_magnification(const Inspection& inspection);

}  // namespace handsight::app
