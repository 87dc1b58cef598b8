// SPDX-License-Identifier: GPL-3.0-or-later
// The images of a session, read through Qt, with the last ones kept.
#pragma once

#include <QCache>
#include <QHash>
#include <QImage>
#include <QObject>
#include <QString>
#include <QThreadPool>
#include <filesystem>
#include <memory>

#include "session/session.h"
#include "vision/image/image.h"

namespace handsight::app {

/// An image for the screen, or the sentence why there is none.
struct ShownImage {
  QImage image;
  QString refusal;
  bool is_coming = false;  // it is being read: `ImageSource::arrived` says when to ask again
};

/// Reads an image file as it is stored (not turned by what its EXIF block says). `name` is what the sentence calls it;
/// the size must be that of the camera. Safe in any thread.
ShownImage read_shown_image(const std::filesystem::path& file, const std::string& name, const Camera& camera);

/// Grey as the engine wants it: colours by thesis (4.1), 16 bit scaled to 8.
Image grey_image(const QImage& image);

/// Images of the session at hand; for the window's thread, which never waits long for a disk: files are read in
/// another.
class ImageSource : public QObject {
  Q_OBJECT

 public:
  explicit ImageSource(QObject* parent = nullptr);
  ~ImageSource() override;
  /// A camera's image of an observation, from memory where it was shown before; nothing where there is none. What takes
  /// longer than a moment to read is coming.
  ShownImage image(const Session& session, const Observation& observation, int camera);
  /// The same, however long it takes: for pictures on paper.
  ShownImage image_now(const Session& session, const Observation& observation, int camera);
  bool is_busy() const { return !reading_.isEmpty(); }
  void clear();

 signals:
  /// An image that was coming is there.
  void arrived();

 private:
  struct Reading;
  void keep(const QString& key, const ShownImage& shown);
  ShownImage read(const Session& session, const Observation& observation, int camera, int patience_ms);

  QCache<QString, QImage> cache_;                     // cost in KiB
  QHash<QString, ShownImage> late_;                   // came after they were asked for, and were not fetched yet
  QHash<QString, std::shared_ptr<Reading>> reading_;  // by file
  QThreadPool pool_;
};

}  // namespace handsight::app
