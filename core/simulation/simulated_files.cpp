// SPDX-License-Identifier: Apache-2.0
#include "simulation/simulated_files.h"

#include <algorithm>
#include <set>

#include "base/files.h"
#include "base/text.h"
#include "session/session_xml.h"
#include "simulation/hand.h"
#include "simulation/renderer.h"
#include "simulation/scene.h"
#include "simulation/shown_target.h"
#include "simulation/simulated_session.h"
#include "vision/image/image_file.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

/// Which observations get images: the first, every disturbed one, and others evenly spread.
std::set<std::size_t> chosen_observations(const SimulatedSession& s, const SimulationOptions& options, int wanted) {
  std::set<std::size_t> chosen;
  if (wanted <= 0) return chosen;
  chosen.insert(0);
  for (const Disturbance& d : options.disturbances) chosen.insert(static_cast<std::size_t>(d.id));
  const std::size_t count = s.session.observations.size();
  for (int i = 0; i < wanted && static_cast<int>(chosen.size()) < wanted; ++i)
    chosen.insert(static_cast<std::size_t>(i) * count / static_cast<std::size_t>(wanted));
  for (std::size_t k = 0; k < count && static_cast<int>(chosen.size()) < wanted; ++k) chosen.insert(k);
  return chosen;
}

/// A room with the target in it. What stands about must not come between it and cameras that move.
Scene target_scene(const SimulatedSession& s, const SceneOptions& options) {
  Scene scene = make_scene({}, options);
  const Chain chain = make_chain(s.session);
  const bool on_hand = tcp_is_moved(chain);
  if (!on_hand) {
    scene.solids.clear();
    scene.plates.clear();
  }
  add_target(s.session, s.markers_in_tcp, on_hand, scene);
  return scene;
}

Scene scene_for(const SimulatedSession& s, const SimulationOptions& options, const ImageOptions& images) {
  SceneOptions scene;
  scene.seed = options.seed;
  scene.distractor_corners = images.distractors;
  scene.workspace.camera = s.root_from_sensor[0].translation;
  scene.workspace.hand.setZero();
  for (const Rigid& tcp : s.root_from_tcp)
    scene.workspace.hand += tcp.translation / static_cast<double>(s.root_from_tcp.size());
  for (const Rigid& tcp : s.root_from_tcp)
    scene.workspace.reach = std::max(scene.workspace.reach, (tcp.translation - scene.workspace.hand).norm());
  // The hand stretches from the wrist through the TCP: along the direction that the markers leave free.
  scene.fingers = (Vector3::UnitZ() - s.normal_in_tcp * s.normal_in_tcp.z());
  scene.fingers = scene.fingers.norm() > 0.2 ? Vector3(scene.fingers.normalized()) : s.normal_in_tcp.unitOrthogonal();
  if (s.session.target) return target_scene(s, scene);
  const double cell = std::clamp(0.2 * options.body_size, 0.005, 0.014);
  return make_scene(marker_plates(s.markers_in_tcp, s.normal_in_tcp, cell, options.seed), scene);
}

/// A number for each image; those of a pair are as they always were.
std::uint64_t seed_of_image(const Rig& rig, std::size_t k, int camera) {
  const auto stride = static_cast<std::size_t>(std::max(rig.count(), 2));
  return stride * k + static_cast<std::size_t>(camera);
}

void render_observation(const SimulatedSession& s, std::size_t k, Scene scene, const std::vector<PixelRays>& rays,
                        const ImageOptions& images, std::uint64_t seed, const fs::path& out, Observation& o) {
  if (s.session.target)
    move_target(s.session, s.markers[k], scene);
  else
    for (std::size_t m = 0; m < scene.markers.size(); ++m) scene.markers[m].center = s.markers[k][m];
  const Rig& rig = *s.true_rig;
  for (int c = 0; c < rig.count(); ++c) {
    const Rigid& root_from_sensor = c == 0 ? s.root_from_sensor[k] : s.later_root_from_sensor[k];
    const Rigid& root_from_tcp = c == 0 ? s.root_from_tcp[k] : s.later_root_from_tcp[k];
    ImageEffects effects;
    effects.blur_px = images.blur_px;
    effects.noise_grey = images.noise_grey;
    effects.seed = Random(seed).child(seed_of_image(rig, k, c)).word();
    std::string& file = o.images[static_cast<std::size_t>(c)];
    file = fmt::format("images/{:03}_{}.png", o.id, rig.at(c).name);
    write_png(render(scene, rays[static_cast<std::size_t>(c)], root_from_sensor * inverse(rig.at(c).camera_from_first),
                     root_from_tcp, effects),
              out / file);
  }
}

