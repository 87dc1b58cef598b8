// SPDX-License-Identifier: Apache-2.0
// The kinds of mistakes that are looked for: each says where it may have been made, and puts a session right.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/message.h"
#include "session/session.h"
#include "vision/image/image.h"

namespace handsight {

struct BlunderKind {
  std::string id;
  bool of_images = false;  // what cameras saw is read otherwise: its points have to be found anew
  bool of_poses = false;   // poses are read otherwise
  bool is_tried_alone = true, is_tried_in_pairs = true;  // beside others that are of poses
  double measured_unit = 1;                              // new metre of what the sensor measured, in old ones
  double points_unit = 1;                                // the same of the points that follow from it
  int numbers = 0;                                       // that are found with it
  /// Where it may have been made in this session.
  std::function<std::vector<std::string>(const Session&)> places;
  /// Puts the session right there; `where` is one of the places, settled.
  std::function<void(const std::string& where, Session&)> mend;
  /// Sentences for people: what is wrong there; what to change, and in which file.
  std::function<Message(const std::string&where, const Session&)> text, fix;
  /// The place with the numbers that go with it, found from a session of points (seen_points.h). Empty: there are none.
  std::function<std::string(const std::string& where, const Session& points)> settle = {};
  /// A camera's image as it should have been, where images themselves have to be put right.
  std::function<Image(const std::string& where, int camera, const Image&, const Session&)> mend_image = {};
};

/// All of them, those that are made most often first.
const std::vector<BlunderKind>& blunder_kinds();

/// One of them by its id; null where there is none.
const BlunderKind* find_blunder_kind(const std::string& id);

// Room by room.
std::vector<BlunderKind> joint_blunders();
std::vector<BlunderKind> pairing_blunders();
std::vector<BlunderKind> order_blunders();
std::vector<BlunderKind> pose_blunders();
std::vector<BlunderKind> image_blunders();
std::vector<BlunderKind> picture_blunders();
std::vector<BlunderKind> size_blunders();
std::vector<BlunderKind> link_blunders();
std::vector<BlunderKind> gravity_blunders();
std::vector<BlunderKind> stray_blunders();

}  // namespace handsight
