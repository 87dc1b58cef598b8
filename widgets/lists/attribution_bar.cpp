// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lists/attribution_bar.h"

#include <QHelpEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/base/tool_tip.h"

namespace handsight::widgets {
namespace {

constexpr int bar_height = 14, legend_height = 18;

struct Part {
  QString letter, name;
  double share;
  QColor color;
};

std::array<Part, 3> list_parts(const ErrorAttribution& attribution) {
  const Colors& c = colors();
  return {Part{attribution.of_tracker ? QStringLiteral("T") : QStringLiteral("C"),
               attribution.of_tracker ? QObject::tr("tracker") : QObject::tr("cameras"), attribution.cameras,
               c.attribution_to_cameras},
          Part{QStringLiteral("B"), QObject::tr("body"), attribution.body, c.attribution_to_body},
          Part{QStringLiteral("R"), QObject::tr("robot"), attribution.robot, c.attribution_to_robot}};
}

}  // namespace

AttributionBar::AttributionBar(QWidget* parent) : QWidget(parent) {
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void AttributionBar::set_attribution(std::optional<ErrorAttribution> attribution) {
  attribution_ = attribution;
  if (attribution)
    setAccessibleDescription((attribution->of_tracker ? QObject::tr("Tracker %1 %, body %2 %, robot %3 %")
                                                      : QObject::tr("Cameras %1 %, body %2 %, robot %3 %"))
                                 .arg(std::lround(100 * attribution->cameras))
                                 .arg(std::lround(100 * attribution->body))
                                 .arg(std::lround(100 * attribution->robot)));
  update();
}

void AttributionBar::set_none_text(const QString& text) {
  none_text_ = text;
  update();
}

void AttributionBar::set_sentence(const QString& sentence) {
  sentence_ = sentence;
  updateGeometry();
  update();
}

QSize AttributionBar::sizeHint() const { return {320, heightForWidth(320)}; }
QSize AttributionBar::minimumSizeHint() const {
  // In a splitter nobody asks for the height for a width: the sentence at the present one must not be cut.
  return {160, std::max(bar_height + legend_height + 24, heightForWidth(std::max(width(), 240)))};
}

int AttributionBar::heightForWidth(int width) const {
  const QFontMetrics metrics(text_font(TextRole::body));
  const int text =
      sentence_.isEmpty()
          ? 0
          : metrics.boundingRect(QRect(0, 0, std::max(width, 40), 4000), Qt::TextWordWrap, sentence_).height() +
                layout_gap;
  return bar_height + legend_height + text + 8;
}

void AttributionBar::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  const QRectF bar(0, 2, width(), bar_height);
  painter.fillRect(bar, c.sunken);
  painter.setFont(text_font(TextRole::small));
  if (attribution_) {
    double x = 0, text_x = 0;
    for (const Part& part : list_parts(*attribution_)) {
      const double wide = bar.width() * std::clamp(part.share, 0.0, 1.0);
      painter.fillRect(QRectF(x, bar.top(), std::max(wide - 1, 0.0), bar.height()), part.color);
      x += wide;
      const QString text = QStringLiteral("%1  %2 %3 %").arg(part.letter, part.name).arg(std::lround(100 * part.share));
      const double room = QFontMetricsF(painter.font()).horizontalAdvance(text);
      const QRectF swatch(text_x, bar.bottom() + 6, 10, 10);
      painter.fillRect(swatch, part.color);
      painter.setPen(c.ink2);
      painter.drawText(QRectF(text_x + 14, bar.bottom() + 2, room + 1, legend_height), Qt::AlignVCenter, text);
      text_x += room + 14 + wide_gap;
    }
  } else {
    painter.setPen(c.ink3);
    painter.drawText(QRectF(0, bar.bottom() + 2, width(), legend_height), Qt::AlignVCenter,
                     none_text_.isEmpty() ? QObject::tr("Whose fault: not known yet") : none_text_);
  }
  painter.setFont(text_font(TextRole::body));
  painter.setPen(c.ink1);
  const double top = bar_height + legend_height + layout_gap;
  painter.drawText(QRectF(0, top, width(), height() - top), Qt::TextWordWrap, sentence_);
}

bool AttributionBar::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  show_tip(this, *static_cast<QHelpEvent*>(event), rect(),
           QObject::tr("How much of this residual the cameras (C), the marker body (B) and the robot (R) "
                       "can answer for."));
  return true;
}

}  // namespace handsight::widgets
