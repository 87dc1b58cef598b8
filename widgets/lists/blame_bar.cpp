// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lists/blame_bar.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

constexpr int kBarHeight = 14, kLegendHeight = 18;

struct Part {
  QString letter, name;
  double share;
  QColor color;
};

std::array<Part, 3> parts_of(const Blame& blame) {
  const Colors& c = colors();
  return {Part{blame.of_tracker ? QStringLiteral("T") : QStringLiteral("C"),
               blame.of_tracker ? QObject::tr("tracker") : QObject::tr("cameras"), blame.cameras, c.blame_cameras},
          Part{QStringLiteral("B"), QObject::tr("body"), blame.body, c.blame_body},
          Part{QStringLiteral("R"), QObject::tr("robot"), blame.robot, c.blame_robot}};
}

}  // namespace

BlameBar::BlameBar(QWidget* parent) : QWidget(parent) {
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void BlameBar::set_blame(std::optional<Blame> blame) {
  blame_ = blame;
  if (blame)
    setAccessibleDescription((blame->of_tracker ? QObject::tr("Tracker %1 %, body %2 %, robot %3 %")
                                                : QObject::tr("Cameras %1 %, body %2 %, robot %3 %"))
                                 .arg(std::lround(100 * blame->cameras))
                                 .arg(std::lround(100 * blame->body))
                                 .arg(std::lround(100 * blame->robot)));
  update();
}

void BlameBar::set_none_text(const QString& text) {
  none_text_ = text;
  update();
}

void BlameBar::set_sentence(const QString& sentence) {
  sentence_ = sentence;
  updateGeometry();
  update();
}

QSize BlameBar::sizeHint() const { return {320, heightForWidth(320)}; }
QSize BlameBar::minimumSizeHint() const {
  // In a splitter nobody asks for the height for a width: the sentence at the present one must not be cut.
  return {160, std::max(kBarHeight + kLegendHeight + 24, heightForWidth(std::max(width(), 240)))};
}

int BlameBar::heightForWidth(int width) const {
  const QFontMetrics metrics(text_font(TextRole::body));
  const int text =
      sentence_.isEmpty()
          ? 0
          : metrics.boundingRect(QRect(0, 0, std::max(width, 40), 4000), Qt::TextWordWrap, sentence_).height() + kGap;
  return kBarHeight + kLegendHeight + text + 8;
}

void BlameBar::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  const QRectF bar(0, 2, width(), kBarHeight);
  painter.fillRect(bar, c.sunken);
  painter.setFont(text_font(TextRole::small));
  if (blame_) {
    double x = 0, text_x = 0;
    for (const Part& part : parts_of(*blame_)) {
      const double wide = bar.width() * std::clamp(part.share, 0.0, 1.0);
      painter.fillRect(QRectF(x, bar.top(), std::max(wide - 1, 0.0), bar.height()), part.color);
      x += wide;
      const QString text = QStringLiteral("%1  %2 %3 %").arg(part.letter, part.name).arg(std::lround(100 * part.share));
      const double room = QFontMetricsF(painter.font()).horizontalAdvance(text);
      const QRectF swatch(text_x, bar.bottom() + 6, 10, 10);
      painter.fillRect(swatch, part.color);
      painter.setPen(c.ink2);
      painter.drawText(QRectF(text_x + 14, bar.bottom() + 2, room + 1, kLegendHeight), Qt::AlignVCenter, text);
      text_x += room + 14 + kWideGap;
    }
  } else {
    painter.setPen(c.ink3);
    painter.drawText(QRectF(0, bar.bottom() + 2, width(), kLegendHeight), Qt::AlignVCenter,
                     none_text_.isEmpty() ? QObject::tr("Whose fault: not known yet") : none_text_);
  }
  painter.setFont(text_font(TextRole::body));
  painter.setPen(c.ink1);
  const double top = kBarHeight + kLegendHeight + kGap;
  painter.drawText(QRectF(0, top, width(), height() - top), Qt::TextWordWrap, sentence_);
}

bool BlameBar::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                     QObject::tr("How much of this residual the cameras (C), the marker body (B) and the robot (R) "
                                 "can answer for."),
                     this);
  return true;
}

}  // namespace handsight::widgets
