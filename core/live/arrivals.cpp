// SPDX-License-Identifier: Apache-2.0
#include "live/arrivals.h"

#include <algorithm>

#include "session/pose_points.h"

namespace handsight {

namespace fs = std::filesystem;

LiveSources usual_sources(const Session& session) {
  const auto count = static_cast<std::size_t>(session.rig ? session.rig->count() : 0);
  return {std::vector<fs::path>(count, folder(session) / "images"), folder(session) / "joints.csv"};
}

LiveSources own_sources(const Session& session) {
  LiveSources sources = usual_sources(session);
  for (std::size_t c = 0; c < sources.folders.size(); ++c)
    for (const Observation& o : session.observations)
      if (!o.images[c].empty()) sources.folders[c] = folder(session) / fs::path(o.images[c]).parent_path();
  return sources;
}

Arrivals::Arrivals(const Session& session, LiveSources sources, std::optional<std::chrono::milliseconds> settles_in)
    : folder_(folder(session)),
      sources_(std::move(sources)),
      joints_(session.joints),
      tells_poses_(session.pose_sensor.has_value()),
      is_of_flange_(session.robot.is_of_poses),
      markers_(session.marker_count),
      table_(sources_.table, session.joints),
      measured_(folder_ / (session.pose_sensor ? "poses.csv" : "points.csv"), {}),
      files_(settles_in) {
  if (session.rig)
    for (const RigCamera& camera : session.rig->cameras) {
      names_.push_back(camera.name);
      cameras_.push_back(camera.camera);
    }
  known_.resize(cameras_.size());
  if (session.pose_sensor) lever_ = pose_lever(*session.pose_sensor);
  know(session);
}

void Arrivals::know(const Session& session) {
  next_time_ = 0;
  postures_.clear();
  for (auto& names : known_)
    for (auto& [name, place] : names) place = no_posture;
  for (const Observation& o : session.observations) {
    next_time_ = std::max(next_time_, o.time + 1);
    known_lines_.push_back(bits_of_line(o.time, o.position));
    if (cameras_.empty())
      known_measured_.push_back(bits_of_measured(o));
    else
      know_images(o);
  }
  make_ascending(known_lines_);
  make_ascending(known_measured_);
}

void Arrivals::forget(const Observation& o) {
  if (!cameras_.empty()) forget_images(o);
  take_out(known_lines_, bits_of_line(o.time, o.position));
  take_out(known_measured_, bits_of_measured(o));
  arrived_.clear();  // what is in the session is known without it
  table_.read_anew();
  measured_.read_anew();
}

void Arrivals::arrive(Observation o, const Pose& pose, Look& look) {
  o.position = pose.position;
  o.time = pose.time.value_or(next_time_);
  next_time_ = std::max(next_time_, o.time + 1);
  if (pose.time) put_into(known_lines_, bits_of_line(o.time, o.position));
  look.arrived.push_back(std::move(o));
}

Arrivals::Look Arrivals::look() {
  Look look;
  take_poses();
  if (!cameras_.empty()) {
    take_images(look);
  } else {
    if (tells_poses_)
      take_target_poses();
    else
      take_points();
    pair_measured(look);
  }
  for (const Message& sentence : waiting_)
    if (!waited_.contains(sentence.english())) look.remarks.push_back(sentence);
  for (GrowingTable* table : {&table_, &measured_})
    for (Message& sentence : table->newly_set_aside()) look.remarks.push_back(std::move(sentence));
  return look;
}

std::vector<Message> Arrivals::standing() const {
  std::vector<Message> all = waiting_;
  for (const GrowingTable* table : {&table_, &measured_})
    for (Message& sentence : table->all_set_aside()) all.push_back(std::move(sentence));
  return all;
}

}  // namespace handsight
