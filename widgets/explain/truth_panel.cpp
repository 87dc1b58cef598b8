// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/truth_panel.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/base/tool_tip.h"
#include "widgets/explain/text_lines.h"

namespace handsight::widgets {
namespace {

constexpr double row_length = 40, truth_verdict_width = 92;

/// Sign, word and ink of a verdict.
struct Look {
  QString sign, word;
  QColor ink;
};

/// "joint elasticity of arm_2, compliance (urad/(N m))"
QString truth_name(const TruthRow& r) {
  const QString name = r.parameter.isEmpty() ? r.what : QStringLiteral("%1, %2").arg(r.what, r.parameter);
  return r.unit.isEmpty() ? name : name + QStringLiteral(" (%1)").arg(r.unit);
}

}  // namespace

TruthPanel::TruthPanel(QWidget* parent) : QWidget(parent), empty_text_(tr("This session does not know its truth.")) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("The truth"));
}

void TruthPanel::set_rows(std::vector<TruthRow> rows, const QString& sentence) {
  rows_ = std::move(rows);
  sentence_ = sentence;
  focused_ = 0;
  setAccessibleDescription(sentence);
  updateGeometry();
  update();
}

void TruthPanel::set_empty_text(const QString& sentence) {
  empty_text_ = sentence;
  update();
}

QSize TruthPanel::minimumSizeHint() const { return {340, 96}; }

QSize TruthPanel::sizeHint() const {
  return {464, static_cast<int>(top_of_rows() +
                                row_length * static_cast<double>(std::max<std::size_t>(rows_.size(), 1)) + layout_gap)};
}

double TruthPanel::top_of_rows() const {
  return layout_gap + lines_height(text_font(TextRole::title), sentence_, width() - 2.0 * layout_gap, 3) + 4 +
         row_height_px;
}

QRectF TruthPanel::row_rect(int row) const {
  return {0, top_of_rows() + row * row_length, static_cast<double>(width()), row_length};
}

void TruthPanel::paint_row(QPainter& painter, int row) const {
  const Colors& c = colors();
  const TruthRow& r = rows_[static_cast<std::size_t>(row)];
  const QRectF area = row_rect(row), room = area.adjusted(layout_gap, 2, -layout_gap, -2);
  const Look look = r.verdict == TruthVerdict::right    ? Look{QStringLiteral("✓"), tr("correct"), c.good}
                    : r.verdict == TruthVerdict::off    ? Look{QStringLiteral("≠"), tr("off"), c.care}
                    : r.verdict == TruthVerdict::missed ? Look{QStringLiteral("✗"), tr("missed"), c.bad}
                                                        : Look{QStringLiteral("+"), tr("not hidden"), c.bad};
  const double half = (room.width() - truth_verdict_width) / 2;
  painter.setFont(text_font(TextRole::body));
  painter.setPen(c.ink1);
  draw_text(painter, QRectF(room.left(), room.top(), room.width() - truth_verdict_width - layout_gap, 18),
            Qt::AlignLeft | Qt::AlignVCenter, truth_name(r));
  painter.setFont(number_font(TextRole::body));
  painter.setPen(c.ink2);
  const QRectF lower(room.left(), room.top() + 18, half, 18);
  draw_text(painter, lower.adjusted(0, 0, -layout_gap, 0), Qt::AlignLeft | Qt::AlignVCenter,
            with_sigma_text(r.hidden, {}));
  draw_text(painter, lower.translated(half, 0).adjusted(0, 0, -layout_gap, 0), Qt::AlignLeft | Qt::AlignVCenter,
            with_sigma_text(r.found, r.sigma));
  const QRectF verdict(room.right() - truth_verdict_width, room.top(), truth_verdict_width, room.height());
  painter.setPen(look.ink);
  painter.setFont(text_font(TextRole::body));
  const bool has_remark = !r.remark.isEmpty();
  draw_text(painter, has_remark ? verdict.adjusted(0, 0, 0, -18) : verdict, Qt::AlignLeft | Qt::AlignVCenter,
            look.sign + QLatin1Char(' ') + look.word);
  if (has_remark) {
    painter.setFont(number_font(TextRole::small));
    painter.setPen(c.ink2);
    draw_text(painter, verdict.adjusted(0, 18, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, r.remark);
  }
  painter.setPen(QPen(c.hairline, 1));
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  if (hasFocus() && row == focused_) draw_focus(painter, area);
}

void TruthPanel::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), c.panel);
  if (rows_.empty() && sentence_.isEmpty()) {
    draw_sentence(painter, rect(), empty_text_);
    return;
  }
  painter.setPen(c.ink1);
  draw_lines(painter, text_font(TextRole::title), QRectF(layout_gap, layout_gap, width() - 2.0 * layout_gap, 80),
             sentence_, 3);
  if (rows_.empty()) return;
  const double head = top_of_rows() - row_height_px, half = (width() - 2.0 * layout_gap - truth_verdict_width) / 2;
  painter.setFont(text_font(TextRole::small));
  painter.setPen(c.ink3);
  draw_text(painter, QRectF(layout_gap, head, half, row_height_px), Qt::AlignLeft | Qt::AlignVCenter, tr("Hidden was"));
  draw_text(painter, QRectF(layout_gap + half, head, half, row_height_px), Qt::AlignLeft | Qt::AlignVCenter,
            tr("Found"));
  painter.setPen(QPen(c.control_edge, 1));
  painter.drawLine(QPointF(0, top_of_rows() - 0.5), QPointF(width(), top_of_rows() - 0.5));
  for (int i = 0; i < static_cast<int>(rows_.size()); ++i) paint_row(painter, i);
}

void TruthPanel::mousePressEvent(QMouseEvent* event) {
  for (int i = 0; i < static_cast<int>(rows_.size()); ++i)
    if (event->button() == Qt::LeftButton && row_rect(i).contains(event->position())) {
      focused_ = i;
      update();
      emit row_chosen(i);
      return;
    }
}

void TruthPanel::keyPressEvent(QKeyEvent* event) {
  const int step = event->key() == Qt::Key_Down ? 1 : event->key() == Qt::Key_Up ? -1 : 0;
  const bool is_enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (rows_.empty() || (step == 0 && !is_enter)) return QWidget::keyPressEvent(event);
  focused_ = std::clamp(focused_ + step, 0, static_cast<int>(rows_.size()) - 1);
  update();
  if (is_enter) emit row_chosen(focused_);
}

/// What of a row does not stand there whole.
QString TruthPanel::shortened_of(int row) const {
  const TruthRow& r = rows_[static_cast<std::size_t>(row)];
  const double room = width() - 3 * layout_gap - truth_verdict_width;
  QString text;
  if (QFontMetricsF(text_font(TextRole::body)).horizontalAdvance(truth_name(r)) > room) text = truth_name(r);
  if (QFontMetricsF(number_font(TextRole::small)).horizontalAdvance(r.remark) > truth_verdict_width)
    text = (text + QLatin1Char('\n') + r.remark).trimmed();
  return text;
}

bool TruthPanel::event(QEvent* event) {
  if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) update();
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  for (int i = 0; i < static_cast<int>(rows_.size()); ++i)
    if (row_rect(i).contains(help->pos())) {
      show_tip(this, *help, row_rect(i).toAlignedRect(), shortened_of(i));
      return true;
    }
  show_tip(this, *help, rect(), {});
  return true;
}

}  // namespace handsight::widgets
