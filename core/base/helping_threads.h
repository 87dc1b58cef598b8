// SPDX-License-Identifier: Apache-2.0
// Threads that stay and help whoever has work: to begin one anew takes as long as many a part of the work does.
#pragma once

#include <functional>

namespace handsight {

/// Calls work() here and, as threads come free, on up to `helpers` others at the same time; returns once all that have
/// begun have ended. A helper that has not begun by the time work() has ended here is not waited for. What one of them
/// throws is thrown here.
void work_with_helpers(int helpers, const std::function<void()>& work);

}  // namespace handsight
