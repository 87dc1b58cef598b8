// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/deciding.h"

#include <algorithm>

#include "base/files.h"
#include "base/text.h"
#include "session/pose_points.h"
#include "vision/image/image_file.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

std::string brought_image(const Session& session, std::int64_t id, const RigCamera& camera, const std::string& file) {
  const fs::path from = fs::path(file).is_absolute() ? fs::path(file) : folder(session) / file;
  std::error_code error;
  if (!fs::is_regular_file(from, error))
    throw DriverFault(message("The driver names {} as what camera {} saw, and there is no such file.", shown_path(from),
                              camera.name));
  std::string name = fmt::format("images/{:04}_{}{}", id, camera.name, from.extension().string());
  const fs::path to = folder(session) / name;
  if (fs::equivalent(from, to, error)) return name;
  if (fs::exists(to, error))
    throw InputError(message("{} is there already and is no image of this experiment; move it away.", shown_path(to)));
  fs::create_directories(to.parent_path(), error);
  replace_file(to, read_file(from));
  return name;
}

void bring_images(const Session& session, const LookAnswer& seen, Observation& o) {
  for (int c = 0; c < session.rig->count(); ++c)
    if (const auto file = seen.images.find(session.rig->at(c).name); file != seen.images.end())
      o.images[static_cast<std::size_t>(c)] = brought_image(session, o.id, session.rig->at(c), file->second);
}

ImagePair pair_of(const Session& session, const Observation& o) {
  const auto image = [&](int c) {
    const std::string& name = o.images[static_cast<std::size_t>(c)];
    return read_image(folder(session) / name, session.rig->at(c).camera, name);
  };
  return {image(0), image(1)};
}

}  // namespace

Observation make_observation(const Session& session, std::int64_t id, double time, const MoveAnswer& stood,
                             const LookAnswer& seen) {
  Observation o;
  o.id = id;
  o.time = time;
  o.position = stood.position;
  o.torque = stood.torque;
  const bool suits = session.pose_sensor ? seen.target_pose.has_value()
                     : session.rig       ? !seen.target_pose && (seen.sightings.empty() || !seen.sightings[0].point)
                                         : seen.images.empty() && !seen.target_pose;
  if (!suits)
    throw DriverFault(message("The driver's look is not what <{}> of the session sees: expected {}.",
                              device_tag(session),
                              session.pose_sensor ? verbatim("\"target_pose\"")
                              : session.rig       ? Message("\"images\" or \"markers\"")
                                                  : verbatim("\"points\"")));
  if (session.pose_sensor) {
    o.target_pose = seen.target_pose;
    show_pose(o, pose_lever(*session.pose_sensor));
  } else if (!seen.images.empty()) {
    bring_images(session, seen, o);
  } else {
    o.sightings = seen.sightings;
  }
  return o;
}

Deciding::Deciding(const Session& session) : online_(std::make_unique<OnlineCalibration>(session)) {
  if (session.target && session.rig) finder_.emplace(session);
  for (const Observation& o : session.observations)
    if (is_used(o)) online_->add(o, nullptr);
  online_->take_revised();
}

OnlineStep Deciding::find_step(const Session& session, const Observation& o) {
  if (!has_images(o)) return online_->add(o, nullptr);
  if (finder_) {
    TargetFinding found = finder_->find(o);
    if (found.images == 0 && !found.unreadable.empty()) throw InputError(found.unreadable.front());
    Observation seen = o;
    seen.sightings = std::move(found.sightings);
    OnlineStep step = online_->add(seen, nullptr, found.reason);
    step.from_images = true;
    step.sightings = std::move(seen.sightings);
    return step;
  }
  if (!session.rig || !is_pair(*session.rig) || o.images[0].empty() || o.images[1].empty())
    return online_->add(o, nullptr);
  const ImagePair images = pair_of(session, o);
  return online_->add(o, &images);
}

OnlineStep Deciding::decide(Session& session, std::size_t place) {
  OnlineStep step = find_step(session, session.observations[place]);
  for (const OnlineStep& revised : online_->take_revised())
    for (Observation& o : session.observations)
      if (o.id == revised.id && o.decision != Decision::excluded) keep_step(revised, o);
  keep_step(step, session.observations[place]);
  return step;
}

}  // namespace handsight
