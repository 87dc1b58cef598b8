// SPDX-License-Identifier: Apache-2.0
#include "compare/change_watch.h"

#include "compare/watch_parts.h"

namespace handsight {

ChangeWatch::ChangeWatch(CalibratedRobot before, WatchOptions options) : parts_(std::make_unique<WatchParts>()) {
  parts_->before = std::move(before);
  parts_->options = options;
}
ChangeWatch::~ChangeWatch() = default;
ChangeWatch::ChangeWatch(ChangeWatch&&) noexcept = default;
ChangeWatch& ChangeWatch::operator=(ChangeWatch&&) noexcept = default;

std::optional<WatchStep> ChangeWatch::add(const Session& session, const Observation& observation) {
  if (observation.sightings.empty() || observation.decision == Decision::excluded) return std::nullopt;
  WatchParts& p = *parts_;
  Matrix6 repeatability;
  Recent one;
  one.sums = p.sums_of(session, observation, repeatability);
  one.pose = p.locate(observation.position, repeatability);
  one.number = p.count++;
  one.ln_weight = p.rounds.next_ln_weight(one.pose);
  if (one.number == 0) p.ln_first_weight = one.ln_weight;
  p.keep(std::move(one));
  WatchStep step = p.reported(p.starts());
  p.has_changed = p.has_changed || step.ln_e_value >= -std::log(p.options.chance);
  step.changed = p.has_changed;
  return step;
}

}  // namespace handsight
