// SPDX-License-Identifier: Apache-2.0
#define HANDSIGHT_PRODUCTS template
#include "geometry/compiled_once.h"
