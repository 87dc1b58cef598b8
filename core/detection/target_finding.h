// SPDX-License-Identifier: Apache-2.0
// The points of a session's target in its images, in place of labels.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/message.h"
#include "session/session.h"

namespace handsight {

struct PreparedTarget;

/// What the images of one observation show of the target. A wrong number is worse than none: points and tags that do
/// not agree with the rest are left out and counted.
struct TargetFinding {
  std::vector<Sighting> sightings;  // in order of number, by="tracker", with the sigmas of the image points
  int images = 0;                   // that could be read
  int dropped_points = 0, dropped_tags = 0;
  std::vector<int> repeated;        // numbers of single tags that an image shows several times
  Message reason;                   // why nothing was found; empty where something was
  std::vector<Message> unreadable;  // a sentence for each image that cannot be read
};

/// Finds the target of one session, of which it keeps what it needs.
class TargetFinder {
 public:
  /// The session has a target and cameras.
  explicit TargetFinder(const Session& session);

  TargetFinding find(const Observation& observation) const;

 private:
  std::filesystem::path folder_;
  Rig rig_;
  std::shared_ptr<const PreparedTarget> target_;
};

/// What became of a whole session's images.
struct TargetSearch {
  int looked_at = 0;  // observations
  int found = 0;      // of them
  int dropped_points = 0, dropped_tags = 0;
  Message in_its_place;        // what the images show where hardly one shows the target; empty otherwise
  std::vector<Message> notes;  // a sentence each
};

/// Gives the observations that have images and no sightings what the images show of the target; those that are rejected
/// or excluded stay as they are. Nothing is done in a session without a target. `progress` hears how many observations
/// are done.
TargetSearch find_targets(Session& session,
                          const std::function<void(std::size_t done, std::size_t all)>& progress = {});

}  // namespace handsight
