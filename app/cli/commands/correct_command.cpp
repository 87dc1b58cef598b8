// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "base/bounds.h"
#include "base/numbers.h"
#include "command.h"
#include "options/driven_poses.h"
#include "printing/outputs.h"
#include "printing/reported_json.h"

namespace handsight::cli {
namespace {

struct CorrectArguments {
  SourceOptions source;
  PoseOptions poses;
  std::string target;
  int gain = 0;
  Output output;
};

std::optional<Rigid> wanted_target(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto n = parse_numbers(text);
  if (!n || n->size() != 6)
    throw InputError(message(
        "--target \"{}\" is not understood; expected six numbers: x y z in m and roll pitch yaw in rad.", text));
  for (std::size_t i = 0; i < 6; ++i) {
    const Bounds& within = i < 3 ? bounds::length : bounds::joint;
    if (!within.hold((*n)[i]))
      throw InputError(message("--target \"{}\" holds {:g}; expected numbers from {:g} to {:g}.", text, (*n)[i],
                               within.lowest, within.highest));
  }
  return Rigid{rotation_from_rpy({(*n)[3], (*n)[4], (*n)[5]}), {(*n)[0], (*n)[1], (*n)[2]}};
}

std::string listed(const Eigen::VectorXd& position) {
  std::string text;
  for (const double q : position) text += fmt::format("{}{:.6f}", text.empty() ? "" : " ", q);
  return text;
}

std::string why_not(const Correction& c, const CalibratedRobot& source) {
  if (c.at_limit.empty()) return "out of reach";
  std::string names;
  for (const int i : c.at_limit) names += " " + source.joint_names[static_cast<std::size_t>(i)];
  return "at the limit of" + names;
}

void tell_gain(const CorrectArguments& o, const CalibratedRobot& source, Json& json) {
  if (source.positions.empty())
    throw InputError(
        "--gain needs the poses that were measured; name the session in place of the calibration, with --effects for "
        "its model.");
  const CorrectionGain g = correction_gain(source.chain, source.model, source.positions, o.gain, 1);
  o.output.line(
      fmt::format("Over {} poses like those measured the hand misses by {:.3f} mm as commanded and by {:.3f} "
                  "mm corrected (medians); {} cannot be reached.",
                  o.gain, 1e3 * g.median_before, 1e3 * g.median_after, g.not_reached));
  for (std::size_t i = 0; i < g.before.size(); ++i)
    json.push_back({{"error_before_m", number(g.before[i])}, {"error_after_m", number(g.after[i])}});
}

int run(const CorrectArguments& o) {
  note_input(o.poses.file);
  const CalibratedRobot source = with_moved_hand(predict_source(o.source));
  require_joints(source);
  o.output.require_places();
  for (const Message& note : source.notes) Output::note(note);
  const std::optional<Rigid> target = wanted_target(o.target);
  Json list = Json::array();
  if (o.gain > 0) {
    tell_gain(o, source, list);
    o.output.json(list);
    return done;
  }
  const std::vector<ObservationState> poses = driven_poses(o.poses, source);
  bool all_reached = true;
  o.output.line("before mm  after mm  sigma mm   command");
  for (const ObservationState& pose : poses) {
    const Correction c = corrected(pose, source.model, target);
    all_reached = all_reached && c.reached;
    o.output.line(fmt::format("{:>9.3f} {:>9.3f} {:>9.3f}   {}{}", 1e3 * c.error_before_m, 1e3 * c.error_after_m,
                              1e3 * c.sigma_m, listed(c.position),
                              c.reached ? "" : "   not reached: " + why_not(c, source)));
    list.push_back(correction_json(commanded_position(pose), c));
  }
  o.output.json(list);
  return all_reached ? done : answer_is_no;
}

}  // namespace

Command add_correct(const CommandLine& program) {
  auto options = std::make_shared<CorrectArguments>();
  const CommandLine command =
      program.command("correct", "The joint angles to command so that the hand arrives where it was meant to be");
  add_source_options(command, options->source);
  add_pose_options(command, options->poses);
  command.option("--target", options->target,
                 "Where the hand is meant to be: \"x y z roll pitch yaw\" (m, rad) of the TCP in the root frame; "
                 "without it where the nominal model puts it for these joints");
  command.option("--gain", options->gain, "Instead: what correcting buys over so many poses like the measured ones")
      .from_to(1, 100000);
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
