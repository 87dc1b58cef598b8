// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/text.h"
#include "command.h"
#include "effects/own_effect.h"
#include "estimation/fit/fit.h"
#include "options/option_limits.h"
#include "options/target_option.h"
#include "printing/outputs.h"
#include "robot/urdf.h"
#include "session/collection.h"
#include "simulate_live.h"
#include "simulation/simulated_files.h"
#include "simulation/simulated_session.h"

namespace handsight::cli {
namespace {

struct SimulateArguments {
  std::string robot, like, out, images = "none";
  std::vector<std::string> effects, curves, disturbances;
  TargetOptions target;
  double noise = -1, rate = 5;
  std::string live;
  bool undeclared = false;
  SimulationOptions simulation;
  std::vector<double> shift;
  ImageOptions image;
  Output output;
};

int images_wanted(const std::string& text, int observations) {
  if (text == "none") return 0;
  if (text == "all") return observations;
  try {
    std::size_t used = 0;
    const int count = std::stoi(text, &used);
    if (used == text.size() && count >= 0) return std::min(count, observations);
  } catch (const std::exception&) {
  }
  throw InputError(message("--images \"{}\": write all, none, or a number of observations.", text));
}

std::string effects_text(std::size_t count) { return fmt::format("{} effect{}", count, count == 1 ? "" : "s"); }

int run(const SimulateArguments& o);

/// A session like each of a collection, with the same truth about the robot; bodies are drawn anew for each, so that
/// none is shared.
int run_of_collection(const SimulateArguments& o) {
  if (o.out.empty()) throw InputError("--out is missing: the folder to make, in which the collection's sessions go.");
  Collection made = read_collection(o.like);
  made.file = std::filesystem::path(o.out) / "collection.xml";
  const Collection given = read_collection(o.like);
  for (std::size_t i = 0; i < given.entries.size(); ++i) {
    SimulateArguments one = o;
    one.like = find_folder(given, given.entries[i]).string();
    one.out = (std::filesystem::path(o.out) / given.entries[i].title).string();
    one.simulation.seed += i;
    one.output.json_file.clear();
    run(one);
    made.entries[i].folder = given.entries[i].title;
    made.entries[i].body.clear();
  }
  replace_file(made.file, collection_text(made));
  o.output.line("Written: " + made.file.string());
  return done;
}

/// Where the session does not say where its sensor sits, its observations do: sensor and body are then as their fit has
/// them.
void settle_by_fit(const SimulateArguments& o, Session& like, SimulationOptions& options) {
  if (like.mount.known || like.is_touch()) return;
  try {
    const Fit fitted = fit(open_searched_session(o.like, o.output));
    like.mount.mount_from_sensor = estimate(fitted).mount_from_sensor;
    if (!is_given(o.target)) options.markers_in_tcp = estimate(fitted).markers_in_tcp;
  } catch (const InputError& error) {
    Output::note(fmt::format(
        "{} does not say where its {} sits, and its observations do not tell it: it is taken to sit at the origin of "
        "{}. ({})",
        like.file.filename().string(), like.rig ? "first camera" : "sensor", in_quotes(like.mount.link), error.what()));
  }
}

int run(const SimulateArguments& o) {
  if (is_collection(o.like)) return run_of_collection(o);
  note_input(o.robot);
  Session like = open_session(o.like, o.output);
  SimulationOptions options = o.simulation;
  std::filesystem::path robot_file = folder(like) / like.robot_file;
  if (!o.robot.empty()) {
    robot_file = o.robot;
    like.robot = read_urdf(robot_file);
  }
  if (is_given(o.target)) {
    if (!like.rig) throw InputError("--target: a target is seen by cameras, and the session that is like it has none.");
    set_target(like, target_from(o.target));
  }
  settle_by_fit(o, like, options);
  if (o.noise >= 0) options.noise = o.noise;
  if (!o.shift.empty()) options.shift_in_sensor = Vector3(o.shift[0], o.shift[1], o.shift[2]);
  const OwnEffects own = list_own_effects(like, make_chain(like));
  for (const std::string& effect : o.effects) add_effect_value(effect, like.robot, options.effects, own);
  check_terms(options.effects, like.marker_count);
  for (const std::string& curve : o.curves) options.curves.push_back(parse_curve(curve, like.robot));
  for (const std::string& d : o.disturbances) options.disturbances.push_back(parse_disturbance(d, like.robot));
  ImageOptions image = o.image;
  image.observations = images_wanted(o.images, options.observations);
  // The noise of corners found in images is the detector's, not that of the simulated labels.
  options.declare_noise = !o.undeclared && image.observations == 0;
  const SimulatedSession simulated = simulate_session(like, options);
  if (!o.live.empty()) {
    if (like.rig && !like.target) require_pair(like, "simulate --live");
    if (like.rig) image.observations = options.observations;
    Progress progress("arriving", static_cast<std::size_t>(options.observations));
    simulate_live(simulated, options, robot_file, image, o.live, o.rate,
                  [&](int done) { progress.at(static_cast<std::size_t>(done)); });
    o.output.line(fmt::format("{}: {} observations have arrived", o.live, options.observations));
    return done;
  }
  if (o.out.empty())
    throw InputError("--out is missing: the folder to make (or --live FOLDER, for arrivals one by one).");
  Progress progress("rendering", static_cast<std::size_t>(image.observations));
  const WrittenSession written = write_simulated(simulated, options, robot_file, image, o.out,
                                                 [&](int done) { progress.at(static_cast<std::size_t>(done)); });
  o.output.line(fmt::format("{}: {} observations, {} with images, label noise {:.3g} {}, {} hidden", o.out,
                            options.observations, written.with_images, simulated.noise, like.is_tracker() ? "m" : "px",
                            effects_text(options.effects.size() + options.curves.size())));
  if (!written.label_hint.empty()) o.output.line("Label the first observation with:\n  " + written.label_hint);
  o.output.json({{"out", o.out},
                 {"observations", options.observations},
                 {"with_images", written.with_images},
                 {"label", written.label_hint}});
  return done;
}

}  // namespace

Command add_simulate(const CommandLine& program) {
  auto o = std::make_shared<SimulateArguments>();
  const CommandLine command = program.command("simulate", "Makes a session with known truth");
  command.option("--robot", o->robot, "URDF of the robot; the session's own where it is left out");
  command.option("--like", o->like, "The session that gives cameras or tracker, mount, joints and markers").required();
  const Option out = command.option("--out", o->out, "Folder to make; it must not hold a session already");
  command.option("--live", o->live, "Instead: a new folder into which the observations arrive one by one")
      .excludes(out);
  command.option("--rate", o->rate, "Arrivals a second").within(0.01, 1000);
  command.option("--effect", o->effects, "What is hidden in it: id:joint.parameter=value");
  command.option("--curve", o->curves,
                 "A deviation of a joint's angle that no effect describes: \"JOINT: SIZE*sin(ORDERq)\", or cos");
  command
      .option("--wrong-corners", o->simulation.wrong_corners,
              "Share of the image points displaced by N(0, 8 px) in u and in v")
      .within(0, 1);
  command.option("--unseen", o->simulation.unseen, "Share of the markers that are missing").within(0, 1);
  command.option("--observations", o->simulation.observations, "How many").from_to(1, 100000);
  command.option("--seed", o->simulation.seed, "Every random thing follows from it");
  command.option("--title", o->simulation.title, "Title of the session");
  command.option("--noise", o->noise, "px (m with a tracker) of one coordinate").within(0, 1000);
  command.flag("--undeclared", o->undeclared, "Do not write the noise into the session");
  command.option("--joint-range", o->simulation.joint_range, "Share of the joint limits that poses are drawn from")
      .within(0.01, 1);
  command.option("--body-size", o->simulation.body_size, "m: longest side of the markers, about").within(1e-4, 10);
  command.option("--nearest", o->simulation.nearest, "m: from the left camera").within(1e-3, 1000);
  command.option("--farthest", o->simulation.farthest, "m: from the left camera").within(1e-3, 1000);
  command.flag("--follow", o->simulation.follow, "Neighbouring observations are neighbours in posture");
  command.option("--shift", o->shift, "m, x y z: every marker is measured off by this in the sensor's frame")
      .takes(3)
      .within(-10, 10);
  command.option("--disturb", o->disturbances, "ID:joint:NAME=RAD, ID:marker:INDEX=METRES or ID:right_image:NAME=RAD");
  command.option("--images", o->images, "all, none, or how many observations get images")
      .takes(0, 1)
      .shows_default("all");
  command.option("--image-noise", o->image.noise_grey, "grey levels").within(0, 255);
  command.option("--image-blur", o->image.blur_px, "px").within(0, 20);
  command.option("--distractors", o->image.distractors, "corners in the scene that are no markers").from_to(0, 500);
  add_target_options(command, o->target, true);
  add_json_option(command, o->output);
  return {command, [o] { return run(*o); }};
}

}  // namespace handsight::cli
