// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lists/parameter_row.h"

#include <QCoreApplication>
#include <QLineEdit>
#include <QPainter>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

/// In the context of the panel.
QString said(const char* text) { return QCoreApplication::translate("handsight::widgets::ModelPanel", text); }

/// A lock, closed where the number is held.
class HoldButton : public QToolButton {
 public:
  HoldButton(bool is_held, QWidget* parent) : QToolButton(parent) {
    setAutoRaise(true);
    setCheckable(true);
    setChecked(is_held);
    setFixedSize(hold_width, 24);
    setToolTip(is_held ? said("Held: the fit leaves it where it is. Press to estimate it again")
                       : said("Hold this number: the fit leaves it where it is, and it can be typed"));
  }
  static constexpr int hold_width = 24;

 protected:
  void paintEvent(QPaintEvent* event) override {
    QToolButton::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ink = isChecked() ? colors().ink1 : underMouse() || hasFocus() ? colors().ink2 : colors().control_edge;
    const QRectF body(width() / 2.0 - 4.5, height() / 2.0 - 1, 9, 7);
    painter.setPen(QPen(ink, 1.5));
    painter.setBrush(isChecked() ? QBrush(ink) : QBrush(Qt::NoBrush));
    painter.drawRect(body);
    painter.setBrush(Qt::NoBrush);
    const QRectF bow(body.center().x() - 3 + (isChecked() ? 0 : 3), body.top() - 6, 6, 10);
    painter.drawArc(bow, 0, 180 * 16);
    painter.drawLine(QPointF(bow.left(), bow.center().y()), QPointF(bow.left(), body.top()));
    if (isChecked()) painter.drawLine(QPointF(bow.right(), bow.center().y()), QPointF(bow.right(), body.top()));
  }
};

}  // namespace

ParameterRow::ParameterRow(ModelParameter parameter, bool is_candidate, bool is_selected, QWidget* parent)
    : QWidget(parent), parameter_(std::move(parameter)), is_candidate_(is_candidate), is_selected_(is_selected) {
  if (parameter_.can_hold) hold_ = new HoldButton(parameter_.is_held, this);
  if (parameter_.is_held) {
    field_ = new QLineEdit(
        parameter_.value ? QString::number(*parameter_.value, 'g', 6).replace('.', decimal_mark()) : QString(), this);
    field_->setAlignment(Qt::AlignRight);
    field_->setFont(number_font(TextRole::small));
  }
  setFixedHeight(bar_top() + (parameter_.plausible ? 10 : 2));
  setToolTip(QStringLiteral("%1 %2%3").arg(name(), value(), plausible()));
}

void ParameterRow::resizeEvent(QResizeEvent*) {
  if (hold_) hold_->move(width() - HoldButton::hold_width, bar_top() - (field_ ? 26 : 24));
  if (!field_) return;
  const int unit = QFontMetrics(number_font(TextRole::small)).horizontalAdvance(parameter_.unit) + 8;
  field_->setGeometry(text_width() - 70 - unit, bar_top() - 26, 70, 24);
}

void ParameterRow::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (is_selected_) painter.fillRect(rect(), c.selected_row);
  const bool is_long = !parameter_.of.isEmpty();
  const QRectF line(0, is_long ? 18 : 0, text_width(), field_ ? 26 : 20);
  painter.setFont(number_font(TextRole::small));
  const QString text = field_ ? parameter_.unit : value();
  double wide = std::min(QFontMetricsF(painter.font()).horizontalAdvance(text) + 2, line.width() * 0.72);
  painter.setPen(is_candidate_ ? c.candidate : c.ink1);
  draw_text(painter, line.adjusted(line.width() - wide, 0, 0, 0), Qt::AlignRight | Qt::AlignVCenter, text);
  if (field_) wide = text_width() - field_->x();
  painter.setFont(text_font(TextRole::small));
  painter.setPen(c.ink2);
  if (is_long) {
    // A long name stands beside its joint rather than cut short before its number.
    const QFontMetricsF metrics(painter.font());
    const bool is_above = metrics.horizontalAdvance(parameter_.name) > line.width() - wide - 6 &&
                          metrics.horizontalAdvance(name()) <= text_width();
    draw_text(painter, QRectF(0, 0, text_width(), 20), Qt::AlignLeft | Qt::AlignVCenter,
              is_above ? name() : parameter_.of);
    if (!is_above)
      draw_text(painter, line.adjusted(0, 0, -wide - 6, 0), Qt::AlignLeft | Qt::AlignVCenter, parameter_.name);
  } else {
    draw_text(painter, line.adjusted(0, 0, -wide - 6, 0), Qt::AlignLeft | Qt::AlignVCenter, name());
  }
  if (parameter_.plausible && *parameter_.plausible > 0) paint_bar(painter, QRectF(0, bar_top() + 2, width(), 6));
}

void ParameterRow::paint_bar(QPainter& painter, const QRectF& bar) const {
  const Colors& c = colors();
  constexpr double most = 3;  // plausible deviations to each side
  painter.fillRect(bar, c.sunken);
  const auto find_x = [&](double deviations) {
    return bar.center().x() + bar.width() / 2 * std::clamp(deviations / most, -1.0, 1.0);
  };
  painter.fillRect(QRectF(find_x(-1), bar.top(), find_x(1) - find_x(-1), bar.height()), c.hairline);
  painter.setPen(QPen(c.control_edge, 1));
  painter.drawLine(QPointF(bar.center().x(), bar.top() - 1), QPointF(bar.center().x(), bar.bottom() + 1));
  if (!parameter_.value) return;
  const double value = *parameter_.value / *parameter_.plausible;
  const bool is_beyond = std::abs(value) > most;
  const QColor ink = is_candidate_ ? c.candidate : is_beyond ? c.bad : c.ink1;
  if (parameter_.sigma) {
    const double sigma = *parameter_.sigma / *parameter_.plausible;
    painter.setPen(QPen(ink, 1));
    painter.drawLine(QPointF(find_x(value - sigma), bar.center().y()),
                     QPointF(find_x(value + sigma), bar.center().y()));
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  painter.drawRect(QRectF(find_x(value) - 1.5, bar.top() - 1, 3, bar.height() + 2));
}

int ParameterRow::text_width() const { return width() - (hold_ ? HoldButton::hold_width : 0); }

int ParameterRow::bar_top() const { return (parameter_.of.isEmpty() ? 22 : 40) + (field_ ? 6 : 0); }

QString ParameterRow::name() const {
  return parameter_.of.isEmpty() ? parameter_.name : parameter_.of + QStringLiteral("  ") + parameter_.name;
}

QString ParameterRow::value() const {
  // A figure would look surer than all others: nothing here tells it.
  if (parameter_.sigma && !std::isfinite(*parameter_.sigma)) return QObject::tr("not determined");
  const QString text = with_sigma_text(parameter_.value, parameter_.sigma);
  return parameter_.unit.isEmpty() || !parameter_.value ? text : text + QChar(0x00A0) + parameter_.unit;
}

QString ParameterRow::plausible() const {
  if (!parameter_.plausible) return {};
  return said(", plausible within about ± %1").arg(with_unit_text(parameter_.plausible, parameter_.unit));
}

}  // namespace handsight::widgets
