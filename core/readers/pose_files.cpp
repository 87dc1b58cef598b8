// SPDX-License-Identifier: Apache-2.0
#include "readers/pose_files.h"

#include <fmt/format.h>

#include "readers/pose_list.h"
#include "readers/yaml_text.h"

namespace handsight {

bool is_hand_eye_samples(const YAML::Node& yaml) {
  const YAML::Node samples = yaml.IsMap() ? yaml["samples"] : YAML::Node();
  return samples && samples.IsSequence() && samples.size() > 0 && samples[0].IsMap() && samples[0]["robot"] &&
         (samples[0]["tracking"] || samples[0]["optical"]);
}

HandEyeSamples read_hand_eye_samples(const YAML::Node& yaml, const std::string& file, std::vector<Message>& notes) {
  HandEyeSamples s;
  const std::string kind = yaml_word(yaml["parameters"], "calibration_type"),
                    on_hand = yaml_word(yaml["parameters"], "eye_on_hand");
  s.kind_is_known = !kind.empty() || !on_hand.empty();
  s.eye_in_hand = kind.empty() ? on_hand != "false" : kind.find("in_hand") != std::string::npos;
  std::size_t number = 0;
  for (const YAML::Node& sample : yaml["samples"]) {
    const Rigid robot = required_pose(sample["robot"], file, number);
    // With the camera on its stand easy_handeye looks the robot's pose up the other way round.
    s.base_from_effector.push_back(s.eye_in_hand ? robot : inverse(robot));
    s.camera_from_target.push_back(
        required_pose(sample["tracking"] ? sample["tracking"] : sample["optical"], file, number));
    ++number;
  }
  if (!s.kind_is_known)
    notes.push_back(message(
        "{}: does not say where the camera is; it is taken to be on the hand (--eye-on-base: on a stand).", file));
  return s;
}

}  // namespace handsight
