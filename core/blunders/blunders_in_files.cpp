// SPDX-License-Identifier: Apache-2.0
#include "blunders/blunders_in_files.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/files.h"
#include "blunders/blunder_kinds.h"
#include "blunders/gravity_blunder.h"
#include "blunders/picture_turns.h"
#include "chain/chain.h"
#include "targets/target_detection.h"
#include "vision/image/image_file.h"
#include "vision/image/image_header.h"

namespace handsight {
namespace {

constexpr std::size_t most_images = 6;  // of a camera that are looked at

Blunder reported(const std::string& id, const std::string& where, const Session& session) {
  const BlunderKind& kind = *find_blunder_kind(id);
  Blunder b{.id = id, .where = where, .text = kind.text(where, session), .fix = kind.fix(where, session)};
  b.is_by_fit = false;
  b.in_pixels = !session.is_tracker();
  return b;
}

/// Some image files of a camera, spread over all.
std::vector<std::filesystem::path> some_images(const Session& session, int camera) {
  std::vector<std::filesystem::path> all, some;
  for (const Observation& o : session.observations)
    if (const std::string& file = o.images[static_cast<std::size_t>(camera)]; !file.empty())
      all.push_back(folder(session) / file);
  const std::size_t step = std::max<std::size_t>(1, all.size() / most_images);
  for (std::size_t i = 0; i < all.size() && some.size() < most_images; i += step) some.push_back(all[i]);
  return some;
}

std::optional<ImageSize> size_of_file(const std::filesystem::path& file) {
  try {
    return image_size(read_file(file));
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Do the images of a camera have its size with width and height exchanged? Nothing where none can be read.
std::optional<bool> are_images_exchanged(const Session& session, int camera) {
  const Camera& c = session.rig->at(camera).camera;
  std::optional<bool> exchanged;
  for (const std::filesystem::path& file : some_images(session, camera))
    if (const auto size = size_of_file(file)) {
      const bool is_so = size->width == c.height && size->height == c.width;
      exchanged = exchanged.value_or(true) && is_so;
    }
  return exchanged;
}

/// Do points lie outside the image as it is described that would all lie inside it with its sides exchanged?
bool are_points_exchanged(const Session& session, int camera) {
  constexpr int fewest = 4;
  constexpr double share = 0.02;
  const Camera& c = session.rig->at(camera).camera;
  int all = 0, outside = 0;
  for (const Observation& o : session.observations)
    for (const Sighting& s : o.sightings)
      if (const CameraPoint* seen = seen_by(s, camera)) {
        const Vector2& p = seen->pixel;
        const auto is_in = [&](int width, int height) {
          return p.x() > -1 && p.y() > -1 && p.x() < width && p.y() < height;
        };
        if (!is_in(c.height, c.width)) return false;
        ++all;
        outside += is_in(c.width, c.height) ? 0 : 1;
      }
  return outside >= fewest && outside > share * all;
}

std::vector<Blunder> exchanged_sizes(const Session& session) {
  std::vector<int> cameras;
  for (int c = 0; session.rig && c < session.rig->count(); ++c) {
    const Camera& camera = session.rig->at(c).camera;
    if (camera.width == camera.height) continue;
    if (are_images_exchanged(session, c).value_or(are_points_exchanged(session, c))) cameras.push_back(c);
  }
  if (cameras.empty()) return {};
  if (static_cast<int>(cameras.size()) == session.rig->count()) return {reported("size_swapped", "", session)};
  std::vector<Blunder> all;
  for (const int c : cameras) all.push_back(reported("size_swapped", session.rig->at(c).name, session));
  return all;
}

/// In how many of some images the target is found as they are, and in their mirror images.
std::pair<int, int> found_in(const Session& session, int camera, const PreparedTarget& target) {
  int as_they_are = 0, mirrored = 0;
  for (const std::filesystem::path& file : some_images(session, camera)) {
    try {
      const Image image = read_image(file, session.rig->at(camera).camera, file.filename().string());
      as_they_are += detect_target(image, target).points.empty() ? 0 : 1;
      mirrored += detect_target(turned_back(image, PictureTurn::mirrored), target).points.empty() ? 0 : 1;
    } catch (const InputError&) {  // it is reported where images are read
    }
  }
  return {as_they_are, mirrored};
}

/// Only tags tell an image from its mirror image.
std::vector<Blunder> mirrored_tags(const Session& session) {
  constexpr double hardly = 0.2;
  if (!session.rig || !session.target || session.target->kind == TargetKind::chessboard) return {};
  std::size_t with_images = 0, with_target = 0;
  for (const Observation& o : session.observations) {
    with_images += has_images(o) ? 1 : 0;
    with_target += o.sightings.empty() ? 0 : 1;
  }
  if (with_images == 0 || static_cast<double>(with_target) > hardly * static_cast<double>(with_images)) return {};
  const PreparedTarget target = prepare(*session.target);
  std::vector<std::string> cameras;
  for (int c = 0; c < session.rig->count(); ++c) {
    const auto [as_they_are, mirrored] = found_in(session, c, target);
    if (mirrored > 0 && as_they_are * 3 < mirrored) cameras.push_back(session.rig->at(c).name);
  }
  if (cameras.empty()) return {};
  const bool all = static_cast<int>(cameras.size()) == session.rig->count();
  return {reported("image_mirrored", all ? "" : cameras.front(), session)};
}

/// What measured torques leave beside the moments of gravity (mean square, N m), each joint with the sign that suits
/// it: a driver may count either way.
double torques_left(const Session& session, const Chain& chain, double* measured = nullptr) {
  const auto count = static_cast<Eigen::Index>(chain.joints.size());
  Eigen::VectorXd held = Eigen::VectorXd::Zero(count), pulled = held;
  double all = 0;
  int rows = 0;
  for (const Observation& o : session.observations) {
    if (o.torque.size() == 0) continue;
    const Posture posture =
        solve_posture(chain.robot, joint_values(chain.robot, chain.joints, o.position), chain.gravity);
    ++rows;
    all += o.torque.squaredNorm();
    for (Eigen::Index j = 0; j < count; ++j) {
      const double gravity = posture.torque[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
      held[j] += std::pow(o.torque[j] + gravity, 2);
      pulled[j] += std::pow(o.torque[j] - gravity, 2);
    }
  }
  if (measured) *measured = rows > 0 ? all / rows : 0;
  return rows > 0 ? held.cwiseMin(pulled).sum() / rows : 0;
}

/// The two senses of an axis leave the same, as a driver may count either way: the one is reported that is usual.
std::vector<Blunder> gravity_by_torques(const Session& session) {
  constexpr std::size_t fewest = 8;
  constexpr double most_left = 0.25, least_left = 0.3, least_torque = 1;  // shares, N m
  const auto with_torques = std::count_if(session.observations.begin(), session.observations.end(),
                                          [](const Observation& o) { return o.torque.size() > 0; });
  if (static_cast<std::size_t>(with_torques) < fewest || session.robot.is_of_poses) return {};
  Chain chain = make_chain(session);
  double measured = 0;
  const double left = torques_left(session, chain, &measured);
  if (measured < least_torque * least_torque || left < least_left * measured) return {};
  std::string best;
  double least = most_left * left;
  for (const std::string& where : other_directions(session)) {
    Session other = session;
    find_blunder_kind("gravity_turned")->mend(where, other);
    chain.gravity = other.gravity;
    if (const double now = torques_left(session, chain); now < 0.999 * least) least = now, best = where;
  }
  if (best.empty()) return {};
  return {reported("gravity_turned", best, session)};
}

}  // namespace

std::vector<Blunder> blunders_in_files(const Session& session) {
  for (const auto& look : {exchanged_sizes, mirrored_tags, gravity_by_torques})
    if (std::vector<Blunder> found = look(session); !found.empty()) return found;
  return {};
}

}  // namespace handsight
