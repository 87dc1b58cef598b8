// SPDX-License-Identifier: Apache-2.0
// A collection of both hands of a humanoid, each seen by the cameras in its head.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "session/session_xml.h"
#include "simulation/simulated_files.h"
#include "simulation/simulated_session.h"

namespace handsight::test {

/// The right hand's session as one of the left.
inline Session of_left_hand(Session s) {
  const auto left = [](std::string name) {
    if (name.starts_with("right_")) name.replace(0, 5, "left");
    return name;
  };
  s.tcp = left(s.tcp);
  for (std::string& joint : s.joints) joint = left(joint);
  return s;
}

/// Simulated like `like` into `out`, with a spring in the shoulder.
inline void write_hand(const Session& like, const std::filesystem::path& out, std::uint64_t seed, int observations,
                       int with_images = 0) {
  SimulationOptions o;
  o.seed = seed;
  o.observations = observations;
  o.title = out.filename().string();
  const std::string shoulder = like.tcp.substr(0, like.tcp.find('_')) + "_arm_2";
  EffectTerm spring = term_of(*find_effect("joint_elasticity"), find_joint(like.robot, shoulder));
  spring.values[0] = 1.2e-4;
  o.effects = {spring};
  ImageOptions images;
  images.observations = with_images;
  write_simulated(simulate_session(like, o), o, folder(like) / like.robot_file, images, out);
}

/// "right" and "left" in the folder, and a collection of both that share the head's cameras.
inline std::filesystem::path two_hands(const std::filesystem::path& folder, int observations = 40) {
  const Session right = read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / "hidden_3");
  write_hand(right, folder / "right", 3, observations);
  write_hand(of_left_hand(right), folder / "left", 4, observations);
  const std::filesystem::path file = folder / "collection.xml";
  std::ofstream(file) << "<handsight_collection version=\"1\" title=\"Both hands\">\n"
                         "  <session folder=\"right\" rig=\"head\"/>\n  <session folder=\"left\" rig=\"head\"/>\n"
                         "</handsight_collection>\n";
  return file;
}

}  // namespace handsight::test
