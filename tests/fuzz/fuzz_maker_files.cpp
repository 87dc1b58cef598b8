// SPDX-License-Identifier: Apache-2.0
// Cameras, targets, servos and motion capture as their makers write them: read to finite numbers, or refused.
#include <cmath>

#include "fuzz.h"
#include "readers/kalibr_target.h"
#include "readers/maker_cameras.h"
#include "readers/mocap/mocap_csv.h"
#include "readers/pose_files.h"
#include "readers/pose_table.h"
#include "readers/robots/lerobot.h"
#include "readers/yaml_text.h"

namespace handsight {
namespace {

void demand_camera(const RosCamera& c) {
  for (const double number : {c.camera.fx, c.camera.fy, c.camera.cx, c.camera.cy, c.camera.k1, c.camera.k4})
    demand(std::isfinite(number), "a camera is of finite numbers");
  demand(c.camera.width > 0 && c.camera.height > 0, "a camera's images have a size");
}

void read_mocap(const MocapTables& all) {
  std::vector<Message> notes;
  for (const MocapBody& body : all.bodies)
    for (const ReadPoses& read : read_pose_table(body.table, true, {}, notes))
      for (const Rigid& pose : read.series.poses) demand(pose.translation.allFinite(), "poses are finite");
  if (!all.markers.columns.empty() && is_point_table(all.markers)) read_point_table(all.markers, notes);
}

void read_any(const std::string& text) {
  std::vector<Message> notes;
  if (is_motive_csv(text)) return read_mocap(read_motive_csv(text, "take.csv"));
  if (is_vicon_csv(text)) return read_mocap(read_vicon_csv(text, "take.csv"));
  if (is_qualisys_tsv(text)) return read_mocap(read_qualisys_tsv(text, "take.tsv"));
  if (is_ost(text)) {
    for (const RosCamera& c : read_ost(text, "ost.ini")) demand_camera(c);
  } else if (is_camodocal(text)) {
    demand_camera(read_camodocal(text, "camera.yaml"));
  } else if (is_realsense_listing(text)) {
    demand_camera(read_realsense_listing(text, "camera.txt", notes));
  } else {
    const YAML::Node yaml = parse_yaml(text, "file.yaml");
    if (is_realsense(yaml)) demand_camera(read_realsense(yaml, "camera.json", notes));
    if (is_echoed_camera_info(yaml)) demand_camera(read_echoed_camera_info(yaml, "camera.yaml"));
    if (is_kalibr_target(yaml)) demand(point_count(read_kalibr_target(yaml, "target.yaml")) > 0, "a target has points");
    if (is_lerobot_calibration(yaml)) read_lerobot_calibration(yaml, "arm.json");
  }
}

}  // namespace
}  // namespace handsight

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace handsight;
  try {
    read_any(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const InputError& error) {
    const std::string sentence = error.what();
    demand(sentence.size() >= 20 && sentence.size() <= 600 && is_utf8(sentence), "a refusal is a sentence", sentence);
  }
  return 0;
}
