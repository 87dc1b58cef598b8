// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "base/degrees.h"
#include "command.h"
#include "options/driven_poses.h"
#include "printing/outputs.h"
#include "printing/told_json.h"

namespace handsight::cli {
namespace {

struct PredictArguments {
  SourceOptions source;
  PoseOptions poses;
  Output output;
};

int run(const PredictArguments& o) {
  note_input(o.poses.file);
  const CalibratedRobot source = with_moved_hand(predict_source(o.source));
  require_joints(source);
  o.output.require_places();
  Json list = Json::array();
  for (const std::string& note : source.notes) Output::note(note);
  if (!source.model.rotation_is_observed)
    Output::note(
        "The markers do not show how the body is turned; sigma is that of the position, and rotations have none.");
  o.output.line("      x        y        z m     moved by mm   sigma x  y  z mm       sigma rx  ry  rz deg");
  for (const Circumstances& pose : driven_poses(o.poses, source)) {
    const TcpPrediction p = predict_tcp(pose, source.model);
    const Vector3 t = p.root_from_tcp_est.translation;
    const Vector6 s = p.sigma();
    const bool turns = source.model.rotation_is_observed;
    const std::string rotation =
        turns ? fmt::format("{:>7.4f} {:>7.4f} {:>7.4f}", degrees * s[3], degrees * s[4], degrees * s[5])
              : fmt::format("{:>7} {:>7} {:>7}", "-", "-", "-");
    o.output.line(fmt::format("{:>8.4f} {:>8.4f} {:>8.4f} {:>12.3f}    {:>6.3f} {:>6.3f} {:>6.3f}    {}", t.x(), t.y(),
                              t.z(), 1e3 * (t - p.root_from_tcp.translation).norm(), 1e3 * s[0], 1e3 * s[1], 1e3 * s[2],
                              rotation));
    list.push_back(prediction_json(p, turns));
  }
  o.output.json(list);
  return done;
}

}  // namespace

Command add_predict(const CommandLine& program) {
  auto options = std::make_shared<PredictArguments>();
  const CommandLine command = program.command("predict", "Where the TCP really is in poses that were not measured");
  add_source_options(command, options->source);
  add_pose_options(command, options->poses);
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
