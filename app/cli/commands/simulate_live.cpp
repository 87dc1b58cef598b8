// SPDX-License-Identifier: Apache-2.0
#include "simulate_live.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"
#include "session/session_xml.h"

namespace handsight::cli {
namespace {

namespace fs = std::filesystem;

void append(const fs::path& file, const std::string& line) {
  std::ofstream out(file, std::ios::binary | std::ios::app);
  out << line << '\n';
  if (!out.flush()) throw InputError(message("{} cannot be written; is the disk full?", shown_path(file)));
}

std::string joined(const double* numbers, Eigen::Index count) {
  std::string text;
  for (Eigen::Index i = 0; i < count; ++i) text += "," + format_number(numbers[i]);
  return text;
}

/// Readers must not see half of it: written beside its place, then renamed.
void bring_image(const fs::path& from, const fs::path& to) {
  const fs::path part = to.parent_path() / ("." + to.filename().string());
  fs::copy_file(from, part, fs::copy_options::overwrite_existing);
  fs::rename(part, to);
}

void write_header(const Session& s, const fs::path& folder) {
  std::string joints = "number,time", points = "number";
  for (const std::string& name : s.joints) joints += "," + name;
  for (int m = 0; m < s.marker_count; ++m)
    for (const char axis : {'x', 'y', 'z'}) points += fmt::format(",m{}_{}", m, axis);
  append(folder / "joints.csv", joints);
  if (s.pose_sensor)
    append(folder / "poses.csv", "number,x,y,z,qx,qy,qz,qw");
  else if (s.is_tracker())
    append(folder / "points.csv", points);
}

void write_points(const Session& s, const Observation& o, const fs::path& folder) {
  std::string line = std::to_string(o.id);
  for (int m = 0; m < s.marker_count; ++m) {
    const auto seen = std::find_if(o.sightings.begin(), o.sightings.end(),
                                   [&](const Sighting& sighting) { return sighting.marker == m && sighting.point; });
    line += seen == o.sightings.end() ? ",,," : joined(seen->point->data(), 3);
  }
  append(folder / "points.csv", line);
}

void write_pose(const Observation& o, const fs::path& folder) {
  const Eigen::Quaterniond q(o.target_pose->rotation);
  append(folder / "poses.csv",
         fmt::format("{}{}{}", o.id, joined(o.target_pose->translation.data(), 3), joined(q.coeffs().data(), 4)));
}

/// What was measured, before the line of joints that calls for it.
void write_measured(const Session& s, const Observation& o, const fs::path& whole, const fs::path& folder) {
  for (const std::string& image : o.images)
    if (!image.empty()) bring_image(whole / image, folder / image);
  if (s.pose_sensor && o.target_pose)
    write_pose(o, folder);
  else if (s.is_tracker() && !s.pose_sensor)
    write_points(s, o, folder);
}

}  // namespace

void simulate_live(const SimulatedSession& simulated, const SimulationOptions& options, const fs::path& robot_file,
                   const ImageOptions& images, const fs::path& folder, double rate,
                   const std::function<void(int)>& arrived) {
  if (fs::exists(folder)) throw InputError(message("{} is there already; name a new folder.", shown_path(folder)));
  fs::path whole = folder;
  whole += ".whole";
  write_simulated(simulated, options, robot_file, images, whole);
  const Session all = read_session(whole);
  Session begun = all;
  begun.observations.resize(1);
  if (!all.target) begun.observations[0].sightings = simulated.session.observations[0].sightings;  // it is labelled
  begun.source.reset();
  begun.file = folder / "session.xml";
  fs::create_directories(folder / "images");
  if (!all.robot.is_of_poses) fs::copy_file(whole / all.robot_file, folder / all.robot_file);
  for (const std::string& image : begun.observations[0].images)
    if (!image.empty()) bring_image(whole / image, folder / image);
  save_session(begun);
  write_header(all, folder);
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t k = 1; k < all.observations.size(); ++k) {
    const Observation& o = all.observations[k];
    std::this_thread::sleep_until(start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                              std::chrono::duration<double>(static_cast<double>(k) / rate)));
    write_measured(all, o, whole, folder);
    append(folder / "joints.csv",
           fmt::format("{},{}{}", o.id, format_number(o.time), joined(o.position.data(), o.position.size())));
    arrived(static_cast<int>(k));
  }
  fs::remove_all(whole);
}

}  // namespace handsight::cli
