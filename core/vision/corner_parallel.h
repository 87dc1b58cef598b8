// SPDX-License-Identifier: Apache-2.0
// Work on parts of a large image, on as many threads as the processor runs at once: what comes out does not depend on
// how many there are.
#pragma once

#include <algorithm>
#include <atomic>
#include <future>
#include <system_error>
#include <thread>
#include <vector>

namespace handsight {

// Threads at most; 0: as many as the processor runs. Tests change it to compare.
inline int& most_threads() {
  static int most = 0;
  return most;
}

// What follows is worth other threads only where it takes longer than to begin one.
inline bool is_worth_threads(int width, int height) { return static_cast<double>(width) * height > 1.5e6; }

/// Calls act(i) once for each i below `count`, which must not depend on each other; where `is_worth_it` on several
/// threads.
template <class Act>
void each_part(int count, bool is_worth_it, const Act& act) {
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int i = next++; i < count; i = next++) act(i);
  };
  const int here = most_threads() > 0 ? most_threads() : static_cast<int>(std::thread::hardware_concurrency());
  std::vector<std::future<void>> others;
  for (int i = 1; is_worth_it && i < std::min(here, count); ++i) {
    try {
      others.push_back(std::async(std::launch::async, work));
    } catch (const std::system_error&) {  // no more threads to be had: this one does the rest
      break;
    }
  }
  work();
  for (std::future<void>& other : others) other.get();
}

}  // namespace handsight
