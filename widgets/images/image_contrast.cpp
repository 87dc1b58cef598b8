// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/images/image_contrast.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handsight::widgets {
namespace {

/// The levels below and above which half a percent of the pixels lie.
std::pair<int, int> used_levels(const QImage& grey) {
  std::array<qint64, 256> counts{};
  for (int y = 0; y < grey.height(); ++y)
    for (int x = 0; x < grey.width(); ++x) ++counts[grey.constScanLine(y)[x]];
  const qint64 few = static_cast<qint64>(grey.width()) * grey.height() / 200;
  int low = 0, high = 255;
  for (qint64 sum = counts[0]; sum <= few && low < 254; sum += counts[static_cast<std::size_t>(++low)]) {
  }
  for (qint64 sum = counts[255]; sum <= few && high > low + 1; sum += counts[static_cast<std::size_t>(--high)]) {
  }
  return {low, high};
}

}  // namespace

QImage with_stretched_contrast(const QImage& image) {
  if (image.isNull()) return image;
  const auto [low, high] = used_levels(image.convertToFormat(QImage::Format_Grayscale8));
  constexpr int nearly_all = 200;
  if (high - low >= nearly_all) return image;
  const double scale = 255.0 / (high - low);
  QImage stretched = image.convertToFormat(QImage::Format_RGB32);
  for (int y = 0; y < stretched.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(stretched.scanLine(y));
    for (int x = 0; x < stretched.width(); ++x) {
      const auto spread = [&, low = low](int level) {
        return std::clamp(static_cast<int>(std::lround((level - low) * scale)), 0, 255);
      };
      line[x] = qRgb(spread(qRed(line[x])), spread(qGreen(line[x])), spread(qBlue(line[x])));
    }
  }
  return stretched;
}

}  // namespace handsight::widgets
