// SPDX-License-Identifier: Apache-2.0
// Collada files (.dae) as texts and as meshes of a link.
#pragma once

#include "robot/collada_text.h"
#include "robot/mesh.h"
