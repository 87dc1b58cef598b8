// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth edges where the processor draws: the mean of pictures that are each moved by another part of a pixel, made one
// by one while nothing moves, so that none keeps the window waiting for longer than a picture takes.
#pragma once

#include <QImage>
#include <QPointF>
#include <vector>

namespace handsight::widgets {

class SmoothPicture {
 public:
  static constexpr std::size_t pictures = 8;

  void begin_anew();
  bool is_done() const { return taken_ == pictures; }
  /// By how much the next picture is to be moved, px, each within half a pixel of the middle. Not when it is done.
  QPointF next_offset() const;
  /// A picture in RGB32; one of another size begins anew.
  void add(const QImage& picture);
  /// The mean of those taken so far; null before the first.
  QImage mean() const;

 private:
  QSize size_;
  std::size_t taken_ = 0;
  std::vector<std::uint16_t> sums_;  // red, green, blue of each pixel
};

}  // namespace handsight::widgets
