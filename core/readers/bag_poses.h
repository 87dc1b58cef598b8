// SPDX-License-Identifier: Apache-2.0
// Detectors' topics whose messages hold several poses each.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/message.h"
#include "readers/bags/bag.h"
#include "readers/bags/messages.h"
#include "readers/series.h"

namespace handsight {

/// Transforms of one child frame of /tf, or poses of one topic.
struct BagFrame {
  std::string parent;
  PoseSeries series;
  bool must_be_named = false;  // by the user: it may be another thing from message to message
};

/// Frames by child of /tf, or by topic.
using BagFrames = std::map<std::string, BagFrame>;

/// Collects such messages as they come in.
class PosesTaker {
 public:
  /// Is something read from it? Of ArucoMarkers the package does not matter: the message is copied from project to
  /// project.
  static bool wants(const BagTopic& topic);

  void take(const BagTopic& topic, const ros::Message& message, std::int64_t nanoseconds);

  /// Adds their poses to `frames`: a tag or board that is named as TOPIC/NAME; the only pose of a
  /// PoseArray as TOPIC. Of arrays of several, always as many, TOPIC[0], TOPIC[1] ... are frames that must be asked
  /// for, since nothing says that the order stays; where they are not always as many the topic is left out and why
  /// stands in `ambiguous`. What another frame tells already is left out.
  void finish(const std::string& bag, BagFrames& frames, std::vector<Message>& ambiguous, std::vector<Message>& notes);

 private:
  struct Instant {
    double time = 0;  // s
    ros::Poses poses;
  };
  static void add_named(const std::string& topic, const std::vector<Instant>& instants, BagFrames& frames);
  /// What is to be said of it.
  static Message add_array(const std::string& bag, const std::string& topic, const std::vector<Instant>& instants,
                           BagFrames& frames, std::vector<Message>& ambiguous);

  std::map<std::string, std::vector<Instant>> named_, arrays_;  // by topic
};

}  // namespace handsight
