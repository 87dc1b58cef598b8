// SPDX-License-Identifier: Apache-2.0
#define HANDSIGHT_OF_THREE template
#include "geometry/compiled_once.h"
