// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/icons.h"

#include <QFile>
#include <QIconEngine>
#include <QSvgRenderer>

/// Outside of any namespace, as the macro wants it: the drawings lie in a static library.
static void init_icons() { Q_INIT_RESOURCE(icons); }

namespace handsight::widgets {
namespace {

QByteArray drawing(const QString& name) {
  static const bool is_ready = (init_icons(), true);
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  return is_ready && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

class ThemedEngine : public QIconEngine {
 public:
  explicit ThemedEngine(QString name) : name_(std::move(name)) {}
  void paint(QPainter* painter, const QRect& area, QIcon::Mode mode, QIcon::State) override {
    const Colors& c = colors();
    const int side = std::min(area.width(), area.height());
    draw_icon(*painter, QRect(area.topLeft(), QSize(side, side)), name_,
              mode == QIcon::Disabled ? c.control_edge : c.ink2);
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return pixmap;
  }
  QIconEngine* clone() const override { return new ThemedEngine(name_); }

 private:
  QString name_;
};

}  // namespace

QIcon icon(const QString& name) { return QIcon(new ThemedEngine(name)); }

void draw_icon(QPainter& painter, const QRectF& area, const QString& name, const QColor& ink) {
  QByteArray svg = drawing(name);
  if (svg.isEmpty()) return;
  svg.replace("currentColor", ink.name().toLatin1());
  QSvgRenderer(svg).render(&painter, area);
}

QPixmap drawn_picture(const QString& name, ThemeKind theme) {
  has_icon(name);  // the resources are ready
  const QString folder = theme == ThemeKind::dark ? QStringLiteral("pictures/dark") : QStringLiteral("pictures");
  QPixmap picture(QStringLiteral(":/%1/%2.png").arg(folder, name));
  picture.setDevicePixelRatio(2);
  return picture;
}

bool has_icon(const QString& name) { return !drawing(name).isEmpty(); }

}  // namespace handsight::widgets
