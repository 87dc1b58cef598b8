// SPDX-License-Identifier: Apache-2.0
#include "driven_poses.h"

#include <fmt/format.h>

#include "base/bounds.h"
#include "base/numbers.h"
#include "printing/outputs.h"
#include "readers/csv.h"

namespace handsight::cli {
namespace {

/// Which of the table's columns the poses follow one another by: said where effects may depend on it.
void say_how_driven(const PoseTable& table, const CalibratedRobot& source) {
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

std::vector<ObservationState> table_poses(const std::string& file, const CalibratedRobot& source) {
  std::vector<Message> notes;
  const PoseTable table = read_pose_table(file, source.joint_names, &notes);
  for (const Message& note : notes) Output::note(note);
  say_how_driven(table, source);
  std::vector<DrivenPose> poses;
  for (std::size_t i = 0; i < table.positions.size(); ++i) {
    DrivenPose& pose = poses.emplace_back(DrivenPose{table.positions[i], {}, {}});
    if (!table.velocities.empty()) pose.velocity = table.velocities[i];
    if (!table.times.empty()) pose.time = table.times[i];
  }
  return states_at(source.chain, poses, source.times);
}

}  // namespace

void add_pose_options(const CommandLine& command, PoseOptions& options) {
  command.option("--position", options.positions,
                 "Joint angles in the session's order, in quotes; several times for several");
  command.option("--positions", options.file,
                 "CSV with one pose a line; columns time and velocity_JOINT say how the robot comes there");
}

std::vector<ObservationState> driven_poses(const PoseOptions& o, const CalibratedRobot& source) {
  std::vector<ObservationState> all;
  const auto count = source.joint_names.size();
  for (const std::string& text : o.positions) {
    const auto numbers = parse_numbers(text);
    if (!numbers || numbers->size() != count)
      throw InputError(message("--position \"{}\" has {} numbers; expected {} finite ones, one for each of: {}.", text,
                               numbers ? std::to_string(numbers->size()) : "unreadable", count,
                               fmt::join(source.joint_names, " ")));
    for (const double number : *numbers)
      if (!bounds::joint.hold(number))
        throw InputError(message("--position \"{}\" holds {:g}; expected numbers from {:g} to {:g}.", text, number,
                                 bounds::joint.lowest, bounds::joint.highest));
    all.push_back(states_at(source.chain, Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(
                                              numbers->data(), static_cast<Eigen::Index>(count)))));
  }
  if (!o.file.empty())
    for (ObservationState& pose : table_poses(o.file, source)) all.push_back(std::move(pose));
  if (all.empty()) throw InputError("No pose to predict; give --position \"q1 q2 ...\" or --positions FILE.csv.");
  return all;
}

}  // namespace handsight::cli
