// SPDX-License-Identifier: GPL-3.0-or-later
#include "images/image_source.h"

#include <QBuffer>
#include <QImageReader>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "base/error.h"
#include "base/files.h"
#include "vision/image_file.h"

namespace handsight::app {

ShownImage read_shown_image(const std::filesystem::path& file, const std::string& name, const Camera& camera) {
  const QString shown = QString::fromStdString(name);
  if (!std::filesystem::exists(file))
    return {{}, QObject::tr("%1 is not there. Put it back, or leave the observation out.").arg(shown)};
  std::string content;
  try {
    content = read_file(file);
  } catch (const InputError& error) {
    return {{}, QString::fromUtf8(error.what())};
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

ShownImage ImageSource::image(const Session& session, const Observation& observation, bool left) {
  const std::string& name = left ? observation.images[0] : observation.images[1];
  if (name.empty() || !session.rig || !is_pair(*session.rig)) return {};
  const std::filesystem::path file = folder(session) / name;
  const QString key = QString::fromStdString(file.string());
  if (const QImage* known = cache_.object(key)) return {*known, {}};
  ShownImage shown = read_shown_image(file, name, left ? session.rig->at(0).camera : session.rig->at(1).camera);
  if (!shown.image.isNull())
    cache_.insert(key, new QImage(shown.image), std::max<qsizetype>(1, shown.image.sizeInBytes() / 1024));
  return shown;
}

}  // namespace handsight::app
