// SPDX-License-Identifier: Apache-2.0
// Which random numbers a simulation takes for what. Internal to its sources.
#pragma once

#include <cstdint>

namespace handsight {

/// The streams of random numbers, one a purpose, so that one more observation changes nothing before it.
enum SimulationStream : std::uint64_t {
  body_stream = 1,
  pose_stream = 2,
  time_stream = 3,
  noise_stream = 100,
  wrong_stream = 1 << 20,
  unseen_stream = 1 << 21
};

}  // namespace handsight
