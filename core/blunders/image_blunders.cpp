// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "blunders/blunder_kinds.h"
#include "blunders/places.h"
#include "session/pose_points.h"

namespace handsight {
namespace {

BlunderKind sides_swapped() {
  BlunderKind k;
  k.id = "sides_swapped";
  k.of_images = true;
  k.places = [](const Session& s) {
    return s.rig && s.rig->count() == 2 ? std::vector<std::string>{""} : std::vector<std::string>{};
  };
  k.mend = [](const std::string&, Session& s) {
    if (!s.rig || s.rig->count() != 2) throw InputError("sides_swapped: the session has not two cameras.");
    for (Observation& o : s.observations) {
      std::swap(o.images[0], o.images[1]);
      for (Sighting& seen : o.sightings) {
        for (CameraPoint& point : seen.in_cameras) point.camera = 1 - point.camera;
        std::reverse(seen.in_cameras.begin(), seen.in_cameras.end());
      }
    }
  };
  k.text = [](const std::string&, const Session& s) {
    return message("The images of the cameras {} and {} are exchanged.", s.rig->at(0).name, s.rig->at(1).name);
  };
  k.fix = [](const std::string&, const Session& s) {
    return message(
        "Exchange {} and {} in <images> and <marker> of every observation of {} (or exchange the cameras of "
        "the calibration).",
        s.rig->at(0).name, s.rig->at(1).name, session_name(s));
  };
  return k;
}

bool has_columns_and_rows(const Session& s) {
  return s.target && s.target->kind != TargetKind::tags && s.target->columns != s.target->rows;
}

BlunderKind board_transposed() {
  BlunderKind k;
  k.id = "board_transposed";
  k.of_images = true;
  k.places = [](const Session& s) {
    return has_columns_and_rows(s) ? std::vector<std::string>{""} : std::vector<std::string>{};
  };
  k.mend = [](const std::string&, Session& s) {
    if (!has_columns_and_rows(s)) throw InputError("board_transposed: the session has no board of rows and columns.");
    Target target = *s.target;
    std::swap(target.columns, target.rows);
    set_target(s, target);
  };
  k.text = [](const std::string&, const Session& s) {
    return message("Columns and rows of the board are exchanged: it has {} columns and {} rows.", s.target->rows,
                   s.target->columns);
  };
  k.fix = [](const std::string&, const Session& s) {
    return message("Write columns=\"{}\" rows=\"{}\" into <target> of {}.", s.target->rows, s.target->columns,
                   session_name(s));
  };
  return k;
}

/// The board as one camera saw it, counted from its other end.
void count_from_other_end(Session& s, int camera) {
  const int last = s.marker_count - 1;
  for (Observation& o : s.observations) {
    std::vector<Sighting> sightings;
    const auto at = [&](int marker, const Sighting& like) -> Sighting& {
      const auto found =
          std::find_if(sightings.begin(), sightings.end(), [&](const Sighting& x) { return x.marker == marker; });
      if (found != sightings.end()) return *found;
      Sighting& one = sightings.emplace_back();
      one.marker = marker;
      one.by = like.by;
      one.usual_sigma = like.usual_sigma;
      return one;
    };
    for (const Sighting& seen : o.sightings)
      for (const CameraPoint& point : seen.in_cameras)
        see(at(point.camera == camera ? last - seen.marker : seen.marker, seen), point.camera, point.pixel,
            point.sigma);
    std::sort(sightings.begin(), sightings.end(),
              [](const Sighting& a, const Sighting& b) { return a.marker < b.marker; });
    o.sightings = std::move(sightings);
  }
}

int camera_named(const Session& s, const std::string& name) {
  for (int c = 1; s.rig && s.target && c < s.rig->count(); ++c)
    if (s.rig->at(c).name == name) return c;
  throw InputError(message("marker_order: there is no camera {:?} beside the first one that sees a board.", name));
}

BlunderKind marker_order() {
  BlunderKind k;
  k.id = "marker_order";
  k.of_images = true;
  k.places = [](const Session& s) {
    std::vector<std::string> places;
    for (int c = 1; s.rig && s.target && s.target->kind != TargetKind::tags && c < s.rig->count(); ++c)
      places.push_back(s.rig->at(c).name);
    return places;
  };
  k.mend = [](const std::string& where, Session& s) { count_from_other_end(s, camera_named(s, where)); };
  k.text = [](const std::string& where, const Session& s) {
    return message(
        "The board's points are counted from the other corner in the images of the camera {} than in those "
        "of {}.",
        where, s.rig->at(0).name);
  };
  k.fix = [](const std::string& where, const Session& s) {
    return message("Count the points of {} in {} from the other end: point m becomes {} - m.", where, session_name(s),
                   s.marker_count - 1);
  };
  return k;
}

void scale_board(Session& s) { set_target(s, scaled(*s.target, 1e-3)); }

void scale_rig(Session& s) {
  for (RigCamera& c : s.rig->cameras) c.camera_from_first.translation *= 1e-3;
}

void scale_points(Session& s) {
  if (s.sigma_point) *s.sigma_point *= 1e-3;
  for (Observation& o : s.observations)
    for (Sighting& seen : o.sightings) {
      if (seen.point) *seen.point *= 1e-3;
      if (seen.point_sigma) *seen.point_sigma *= 1e-3;
    }
}

void scale_target_poses(Session& s) {
  for (Observation& o : s.observations)
    if (o.target_pose) o.target_pose->translation *= 1e-3;
  show_poses(s, pose_lever(*s.pose_sensor));
}

std::vector<std::string> lengths_of_images(const Session& s) {
  std::vector<std::string> places;
  if (s.rig && s.target) places.emplace_back("board");
  if (s.rig && s.rig->count() > 1) places.emplace_back("rig");
  return places;
}

std::vector<std::string> measured_lengths(const Session& s) {
  if (s.pose_sensor) return {"target"};
  return s.rig ? std::vector<std::string>{} : std::vector<std::string>{"points"};
}

void mend_length(const std::string& where, Session& s) {
  std::vector<std::string> known = lengths_of_images(s);
  for (const std::string& measured : measured_lengths(s)) known.push_back(measured);
  if (std::find(known.begin(), known.end(), where) == known.end())
    throw InputError(
        message("length_unit: {:?} is no length of this session; expected one of: {}.", where, fmt::join(known, " ")));
  (where == "board"    ? scale_board
   : where == "rig"    ? scale_rig
   : where == "target" ? scale_target_poses
                       : scale_points)(s);
}

const char* lengths_text(const std::string& where) {
  return where == "board"    ? "The board's lengths"
         : where == "rig"    ? "The distances of the cameras"
         : where == "target" ? "The places of the target"
                             : "The tracker's points";
}

const char* lengths_fix(const std::string& where) {
  return where == "board"    ? "the lengths in <target>"
         : where == "rig"    ? "the distances between the cameras"
         : where == "target" ? "the xyz of every <target_pose>"
                             : "every point";
}

BlunderKind length_unit(bool of_images) {
  BlunderKind k;
  k.id = "length_unit";
  k.of_images = of_images;
  k.of_poses = !of_images;
  k.measured_unit = of_images ? 1 : 1e3;
  k.points_unit = 1e3;
  k.places = of_images ? lengths_of_images : measured_lengths;
  k.mend = mend_length;
  k.text = [](const std::string& where, const Session&) {
    return message("{} are in millimetres, where metres are expected.", lengths_text(where));
  };
  k.fix = [](const std::string& where, const Session& s) {
    return message("Write {} in {} in metres (a thousandth).", lengths_fix(where), session_name(s));
  };
  return k;
}

/// A frame with its axes exchanged or one of them turned round is left-handed; which one it was, the place of the
/// tracker takes up.
BlunderKind points_mirrored() {
  BlunderKind k;
  k.id = "points_mirrored";
  k.places = [](const Session& s) {
    const bool is_of_tracker = !s.rig && !s.pose_sensor && !s.is_touch() && s.mount.estimate;
    return is_of_tracker ? std::vector<std::string>{""} : std::vector<std::string>{};
  };
  k.mend = [](const std::string&, Session& s) {
    if (s.rig || s.pose_sensor) throw InputError("points_mirrored: the session has no points of a tracker.");
    for (Observation& o : s.observations)
      for (Sighting& seen : o.sightings)
        if (seen.point) std::swap(seen.point->y(), seen.point->z());
  };
  k.text = [](const std::string&, const Session&) {
    return Message(
        "The tracker's points are mirrored: two of its axes are exchanged, or one counts the other way, so that its "
        "frame is left-handed.");
  };
  k.fix = [](const std::string&, const Session& s) {
    return message(
        "Exchange two coordinates of every point in {} (two columns of the table that it was made of), or export again "
        "with right-handed axes.",
        session_name(s));
  };
  return k;
}

}  // namespace

std::vector<BlunderKind> image_blunders() {
  return {length_unit(true), length_unit(false), points_mirrored(),
          sides_swapped(),   board_transposed(), marker_order()};
}

}  // namespace handsight
