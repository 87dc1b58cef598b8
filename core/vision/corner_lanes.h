// SPDX-License-Identifier: Apache-2.0
// The same instructions in 8 lanes where the processor has AVX2, in 2 x 4 elsewhere: results are the same bit by bit.
#pragma once

#if defined(__x86_64__) && defined(__ELF__)
#define HANDSIGHT_LANES __attribute__((target_clones("avx2", "default")))
#else
#define HANDSIGHT_LANES
#endif
#define HANDSIGHT_INLINE inline __attribute__((always_inline))
