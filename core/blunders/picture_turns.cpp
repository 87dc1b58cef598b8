// SPDX-License-Identifier: Apache-2.0
#include "blunders/picture_turns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "blunders/places.h"

namespace handsight {
namespace {

bool is_quarter(PictureTurn turn) { return turn == PictureTurn::quarter_right || turn == PictureTurn::quarter_left; }
bool is_mirror(PictureTurn turn) { return turn == PictureTurn::mirrored || turn == PictureTurn::flipped; }

/// How far the principal point is from the middle of an image of that size.
double off_middle(const Camera& camera, int width, int height) {
  return std::hypot(camera.cx - 0.5 * (width - 1), camera.cy - 0.5 * (height - 1));
}

/// The pixel of an image of width x height, as it was taken, that stands at (u, v) now.
Vector2 place_before(double u, double v, PictureTurn turn, double width, double height) {
  switch (turn) {
    case PictureTurn::mirrored:
      return {width - 1 - u, v};
    case PictureTurn::flipped:
      return {u, height - 1 - v};
    case PictureTurn::half:
      return {width - 1 - u, height - 1 - v};
    case PictureTurn::quarter_right:
      return {v, height - 1 - u};
    case PictureTurn::quarter_left:
      break;
  }
  return {width - 1 - v, u};
}

/// A chessboard seen in a mirror looks like itself with its rows, or its columns, counted from the other end.
int number_before(int number, const Target& board) {
  const int row = number / board.columns, column = number % board.columns;
  return board.rows % 2 == 0 ? (board.rows - 1 - row) * board.columns + column
                             : row * board.columns + board.columns - 1 - column;
}

PictureTurn turn_named(const std::string& id, const std::string& how) {
  if (id == "image_mirrored") {
    if (how.empty()) return PictureTurn::mirrored;
    if (how == "vertical") return PictureTurn::flipped;
    throw InputError(
        message("image_mirrored: {:?} is not known; expected nothing (left and right exchanged) or "
                "vertical (top and bottom).",
                how));
  }
  if (how.empty() || how == "180") return PictureTurn::half;
  if (how == "90") return PictureTurn::quarter_right;
  if (how == "270") return PictureTurn::quarter_left;
  throw InputError(message("image_turned: {:?} is not known; expected 90, 180 or 270 (degrees to the right).", how));
}

int look_up_camera(const std::string& name, const Session& s) {
  for (int c = 0; s.rig && c < s.rig->count(); ++c)
    if (s.rig->at(c).name == name) return c;
  return -1;
}

}  // namespace

Camera upright(const Camera& camera) {
  Camera turned = camera;
  std::swap(turned.width, turned.height);
  const bool is_turned =
      off_middle(camera, turned.width, turned.height) < 0.5 * off_middle(camera, camera.width, camera.height);
  return is_turned ? turned : camera;
}

CameraPoint turned_back(const CameraPoint& point, PictureTurn turn, const Camera& camera) {
  CameraPoint before = point;
  before.pixel = place_before(point.pixel.x(), point.pixel.y(), turn, camera.width, camera.height);
  if (!point.sigma) return before;
  if (is_quarter(turn)) std::swap(before.sigma->u, before.sigma->v);
  if (turn != PictureTurn::half) before.sigma->uv = -before.sigma->uv;
  return before;
}

Image turned_back(const Image& image, PictureTurn turn) {
  Image before = is_quarter(turn) ? Image(image.height, image.width) : Image(image.width, image.height);
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) {
      const Vector2 place = place_before(u, v, turn, before.width, before.height);
      before.row(static_cast<int>(place.y()))[static_cast<int>(place.x())] = image.row(v)[u];
    }
  return before;
}

PicturesAt pictures_at(const std::string& id, const std::string& where, const Session& session) {
  const auto [first, second] = name_and_value(where);
  if (const int camera = look_up_camera(first, session); camera >= 0) return {camera, turn_named(id, second)};
  if (!second.empty()) throw InputError(message("{}: the session has no camera {:?}.", id, first));
  return {-1, turn_named(id, first)};
}

std::vector<std::string> picture_places(const std::string& id, const Session& session) {
  std::vector<std::string> places;
  if (!session.rig) return places;
  const std::vector<std::string> ways =
      id == "image_mirrored" ? std::vector<std::string>{"", "vertical"} : std::vector<std::string>{"", "90", "270"};
  places = ways;
  if (session.rig->count() > 1)
    for (const RigCamera& camera : session.rig->cameras)
      for (const std::string& way : ways) places.push_back(way.empty() ? camera.name : camera.name + "=" + way);
  return places;
}

void turn_back(const PicturesAt& at, Session& session) {
  if (!session.rig) throw InputError("image_turned: the session has no camera.");
  const bool renumbers =
      is_mirror(at.turn) && at.camera < 0 && session.target && session.target->kind == TargetKind::chessboard;
  if (is_quarter(at.turn))
    for (int c = 0; c < session.rig->count(); ++c)
      if (at.camera < 0 || at.camera == c) {
        Camera& camera = session.rig->cameras[static_cast<std::size_t>(c)].camera;
        camera = upright(camera);
      }
  for (Observation& o : session.observations) {
    for (Sighting& seen : o.sightings) {
      for (CameraPoint& point : seen.in_cameras)
        if (at.camera < 0 || at.camera == point.camera)
          point = turned_back(point, at.turn, session.rig->at(point.camera).camera);
      if (renumbers && seen.by == MarkedBy::tracker) seen.marker = number_before(seen.marker, *session.target);
    }
    std::stable_sort(o.sightings.begin(), o.sightings.end(),
                     [](const Sighting& a, const Sighting& b) { return a.marker < b.marker; });
  }
}

}  // namespace handsight
