// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/history_plot.h"

#include <qcustomplot.h>

#include <QDateTime>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/plots/marked_ticker.h"

namespace handsight::widgets {
namespace {

constexpr double near_px = 40;  // the pointer, along x

}  // namespace

struct HistoryPlot::Layers {
  QCPGraph *low = nullptr, *high = nullptr, *curve = nullptr, *outstanding = nullptr;
  QCPItemStraightLine* limit = nullptr;
  QCPItemText* limit_name = nullptr;
  QSharedPointer<QCPAxisTickerDateTime> dates;
};

HistoryPlot::HistoryPlot(Along along, QWidget* parent)
    : PlotWidget(parent), along_(along), layers_(std::make_shared<Layers>()) {
  layers_->low = plot_->addGraph();
  layers_->high = plot_->addGraph();
  layers_->high->setChannelFillGraph(layers_->low);
  layers_->curve = plot_->addGraph();
  layers_->outstanding = plot_->addGraph();
  layers_->outstanding->setLineStyle(QCPGraph::lsNone);
  layers_->limit = new QCPItemStraightLine(plot_);
  layers_->limit_name = new QCPItemText(plot_);
  layers_->limit_name->setPositionAlignment(Qt::AlignRight | Qt::AlignBottom);
  layers_->limit_name->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
  layers_->limit_name->position->setTypeY(QCPItemPosition::ptPlotCoords);
  if (along_ == Along::time) {
    layers_->dates.reset(new QCPAxisTickerDateTime);
    layers_->dates->setTickCount(4);
    plot_->xAxis->setTicker(layers_->dates);
  } else {
    QSharedPointer<QCPAxisTickerFixed> whole(new QCPAxisTickerFixed);  // no half observations
    whole->setTickStep(1);
    whole->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
    plot_->xAxis->setTicker(whole);
  }
  style_axes();
  HistoryPlot::restyle();
}

void HistoryPlot::set_quantity(const QString& quantity, const QString& unit, bool is_log) {
  quantity_ = quantity;
  unit_ = unit;
  is_log_ = is_log;
  plot_->yAxis->setScaleType(is_log ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
  plot_->yAxis->setTicker(is_log ? QSharedPointer<QCPAxisTicker>(new MarkedTicker<QCPAxisTickerLog>)
                                 : QSharedPointer<QCPAxisTicker>(new MarkedTicker<QCPAxisTicker>));
  plot_->yAxis->setLabel(unit.isEmpty() ? quantity : QStringLiteral("%1 (%2)").arg(quantity, unit));
  fill();
  fit();
}

void HistoryPlot::set_limit(std::optional<double> value, const QString& name) {
  limit_ = value;
  limit_name_ = name;
  fill();
  fit();
}

void HistoryPlot::set_points(std::vector<HistoryPoint> points) {
  points_ = std::move(points);
  fill();
  fit();
}

void HistoryPlot::restyle() {
  const Colors& c = colors();
  QColor band = c.ink2;
  band.setAlpha(40);
  layers_->low->setPen(Qt::NoPen);
  layers_->high->setPen(Qt::NoPen);
  layers_->high->setBrush(band);
  layers_->curve->setPen(QPen(c.ink2, 1.6));
  layers_->curve->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(c.ink1, 1), c.ink1, 5));
  layers_->outstanding->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(c.bad, 1), c.bad, 8));
  layers_->limit->setPen(QPen(c.care, 1.4, Qt::DashLine));
  layers_->limit_name->setColor(c.care);
  layers_->limit_name->setFont(text_font(TextRole::small));
  plot_->xAxis->setLabel(along_ == Along::observations ? QObject::tr("observations") : QString());
  fill();
}

void HistoryPlot::fill() {
  QVector<double> x, y, low, high, x_out, y_out;
  bool has_bands = false;
  for (const HistoryPoint& p : points_) {
    if (is_log_ && !(p.y > 0)) continue;
    x += p.x;
    y += p.y;
    low += p.y - 2 * p.sigma;
    high += p.y + 2 * p.sigma;
    has_bands = has_bands || p.sigma > 0;
    if (!p.stands_out) continue;
    x_out += p.x;
    y_out += p.y;
  }
  has_bands = has_bands && !is_log_;
  layers_->curve->setData(x, y, true);
  layers_->low->setData(has_bands ? x : QVector<double>(), has_bands ? low : QVector<double>(), true);
  layers_->high->setData(has_bands ? x : QVector<double>(), has_bands ? high : QVector<double>(), true);
  layers_->outstanding->setData(x_out, y_out, true);
  layers_->limit->setVisible(limit_.has_value() && !points_.empty());
  layers_->limit_name->setVisible(limit_.has_value() && !points_.empty());
  if (!limit_) return;
  layers_->limit->point1->setCoords(0, *limit_);
  layers_->limit->point2->setCoords(1, *limit_);
  layers_->limit_name->setText(limit_name_);
  layers_->limit_name->position->setCoords(0.99, *limit_);
}

