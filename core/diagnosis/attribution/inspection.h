// SPDX-License-Identifier: Apache-2.0
// Every observation held against the model, the ones that are not part of the fit too: how far off, whose fault, and
// the smallest change that would make it right.
#pragma once

#include <algorithm>
#include <string>

#include "base/message.h"
#include "diagnosis/attribution/error_attribution.h"
#include "diagnosis/outliers/lone_observations.h"
#include "diagnosis/outliers/snooping.h"
#include "estimation/online/second_look.h"
#include "estimation/report/fit_report.h"

namespace handsight {

/// One marker in one image, px: where it was seen, where the model predicts it (nothing behind the camera).
struct ImageCorner {
  std::optional<Vector2> measured, predicted;

  bool is_compared() const { return measured && predicted; }
};

/// One marker of one observation, measured against predicted.
struct MarkerResidual {
  int marker = 0;
  std::vector<ImageCorner> corners;               // by camera of the rig; none in tracker sessions
  Vector3 predicted_in_sensor = Vector3::Zero();  // m
  std::optional<Vector3> measured_in_sensor;      // m, triangulated or the tracker's

  bool is_seen() const {
    return std::any_of(corners.begin(), corners.end(), [](const ImageCorner& c) { return c.measured.has_value(); });
  }
};

struct InspectionRow {
  std::int64_t id = 0;
  int index = 0;  // into Session::observations
  bool is_used = false;
  bool at_second_look = false;  // the markers were found with wider gates after the observation was rejected
  int coordinates = 0;
  std::optional<double> rms;    // px (m in tracker sessions) of one coordinate
  std::optional<double> rms_m;  // m, of the markers' distances in space, measured to predicted
  int points = 0;               // markers that are known in space: what rms_m averages
  /// What noise alone makes of rms_m: its root mean square (m), and of how many equal coordinates it is that.
  std::optional<double> noise_m;
  double noise_coordinates = 0;
  /// Of cameras: how far the hand is seen from where it is predicted, all markers together, m; what noise alone makes
  /// of it (rms, m), and of how many equal coordinates it is that.
  std::optional<double> hand_m, noise_of_hand_m;
  double hand_coordinates = 0;
  std::optional<double> angle;  // rad, of tcp_from_tcp_est
  std::optional<double> ratio;  // rms over the noise
  std::optional<Rigid> tcp_from_tcp_est;
  Rigid root_from_tcp, root_from_sensor;
  std::vector<MarkerResidual> markers;
  int worst_marker = -1;
  int worst_camera = -1;  // of the rig; -1: a tracker
  double worst_size = 0;  // px (m), length
  ErrorAttribution attribution;
  bool outlier = false;                    // stands out of the other observations
  Message what_would_mend;                 // a sentence (change_text); empty: nothing to mend
  std::optional<double> smallest_visible;  // px (m): an error of one corner below it could not be seen here
};

struct Inspection {
  std::vector<InspectionRow> rows;  // one for each observation of the session, in its order
  std::optional<double> noise;      // px or m, of one coordinate
  std::optional<double> noise_m;    // m: what noise alone makes of the used markers' distances in space
  ErrorAttribution attribution;     // of the used observations together
  bool in_pixels = true;
};

/// One observation against any estimate; `row` has its id and index already. `noise` of one coordinate, where known.
void inspect_observation(const Problem& problem, const ProblemObservation& observation, const Unknowns& unknowns,
                         std::optional<double> noise, const std::vector<char>& marker_is_known, InspectionRow& row);

/// The model's effects move the robot, the cameras and the markers as in the fit.
Inspection inspect(const Session& session, const Fit& fit, const FitReport& report, const SecondLooks& looks);

/// A point that is wrong whatever the robot does makes its observation odd, though the fit no longer holds it; so does
/// what was left out as a whole.
void mark_left_out(const std::vector<WrongPoint>& points, const std::vector<LoneObservation>& lone,
                   Inspection& inspection);

}  // namespace handsight
