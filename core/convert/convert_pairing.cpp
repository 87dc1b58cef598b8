// SPDX-License-Identifier: Apache-2.0
#include "convert/convert_pairing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "base/text.h"

namespace handsight {

Paired pair_events(const JointSeries& joints, const std::vector<double>& times, std::size_t count,
                   const std::vector<double>& speeds, const ConvertOptions& o, std::vector<Message>& notes) {
  Paired p;
  constexpr double same = 0.1;  // s: rows of two tables that were written together
  bool row_by_row = joints.positions.size() == count;
  for (std::size_t i = 0; row_by_row && i < count && !times.empty() && !joints.times.empty(); ++i)
    row_by_row = std::abs(times[i] - joints.times[i]) <= same;
  if (row_by_row) {
    p.events.resize(count);
    std::iota(p.events.begin(), p.events.end(), std::size_t{0});
    p.positions = joints.positions;
    return p;
  }
  if (times.empty() || joints.times.empty())
    throw InputError(
        message("There are {} lines of joint readings and {} measurements, and {} no times to pair them "
                "by; expected one line for each, or a column `time` in both.",
                joints.positions.size(), count, times.empty() ? "the measurements have" : "the joints have"));
  PairingOptions options = o.pairing;
  if (o.estimate_lag) {
    const auto lag = estimated_lag(joints, times, speeds);
    if (lag) options.lag = *lag;
    notes.push_back(
        lag ? message("The measurements come {:.3f} s after the joint readings; that was taken out.", *lag)
            : message("The lag between measurements and joint readings cannot be told: both must show the same "
                      "movements. It is taken as {:g} s.",
                      options.lag));
  }
  const double median_step =
      (joints.times.back() - joints.times.front()) / std::max<std::size_t>(1, joints.times.size() - 1);
  if (median_step > options.still_for) options.still_for = 0;  // nobody could say whether it stood
  options.widest_gap = std::max(options.widest_gap, 2.5 * median_step);
  const Pairing pairing = paired(joints, times, options);
  const auto reported = [&](std::size_t n, const char* why) {
    if (n > 0) notes.push_back(message("{} of {} measurements are left out: {}.", n, count, why));
  };
  reported(pairing.outside, "there are no joint readings at their times");
  reported(pairing.gaps, "the joint readings have a gap there");
  reported(pairing.moving, "the robot was moving");
  reported(pairing.repeated, "they show a standstill that another one shows");
  if (pairing.events.empty())
    throw InputError(message(
        "None of the {} measurements has joint readings to it: they are from {:.3f} to {:.3f} s, the joints from "
        "{:.3f} to "
        "{:.3f} s, and {} were left out because the robot moved. Do the clocks agree (--lag)? Did the robot stand "
        "(--still 0 allows moving)?",
        count, times.front(), times.back(), joints.times.front(), joints.times.back(), pairing.moving));
  p.events = pairing.events;
  p.positions = pairing.positions;
  return p;
}

}  // namespace handsight
