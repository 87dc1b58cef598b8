// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/verdict_line.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/base/tool_tip.h"
#include "widgets/explain/text_lines.h"

namespace handsight::widgets {
namespace {

constexpr double state_width = 104, attribution_width = 208;

enum class Mood { quiet, good, care, bad };

Mood mood_of(SessionState state) {
  switch (state) {
    case SessionState::adequate:
      return Mood::good;
    case SessionState::mistake:
    case SessionState::missing:
    case SessionState::implausible:
    case SessionState::unexplained:
      return Mood::bad;
    case SessionState::waiting:
    case SessionState::looking:
      return Mood::quiet;
    default:
      return Mood::care;
  }
}

/// Was it looked for what is missing, and is the noise known?
bool is_judged(SessionState state) {
  return state != SessionState::waiting && state != SessionState::looking && state != SessionState::too_few &&
         state != SessionState::noise_unknown;
}

QString sign_of(SessionState state) {
  switch (state) {
    case SessionState::waiting:
    case SessionState::looking:
      return QStringLiteral("…");
    case SessionState::adequate:
      return QStringLiteral("✓");
    case SessionState::mistake:
    case SessionState::missing:
      return QStringLiteral("!");
    case SessionState::ambiguous:
      return QStringLiteral("⇄");
    case SessionState::repeatability:
      return QStringLiteral("∴");
    default:
      return QStringLiteral("?");
  }
}

QString line_text(const char* text) { return QCoreApplication::translate("handsight::widgets::VerdictLine", text); }

}  // namespace

QString session_state_text(SessionState state) {
  switch (state) {
    case SessionState::waiting:
      return line_text("waiting");
    case SessionState::looking:
      return line_text("looking …");
    case SessionState::mistake:
      return line_text("mistake");
    case SessionState::adequate:
      return line_text("adequate");
    case SessionState::stand_in:
      return line_text("stand-in");
    case SessionState::unnamed:
      return line_text("not all named");
    case SessionState::missing:
      return line_text("cause missing");
    case SessionState::implausible:
      return line_text("implausible");
    case SessionState::ambiguous:
      return line_text("ambiguous");
    case SessionState::unexplained:
      return line_text("unexplained");
    case SessionState::repeatability:
      return line_text("looks random");
    case SessionState::too_few:
      return line_text("too few");
    case SessionState::noise_unknown:
      return line_text("noise unknown");
  }
  return {};
}

VerdictLine::VerdictLine(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Verdict"));
}

void VerdictLine::set_verdict(SessionVerdict verdict) {
  verdict_ = std::move(verdict);
  setAccessibleDescription(session_state_text(verdict_.state) + QStringLiteral(": ") + verdict_.sentence);
  update();
}

QSize VerdictLine::sizeHint() const { return {1056, 72}; }
QSize VerdictLine::minimumSizeHint() const { return {640, 72}; }

QRectF VerdictLine::attribution_area() const {
  return {width() - attribution_width - layout_gap, 8.0, attribution_width, height() - 16.0};
}

void VerdictLine::paint_state(QPainter& painter, const QRectF& area) const {
  const Colors& c = colors();
  const Mood mood = mood_of(verdict_.state);
  const QColor ink = mood == Mood::good ? c.good : mood == Mood::care ? c.care : mood == Mood::bad ? c.bad : c.ink2;
  const QColor tint = mood == Mood::good   ? c.good_tint
                      : mood == Mood::care ? c.care_tint
                      : mood == Mood::bad  ? c.bad_tint
                                           : c.sunken;
  painter.fillRect(area, tint);
  const QPointF middle(area.center().x(), area.top() + 24);
  painter.setPen(QPen(ink, 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(middle, 14, 14);
  painter.setFont(text_font(TextRole::title));
  painter.drawText(QRectF(middle - QPointF(14, 14), QSizeF(28, 28)), Qt::AlignCenter, sign_of(verdict_.state));
  const QString state = session_state_text(verdict_.state);
  const bool is_long = QFontMetricsF(text_font(TextRole::body)).horizontalAdvance(state) > area.width() - 4;
  painter.setFont(text_font(is_long ? TextRole::small : TextRole::body));  // long: two lines rather than cut off
  painter.drawText(is_long ? QRectF(area.left(), area.bottom() - 31, area.width(), 30)
                           : QRectF(area.left(), area.bottom() - 28, area.width(), 24),
                   Qt::AlignCenter | Qt::TextWordWrap, state);
}

void VerdictLine::paint_sentence(QPainter& painter, const QRectF& area) const {
  const QString& sentence = verdict_.sentence;
  painter.setPen(colors().ink1);
  QFont font = text_font(TextRole::title);
  int most = 3;
  const auto fits = [&] {
    return lines_height(font, sentence, area.width(), most + 1) <= (most + 0.5) * QFontMetricsF(font).lineSpacing();
  };
  if (!fits()) font.setWeight(QFont::Normal);
  if (!fits()) font = text_font(TextRole::body);  // long: smaller rather than cut off
  if (!fits()) font = text_font(TextRole::small), ++most;
  const int lines = most;
  const double high = lines_height(font, sentence, area.width(), lines);
  draw_lines(painter, font, QRectF(area.left(), area.center().y() - high / 2, area.width(), high), sentence, lines);
}

void VerdictLine::paint_attribution(QPainter& painter, const QRectF& area) const {
  const Colors& c = colors();
  painter.setFont(text_font(TextRole::small));
  painter.setPen(c.ink2);
  const QRectF caption(area.left(), area.top(), area.width(), 18), bar(area.left(), area.top() + 20, area.width(), 12);
  painter.drawText(caption, Qt::AlignLeft | Qt::AlignVCenter,
                   verdict_.attribution ? (verdict_.attribution->of_tracker ? tr("tracker | body | robot")
                                                                            : tr("cameras | body | robot"))
                   : !verdict_.why_no_attribution.isEmpty() ? verdict_.why_no_attribution
                   : is_judged(verdict_.state)              ? tr("nothing stands out of the noise")
                                                            : tr("whose fault: not known yet"));
  painter.fillRect(bar, c.sunken);
  if (!verdict_.attribution) return;
  const ErrorAttribution& attribution = *verdict_.attribution;
  double x = bar.left();
  const auto part = [&](double share, const QColor& color) {
    const double wide = bar.width() * std::clamp(share, 0.0, 1.0);
    painter.fillRect(QRectF(x, bar.top(), std::max(wide - 1, 0.0), bar.height()), color);
    x += wide;
  };
  part(attribution.cameras, c.attribution_to_cameras);
  part(attribution.body, c.attribution_to_body);
  part(attribution.robot, c.attribution_to_robot);
  double text_x = area.left();
  const auto letter = [&](const QString& name, double share, const QColor& color) {
    const QString text = QStringLiteral("%1 %2 %").arg(name).arg(std::lround(100 * share));
    painter.fillRect(QRectF(text_x, bar.bottom() + 9, 9, 9), color);
    painter.setPen(c.ink1);
    const double wide = QFontMetricsF(painter.font()).horizontalAdvance(text);
    painter.drawText(QRectF(text_x + 13, bar.bottom() + 4, wide + 2, 19), Qt::AlignLeft | Qt::AlignVCenter, text);
    text_x += std::max(area.width() / 3, 13 + wide + layout_gap);
  };
  painter.setFont(number_font(TextRole::body));
  letter(attribution.of_tracker ? QStringLiteral("T") : QStringLiteral("C"), attribution.cameras,
         c.attribution_to_cameras);
  letter(QStringLiteral("B"), attribution.body, c.attribution_to_body);
  letter(QStringLiteral("R"), attribution.robot, c.attribution_to_robot);
}

void VerdictLine::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), colors().panel);
  paint_state(painter, QRectF(0, 0, state_width, height()));
  const double left = state_width + wide_gap;
  // The figures stand in the window's header: the sentence has the width.
  paint_sentence(painter, QRectF(left, 4, attribution_area().left() - wide_gap - left, height() - 8));
  paint_attribution(painter, attribution_area());
}

void VerdictLine::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && verdict_.attribution && attribution_area().contains(event->position()))
    emit attribution_clicked();
}

bool VerdictLine::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const QString text =
      attribution_area().contains(help->pos())
          ? (verdict_.attribution && verdict_.attribution->of_tracker
                 ? tr("How much of the error the tracker (T), the marker body (B) and the robot (R) can answer for.")
                 : tr("How much of the error the cameras (C), the marker body (B) and the robot (R) can answer for."))
          : QString();  // the sentence stands there
  show_tip(this, *help, rect(), text);
  return true;
}

}  // namespace handsight::widgets
