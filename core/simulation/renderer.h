// SPDX-License-Identifier: Apache-2.0
// Grey images of a scene as a camera would take them, distortion, blur and noise included.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "camera/camera.h"
#include "simulation/scene_parts.h"
#include "vision/image/image.h"

namespace handsight {

/// What the optics and the sensor do to the image.
struct ImageEffects {
  double blur_px = 0.7;     // standard deviation of the Gaussian point spread, beside the pixel's own area
  double noise_grey = 1.5;  // standard deviation of one pixel's noise
  std::uint64_t seed = 1;   // of the noise
};

/// The ray of every pixel, (x', y', 1) in the camera frame: worked out once per camera and used for many images.
struct PixelRays {
  static constexpr int tile = 16;  // px
  Camera camera;
  std::vector<Vector2> rays;  // width * height; NaN where the distortion cannot be undone (left black)
  std::vector<std::array<double, 4>> tile_bounds;  // least x', largest x', least y', largest y' with a pixel around
  int tile_columns = 0, tile_rows = 0;
};

PixelRays pixel_rays(const Camera& camera);

/// The image of the scene: blurred by the optics, gathered over each pixel's square (17 samples a pixel where anything
/// changes inside it, 89 on markers), then noisy, then rounded. The X-corner of a marker lies at
/// project(camera, camera_from_tcp * center), pixel centres being integers.
Image render(const Scene& scene, const PixelRays& rays, const Rigid& root_from_camera, const Rigid& root_from_tcp,
             const ImageEffects& effects = {});

/// The same for a single image.
Image render(const Scene& scene, const Camera& camera, const Rigid& root_from_camera, const Rigid& root_from_tcp,
             const ImageEffects& effects = {});

/// Does the camera see marker `marker`: inside the image by `margin_px` with all its cells, its normal within
/// `most_turned_deg` of the direction to the camera, and nothing in front of centre or cells?
bool marker_is_seen(const Scene& scene, const Camera& camera, const Rigid& root_from_camera, const Rigid& root_from_tcp,
                    int marker, double most_turned_deg = 60, double margin_px = 8);

}  // namespace handsight
