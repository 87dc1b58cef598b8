// SPDX-License-Identifier: Apache-2.0
// A simulated session as a folder: session.xml, the robot, images, truth.xml.
#pragma once

#include <filesystem>
#include <functional>

#include "simulation/simulated_truth.h"
#include "simulation/simulation_options.h"

namespace handsight {

struct ImageOptions {
  int observations = 0;     // so many get rendered images in place of labels: the first, the disturbed, and others
                            // evenly spread
  double noise_grey = 2.0;  // grey levels
  double blur_px = 0.9;     // px, Gaussian
  int distractors = 12;     // X-corners in the scene that are no markers
};

struct WrittenSession {
  int with_images = 0;
  std::string label_hint;  // the command that labels the first observation; empty without images
};

/// Makes the folder whole or not at all (it is written beside its place and renamed). InputError where the folder holds
/// a session already. `rendered` is called with the number of observations rendered so far.
WrittenSession write_simulated(SimulatedSession simulated, const SimulationOptions& options,
                               const std::filesystem::path& robot_file, const ImageOptions& images,
                               const std::filesystem::path& out, const std::function<void(int)>& rendered = {});

/// Renders what the cameras see in observation `k` into folder/images, and names the files in the observation. The
/// scene is that of `scene_of`, the same for all images of a robot. The simulation has cameras.
void write_images(const SimulatedSession& scene_of, const SimulationOptions& options, const ImageOptions& images,
                  std::size_t k, const std::filesystem::path& folder, SimulatedSession& simulated);

}  // namespace handsight
