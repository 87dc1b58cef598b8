// SPDX-License-Identifier: Apache-2.0
// A rig of one to eight cameras. The first is the reference: the rig's frame is its frame.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/message.h"
#include "camera/camera.h"

namespace handsight {

constexpr int max_cameras = 8;

template <class T>
struct RigCameraT {
  std::string name;  // letters, digits, _; each once in a rig
  CameraT<T> camera;
  RigidT<T> camera_from_first;  // X_camera = camera_from_first * X_first; the first's own is the identity
};
using RigCamera = RigCameraT<double>;

template <class T>
struct RigT {
  std::vector<RigCameraT<T>> cameras;  // 1 to max_cameras

  int count() const { return static_cast<int>(cameras.size()); }
  const RigCameraT<T>& at(int camera) const { return cameras[static_cast<std::size_t>(camera)]; }
  RigCameraT<T>& at(int camera) { return cameras[static_cast<std::size_t>(camera)]; }
};
using Rig = RigT<double>;

/// Two cameras as a rig of the names `left` and `right`.
Rig make_rig(const StereoRig& stereo);

/// The first two cameras of a rig; it must have two.
StereoRig make_stereo(const Rig& rig);

/// Exactly two cameras: what the search for corners and their pairs works with.
inline bool is_pair(const Rig& rig) { return rig.count() == 2; }

/// Exactly two cameras, named `left` and `right`: what <stereo> holds.
bool is_left_and_right(const Rig& rig);

/// The names of the cameras.
std::vector<std::string> camera_names(const Rig& rig);

/// "front, side and rear".
Message listed_names(const Rig& rig);

/// The camera of that name, -1 where there is none.
int find_camera(const Rig& rig, const std::string& name);

/// Of what cameras have against a point (0: they see it well), the sum of the least two: of a single camera its own.
struct LeastTwo {
  double least = -1, second = -1;  // < 0: none yet

  void add(double x) {
    if (least < 0 || x < least) {
      second = least;
      least = x;
    } else if (second < 0 || x < second) {
      second = x;
    }
  }
  double sum() const { return (least < 0 ? 0 : least) + (second < 0 ? 0 : second); }
};

/// "both cameras", "the camera" or "two of the cameras": which must see a marker in a good pose.
const char* cameras_that_must_see(const std::optional<Rig>& rig);

/// One camera that saw a point.
struct View {
  const Camera* camera = nullptr;
  const Rigid* camera_from_first = nullptr;
  Vector2 pixel;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  // of the image point, px^2
};

/// A point in the first camera's frame (m) and its covariance (m^2).
struct SeenPoint {
  Vector3 point;
  Matrix3 covariance;
};

/// The point of the least reprojection error in all views, from Bouguet's linear start (thesis 4.12-4.15) of the two
/// views whose rays meet at the widest angle. Nothing with fewer than two views, where all rays are parallel, where the
/// point would lie behind a camera, or where a distortion cannot be undone.
std::optional<SeenPoint> triangulate(std::span<const View> views);

/// The numbers of a camera that effects and estimates may move, in the order in which sites and derivatives hold them.
/// Everything else that needs their names, units and prior sigmas reads this table.
struct CameraNumber {
  const char* name;
  const char* unit;
  double sigma;           // the plausible error of a calibration, one standard deviation
  double share_of_focal;  // > 0: the sigma of a session is this share of its focal length (px)
  double Camera::*value;
};
constexpr int camera_number_count = 8;
constexpr int distortion_numbers = 4;  // the last of them; those before are of the pinhole
std::span<const CameraNumber, camera_number_count> camera_numbers(const Camera& camera);

/// How the numbers of a whole rig are laid out: the motions of all cameras but the first (6 each), then each camera's
/// numbers.
constexpr int motion_number(int camera) { return 6 * (camera - 1); }
constexpr int first_number(int cameras, int camera) { return 6 * (cameras - 1) + camera_number_count * camera; }
constexpr int rig_number_count(int cameras) { return first_number(cameras, cameras); }

}  // namespace handsight
