// SPDX-License-Identifier: Apache-2.0
// What has changed between sessions, for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "command.h"
#include "compare/comparison_result.h"
#include "compare/several_comparison.h"

namespace handsight::cli {

void print_comparison(const Output& output, const Comparison& comparison);
Json comparison_json(const Comparison& comparison);

void print_comparison(const Output& output, const SeveralComparison& comparison);
Json comparison_json(const SeveralComparison& comparison);

}  // namespace handsight::cli
