// SPDX-License-Identifier: GPL-3.0-or-later
#include "images/image_source.h"

#include <QBuffer>
#include <QImageReader>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <opencv2/imgproc.hpp>

#include "base/error.h"
#include "base/files.h"
#include "vision/image/image_file.h"
#include "words/core_words.h"

namespace handsight::app {

ShownImage read_shown_image(const std::filesystem::path& file, const std::string& name, const Camera& camera) {
  const QString shown = QString::fromStdString(name);
  if (!std::filesystem::exists(file))
    return {{}, QObject::tr("%1 is not there. Put it back, or leave the observation out.").arg(shown)};
  std::string content;
  try {
    content = read_file(file);
  } catch (const InputError& error) {
    return {{}, translated_error(error)};
  }
  if (is_cut_off(content))
    return {
        {},
        QObject::tr("%1 is cut off after %2 bytes. Copy it again from where it came.").arg(shown).arg(content.size())};
  QByteArray bytes = QByteArray::fromRawData(content.data(), static_cast<qsizetype>(content.size()));
  QBuffer buffer(&bytes);
  QImageReader reader(&buffer);
  reader.setAutoTransform(false);
  reader.setDecideFormatFromContent(true);
  const QSize size = reader.size();
  if (size.isValid() && (size.width() != camera.width || size.height() != camera.height))
    return {{},
            QObject::tr("%1 is %2 x %3, the camera says %4 x %5. Use the images that the camera was calibrated with.")
                .arg(shown)
                .arg(size.width())
                .arg(size.height())
                .arg(camera.width)
                .arg(camera.height)};
  QImage image = reader.read();
  if (image.isNull())
    return {{},
            QObject::tr("%1 cannot be read as an image (%2). Copy it again from where it came.")
                .arg(shown, reader.errorString())};
  return {image, {}};
}

Image grey_image(const QImage& image) {
  const auto copy_rows = [](const cv::Mat& grey) {
    Image result(grey.cols, grey.rows);
    for (int v = 0; v < grey.rows; ++v) std::memcpy(result.row(v), grey.ptr(v), static_cast<std::size_t>(grey.cols));
    return result;
  };
  const auto mat_of = [](const QImage& i, int type) {
    return cv::Mat(i.height(), i.width(), type, const_cast<uchar*>(i.constBits()),
                   static_cast<std::size_t>(i.bytesPerLine()));
  };
  if (image.format() == QImage::Format_Grayscale8) return copy_rows(mat_of(image, CV_8UC1));
  if (image.format() == QImage::Format_Grayscale16) {
    cv::Mat eight;
    mat_of(image, CV_16UC1).convertTo(eight, CV_8U, 1.0 / 257);
    return copy_rows(eight);
  }
  if (image.isGrayscale()) return copy_rows(mat_of(image.convertToFormat(QImage::Format_Grayscale8), CV_8UC1));
  const QImage colours = image.convertToFormat(QImage::Format_BGR888);
  cv::Mat grey;
  cv::cvtColor(mat_of(colours, CV_8UC3), grey, cv::COLOR_BGR2GRAY);
  return copy_rows(grey);
}

/// A file that is being read; shared by the window's thread and the reader's.
struct ImageSource::Reading {
  std::mutex mutex;
  std::condition_variable changed;
  bool is_done = false;
  ShownImage shown;
};

namespace {

constexpr int moment_ms = 30;  // what nobody notices
constexpr int as_long_as_it_takes = -1;

}  // namespace

ImageSource::ImageSource(QObject* parent) : QObject(parent), cache_(96 * 1024) { pool_.setMaxThreadCount(1); }

ImageSource::~ImageSource() {
  pool_.clear();
  pool_.waitForDone();
}

void ImageSource::clear() {
  pool_.clear();
  cache_.clear();
  late_.clear();
  reading_.clear();
}

void ImageSource::keep(const QString& key, const ShownImage& shown) {
  if (shown.image.isNull()) return;
  cache_.insert(key, new QImage(shown.image), std::max<qsizetype>(1, shown.image.sizeInBytes() / 1024));
}

ShownImage ImageSource::image(const Session& session, const Observation& observation, int camera) {
  return read(session, observation, camera, moment_ms);
}

ShownImage ImageSource::image_now(const Session& session, const Observation& observation, int camera) {
  return read(session, observation, camera, as_long_as_it_takes);
}

ShownImage ImageSource::read(const Session& session, const Observation& observation, int camera, int patience_ms) {
  if (!session.rig || camera >= session.rig->count()) return {};
  const std::string& name = observation.images[static_cast<std::size_t>(camera)];
  if (name.empty()) return {};
  const std::filesystem::path file = folder(session) / name;
  const QString key = QString::fromStdString(file.string());
  if (const QImage* known = cache_.object(key)) {
    late_.remove(key);
    return {*known, {}};
  }
  if (late_.contains(key)) return late_.take(key);
  std::shared_ptr<Reading>& reading = reading_[key];
  const bool is_new = !reading;
  if (is_new) {
    reading = std::make_shared<Reading>();
    pool_.start([this, file, name, key, reading, lens = session.rig->at(camera).camera] {
      ShownImage shown = read_shown_image(file, name, lens);
      {
        const std::lock_guard lock(reading->mutex);
        reading->shown = std::move(shown);
        reading->is_done = true;
      }
      reading->changed.notify_all();
      QMetaObject::invokeMethod(this, [this, key, reading] {
        if (reading_.value(key) != reading) return;  // fetched in time, or another session is open
        reading_.remove(key);
        keep(key, reading->shown);
        late_.insert(key, reading->shown);
        emit arrived();
      });
    });
  }
  const std::shared_ptr<Reading> wanted = reading;
  std::unique_lock lock(wanted->mutex);
  const auto is_done = [&] { return wanted->is_done; };
  if (patience_ms < 0)
    wanted->changed.wait(lock, is_done);
  else if (is_new)
    wanted->changed.wait_for(lock, std::chrono::milliseconds(patience_ms), is_done);
  if (!wanted->is_done) return {.is_coming = true};
  ShownImage shown = wanted->shown;
  reading_.remove(key);
  keep(key, shown);
  return shown;
}

}  // namespace handsight::app
