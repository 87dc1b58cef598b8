// SPDX-License-Identifier: Apache-2.0
// A robot with what was found out about it: what predictions, corrections and exports are made from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/message.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/prediction.h"

namespace handsight {

struct CalibratedRobot {
  Chain chain;
  std::vector<std::string> joint_names;  // the order of a position
  std::string tcp, mount;                // links
  PredictionModel model;
  std::vector<double> times;               // s, of the session's observations; empty: not known
  std::vector<Eigen::VectorXd> positions;  // of the session's used observations; empty: not known
  Calibration calibration;                 // the same in numbers, with their sigmas
  std::optional<Rig> rig;                  // with the effects on rig and cameras; absent: a tracker, or not known
  std::string urdf_text, urdf_file;        // the robot as written; the text is empty where it was not kept
  std::filesystem::path robot_folder;      // where its meshes are named from; empty: not known
  std::optional<PredictionModel> of_hand;  // for chain_of_hand, where the sensor rides on the hand (hand_end.h)
  std::vector<Message> notes;              // a sentence each
};

/// The robot with the end that it moves as its hand: exchanged ends where the sensor rides on it, else as it is.
/// Predictions, corrections and programs are of this one.
CalibratedRobot with_moved_hand(CalibratedRobot robot);

/// The session's fit with what a file of it would say. `software`: name and version.
CalibratedRobot calibrated_robot(const Session& session, const Fit& fit, const FitReport& reported,
                                 const FitOptions& options, const std::string& software,
                                 const ModelUncertainty& model_uncertainty = {});

/// From an exported calibration and the robot; `robot_file` and `file` are what sentences call them. InputError where
/// the file does not say what a prediction needs, or does not fit the robot.
CalibratedRobot calibrated_robot(const Calibration& calibration, Robot robot, const std::string& robot_file,
                                 const std::string& file);

/// Is this the text of an exported calibration, not of a session?
bool is_calibration_file(const std::filesystem::path& path);

}  // namespace handsight
