// SPDX-License-Identifier: Apache-2.0
// What arrives as images.
#include <algorithm>

#include "base/error.h"
#include "live/arrivals.h"
#include "session/new_session.h"

namespace handsight {

namespace fs = std::filesystem;

namespace {

constexpr double same_posture = 1e-6;  // rad or m: what a table's digits may leave out

std::string display_name(const fs::path& file) { return file.filename().string(); }

/// The first image that is there, and its camera.
std::size_t first_camera(const InstantImages& instant) {
  std::size_t c = 0;
  while (c + 1 < instant.files.size() && instant.files[c].empty()) ++c;
  return c;
}

}  // namespace

void Arrivals::know_images(const Observation& o) {
  for (std::size_t c = 0; c < cameras_.size(); ++c)
    if (!o.images[c].empty()) known_[c][display_name(o.images[c])] = postures_.size();
  postures_.push_back(o.position);
}

void Arrivals::forget_images(const Observation& o) {
  for (std::size_t c = 0; c < cameras_.size(); ++c) known_[c].erase(display_name(o.images[c]));
}

bool Arrivals::is_known(std::size_t camera, const fs::path& image) const {
  return known_[camera].contains(display_name(image));
}

/// Has all of it arrived?
bool Arrivals::is_known(const InstantImages& instant) const {
  for (std::size_t c = 0; c < instant.files.size(); ++c)
    if (!instant.files[c].empty() && !is_known(c, instant.files[c])) return false;
  return true;
}

/// Of one that is known.
std::size_t Arrivals::place_of_posture(const InstantImages& instant) const {
  const std::size_t c = first_camera(instant);
  return known_[c].at(display_name(instant.files[c]));
}

/// Looks at the files of all that is new; has one of them been there for long?
bool Arrivals::look_at(const std::vector<InstantImages>& instants) {
  bool is_any_overdue = false;
  files_.begin_look();
  for (const InstantImages& instant : instants) {
    if (is_known(instant)) continue;
    for (const fs::path& file : instant.files) {
      if (file.empty()) continue;
      files_.look_at(file);
      is_any_overdue = is_any_overdue || files_.is_overdue(file);
    }
  }
  return is_any_overdue;
}

/// Without numbers, lines are counted: those of instants that are in the session must say what it says.
Message Arrivals::counting_refusal(const std::vector<InstantImages>& instants) const {
  const std::string table = table_.name();
  if (lines_.size() != instants.size())
    return cameras_.size() == 2
               ? message(
                     "{} has {} lines for {} image pairs: it waits until they are as many. With a column "
                     "\"number\" each pair finds its own line.",
                     table, lines_.size(), instants.size())
               : message(
                     "{} has {} lines for {} images: it waits until they are as many. With a column "
                     "\"number\" each image finds its own line.",
                     table, lines_.size(), instants.size());
  for (std::size_t rank = 0; rank < instants.size(); ++rank) {
    if (!is_known(instants[rank]) || !lines_[rank]) continue;
    const std::size_t place = place_of_posture(instants[rank]);
    if (place == no_posture) continue;
    if ((postures_[place] - lines_[rank]->position).cwiseAbs().maxCoeff() > same_posture)
      return message(
          "Line {} of {} is not the posture that the session has for {}. Name the images' numbers in a "
          "column \"number\".",
          rank + 1, table, display_name(instants[rank].files[first_camera(instants[rank])]));
  }
  return {};
}

/// Why no instant can have its joint angles; empty: some may.
Message Arrivals::table_refusal(const std::vector<InstantImages>& instants) const {
  if (!table_.is_there())
    return cameras_.size() == 2
               ? message("{} is not there yet: the joint angles of the new images, a line for each pair.",
                         table_.name())
               : message("{} is not there yet: the joint angles, a line for each new image.", table_.name());
  return table_.has("number") ? Message() : counting_refusal(instants);
}

const Arrivals::Pose* Arrivals::find_instant_pose(const InstantImages& instant, std::size_t rank) const {
  if (!table_.has("number")) return rank < lines_.size() && lines_[rank] ? &*lines_[rank] : nullptr;
  const auto found = poses_.find(instant.number);
  return found == poses_.end() ? nullptr : &found->second;
}

/// Says what the instant waits for; true where it waits for nothing.
bool Arrivals::has_every_image(const InstantImages& instant) {
  const fs::path& there = instant.files[first_camera(instant)];
  for (std::size_t c = 0; c < instant.files.size(); ++c) {
    if (!instant.files[c].empty()) continue;
    if (files_.is_overdue(there))
      waiting_.push_back(message("{} waits for its {} image, with the number {} in its name.", display_name(there),
                                 names_[c], instant.number));
    return false;
  }
  return std::all_of(instant.files.begin(), instant.files.end(),
                     [&](const fs::path& file) { return files_.may_be_opened(file); });
}

/// Says what is wrong with an image that stays as it is.
bool Arrivals::are_whole(const InstantImages& instant) {
  for (std::size_t c = 0; c < instant.files.size(); ++c) {
    const Message& fault = files_.fault(instant.files[c], cameras_[c]);
    if (fault.empty()) continue;
    if (files_.is_overdue(instant.files[c])) waiting_.push_back(fault);
    return false;
  }
  return true;
}

/// One folder for all cameras unless their files have the same names.
fs::path Arrivals::find_folder(const InstantImages& instant, std::size_t camera) const {
  for (std::size_t i = 0; i < instant.files.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (instant.files[i].filename() == instant.files[k].filename()) return fs::path("images") / names_[camera];
  return "images";
}

void Arrivals::take(const InstantImages& instant, std::size_t rank, Look& look) {
  if (!has_every_image(instant)) return;
  const Pose* pose = find_instant_pose(instant, rank);
  if (!pose) {
    if (files_.is_overdue(instant.files[0]))
      waiting_.push_back(table_.has("number") ? message("{} waits for its joint angles in {} (number {}).",
                                                        display_name(instant.files[0]), table_.name(), instant.number)
                                              : message("{} waits for its joint angles in {} (line {}).",
                                                        display_name(instant.files[0]), table_.name(), rank + 1));
    return;
  }
  if (!are_whole(instant)) return;
  Observation o;
  try {
    for (std::size_t c = 0; c < instant.files.size(); ++c)
      o.images[c] = bring_into(instant.files[c], folder_, find_folder(instant, c));
  } catch (const InputError& error) {
    waiting_.emplace_back(error.what());
    return;
  }
  arrive(std::move(o), *pose, look);
  know_images(look.arrived.back());
  poses_.erase(instant.number);
}

/// One that has arrived is no part of a new instant.
void Arrivals::leave_out_known(std::vector<InstantImages>& instants) const {
  for (InstantImages& instant : instants)
    for (std::size_t c = 0; !is_known(instant) && c < instant.files.size(); ++c)
      if (!instant.files[c].empty() && is_known(c, instant.files[c])) instant.files[c].clear();
}

void Arrivals::take_images(Look& look) {
  waited_ = {waiting_.begin(), waiting_.end()};
  waiting_.clear();
  const auto is_old = [this](std::size_t camera, const fs::path& file) { return is_known(camera, file); };
  std::vector<InstantImages> instants = find_camera_folders(names_, sources_.folders, is_old, waiting_);
  leave_out_known(instants);
  const bool is_any_overdue = look_at(instants);
  if (table_.is_set_aside(verbatim(table_.name()))) return;
  if (!poses_.empty())
    for (const InstantImages& instant : instants)
      if (is_known(instant)) poses_.erase(instant.number);
  const auto is_new = [this](const InstantImages& instant) { return !is_known(instant); };
  if (std::none_of(instants.begin(), instants.end(), is_new)) return;
  const Message refusal = table_refusal(instants);
  if (!refusal.empty()) {
    if (is_any_overdue) waiting_.push_back(refusal);
    return;
  }
  for (std::size_t rank = 0; rank < instants.size(); ++rank)
    if (is_new(instants[rank])) take(instants[rank], rank, look);
}

}  // namespace handsight
