// SPDX-License-Identifier: Apache-2.0
// What a process does with memory that was freed. Large matrices come and go by the thousand.
#pragma once

namespace handsight {

/// From now on freed memory stays with the process for the next matrix, in place of new pages of the system's, which
/// cost more than the computation. For programs, at their start; does nothing where malloc is not glibc's.
void keep_freed_memory();

/// What was kept goes back to the system.
void give_back_freed_memory();

}  // namespace handsight
