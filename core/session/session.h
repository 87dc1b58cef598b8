// SPDX-License-Identifier: Apache-2.0
// A session: a robot, what watches it, and the observations. Plain data; read and written by session_xml.h.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "camera/camera.h"
#include "robot/robot.h"
#include "session/effect_definition.h"

namespace handsight {

enum class MarkedBy { hand, tracker, import };

/// How sure an image point is: standard deviations of u and v (px) and their covariance (px^2, smaller than su sv).
struct PixelSigma {
  double u = 0, v = 0, uv = 0;
};

/// Where one marker was seen in one observation. In a stereo session `left` and `right` (px, either may be absent);
/// in a tracker session `point` (m, in the tracker's frame).
struct Sighting {
  int marker = 0;  // 0 to marker_count - 1
  std::optional<Vector2> left, right;
  std::optional<Vector3> point;
  MarkedBy by = MarkedBy::import;
  std::optional<PixelSigma> left_sigma = {}, right_sigma = {};  // absent: the session's usual one
  std::optional<double> point_sigma = {};                       // m, of each coordinate
  /// The sigma of a measurement whose residuals are taken as they are (px, m): those of surer ones are drawn out, those
  /// of less sure ones drawn in. 0: all are taken as they are.
  double usual_sigma = 0;
};

enum class Decision { none, accepted, rejected, excluded };

struct Observation {
  std::int64_t id = 0;                  // non-negative, unique
  double time = 0;                      // s
  Eigen::VectorXd position;             // rad or m, in the order of Session::joints
  Eigen::VectorXd velocity;             // empty where not measured
  Eigen::VectorXd torque;               // N m (N), empty where not measured
  std::string left_image, right_image;  // relative to the session's folder; empty where there are none
  std::vector<Sighting> sightings;      // in order of marker
  Decision decision = Decision::none;
  std::string reason;
};

/// The link that carries the cameras or the tracker, and where on it: mount_from_sensor, the sensor's frame being
/// the left camera's (x right, y down, z forward) or the tracker's own.
struct Mount {
  std::string link;
  Rigid mount_from_sensor;
  bool estimate = false;  // only a guess: part of every fit
  bool known = true;      // false: estimate="yes" with neither xyz nor rpy; the start is found in closed form
};

struct Session {
  std::filesystem::path file;  // session.xml; images and robot are relative to its folder
  std::string title;
  std::string robot_file;
  Robot robot;
  std::string tcp;               // the link whose frame is TCP
  Vector3 gravity{0, 0, -9.81};  // m/s^2, in the root link's frame
  Mount mount;
  std::optional<StereoRig> stereo;    // absent: a tracker session
  std::optional<double> sigma_pixel;  // declared noise of one image coordinate, px
  std::optional<double> sigma_point;  // tracker sessions: declared noise of one coordinate, m
  int marker_count = 0;
  std::vector<std::string> joints;            // the order of position, velocity and torque; joints not named stand at 0
  std::vector<Observation> observations;      // in order of time
  std::vector<EffectDefinition> effect_definitions;  // of effects.xml and the user's own folder
  std::vector<std::string> notes;             // what the reader ignored, and warnings, a sentence each
  std::shared_ptr<const std::string> source;  // the XML text as read, so that saving keeps what is not understood

  bool is_tracker() const { return !stereo.has_value(); }
};

/// The folder that robot and images are relative to.
std::filesystem::path folder(const Session& session);

/// What a sighting without a sigma of its own is taken to have (px, m): declared for the session, else the median of
/// those that are told; 0 where no sighting tells one.
double usual_sigma(const Session& session);

PixelSigma pixel_sigma(const Eigen::Matrix2d& covariance);
Eigen::Matrix2d covariance_of(const PixelSigma& sigma);

/// Is the observation part of a fit: it has a sighting and is neither rejected nor excluded?
bool is_used(const Observation& observation);

}  // namespace handsight
