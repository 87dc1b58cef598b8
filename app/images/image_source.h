// SPDX-License-Identifier: GPL-3.0-or-later
// The images of a session, read through Qt, with the last ones kept.
#pragma once

#include <QCache>
#include <QImage>
#include <QString>
#include <filesystem>

#include "session/session.h"
#include "vision/image.h"

namespace handsight::app {

/// An image for the screen, or the sentence why there is none.
struct ShownImage {
  QImage image;
  QString refusal;
};

/// Reads an image file as it is stored (not turned by what its EXIF block says). `name` is what the sentence calls it;
/// the size must be that of the camera. Safe in any thread.
ShownImage read_shown_image(const std::filesystem::path& file, const std::string& name, const Camera& camera);

/// Grey as the engine wants it: colours by thesis (4.1), 16 bit scaled to 8.
Image grey_image(const QImage& image);

/// Images of the session at hand; for the window's thread.
class ImageSource {
 public:
  ImageSource() : cache_(96 * 1024) {}
  /// A camera's image of an observation, from memory where it was shown before; nothing where there is none.
  ShownImage image(const Session& session, const Observation& observation, int camera);
  void clear() { cache_.clear(); }

 private:
  QCache<QString, QImage> cache_;  // cost in KiB
};

}  // namespace handsight::app
