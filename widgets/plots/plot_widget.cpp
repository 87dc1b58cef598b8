// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_widget.h"

#include <qcustomplot.h>

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QMenu>
#include <QMouseEvent>
#include <QSaveFile>
#include <QSvgGenerator>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/plots/marked_ticker.h"

namespace handsight::widgets {

PlotWidget::PlotWidget(QWidget* parent)
    : QWidget(parent), plot_(new QCustomPlot(this)), empty_text_(QObject::tr("Nothing to plot yet.")) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setFocusPolicy(Qt::StrongFocus);
  plot_->setFocusPolicy(Qt::NoFocus);
  plot_->setMinimumSize(16, 16);  // of no size at all it warns: splitters give that for a moment
  plot_->setMouseTracking(true);
  plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  plot_->setNoAntialiasingOnDrag(true);
  plot_->setContextMenuPolicy(Qt::CustomContextMenu);
  plot_->axisRect()->setMinimumMargins(QMargins(8, 8, 10, 6));  // half a number stands above the axis
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis})
    axis->setTicker(QSharedPointer<MarkedTicker<QCPAxisTicker>>::create());
  plot_->installEventFilter(this);
  connect(plot_, &QCustomPlot::afterReplot, this, [this] { is_drawn_ = true; });
  connect(plot_, &QCustomPlot::afterLayout, this, &PlotWidget::shorten_title);
  connect(plot_, &QCustomPlot::customContextMenuRequested, this, &PlotWidget::show_menu);
  connect(plot_, &QCustomPlot::mouseDoubleClick, this, [this] { fit(); });
  connect(plot_->selectionRect(), &QCPSelectionRect::accepted, this, [this](const QRect& rect) {
    const QPointF a(plot_->xAxis->pixelToCoord(rect.left()), plot_->yAxis->pixelToCoord(rect.top()));
    const QPointF b(plot_->xAxis->pixelToCoord(rect.right()), plot_->yAxis->pixelToCoord(rect.bottom()));
    brushed(QRectF(a, b).normalized());
  });
  plot_->plotLayout()->insertRow(0);
  title_element_ = new QCPTextElement(plot_);
  title_element_->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
  title_element_->setMargins(QMargins(8, 4, 8, 0));
  plot_->plotLayout()->addElement(0, 0, title_element_);
  plot_->plotLayout()->setRowSpacing(0);
  empty_label_ = new QLabel(this);
  empty_label_->setWordWrap(true);
  empty_label_->setAlignment(Qt::AlignCenter);
  empty_label_->setMargin(wide_gap);
  empty_label_->setAutoFillBackground(true);
  empty_label_->setBackgroundRole(QPalette::Base);
  empty_label_->setAttribute(Qt::WA_TransparentForMouseEvents);
}

QSize PlotWidget::sizeHint() const { return {332, 220}; }
QSize PlotWidget::minimumSizeHint() const { return {160, 100}; }

void PlotWidget::set_title(const QString& title) {
  title_ = title;
  setAccessibleName(title);
  title_element_->setText(title);
  replot();
}

void PlotWidget::shorten_title() {
  const double room = plot_->width() - 16;
  const QFontMetricsF metrics(title_element_->font());
  const QString whole = title_note_.isEmpty() ? title_ : title_ + QStringLiteral(", ") + title_note_;
  const bool has_room = metrics.horizontalAdvance(whole) <= room;
  title_element_->setText(has_room ? whole : metrics.elidedText(title_, Qt::ElideMiddle, room));
}

void PlotWidget::set_empty_text(const QString& sentence) {
  empty_text_ = sentence;
  replot();
}

void PlotWidget::replot() {
  empty_label_->setText(empty_text_);
  empty_label_->setVisible(is_empty());
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) axis->setVisible(!is_empty());
  is_stale_ = !isVisible();
  if (!is_stale_) plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotWidget::replot_marks() {
  const bool has_room = !plot_->viewport().isEmpty() && !plot_->size().isEmpty();
  if (isVisible() && is_drawn_ && has_room)
    plot_->layer(marks_layer)->replot();
  else
    replot();
}

void PlotWidget::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (is_stale_) replot();
}

void PlotWidget::resizeEvent(QResizeEvent*) {
  empty_label_->setGeometry(rect().adjusted(0, 21, 0, 0));
  constexpr int frame = 66, step = 22;  // px: title and axis; a line of the grid
  const int fewest = height() < 2 * frame ? 2 : 3;
  plot_->yAxis->ticker()->setTickCount(std::clamp((height() - frame) / step, fewest, 5));
}

void PlotWidget::brushed(const QRectF&) {}

