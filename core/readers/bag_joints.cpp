// SPDX-License-Identifier: Apache-2.0
#include "readers/bag_joints.h"

#include <algorithm>
#include <cmath>

namespace handsight {

void JointTaker::see(const ros::JointState& s, double time) {
  bool any = false;
  for (std::size_t i = 0; i < s.names.size() && i < s.position.size(); ++i) {
    const int j = find_joint(robot_, s.names[i]);
    if (j < 0 || !robot_.joints[static_cast<std::size_t>(j)].moves() ||
        robot_.joints[static_cast<std::size_t>(j)].is_mimic() || !std::isfinite(s.position[i])) {
      ++unknown_[s.names[i]];
      continue;
    }
    values_[j].push_back({time, s.position[i]});
    any = true;
  }
  if (any) times_.push_back(time);
}

JointSeries JointTaker::series() {
  JointSeries out;
  std::sort(times_.begin(), times_.end());
  times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
  double begin = -1e300;
  for (auto& [joint, reported] : values_) {
    std::stable_sort(reported.begin(), reported.end(), [](const Told& a, const Told& b) { return a.time < b.time; });
    out.names.push_back(robot_.joints[static_cast<std::size_t>(joint)].name);
    begin = std::max(begin, reported.front().time);
  }
  std::vector<std::size_t> at(values_.size(), 0);
  for (const double time : times_) {
    if (time < begin) continue;
    Eigen::VectorXd q(static_cast<Eigen::Index>(values_.size()));
    Eigen::Index row = 0;
    for (const auto& [joint, reported] : values_) {
      std::size_t& place = at[static_cast<std::size_t>(row)];
      while (place + 1 < reported.size() && reported[place + 1].time <= time) ++place;
      q[row++] = reported[place].value;
    }
    out.times.push_back(time);
    out.positions.push_back(std::move(q));
  }
  return out;
}

}  // namespace handsight
