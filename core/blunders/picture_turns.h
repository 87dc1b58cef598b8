// SPDX-License-Identifier: Apache-2.0
// Images that are mirrored or turned against how their camera was calibrated, and back.
#pragma once

#include <string>

#include "session/session.h"
#include "vision/image/image.h"

namespace handsight {

/// What was done to the images.
enum class PictureTurn { mirrored, flipped, half, quarter_right, quarter_left };

/// The camera as it was calibrated: width and height exchanged where its principal point says so.
Camera upright(const Camera& camera);

/// Where a point of a mirrored or turned image belongs in the image as it was taken by `camera`, with its sigmas.
CameraPoint turned_back(const CameraPoint& point, PictureTurn turn, const Camera& camera);

/// The image as it was taken.
Image turned_back(const Image& image, PictureTurn turn);

/// "image_mirrored" and "image_turned": which cameras' images and how, by the place; camera -1: all of them. InputError
/// where the session has no such camera.
struct PicturesAt {
  int camera = -1;
  PictureTurn turn = PictureTurn::half;
};
PicturesAt pictures_at(const std::string& id, const std::string& where, const Session& session);

/// Their places: "" (all cameras), "vertical" or "90" and "270"; of more than one camera "left", "left=vertical" ...
/// too.
std::vector<std::string> picture_places(const std::string& id, const Session& session);

/// Puts the sightings right, and the cameras' sizes where they are those of turned images.
void turn_back(const PicturesAt& at, Session& session);

}  // namespace handsight