void PlotWidget::style_axes() {
  const Colors& c = colors();
  plot_->setBackground(QBrush(c.panel));
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis, plot_->xAxis2, plot_->yAxis2}) {
    axis->setBasePen(QPen(c.control_edge, 1));
    axis->setTickPen(QPen(c.control_edge, 1));
    axis->setSubTickPen(QPen(c.hairline, 1));
    axis->setTickLabelColor(c.ink2);
    axis->setLabelColor(c.ink2);
    axis->setTickLabelFont(number_font(TextRole::small));
    axis->setLabelFont(text_font(TextRole::small));
    axis->setLabelPadding(5);
    axis->setTickLabelPadding(3);
    axis->setTickLengthIn(0);
    axis->setTickLengthOut(4);
    axis->setSubTickLength(0, 0);
    axis->ticker()->setTickCount(5);
    axis->grid()->setPen(QPen(c.hairline, 1));
    axis->grid()->setZeroLinePen(QPen(c.control_edge, 1));
  }
  plot_->xAxis->grid()->setVisible(false);
  QFont font = text_font(TextRole::body);
  font.setWeight(QFont::DemiBold);
  title_element_->setFont(font);
  title_element_->setTextColor(c.ink1);
  QColor fill = c.accent;
  fill.setAlpha(50);
  plot_->selectionRect()->setPen(QPen(c.accent, 1));
  plot_->selectionRect()->setBrush(fill);
}

namespace {

/// While it lives, what is selected or hovered is not drawn: a picture is of the plot, not of who looks at it.
class WithoutMarks {
 public:
  explicit WithoutMarks(QCPLayer* marks) : marks_(marks) { marks_->setVisible(false); }
  ~WithoutMarks() {
    marks_->setVisible(true);
    marks_->parentPlot()->replot(QCustomPlot::rpQueuedReplot);
  }
  WithoutMarks(const WithoutMarks&) = delete;
  WithoutMarks& operator=(const WithoutMarks&) = delete;

 private:
  QCPLayer* marks_;
};

}  // namespace

QImage PlotWidget::picture(double scale) const {
  const WithoutMarks without_marks(plot_->layer(marks_layer));
  plot_->replot(QCustomPlot::rpImmediateRefresh);
  QImage image(plot_->size() * scale, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(scale);
  image.fill(colors().panel);
  const_cast<PlotWidget*>(this)->QWidget::render(&image, {}, {}, QWidget::DrawChildren);
  return image;
}

QByteArray PlotWidget::svg(const QSize& size) const {
  const WithoutMarks without_marks(plot_->layer(marks_layer));
  QByteArray text;
  QBuffer buffer(&text);
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(size);
  generator.setViewBox(QRect(QPoint(0, 0), size));
  generator.setTitle(title_);
  QCPPainter painter;
  painter.begin(&generator);
  painter.setMode(QCPPainter::pmVectorized);
  painter.setMode(QCPPainter::pmNoCaching);
  painter.fillRect(QRect(QPoint(0, 0), size), colors().panel);
  plot_->toPainter(&painter, size.width(), size.height());
  painter.end();
  return text;
}

QString PlotWidget::csv() const {
  const std::vector<PlotColumn> all = columns();
  std::size_t rows = 0;
  QStringList head;
  for (const PlotColumn& column : all) {
    rows = std::max(rows, column.values.size());
    head +=
        QLatin1Char('"') + QString(column.name).replace(QLatin1Char('"'), QStringLiteral("\"\"")) + QLatin1Char('"');
  }
  QString text = head.join(QLatin1Char(',')) + QLatin1Char('\n');
  for (std::size_t row = 0; row < rows; ++row) {
    QStringList line;
    for (const PlotColumn& column : all) {
      const bool is_known = row < column.values.size() && std::isfinite(column.values[row]);
      line += is_known ? QString::number(column.values[row], 'g', 17) : QString();
    }
    text += line.join(QLatin1Char(',')) + QLatin1Char('\n');
  }
  return text;
}

QString PlotWidget::save(const QString& path) const {
  QByteArray content;
  if (path.endsWith(QStringLiteral(".png"), Qt::CaseInsensitive)) {
    QBuffer buffer(&content);
    buffer.open(QIODevice::WriteOnly);
    picture().save(&buffer, "PNG");
  } else if (path.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive)) {
    content = svg(size());
  } else if (path.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive)) {
    content = csv().toUtf8();
  } else {
    return QObject::tr("%1 must end in .png, .svg or .csv.").arg(path);
  }
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.commit())
    return QObject::tr("%1 cannot be written: %2. Choose another folder.").arg(path, file.errorString());
  return {};
}

