// SPDX-License-Identifier: Apache-2.0
#define HANDSIGHT_DYNAMIC_SYMMETRIC template
#include "geometry/compiled_once.h"
