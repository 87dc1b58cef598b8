// SPDX-License-Identifier: Apache-2.0
// An improvement, step by step, for people and as JSON.
#pragma once

#include "command.h"
#include "diagnosis/selection/improvement_result.h"

namespace handsight::cli {

void print_improvement(const Output& output, const Session& session, const Improvement& improvement);
Json improvement_json(const Session& session, const Improvement& improvement);

}  // namespace handsight::cli
