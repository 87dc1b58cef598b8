// SPDX-License-Identifier: Apache-2.0
#include "geometry/compiled_once.h"

#define HANDSIGHT_OF_SIX template
#include "geometry/compiled_list.inc"
