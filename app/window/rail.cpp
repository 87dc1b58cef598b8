// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/rail.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>

#include "widgets/base/icons.h"
#include "widgets/base/theme.h"
#include "window/rail_button.h"

namespace handsight::app {

using widgets::colors;
using widgets::TextRole;

RailButton::RailButton(const QString& name, const QString& icon, const QString& tip, QWidget* parent)
    : QAbstractButton(parent), icon_(icon) {
  setText(name);
  setCheckable(true);
  setAutoExclusive(true);
  setFocusPolicy(Qt::TabFocus);
  setToolTip(tip);
  setAccessibleName(name);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
}

void RailButton::set_status(const WorkStatus& status) {
  if (status.state == status_.state && status.line == status_.line) return;
  status_ = status;
  setAccessibleDescription(status.line);
  update();
}

QSize RailButton::sizeHint() const { return {104, 86}; }

bool RailButton::event(QEvent* event) {
  if (event->type() == QEvent::HoverEnter || event->type() == QEvent::HoverLeave) update();
  return QAbstractButton::event(event);
}

void RailButton::paint_mark(QPainter& painter, const QRectF& area) const {
  const auto& c = colors();
  QPen pen(c.ink3, 1.5);
  switch (status_.state) {
    case WorkState::done: {
      painter.setPen(Qt::NoPen);
      painter.setBrush(c.good);
      painter.drawEllipse(area);
      painter.setPen(QPen(c.panel, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.setBrush(Qt::NoBrush);
      const QPointF o = area.topLeft();
      painter.drawPolyline(QPolygonF{o + QPointF(4.5, 8.5), o + QPointF(7.2, 11.2), o + QPointF(11.8, 5.4)});
      break;
    }
    case WorkState::open:
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(c.accent, 2));
      painter.drawEllipse(area.adjusted(1, 1, -1, -1));
      painter.setBrush(c.accent);
      painter.setPen(Qt::NoPen);
      painter.drawEllipse(area.adjusted(5, 5, -5, -5));
      break;
    case WorkState::care:
      painter.setPen(Qt::NoPen);
      painter.setBrush(c.care);
      painter.drawPolygon(QPolygonF{{area.center().x(), area.top()}, area.bottomRight(), area.bottomLeft()});
      painter.setPen(QPen(c.panel, 1.8, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(QPointF(area.center().x(), area.top() + 5.5), QPointF(area.center().x(), area.top() + 10));
      painter.drawPoint(QPointF(area.center().x(), area.top() + 13));
      break;
    case WorkState::waiting:
      pen.setDashPattern({2, 2});
      painter.setPen(pen);
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(area.adjusted(1, 1, -1, -1));
      break;
  }
}

void RailButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto& c = colors();
  const QRectF all = rect();
  if (isChecked()) {
    painter.fillRect(all, c.selected_row);
    painter.fillRect(QRectF(0, 0, 3, height()), c.accent);
  } else if (underMouse()) {
    painter.fillRect(all, c.sunken);
  }
  const bool is_low = height() < 80, is_lowest = height() < 70;  // two lines of state stay whole in each
  const double icon_y = is_lowest ? 1 : is_low ? 3 : 8, icon_size = is_lowest ? 16 : 22;
  const double name_y = is_lowest ? 15 : is_low ? 23 : 30, line_y = is_lowest ? 32 : is_low ? 41 : 50;
  widgets::draw_icon(painter, QRectF(9, icon_y, icon_size, icon_size), icon_, isChecked() ? c.accent : c.ink2);
  paint_mark(painter, QRectF(width() - 26, icon_y + (icon_size - 16) / 2, 16, 16));
  QFont font = widgets::text_font(TextRole::body);
  font.setWeight(isChecked() ? QFont::DemiBold : QFont::Normal);
  painter.setFont(font);
  painter.setPen(c.ink1);
  painter.drawText(QRectF(10, name_y, width() - 14, 20), Qt::AlignVCenter | Qt::AlignLeft, text());
  painter.setFont(widgets::text_font(TextRole::small));
  painter.setPen(c.ink2);
  painter.drawText(QRectF(10, line_y, width() - 14, height() - line_y - 1),
                   Qt::AlignTop | Qt::AlignLeft | Qt::TextWordWrap, status_.line);
  if (hasFocus()) {
    painter.setPen(QPen(c.accent, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(all.adjusted(2, 2, -2, -2));
  }
}

Rail::Rail(std::span<const WorkspaceKind> kinds, QWidget* parent) : QWidget(parent) {
  setObjectName("rail");
  setFixedWidth(104);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 8, 0, 8);
  layout->setSpacing(0);
  for (const WorkspaceKind& kind : kinds) {
    auto* button = new RailButton(kind.name(), kind.icon, kind.tool_tip(), this);
    button->setObjectName("rail_" + kind.id);
    button->setAttribute(Qt::WA_Hover);
    connect(button, &QAbstractButton::clicked, this, [this, place = kind.place] { emit chosen(place); });
    layout->addWidget(button);
    buttons_[kind.place] = button;
  }
  layout->addStretch();
  buttons_.begin()->second->setChecked(true);
}

void Rail::set_status(Place place, const WorkStatus& status) { buttons_.at(place)->set_status(status); }

void Rail::set_current(Place place) { buttons_.at(place)->setChecked(true); }

void Rail::set_none() {
  for (const auto& [place, button] : buttons_) {
    button->setAutoExclusive(false);  // while one of them must be checked, none can be unchecked
    button->setChecked(false);
    button->setAutoExclusive(true);
  }
}

}  // namespace handsight::app
