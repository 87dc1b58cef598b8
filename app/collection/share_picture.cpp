// SPDX-License-Identifier: GPL-3.0-or-later
#include "collection/share_picture.h"

#include <QPainter>

#include "widgets/base/theme.h"

namespace handsight::app {
namespace {

constexpr int wide = 92, high = 44;  // px

void draw_robot(QPainter& p, const QPointF& at) {
  const QPolygonF arm{at + QPointF(-14, 16), at + QPointF(-10, -4), at + QPointF(4, -12), at + QPointF(14, -2)};
  p.drawPolyline(arm);
  p.drawLine(at + QPointF(-20, 17), at + QPointF(-8, 17));
  for (const QPointF& joint : {arm[1], arm[2]}) p.drawEllipse(joint, 2.5, 2.5);
}

void draw_camera(QPainter& p, const QPointF& at) {
  p.drawRoundedRect(QRectF(at.x() - 13, at.y() - 8, 18, 16), 2, 2);
  p.drawPolygon(QPolygonF{at + QPointF(5, -3), at + QPointF(13, -8), at + QPointF(13, 8), at + QPointF(5, 3)});
}

void draw_hand(QPainter& p, const QPointF& at) {
  p.drawRoundedRect(QRectF(at.x() - 15, at.y() - 4, 14, 8), 2, 2);
  p.drawPolyline(QPolygonF{at + QPointF(11, -11), at + QPointF(-1, -11), at + QPointF(-1, 11), at + QPointF(11, 11)});
  for (const QPointF& marker : {QPointF(13, -11), QPointF(13, 11), QPointF(4, 0)}) {
    p.drawLine(at + marker - QPointF(3, 0), at + marker + QPointF(3, 0));
    p.drawLine(at + marker - QPointF(0, 3), at + marker + QPointF(0, 3));
  }
}

}  // namespace

SharePicture::SharePicture(What what, QWidget* parent) : QWidget(parent), what_(what) { setFixedSize(wide, high); }

void SharePicture::set_shared(bool is_shared) {
  is_shared_ = is_shared;
  update();
}

void SharePicture::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.setBrush(Qt::NoBrush);
  const auto draw = [&](const QPointF& at) {
    what_ == What::robot ? draw_robot(p, at) : what_ == What::rig ? draw_camera(p, at) : draw_hand(p, at);
  };
  const QPointF middle(wide / 2.0, high / 2.0);
  p.setPen(QPen(widgets::colors().ink1, 1.5));
  if (is_shared_) return draw(middle);
  draw(middle - QPointF(23, 0));
  p.setPen(QPen(widgets::colors().ink2, 1.5, Qt::DotLine));
  draw(middle + QPointF(23, 0));
}

}  // namespace handsight::app
