// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/smooth_picture.h"

namespace handsight::widgets {
namespace {

/// Sixteenths of a pixel: no two in a row or a column, as graphics cards place eight samples.
constexpr int offsets[SmoothPicture::pictures][2] = {{1, -3}, {-1, 3},  {5, 1}, {-3, -5},
                                                     {-5, 5}, {-7, -1}, {3, 7}, {7, -7}};

}  // namespace

void SmoothPicture::begin_anew() {
  taken_ = 0;
  sums_.clear();
}

QPointF SmoothPicture::next_offset() const { return QPointF(offsets[taken_][0], offsets[taken_][1]) / 16; }

void SmoothPicture::add(const QImage& picture) {
  if (picture.size() != size_) begin_anew();
  size_ = picture.size();
  const auto width = static_cast<std::size_t>(size_.width());
  sums_.resize(3 * width * static_cast<std::size_t>(size_.height()));
  for (int v = 0; v < size_.height(); ++v) {
    const auto* row = reinterpret_cast<const QRgb*>(picture.constScanLine(v));
    std::uint16_t* sum = sums_.data() + 3 * width * static_cast<std::size_t>(v);
    for (std::size_t u = 0; u < width; ++u, sum += 3) {
      sum[0] = static_cast<std::uint16_t>(sum[0] + qRed(row[u]));
      sum[1] = static_cast<std::uint16_t>(sum[1] + qGreen(row[u]));
      sum[2] = static_cast<std::uint16_t>(sum[2] + qBlue(row[u]));
    }
  }
  ++taken_;
}

QImage SmoothPicture::mean() const {
  if (taken_ == 0) return {};
  QImage mean(size_, QImage::Format_RGB32);
  const auto width = static_cast<std::size_t>(size_.width());
  const auto of = [this](std::uint16_t sum) { return static_cast<int>((sum + taken_ / 2) / taken_); };
  for (int v = 0; v < size_.height(); ++v) {
    auto* row = reinterpret_cast<QRgb*>(mean.scanLine(v));
    const std::uint16_t* sum = sums_.data() + 3 * width * static_cast<std::size_t>(v);
    for (std::size_t u = 0; u < width; ++u, sum += 3) row[u] = qRgb(of(sum[0]), of(sum[1]), of(sum[2]));
  }
  return mean;
}

}  // namespace handsight::widgets
