// SPDX-License-Identifier: Apache-2.0
// How likely a change comes just before an observation, by the rounds in which poses are taken. Internal to
// change_watch.
#pragma once

#include <cmath>
#include <numbers>
#include <set>

namespace handsight {

/// Shares of 1 that fall as slowly as shares can: about 1 / (k ln(k)^2). Over all k they are 1 together.
inline double slow_share(std::size_t k) {
  const auto x = static_cast<double>(k) + std::numbers::e;
  return 1 / std::log(x) - 1 / std::log(x + 1);
}

/// Robots are hit and knocked between two rounds rather than within one: half of what a round weighs is its begin's. A
/// round ends where one of its poses is taken again.
class Rounds {
 public:
  /// ln of the weight of a change just before the next observation, which is of this pose. All weights together are no
  /// more than 1, however the poses come.
  double next_ln_weight(std::size_t pose) {
    if (!taken_.insert(pose).second) {
      taken_ = {pose};
      ++round_;
    }
    const std::size_t place = taken_.size() - 1;
    return std::log(slow_share(round_) * 0.5 * (place == 0 ? 1 : slow_share(place - 1)));
  }

 private:
  std::set<std::size_t> taken_;  // poses of this round
  std::size_t round_ = 0;
};

}  // namespace handsight
