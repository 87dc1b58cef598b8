// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/paint_tools.h"

#include <QPainterPath>
#include <algorithm>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {

void draw_text(QPainter& painter, const QRectF& area, Qt::Alignment alignment, const QString& text) {
  const QFontMetricsF metrics(painter.font());
  painter.drawText(area, static_cast<int>(alignment) | Qt::TextSingleLine,
                   metrics.elidedText(text, Qt::ElideRight, area.width() + 0.5));
}

void draw_sentence(QPainter& painter, const QRectF& area, const QString& sentence) {
  painter.save();
  painter.setFont(text_font(TextRole::body));
  painter.setPen(colors().ink2);
  const double margin = std::min<double>(wide_gap, area.width() / 8);
  painter.drawText(area.adjusted(margin, 0, -margin, 0), Qt::AlignCenter | Qt::TextWordWrap, sentence);
  painter.restore();
}

void draw_rimmed_path(QPainter& painter, const QPainterPath& path, const QPen& pen) {
  const bool is_light = pen.color().lightnessF() > 0.55;
  QPen rim(is_light ? QColor(0, 0, 0, 190) : QColor(255, 255, 255, 210), pen.widthF() + 2);
  rim.setCapStyle(pen.capStyle());
  painter.setBrush(Qt::NoBrush);
  painter.setPen(rim);
  painter.drawPath(path);
  painter.setPen(pen);
  painter.drawPath(path);
}

QSizeF plate_size(const QPainter& painter, const QString& text) {
  const QFontMetricsF metrics(painter.font());
  return {std::max(metrics.horizontalAdvance(text) + 6, 14.0), metrics.height()};
}

QRectF draw_plate(QPainter& painter, const QPointF& position, const QString& text, const QColor& ink,
                  const QColor& ground) {
  const QSizeF size = plate_size(painter, text);
  const QRectF plate(QPointF(position.x(), position.y() - size.height() / 2), size);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawRoundedRect(plate, 3, 3);
  painter.setPen(ink);
  painter.drawText(plate, Qt::AlignCenter, text);
  return plate;
}

QBrush noise_hatching(const QColor& color) {
  QBrush brush(color, Qt::BDiagPattern);
  return brush;
}

void draw_focus(QPainter& painter, const QRectF& area) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors().accent, 2));
  painter.drawRoundedRect(area.adjusted(1, 1, -1, -1), 3, 3);
  painter.restore();
}

QString state_name(CellState state) {
  switch (state) {
    case CellState::waiting:
      return QObject::tr("waiting");
    case CellState::used:
      return QObject::tr("used");
    case CellState::rejected:
      return QObject::tr("rejected");
    case CellState::excluded:
      return QObject::tr("excluded");
  }
  return {};
}

QString cell_text(const ObservationCell& cell) {
  QString text = QObject::tr("obs %1").arg(cell.id);
  if (const ShownSize size = reported_size(cell); size.value) text += QStringLiteral(": ") + size_text(size);
  if (cell.predicted) text += QObject::tr(", predicted %1 σ").arg(short_text(cell.predicted));
  if (cell.state != CellState::used) text += QStringLiteral(", ") + state_name(cell.state);
  if (!cell.note.isEmpty()) text += QStringLiteral(": ") + cell.note;
  return text;
}

}  // namespace handsight::widgets
