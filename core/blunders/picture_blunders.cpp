// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "blunders/blunder_kinds.h"
#include "blunders/picture_turns.h"
#include "blunders/places.h"

namespace handsight {
namespace {

/// The names of the cameras whose images it is.
std::string cameras_text(int camera, const Session& s) {
  if (camera >= 0) return s.rig->at(camera).name;
  return fmt::format("{}", fmt::join(camera_names(*s.rig), ", "));
}

Message turn_text(PictureTurn turn, const std::string& cameras) {
  switch (turn) {
    case PictureTurn::mirrored:
      return message("The images of {} are mirrored: left and right are exchanged.", cameras);
    case PictureTurn::flipped:
      return message("The images of {} are mirrored: top and bottom are exchanged.", cameras);
    case PictureTurn::half:
      return message("The images of {} stand upside down against how the camera was calibrated.", cameras);
    case PictureTurn::quarter_right:
      return message("The images of {} are turned by 90 degrees to the right against how the camera was calibrated.",
                     cameras);
    case PictureTurn::quarter_left:
      break;
  }
  return message("The images of {} are turned by 90 degrees to the left against how the camera was calibrated.",
                 cameras);
}

BlunderKind picture_blunder(const char* id) {
  BlunderKind k;
  k.id = id;
  k.of_images = true;
  k.places = [id](const Session& s) { return picture_places(id, s); };
  k.mend = [id](const std::string& where, Session& s) { turn_back(pictures_at(id, where, s), s); };
  k.mend_image = [id](const std::string& where, int camera, const Image& image, const Session& s) {
    const PicturesAt at = pictures_at(id, where, s);
    return at.camera < 0 || at.camera == camera ? turned_back(image, at.turn) : image;
  };
  k.text = [id](const std::string& where, const Session& s) {
    const PicturesAt at = pictures_at(id, where, s);
    return turn_text(at.turn, cameras_text(at.camera, s));
  };
  k.fix = [](const std::string&, const Session& s) {
    return message(
        "Take the images as the camera delivers them (look for flip, mirror or rotate in the driver), or calibrate the "
        "camera with images as those of {}.",
        session_name(s));
  };
  return k;
}

void exchange(Camera& camera) {
  const auto off = [&](double cx, double cy) {
    return std::abs(cx - 0.5 * (camera.width - 1)) + std::abs(cy - 0.5 * (camera.height - 1));
  };
  std::swap(camera.width, camera.height);
  if (off(camera.cy, camera.cx) < 0.5 * off(camera.cx, camera.cy)) std::swap(camera.cx, camera.cy);
}

/// Would all that was seen lie in the image if its width and height were exchanged?
bool fits_exchanged(const Session& s, int camera) {
  const Camera& c = s.rig->at(camera).camera;
  for (const Observation& o : s.observations)
    for (const Sighting& sighting : o.sightings)
      for (const CameraPoint& p : sighting.in_cameras)
        if (p.camera == camera && (p.pixel.x() > c.height || p.pixel.y() > c.width)) return false;
  return true;
}

std::vector<std::string> oblong_cameras(const Session& s) {
  std::vector<std::string> places;
  for (int c = 0; s.rig && c < s.rig->count(); ++c)
    if (s.rig->at(c).camera.width != s.rig->at(c).camera.height && fits_exchanged(s, c))
      places.push_back(s.rig->at(c).name);
  if (places.size() > 1 || (s.rig && s.rig->count() == 1 && !places.empty())) places.insert(places.begin(), "");
  if (s.rig && s.rig->count() == 1 && places.size() > 1) places.pop_back();
  return places;
}

BlunderKind size_swapped() {
  BlunderKind k;
  k.id = "size_swapped";
  k.of_images = true;
  k.places = oblong_cameras;
  k.mend = [](const std::string& where, Session& s) {
    bool any = false;
    for (int c = 0; s.rig && c < s.rig->count(); ++c) {
      RigCamera& one = s.rig->cameras[static_cast<std::size_t>(c)];
      if (!where.empty() && one.name != where) continue;
      exchange(one.camera);
      any = true;
    }
    if (!any) throw InputError(message("size_swapped: the session has no camera {:?}.", where));
  };
  k.text = [](const std::string& where, const Session& s) {
    return message("Width and height of the images of {} are exchanged.", where.empty() ? cameras_text(-1, s) : where);
  };
  k.fix = [](const std::string& where, const Session& s) {
    Camera camera = s.rig->at(0).camera;
    for (const RigCamera& one : s.rig->cameras)
      if (one.name == where) camera = one.camera;
    exchange(camera);
    return message("Write width=\"{}\" height=\"{}\" cx=\"{:g}\" cy=\"{:g}\" into <camera> of {}.", camera.width,
                   camera.height, camera.cx, camera.cy, session_name(s));
  };
  return k;
}

}  // namespace

std::vector<BlunderKind> picture_blunders() {
  return {picture_blunder("image_mirrored"), picture_blunder("image_turned"), size_swapped()};
}

}  // namespace handsight
