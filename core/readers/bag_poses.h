// SPDX-License-Identifier: Apache-2.0
// Detectors' topics whose messages hold several poses each.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "readers/bag_contents.h"
#include "readers/bags/messages.h"

namespace handsight {

/// Collects such messages as they come in.
class PosesTaker {
 public:
  /// Is something read from it? Of ArucoMarkers the package does not matter: the message is copied from project to
  /// project.
  static bool wants(const BagTopic& topic);

  void take(const BagTopic& topic, const ros::Message& message, std::int64_t nanoseconds);

  /// Adds their poses to `contents` as frames: a tag or board that is named as TOPIC/NAME; the only pose of a
  /// PoseArray as TOPIC. Of arrays of several, always as many, TOPIC[0], TOPIC[1] ... are frames that must be asked
  /// for, since nothing says that the order stays; where they are not always as many the topic is left out and why
  /// stands in BagContents::ambiguous. What another frame tells already is left out.
  void finish(const std::string& bag, BagContents& contents);

 private:
  struct Instant {
    double time = 0;  // s
    ros::Poses poses;
  };
  void add_named(const std::string& topic, const std::vector<Instant>& instants, BagContents& contents) const;
  void add_array(const std::string& bag, const std::string& topic, const std::vector<Instant>& instants,
                 BagContents& contents) const;

  std::map<std::string, std::vector<Instant>> named_, arrays_;  // by topic
};

}  // namespace handsight
