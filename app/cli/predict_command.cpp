// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "base/bounds.h"
#include "base/numbers.h"
#include "command.h"
#include "estimation/prediction.h"
#include "json_values.h"
#include "outputs.h"
#include "predict_source.h"
#include "session/csv.h"

namespace handsight::cli {
namespace {

struct Options {
  std::string source, robot, positions_file;
  std::vector<std::string> positions;
  Output output;
};

/// Which of the table's columns the poses follow one another by: said where effects may depend on it.
void say_how_driven(const PoseTable& table, const PredictSource& source) {
  if (source.model.effects.empty()) return;
  Output::note(
      table.velocities.empty()
          ? "the direction of approach is taken from the order of the lines; there are no columns velocity_JOINT."
          : "velocities and the direction of approach are taken from the columns velocity_JOINT.");
  Output::note(table.times.empty() ? "the poses are taken for poses after the session; there is no column time."
               : source.times.empty()
                   ? "the column time is not used: the calibration does not say when it was made."
                   : "what drifts and slips is taken from the column time, in the session's seconds.");
}

std::vector<Circumstances> table_poses(const std::string& file, const PredictSource& source) {
  std::vector<std::string> notes;
  const PoseTable table = read_pose_table(file, source.joint_names, &notes);
  for (const std::string& note : notes) Output::note(note);
  say_how_driven(table, source);
  std::vector<DrivenPose> poses;
  for (std::size_t i = 0; i < table.positions.size(); ++i) {
    DrivenPose& pose = poses.emplace_back(DrivenPose{table.positions[i], {}, {}});
    if (!table.velocities.empty()) pose.velocity = table.velocities[i];
    if (!table.times.empty()) pose.time = table.times[i];
  }
  return circumstances_at(source.chain, poses, source.times);
}

std::vector<Circumstances> wanted_poses(const Options& o, const PredictSource& source) {
  std::vector<Circumstances> all;
  const auto count = source.joint_names.size();
  for (const std::string& text : o.positions) {
    const auto numbers = parse_numbers(text);
    if (!numbers || numbers->size() != count)
      throw InputError(fmt::format("--position \"{}\" has {} numbers; expected {} finite ones, one for each of: {}.",
                                   text, numbers ? std::to_string(numbers->size()) : "unreadable", count,
                                   fmt::join(source.joint_names, " ")));
    for (const double number : *numbers)
      if (!bounds::joint.hold(number))
        throw InputError(fmt::format("--position \"{}\" holds {:g}; expected numbers from {:g} to {:g}.", text, number,
                                     bounds::joint.lowest, bounds::joint.highest));
    all.push_back(circumstances_at(source.chain, Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(
                                                     numbers->data(), static_cast<Eigen::Index>(count)))));
  }
  if (!o.positions_file.empty())
    for (Circumstances& pose : table_poses(o.positions_file, source)) all.push_back(std::move(pose));
  if (all.empty()) throw InputError("No pose to predict; give --position \"q1 q2 ...\" or --positions FILE.csv.");
  return all;
}

int run(const Options& o) {
  for (const std::string& input : {o.source, o.robot, o.positions_file}) note_input(input);
  const PredictSource source = predict_source(o.source, o.robot);
  o.output.require_places();
  Json list = Json::array();
  for (const std::string& note : source.notes) Output::note(note);
  if (!source.model.rotation_is_observed)
    Output::note(
        "The markers do not show how the body is turned; sigma is that of the position, and rotations have none.");
  o.output.line("      x        y        z m     moved by mm   sigma x  y  z mm       sigma rx  ry  rz deg");
  for (const Circumstances& pose : wanted_poses(o, source)) {
    const TcpPrediction p = predict_tcp(pose, source.model);
    const Vector3 t = p.root_from_tcp_est.translation;
    const Vector6 s = p.sigma();
    constexpr double degrees = 57.29577951308232;
    const bool turns = source.model.rotation_is_observed;
    const std::string rotation =
        turns ? fmt::format("{:>7.4f} {:>7.4f} {:>7.4f}", degrees * s[3], degrees * s[4], degrees * s[5])
              : fmt::format("{:>7} {:>7} {:>7}", "-", "-", "-");
    o.output.line(fmt::format("{:>8.4f} {:>8.4f} {:>8.4f} {:>12.3f}    {:>6.3f} {:>6.3f} {:>6.3f}    {}", t.x(), t.y(),
                              t.z(), 1e3 * (t - p.root_from_tcp.translation).norm(), 1e3 * s[0], 1e3 * s[1], 1e3 * s[2],
                              rotation));
    Json sigma = numbers(s);
    for (std::size_t i = 3; i < 6 && !turns; ++i) sigma[i] = nullptr;
    list.push_back({{"root_from_tcp", motion(p.root_from_tcp)},
                    {"root_from_tcp_est", motion(p.root_from_tcp_est)},
                    {"root_from_body_est", motion(p.root_from_body_est)},
                    {"root_from_sensor_est", p.root_from_sensor_est ? motion(*p.root_from_sensor_est) : Json(nullptr)},
                    {"sigma", sigma}});
  }
  o.output.json(list);
  return done;
}

}  // namespace

Command add_predict(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("predict", "Where the TCP really is in poses that were not measured");
  command->add_option("SESSION", options->source, "A session, or a calibration XML")->required();
  command->add_option("--robot", options->robot, "URDF; needed with a calibration");
  command->add_option("--position", options->positions,
                      "Joint angles in the session's order, in quotes; several times for several");
  command->add_option("--positions", options->positions_file,
                      "CSV with one pose a line; columns time and velocity_JOINT say how the robot comes there");
  add_json_option(*command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
