// SPDX-License-Identifier: Apache-2.0
// Which joint readings belong to which measurement. Internal to convert.
#pragma once

#include "base/message.h"
#include "convert/conversion.h"

namespace handsight {

/// Joints for these events: row by row, or paired by time.
struct Paired {
  std::vector<std::size_t> events;
  std::vector<Eigen::VectorXd> positions;
};

/// `times` (s) and `speeds` of the measurements, empty where they have none; InputError where none has joint readings
/// to it. What is left out is counted in the notes.
Paired pair_events(const JointSeries& joints, const std::vector<double>& times, std::size_t count,
                   const std::vector<double>& speeds, const ConvertOptions& options, std::vector<Message>& notes);

/// Those at these places.
template <class T>
std::vector<T> chosen(const std::vector<T>& all, const std::vector<std::size_t>& places) {
  std::vector<T> some;
  for (const std::size_t i : places)
    if (i < all.size()) some.push_back(all[i]);
  return some;
}

}  // namespace handsight
