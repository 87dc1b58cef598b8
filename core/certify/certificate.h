// SPDX-License-Identifier: Apache-2.0
// What a certificate says of a robot: measured errors before and after correction, what is promised and how often it
// held, over the workspace, and of which files.
#pragma once

#include <filesystem>
#include <string>

#include "certify/iso_test.h"
#include "certify/limits.h"
#include "certify/workspace_map.h"
#include "session/calibration.h"

namespace handsight {

/// Of the hand over all measured poses: m and rad.
struct ErrorFigures {
  double mean = 0, rms = 0, p95 = 0, largest = 0;
  std::optional<double> rms_turn, largest_turn;  // absent: the measurements do not show how the hand is turned
};

struct CertifiedFile {
  std::string what, name;  // "session", "robot", "calibration", "images"
  std::uint64_t bytes = 0;
  std::string sha256;
};

struct Coverage {
  int inside = 0, all = 0;
  ShareInterval interval;  // 95 %
};

struct Certificate {
  std::string date, software, title, robot, hand, sensor, model_from;
  int joints = 0, observations = 0, used = 0, folds = 0, shown_nothing = 0;
  std::vector<AttainedPose> poses;
  ErrorFigures before, after;
  Coverage coverage;
  double median_limit = 0;  // m, of the promised limits of the held-out observations
  IsoTest iso;
  std::vector<ExpectedError> expected;
  std::vector<CalibrationEffect> effects;
  std::vector<CertifiedFile> files;
  bool is_stopped = false;
};

/// What the certificate is made from.
struct CertificateRequest {
  CertifiedModel model;
  std::vector<CalibrationEffect> effects;  // of the model, to be reported
  std::string software;                    // name and version
  std::string model_from;                  // a phrase: where the model comes from
  std::filesystem::path calibration;       // empty: none
  Chain chain;                             // with `prediction`: of the hand, for the map
  PredictionModel prediction;
};

/// `goes_on` is asked with the share that is done; where it says no, the certificate is `is_stopped` and not whole.
/// InputError as attained_poses.
Certificate make_certificate(const Session& session, const CertificateRequest& request,
                             const std::function<bool(double done)>& goes_on = {});

/// "2 cameras of 1920 x 1080 pixels on head": what measured.
std::string sensor_text(const Session& session);

}  // namespace handsight
