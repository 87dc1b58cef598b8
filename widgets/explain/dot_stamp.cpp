// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/dot_stamp.h"

#include <algorithm>
#include <cmath>

namespace handsight::widgets {
namespace {

/// Every channel times by / 255, rounded; two channels at a time.
std::uint32_t scaled(std::uint32_t pixel, std::uint32_t by) {
  const auto half = [by](std::uint32_t two) {
    const std::uint32_t product = (two & 0x00FF00FF) * by + 0x00800080;
    return (product + (product >> 8 & 0x00FF00FF)) >> 8 & 0x00FF00FF;
  };
  return half(pixel) | half(pixel >> 8) << 8;
}

}  // namespace

DotStamp::DotStamp(const QColor& color, double diameter) : side_(static_cast<int>(std::ceil(diameter)) + 2) {
  const double radius = diameter / 2;
  for (int part = 0; part < part_count * part_count; ++part) {
    std::vector<std::uint32_t>& mask = masks_[static_cast<std::size_t>(part)];
    mask.resize(static_cast<std::size_t>(side_ * side_));
    const int column = part % part_count, row = part / part_count;
    const double middle_x = side_ / 2.0 + (column + 0.5) / part_count - 0.5;
    const double middle_y = side_ / 2.0 + (row + 0.5) / part_count - 0.5;
    for (int y = 0; y < side_; ++y)
      for (int x = 0; x < side_; ++x) {
        const double away = std::hypot(x + 0.5 - middle_x, y + 0.5 - middle_y);
        const double cover = std::clamp(radius + 0.5 - away, 0.0, 1.0) * color.alphaF();
        const auto channel = [cover](int value) { return static_cast<std::uint32_t>(std::lround(value * cover)); };
        mask[static_cast<std::size_t>(y * side_ + x)] = static_cast<std::uint32_t>(std::lround(255 * cover)) << 24 |
                                                        channel(color.red()) << 16 | channel(color.green()) << 8 |
                                                        channel(color.blue());
      }
  }
}

void DotStamp::put(QImage& image, double x, double y) const {
  if (!(std::abs(x) < 1e6 && std::abs(y) < 1e6)) return;
  const double left = x - side_ / 2.0 + 0.5, top = y - side_ / 2.0 + 0.5;
  const int column = static_cast<int>(std::floor(left)), row = static_cast<int>(std::floor(top));
  const int part_x = std::min(static_cast<int>((left - column) * part_count), part_count - 1);
  const int part_y = std::min(static_cast<int>((top - row) * part_count), part_count - 1);
  const std::vector<std::uint32_t>& mask = masks_[static_cast<std::size_t>(part_y * part_count + part_x)];
  const int first_x = std::max(0, -column), last_x = std::min(side_, image.width() - column);
  const int first_y = std::max(0, -row), last_y = std::min(side_, image.height() - row);
  uchar* const pixels = image.bits();
  const qsizetype stride = image.bytesPerLine();
  for (int j = first_y; j < last_y; ++j) {
    auto* line = reinterpret_cast<std::uint32_t*>(pixels + (row + j) * stride) + column;
    const std::uint32_t* from = mask.data() + j * side_;
    for (int i = first_x; i < last_x; ++i) {
      const std::uint32_t alpha = from[i] >> 24;
      if (alpha == 255)
        line[i] = from[i];
      else if (alpha > 0)
        line[i] = from[i] + scaled(line[i], 255 - alpha);
    }
  }
}

std::vector<DotStamp> residual_stamps(double diameter, int alpha) {
  std::vector<DotStamp> stamps;
  for (QColor color : colors().residual) {
    color.setAlpha(alpha);
    stamps.emplace_back(color, diameter);
  }
  return stamps;
}

QImage dot_canvas(const QSizeF& size, double device_pixel_ratio) {
  QImage image(static_cast<int>(std::ceil(size.width() * device_pixel_ratio)),
               static_cast<int>(std::ceil(size.height() * device_pixel_ratio)), QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(device_pixel_ratio);
  image.fill(Qt::transparent);
  return image;
}

}  // namespace handsight::widgets
