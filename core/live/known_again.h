// SPDX-License-Identifier: Apache-2.0
// What has arrived is known again by eight bytes each: a watch may last for days.
#pragma once

#include <cstdint>
#include <vector>

#include "session/session.h"

namespace handsight {

/// Of a line of a table that tells the time: it and the joint angles, these to 1e-9.
std::uint64_t bits_of_line(double time, const Eigen::VectorXd& position);

/// Of the joint angles and the points or the place that were measured, to 1e-9; with the number under which they came.
std::uint64_t bits_of_measured(const Observation& observation, std::int64_t number = 0);

using Ascending = std::vector<std::uint64_t>;
bool holds(const Ascending& all, std::uint64_t bits);
void put_into(Ascending& all, std::uint64_t bits);
void take_out(Ascending& all, std::uint64_t bits);
/// In order, each once.
void make_ascending(Ascending& all);

}  // namespace handsight