/// The limit is in sight; on a log axis at least two decades are.
void HistoryPlot::fit() {
  double left = 1e300, right = -1e300, low = 1e300, high = -1e300;
  for (const HistoryPoint& p : points_) {
    if (is_log_ && !(p.y > 0)) continue;
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    low = std::min(low, is_log_ ? p.y : p.y - 2 * p.sigma);
    high = std::max(high, is_log_ ? p.y : p.y + 2 * p.sigma);
  }
  if (left > right) return replot();
  if (limit_) {
    low = std::min(low, *limit_);
    high = std::max(high, *limit_);
  }
  // Where they can be written out, numbers are.
  const bool by_powers = is_log_ && (high > 1e5 || low < 1e-3);
  plot_->yAxis->setNumberFormat(by_powers ? QStringLiteral("eb") : QStringLiteral("gb"));
  plot_->yAxis->setNumberPrecision(by_powers ? 0 : 4);
  constexpr double an_hour = 3600;
  if (layers_->dates)
    layers_->dates->setDateTimeFormat(right - left < an_hour ? QStringLiteral("yyyy-MM-dd\nHH:mm:ss")
                                                             : QStringLiteral("yyyy-MM-dd\nHH:mm"));
  const double least = along_ == Along::time ? 20 : 4, span = std::max(right - left, least);
  const double middle = (left + right) / 2;
  plot_->xAxis->setRange(middle - 0.55 * span, middle + 0.55 * span);
  if (is_log_) {
    const double decades = std::max(std::log10(high / low), 2.0), centre = (std::log10(high) + std::log10(low)) / 2;
    plot_->yAxis->setRange(std::pow(10, centre - 0.62 * decades), std::pow(10, centre + 0.62 * decades));
  } else {
    const double margin = std::max(0.12 * (high - low), 1e-12 + 1e-6 * std::abs(high));
    plot_->yAxis->setRange(low - margin, high + margin);
  }
  replot();
}

const HistoryPoint* HistoryPlot::point_at(const QPointF& position) const {
  if (!plot_->axisRect()->rect().contains(position.toPoint())) return nullptr;
  const HistoryPoint* best = nullptr;
  double nearest = near_px;
  for (const HistoryPoint& p : points_) {
    const double distance = std::abs(plot_->xAxis->coordToPixel(p.x) - position.x());
    if (distance >= nearest) continue;
    nearest = distance;
    best = &p;
  }
  return best;
}

QString HistoryPlot::x_text(double x) const {
  if (along_ == Along::observations) return QObject::tr("after %1").arg(x);
  return QDateTime::fromSecsSinceEpoch(static_cast<qint64>(x)).toString(QStringLiteral("yyyy-MM-dd HH:mm"));
}

QString HistoryPlot::text_at(const QPointF& position) {
  const HistoryPoint* p = point_at(position);
  if (!p) return {};
  const QString value = p->sigma > 0 ? with_sigma_text(p->y, p->sigma) : short_text(p->y, 3);
  return QStringLiteral("%1: %2 %3 %4").arg(x_text(p->x), quantity_, value, unit_).trimmed();
}

void HistoryPlot::clicked_at(const QPointF& position, Qt::KeyboardModifiers) {
  if (const HistoryPoint* p = point_at(position); p && p->observation != no_observation)
    emit observation_selected(p->observation);
}

std::vector<PlotColumn> HistoryPlot::columns() const {
  std::vector<PlotColumn> all(3);
  all[0].name = along_ == Along::observations ? QObject::tr("observations") : QObject::tr("time (s since 1970)");
  all[1].name = unit_.isEmpty() ? quantity_ : QStringLiteral("%1 (%2)").arg(quantity_, unit_);
  all[2].name = QObject::tr("sigma of %1 (%2)").arg(quantity_, unit_);
  for (const HistoryPoint& p : points_) {
    all[0].values.push_back(p.x);
    all[1].values.push_back(p.y);
    all[2].values.push_back(p.sigma);
  }
  return all;
}

}  // namespace handsight::widgets
