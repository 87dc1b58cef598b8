// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/board_knowledge.h"

#include <Eigen/Dense>
#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "camera_calibration/bundle.h"
#include "camera_calibration/camera_calibration.h"
#include "camera_calibration/held_out.h"

namespace handsight {
namespace {

void require_same_cameras(const DetectedImages& images, const Rig& rig) {
  for (int c = 0; c < rig.count(); ++c) {
    const auto [width, height] = images.sizes[static_cast<std::size_t>(c)];
    const Camera& camera = rig.at(c).camera;
    if (width != camera.width || height != camera.height)
      throw InputError(
          message("The images of camera {} are {} x {} px, and camera {} of the session has {} x {}: they are "
                  "another camera's, or were scaled; name images of the session's cameras.",
                  in_quotes(images.names[static_cast<std::size_t>(c)]), width, height, in_quotes(rig.at(c).name),
                  camera.width, camera.height));
    if (camera.skew != 0)
      throw InputError(
          message("Camera {} of the session has the skew {:g}, which a calibration by images does not know; set it "
                  "to 0.",
                  in_quotes(rig.at(c).name), camera.skew));
  }
}

BundleResult make_start(const BoardImages& images, const Rig& rig) {
  BundleResult start;
  for (const RigCamera& c : rig.cameras) {
    start.rig.lenses.push_back(make_lens(c.camera));
    start.rig.from_first.push_back(c.camera_from_first);
  }
  start.rig.from_first[0] = Rigid{};
  for (int frame = 0; frame < images.frame_count; ++frame)
    start.first_from_target.push_back(pose_of_frame(images, start.rig, frame));
  return start;
}

/// The bundle with the target bent, or of other points than described, where the images say so beyond doubt.
BundleResult with_the_boards_shape(const BoardImages& images, const BundleResult& flat) {
  if (!flat.covariance) return flat;
  std::vector<FittedModel> candidates;
  const FittedModel described{flat, held_out(images, flat)};
  for (const BoardShape shape : list_shapes(images)) candidates.push_back(reshaped(images, described, shape));
  const FittedModel* best = preferred(candidates);
  return best && best->bundle.covariance ? best->bundle : flat;
}

/// The session's rig with what the images say in it.
Rig rig_with(const Rig& session, const CameraRig& found) {
  Rig rig = session;
  for (int c = 0; c < rig.count(); ++c) {
    const auto i = static_cast<std::size_t>(c);
    const Camera reported = look_up_camera(found.lenses[i]).value();
    for (const CameraNumber& number : camera_numbers(reported)) rig.at(c).camera.*number.value = reported.*number.value;
    if (c > 0) rig.at(c).camera_from_first = found.from_first[i];
  }
  return rig;
}

/// Where the numbers of the bundle's covariance stand in the rig's; -1: not there, it stays as the session has it.
/// `off`: what the session has less what the images say, of those.
void place_numbers(const Rig& session, const CameraRig& found, std::vector<int>& places, std::vector<double>& off) {
  for (int c = 0; c < session.count(); ++c) {
    const Lens& lens = found.lenses[static_cast<std::size_t>(c)];
    const Lens kept = make_lens(session.at(c).camera);
    const auto numbers = camera_numbers(session.at(c).camera);
    for (std::size_t k = 0; k < lens.numbers.size(); ++k) {
      const auto there = std::find_if(numbers.begin(), numbers.end(),
                                      [&](const auto& n) { return lens.model->numbers[k].name == n.name; });
      const bool moves = there != numbers.end();
      places.push_back(moves ? first_number(session.count(), c) + static_cast<int>(there - numbers.begin()) : -1);
      off.push_back(moves ? 0 : kept.numbers[k] - lens.numbers[k]);
    }
  }
  for (int c = 1; c < session.count(); ++c)
    for (int i = 0; i < 6; ++i) {
      places.push_back(motion_number(c) + i);
      off.push_back(0);
    }
}

/// Each number in units of its sigma before it is inverted.
Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * covariance * scale.asDiagonal();
  return scale.asDiagonal() * scaled.inverse() * scale.asDiagonal();
}

}  // namespace

GroupedImages group_by_cameras(const GroupedImages& grouped, const Rig& rig) {
  if (static_cast<int>(grouped.cameras.size()) != rig.count()) {
    std::vector<std::string> names;
    for (const CameraImages& camera : grouped.cameras) names.push_back(camera.name);
    throw InputError(message(
        "There are board images of {} {} ({}), and the session has {} ({}): name a folder for each of its cameras.",
        names.size(), names.size() == 1 ? "camera" : "cameras",
        shortened(fmt::format("{}", fmt::join(names, ", ")), 200), rig.count(), listed_names(rig)));
  }
  GroupedImages ordered = grouped;
  std::size_t found = 0;
  for (int c = 0; c < rig.count(); ++c)
    for (const CameraImages& camera : grouped.cameras)
      if (camera.name == rig.at(c).name) {
        ordered.cameras[static_cast<std::size_t>(c)] = camera;
        ++found;
      }
  if (found == grouped.cameras.size()) return ordered;
  ordered = grouped;
  for (int c = 0; rig.count() > 1 && c < rig.count(); ++c)
    ordered.notes.push_back(message("the images of {} are taken for those of camera {}",
                                    in_quotes(grouped.cameras[static_cast<std::size_t>(c)].name),
                                    in_quotes(rig.at(c).name)));
  return ordered;
}

CameraKnowledge board_knowledge(const DetectedImages& detected, const Rig& session) {
  require_same_cameras(detected, session);
  const BundleResult start = make_start(detected.board, session);
  const BundleResult flat = adjust_robustly(detected.board, adjust_robustly(detected.board, start, false), true);
  if (flat.points == 0)
    throw InputError("The target is found in none of the board images; look at one and at what --target says of it.");
  const BundleResult bundle = with_the_boards_shape(detected.board, flat);
  if (!bundle.covariance)
    throw InputError(
        "These board images do not determine the cameras' numbers; take 10 to 20 of each camera, tilted to all sides, "
        "and "
        "of several cameras at the same moments.");
  std::vector<int> places;
  std::vector<double> off;
  place_numbers(session, bundle.rig, places, off);
  const Eigen::MatrixXd information = inverse_of(*bundle.covariance);
  CameraKnowledge k;
  k.rig = rig_with(session, bundle.rig);
  const int count = rig_number_count(session.count());
  k.information = Eigen::MatrixXd::Zero(count, count);
  k.pull = Eigen::VectorXd::Zero(count);
  const Eigen::VectorXd offsets = Eigen::Map<const Eigen::VectorXd>(off.data(), static_cast<Eigen::Index>(off.size()));
  const Eigen::VectorXd pulled = information * offsets;
  k.residual = offsets.dot(pulled);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] < 0) continue;
    ++k.numbers;
    k.pull[places[i]] += pulled[static_cast<Eigen::Index>(i)];
    for (std::size_t j = 0; j < places.size(); ++j)
      if (places[j] >= 0)
        k.information(places[i], places[j]) += information(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
  for (const BoardImage& image : detected.board.images)
    k.images += !image.points.empty() && bundle.first_from_target[static_cast<std::size_t>(image.frame)].has_value();
  k.points = bundle.points;
  k.rms_pixel = bundle.rms_pixel;
  return k;
}

}  // namespace handsight
