// SPDX-License-Identifier: Apache-2.0
#include "session/by_time.h"

#include <algorithm>
#include <numeric>

namespace handsight {

std::vector<int> by_time(const Session& session) {
  std::vector<int> order(session.observations.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    const Observation& first = session.observations[static_cast<std::size_t>(a)];
    const Observation& second = session.observations[static_cast<std::size_t>(b)];
    return std::pair(first.time, first.id) < std::pair(second.time, second.id);
  });
  return order;
}

}  // namespace handsight
