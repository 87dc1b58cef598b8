// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "estimation/prediction.h"

namespace handsight::cli {

/// What a prediction is made from: a session, which is fitted, or a calibration file and a robot.
struct PredictSource {
  Chain chain;
  std::vector<std::string> joint_names;
  PredictionModel model;
  std::vector<double> times;  // s, of the session's observations; empty: not known
  std::vector<std::string> notes;
};

PredictSource predict_source(const std::string& session_or_calibration, const std::string& robot_file);

}  // namespace handsight::cli