void PlotWidget::save_as(const QString& ending) {
  QString name = title_.isEmpty() ? QObject::tr("plot") : title_.toLower();
  name.replace(QRegularExpression(QStringLiteral("[^a-z0-9]+")), QStringLiteral("_"));
  const QString path = QFileDialog::getSaveFileName(this, QObject::tr("Save the plot"), name + ending,
                                                    ending.toUpper().mid(1) + QStringLiteral(" (*") + ending + ')');
  if (path.isEmpty()) return;
  const QString whole = path.endsWith(ending, Qt::CaseInsensitive) ? path : path + ending;
  const QString reason = save(whole);
  emit message(reason.isEmpty() ? QObject::tr("Saved %1.").arg(whole) : reason);
}

void PlotWidget::show_menu(const QPoint& position) {
  QMenu menu(this);
  menu.addAction(QObject::tr("Fit"), this, [this] { fit(); });
  menu.addSeparator();
  menu.addAction(QObject::tr("Copy the picture"), this, [this] {
    QApplication::clipboard()->setImage(picture());
    emit message(QObject::tr("The plot's picture is on the clipboard."));
  });
  menu.addAction(QObject::tr("Copy the numbers as CSV"), this, [this] {
    QApplication::clipboard()->setText(csv());
    emit message(QObject::tr("The plot's numbers are on the clipboard."));
  });
  menu.addSeparator();
  for (const char* ending : {".png", ".svg", ".csv"})
    menu.addAction(QObject::tr("Save as %1 ...").arg(QString::fromLatin1(ending).mid(1).toUpper()), this,
                   [this, ending] { save_as(QString::fromLatin1(ending)); });
  menu.exec(plot_->mapToGlobal(position));
}

void PlotWidget::clicked_at(const QPointF&, Qt::KeyboardModifiers) {}

void PlotWidget::wheel_over(const QPointF& position) {
  // Over an axis that axis alone, elsewhere both.
  QCPAxisRect* rect = plot_->axisRect();
  const bool is_left = position.x()<rect->left(), is_below = position.y()> rect->bottom();
  Qt::Orientations both = Qt::Horizontal | Qt::Vertical;
  rect->setRangeZoom(is_left == is_below ? both
                     : is_left           ? Qt::Orientations(Qt::Vertical)
                                         : Qt::Orientations(Qt::Horizontal));
}

bool PlotWidget::eventFilter(QObject* watched, QEvent* event) {
  if (watched != plot_) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
      follow_mouse(*static_cast<QMouseEvent*>(event));
      break;
    case QEvent::Leave:
      text_at({-1e6, -1e6});
      emit read_out({});
      break;
    case QEvent::Wheel:
      wheel_over(static_cast<QWheelEvent*>(event)->position());
      break;
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

void PlotWidget::follow_mouse(const QMouseEvent& mouse) {
  switch (mouse.type()) {
    case QEvent::MouseButtonPress:
      setFocus(Qt::MouseFocusReason);
      pressed_at_ = mouse.position();
      is_dragging_ = false;
      if (has_brush_ && mouse.button() == Qt::LeftButton)
        plot_->setSelectionRectMode(brushes_always_ || mouse.modifiers() & Qt::ShiftModifier ? QCP::srmCustom
                                                                                             : QCP::srmNone);
      break;
    case QEvent::MouseMove:
      if (mouse.buttons() && (mouse.position() - pressed_at_).manhattanLength() > 4) is_dragging_ = true;
      if (!mouse.buttons()) emit read_out(is_empty() ? QString() : text_at(mouse.position()));
      break;
    case QEvent::MouseButtonRelease:
      if (!is_dragging_ && mouse.button() == Qt::LeftButton && !is_empty())
        clicked_at(mouse.position(), mouse.modifiers());
      is_dragging_ = false;
      break;
    default:
      break;
  }
}

void PlotWidget::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    style_axes();
    restyle();
    replot();
  }
  QWidget::changeEvent(event);
}

void PlotWidget::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_F && !event->modifiers()) return fit();
  if (event->matches(QKeySequence::Copy)) {
    QApplication::clipboard()->setImage(picture());
    emit message(QObject::tr("The plot's picture is on the clipboard."));
    return;
  }
  const double factor = event->key() == Qt::Key_Plus ? 0.8 : event->key() == Qt::Key_Minus ? 1.25 : 0;
  if (factor == 0) return QWidget::keyPressEvent(event);
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) axis->scaleRange(factor, axis->range().center());
  replot();
}

}  // namespace handsight::widgets
