// SPDX-License-Identifier: GPL-3.0-or-later
// A loupe: a small part of an image, magnified, with its pixel grid.
#pragma once

#include <QImage>
#include <QWidget>
#include <optional>

#include "geometry/rigid.h"

namespace handsight::widgets {

/// 8 x with the pixel grid and one middle cell, key hints written in it; below, the patch minus its half-turn about
/// the centre, which is flat for a good X-corner.
class Loupe : public QWidget {
  Q_OBJECT
 public:
  explicit Loupe(QWidget* parent = nullptr);
  void set_title(const QString& title);
  void set_hints(const QString& hints);  // "arrows 0.1 px, Shift 1, Alt free"
  void set_image(const QImage& image);
  void set_center(std::optional<Vector2> px);  // nothing: empty
  void set_mark(std::optional<Vector2> px);    // a cross at a marker's place
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString title_, hints_;
  QImage image_;
  std::optional<Vector2> center_, mark_;
};

/// Paints the part of an image round `center` (px) into `target`, `times` larger, with grid and middle cell.
void paint_loupe(QPainter& painter, const QRectF& target, const QImage& image, const Vector2& center, double times);

/// The patch of `radius` px minus its half-turn about `center`, grey 128 where they agree; bilinear.
QImage half_turn_difference(const QImage& image, const Vector2& center, int radius);

}  // namespace handsight::widgets
