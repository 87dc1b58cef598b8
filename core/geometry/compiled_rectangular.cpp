// SPDX-License-Identifier: Apache-2.0
#include "geometry/compiled_once.h"

#define HANDSIGHT_DYNAMIC_RECTANGULAR template
#include "geometry/compiled_list.inc"