std::string label_hint(const SimulatedSession& s, const fs::path& out) {
  std::string hint =
      fmt::format("handsight-cli label {} --observation {} --left", out.string(), s.session.observations[0].id);
  for (const Vector3& marker : s.markers[0]) {
    const Vector2 pixel =
        project(s.true_rig->at(0).camera, inverse(s.root_from_sensor[0]) * (s.root_from_tcp[0] * marker));
    hint += fmt::format(" \"{:.0f},{:.0f}\"", pixel.x(), pixel.y());
  }
  return hint;
}

/// Removes the folder at the end of the scope where it has not been renamed by then.
struct Unfinished {
  fs::path folder;
  ~Unfinished() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
};

/// The robot's own name, but for those that files of a session have.
std::string robot_name(const fs::path& robot_file) {
  const std::string name = robot_file.filename().string();
  const bool is_taken = name == "session.xml" || name == "truth.xml" || name == "effects.xml" || name == "images";
  return is_taken ? "robot.urdf" : name;
}

}  // namespace

void write_images(const SimulatedSession& scene_of, const SimulationOptions& options, const ImageOptions& images,
                  std::size_t k, const fs::path& folder, SimulatedSession& simulated) {
  const Scene scene = scene_for(scene_of, options, images);
  std::vector<PixelRays> rays;
  for (const RigCamera& c : simulated.true_rig->cameras) rays.push_back(pixel_rays(c.camera));
  fs::create_directories(folder / "images");
  render_observation(simulated, k, scene, rays, images, options.seed, folder, simulated.session.observations[k]);
}

WrittenSession write_simulated(SimulatedSession simulated, const SimulationOptions& options, const fs::path& robot_file,
                               const ImageOptions& images, const fs::path& out,
                               const std::function<void(int)>& rendered) {
  if (fs::exists(out) && !(fs::is_directory(out) && fs::is_empty(out)))
    throw InputError(message("{} is there already and not empty; name a new folder in --out.", shown_path(out)));
  if (images.observations > 0 && !simulated.session.rig)
    throw InputError("A tracker session has no images to render; leave --images out.");
  const bool has_file = !simulated.session.robot.is_of_poses;
  const std::string robot_text = has_file ? read_file(robot_file) : std::string();
  std::error_code error;
  const fs::path target = fs::absolute(out, error).lexically_normal();
  const fs::path part = make_temporary_folder((target.has_filename() ? target : target.parent_path()).parent_path());
  const Unfinished unfinished{part};
  if (images.observations > 0) fs::create_directory(part / "images", error);
  if (error) throw InputError(message("{} cannot be made: {}.", shown_path(out), system_text(error)));

  WrittenSession written;
  const auto chosen = chosen_observations(simulated, options, images.observations);
  if (!chosen.empty()) {
    const Scene scene = scene_for(simulated, options, images);
    const bool are_found = simulated.session.target || is_pair(*simulated.true_rig);  // in the images
    std::vector<PixelRays> rays;
    for (const RigCamera& c : simulated.true_rig->cameras) rays.push_back(pixel_rays(c.camera));
    for (const std::size_t k : chosen) {
      Observation& o = simulated.session.observations[k];
      render_observation(simulated, k, scene, rays, images, options.seed, part, o);
      if (are_found) o.sightings.clear();
      if (rendered) rendered(++written.with_images);
    }
    written.with_images = static_cast<int>(chosen.size());
    if (are_found && !simulated.session.target) written.label_hint = label_hint(simulated, out);
  }
  if (has_file) {
    simulated.session.robot_file = robot_name(robot_file);
    replace_file(part / simulated.session.robot_file, robot_text);
  }
  simulated.session.file = part / "session.xml";
  save_session(simulated.session);
  write_truth(simulated, options, part / "truth.xml");
  fs::remove(out, error);  // an empty folder of that name
  fs::rename(part, out, error);
  if (error) throw InputError(message("{} cannot be made: {}.", shown_path(out), system_text(error)));
  return written;
}

}  // namespace handsight
