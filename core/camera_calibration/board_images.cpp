// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/board_images.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "targets/target_detection.h"
#include "targets/target_guess.h"
#include "vision/image/image_file.h"

namespace handsight {
namespace {

/// The points of one image by piece: those of a piece are one body.
void add_points(BoardImages& board, const PreparedTarget& target, const TargetSighting& sighting, int camera,
                int moment, int pieces) {
  std::vector<BoardImage> images(static_cast<std::size_t>(pieces));
  for (const TargetPixel& seen : sighting.points)
    images[static_cast<std::size_t>(target.points[static_cast<std::size_t>(seen.number)].piece)].points.push_back(seen);
  for (int piece = 0; piece < pieces; ++piece) {
    BoardImage& image = images[static_cast<std::size_t>(piece)];
    if (image.points.empty()) continue;
    image.camera = camera;
    image.frame = moment * pieces + piece;
    board.images.push_back(std::move(image));
  }
}

}  // namespace

DetectedImages detect_in_images(const GroupedImages& grouped, const Target& target,
                                const std::function<void(std::size_t)>& progress) {
  // Cameras are calibrated with what is flat: a grid of tags is one board, other tags are each one of their own.
  const PreparedTarget prepared =
      prepare(is_tag_grid(target) && are_places_exact(target) ? target : without_places(target));
  const int pieces = prepared.points.back().piece + 1;
  DetectedImages result;
  for (const TargetPoint& point : prepared.points) {
    result.board.points.push_back(point.position);
    result.board.pieces.push_back(point.piece);
  }
  result.board.sigma = print_sigma(target);
  result.board.camera_count = static_cast<int>(grouped.cameras.size());
  result.board.frame_count = static_cast<int>(grouped.frames.size()) * pieces;
  for (std::size_t c = 0; c < grouped.cameras.size(); ++c) {
    const CameraImages& camera = grouped.cameras[c];
    result.names.push_back(camera.name);
    result.sizes.emplace_back(0, 0);
    for (std::size_t i = 0; i < camera.files.size(); ++i) {
      const Image image = read_image(camera.files[i]);
      auto& size = result.sizes.back();
      if (i == 0) size = {image.width, image.height};
      if (size != std::pair{image.width, image.height})
        throw InputError(message(
            "{}: the image has {} x {} px, the first of camera {} has {} x {}; expected images of one size.",
            shown_path(camera.files[i]), image.width, image.height, shortened(camera.name), size.first, size.second));
      const auto frame =
          std::find(grouped.frames.begin(), grouped.frames.end(), camera.keys[i]) - grouped.frames.begin();
      const TargetSighting sighting = detect_target(image, prepared);
      add_points(result.board, prepared, sighting, static_cast<int>(c), static_cast<int>(frame), pieces);
      result.images.push_back({static_cast<int>(c), static_cast<int>(frame), camera.files[i],
                               static_cast<int>(sighting.points.size()), sighting.dropped_points, sighting.reason,
                               sighting.repeated});
      if (progress) progress(result.images.size());
    }
  }
  return result;
}

Message shown_in_its_place(const DetectedImages& detected, const Target& target) {
  constexpr std::size_t most = 4;
  std::vector<const ReadImage*> without;
  for (const ReadImage& image : detected.images)
    if (image.points == 0) without.push_back(&image);
  if (without.empty() || 3 * without.size() <= 2 * detected.images.size()) return {};
  std::vector<Image> images;
  const std::size_t step = std::max<std::size_t>(1, without.size() / most);
  for (std::size_t i = 0; i < without.size() && images.size() < most; i += step)
    images.push_back(read_image(without[i]->file));
  return guess_target(images, target, TargetWording::options).text;
}

}  // namespace handsight
