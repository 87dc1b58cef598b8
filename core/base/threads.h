// SPDX-License-Identifier: Apache-2.0
// Work in parts, on as many threads as the processor runs at once: what comes out does not depend on how many there
// are.
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>

#include "base/helping_threads.h"

namespace handsight {

// Threads at most; 0: as many as the processor runs. Programs set it before they begin to work.
inline int& most_threads() {
  static int most = 0;
  return most;
}

// Whether this thread does one of several parts.
inline bool& is_a_part() {
  thread_local bool is = false;
  return is;
}

// Threads that do a part now, whoever called for it.
inline std::atomic<int>& threads_at_work() {
  static std::atomic<int> at_work{0};
  return at_work;
}

class AsPart {
 public:
  explicit AsPart(bool of_several) : begins_(of_several && !is_a_part()) {
    if (!begins_) return;
    is_a_part() = true;
    ++threads_at_work();
  }
  ~AsPart() {
    if (!begins_) return;
    --threads_at_work();
    is_a_part() = false;
  }
  AsPart(const AsPart&) = delete;
  AsPart& operator=(const AsPart&) = delete;

 private:
  bool begins_;
};

/// How many of `count` parts are done at once, this thread's among them. Parts of a part get the threads that other
/// parts leave idle: more would only be in each other's way.
inline int threads_for(int count) {
  const int here = most_threads() > 0 ? most_threads() : static_cast<int>(std::thread::hardware_concurrency());
  const int others = is_a_part() ? threads_at_work() - 1 : 0;
  return std::max(1, std::min(here - others, count));
}

/// Calls act(i) once for each i below `count`, which must not depend on each other; where `is_worth_it` (more than a
/// tenth of a millisecond: a thread takes as long as that to wake) on several threads. What one of them throws is
/// thrown here.
template <class Act>
void each_part(int count, bool is_worth_it, const Act& act) {
  std::atomic<int> next{0};
  const auto work = [&](bool of_several) {
    const AsPart as_part(of_several);
    for (int i = next++; i < count; i = next++) act(i);
  };
  const int threads = is_worth_it ? threads_for(count) : 1;
  if (threads == 1) return work(false);
  work_with_helpers(threads - 1, [&] { work(true); });
}

}  // namespace handsight
