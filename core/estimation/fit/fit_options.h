// SPDX-License-Identifier: Apache-2.0
// What a fit is asked for.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "camera/camera_knowledge.h"
#include "chain/body_frame.h"
#include "effects/effect.h"
#include "estimation/problem/problem.h"
#include "estimation/solvers/loss.h"

namespace handsight {

enum class Objective {
  image,       // thesis (4.42): px in the images (m in a tracker session)
  camera,      // thesis (4.41): m in the first camera's frame, triangulated markers
  angle_axis,  // thesis (4.39-4.40): body pose of each observation; m and rad weighed by their sigmas
};

struct FitOptions {
  Objective objective = Objective::image;
  bool fix_markers = false;  // hold the body's shape at the average of the observations (thesis 4.19-4.23)
  Loss loss = Loss::none;
  std::vector<EffectTerm> effects;    // in the model, held at these values
  std::vector<EffectTerm> estimated;  // in the model, estimated with their prior sigmas as priors; from here
  std::shared_ptr<const CameraKnowledge> camera_images;  // of the session's rig; counts with the cameras' effects
  std::optional<BodySides> sides;                        // decided earlier; absent: decided by this fit's estimate
  std::optional<Rigid> start_tcp_from_body;  // what the session cannot observe of the rotation is taken from here
  std::optional<Unknowns> start;  // markers and mount of a fit before, near the answer; absent: in closed form
  int most_iterations = 100;
  double smallest_step = 1e-12;  // SolveOptions::smallest_step
  double least_gain = 0;         // SolveOptions::least_gain
  double reuse_below = 0;        // SolveOptions::reuse_below
  std::function<bool(int iteration, double cost, const Unknowns&)> on_iteration;
};

}  // namespace handsight
