// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibrate/recall.h"

namespace handsight::app {

std::vector<OnlineStep> recalled_steps(const Session& session, const std::function<bool()>& goes_on) {
  std::vector<OnlineStep> steps;
  OnlineCalibration online(session);
  for (const Observation& o : session.observations) {
    if (!goes_on()) break;
    if (!is_used(o) || o.sightings.empty()) continue;
    Observation labelled = o;
    labelled.decision = Decision::none;
    steps.push_back(online.add(labelled, nullptr));
  }
  return steps;
}

}  // namespace handsight::app
