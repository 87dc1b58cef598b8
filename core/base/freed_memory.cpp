// SPDX-License-Identifier: Apache-2.0
#include "base/freed_memory.h"

#include <limits>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace handsight {

void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TOP_PAD, 64 << 20);
#endif
}

void give_back_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace handsight
