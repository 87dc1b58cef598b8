// SPDX-License-Identifier: Apache-2.0
// Every text that a window paints, with its place: what labels hold and what widgets paint themselves.
#pragma once

#include <qcustomplot.h>

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QWidget>
#include <vector>

namespace handsight::test {

struct PaintedText {
  QString text;
  QRectF place;  // of its ink and a little more, in the coordinates of the widget
  const QWidget* widget = nullptr;
};

/// Takes what is painted and keeps the texts.
class TextRecorder : public QPaintDevice {
 public:
  explicit TextRecorder(const QSize& size) : size_(size), engine_(*this) {}
  QPaintEngine* paintEngine() const override { return &engine_; }
  std::vector<PaintedText> texts;

 protected:
  int metric(PaintDeviceMetric m) const override {
    switch (m) {
      case PdmWidth:
        return size_.width();
      case PdmHeight:
        return size_.height();
      case PdmDpiX:
      case PdmDpiY:
      case PdmPhysicalDpiX:
      case PdmPhysicalDpiY:
        return 96;
      case PdmWidthMM:
        return size_.width() * 254 / 960;
      case PdmHeightMM:
        return size_.height() * 254 / 960;
      case PdmNumColors:
        return 1 << 24;
      case PdmDepth:
        return 32;
      case PdmDevicePixelRatio:
        return 1;
      case PdmDevicePixelRatioScaled:
        return static_cast<int>(devicePixelRatioFScale());
      default:
        return 0;
    }
  }

 private:
  class Engine : public QPaintEngine {
   public:
    explicit Engine(TextRecorder& device) : QPaintEngine(AllFeatures), device_(device) {}
    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState&) override {}
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawImage(const QRectF&, const QImage&, const QRectF&, Qt::ImageConversionFlags) override {}
    void drawTiledPixmap(const QRectF&, const QPixmap&, const QPointF&) override {}
    void drawPath(const QPainterPath&) override {}
    void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
    Type type() const override { return User; }
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
      const QFontMetricsF metrics(item.font());
      // From the capitals' height to the base line: what is read even where a line stands close.
      const QRectF box(at.x(), at.y() - metrics.capHeight(), item.width(), metrics.capHeight());
      if (!item.text().trimmed().isEmpty())
        device_.texts.push_back({item.text(), painter()->combinedTransform().mapRect(box), nullptr});
    }

   private:
    TextRecorder& device_;
  };

  QSize size_;
  mutable Engine engine_;
};

/// The texts that this widget itself paints, without its children.
inline std::vector<PaintedText> texts_of(QWidget& widget) {
  TextRecorder recorder(widget.size());
  if (auto* plot = qobject_cast<QCustomPlot*>(&widget)) {  // paints a picture that it keeps
    QCPPainter painter(&recorder);
    plot->toPainter(&painter, widget.width(), widget.height());
  } else {
    widget.render(&recorder, QPoint(), QRegion(), QWidget::RenderFlags());
  }
  for (PaintedText& text : recorder.texts) text.widget = &widget;
  return recorder.texts;
}

/// Everything that is painted now, a line a widget.
inline QStringList painted(QWidget& window) {
  QStringList lines;
  for (QWidget* w : window.findChildren<QWidget*>()) {
    if (!w->isVisible() || w->visibleRegion().isEmpty()) continue;
    QStringList own;
    for (const PaintedText& t : texts_of(*w)) own << t.text;
    if (!own.isEmpty()) lines << own.join(' ');
  }
  return lines;
}

}  // namespace handsight::test
