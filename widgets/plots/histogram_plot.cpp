// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/histogram_plot.h"

#include <qcustomplot.h>

#include <QObject>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/plots/histogram_bins.h"
#include "widgets/plots/marked_ticker.h"

namespace handsight::widgets {
namespace {

constexpr double bin_width = histogram_bin;

}  // namespace

struct HistogramPlot::Bars {
  std::array<QCPBars*, 6> step{};
  QCPGraph* noise = nullptr;
  QCPItemStraightLine *threshold = nullptr, *selected = nullptr;
  QCPItemText* threshold_text = nullptr;
  std::map<int, SizeBin> bins;
};

HistogramPlot::HistogramPlot(QWidget* parent) : PlotWidget(parent), bars_(std::make_shared<Bars>()) {
  bars_->noise = plot_->addGraph();
  for (QCPBars*& bars : bars_->step) {
    bars = new QCPBars(plot_->xAxis, plot_->yAxis);
    bars->setWidth(bin_width * 0.9);
    bars->setPen(Qt::NoPen);
    if (bars != bars_->step.front()) bars->moveAbove(*(std::find(bars_->step.begin(), bars_->step.end(), bars) - 1));
  }
  bars_->threshold = new QCPItemStraightLine(plot_);
  bars_->selected = new QCPItemStraightLine(plot_);
  bars_->selected->setLayer(marks_layer);
  bars_->threshold_text = new QCPItemText(plot_);
  bars_->threshold_text->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
  bars_->threshold_text->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
  bars_->threshold_text->setPadding(QMargins(4, 0, 4, 0));
  connect(plot_, &QCustomPlot::afterLayout, this, &HistogramPlot::place_threshold_text);
  const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
  for (int power = -3; power <= 3; ++power)
    for (const double times : {1.0, 3.0}) {
      const double size = times * std::pow(10.0, power);
      ticker->addTick(std::log10(size), short_text(size, 1));
    }
  plot_->xAxis->setTicker(ticker);
  const QSharedPointer<QCPAxisTickerFixed> counts(new MarkedTicker<QCPAxisTickerFixed>);  // no half observations
  counts->setTickStep(1);
  counts->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
  counts->setTickStepStrategy(QCPAxisTicker::tssReadability);
  plot_->yAxis->setTicker(counts);
  style_axes();
  HistogramPlot::restyle();
}

void HistogramPlot::restyle() {
  const Colors& c = colors();
  for (std::size_t i = 0; i < 6; ++i) bars_->step[i]->setBrush(c.residual[i]);
  bars_->noise->setPen(QPen(c.ink2, 1.2));
  bars_->noise->setBrush(QBrush(c.control_edge, Qt::BDiagPattern));
  bars_->threshold->setPen(QPen(c.ink1, 1.6, Qt::DashLine));
  bars_->selected->setPen(QPen(c.accent, 1.6));
  bars_->threshold_text->setColor(c.ink1);
  bars_->threshold_text->setFont(text_font(TextRole::small));
  plot_->yAxis->setLabel(QObject::tr("count"));
  fill();
}

bool HistogramPlot::is_empty() const {
  return std::none_of(cells_.begin(), cells_.end(), [this](const auto& cell) { return counts_in(cell, unit_); });
}

void HistogramPlot::set_cells(std::vector<ObservationCell> cells) {
  const bool was_empty = is_empty();
  cells_ = std::move(cells);
  fill();
  if (was_empty) fit();
  replot();
}

void HistogramPlot::set_noise(std::optional<double> sigma, const QString& unit) {
  noise_ = sigma;
  noise_unit_ = unit;
  fill();
  replot();
}

void HistogramPlot::set_distance_name(const QString& name) {
  if (name == distance_name_) return;
  distance_name_ = name;
  fill();
  replot();
}

void HistogramPlot::set_unit(SizeUnit unit) {
  if (unit == unit_) return;
  unit_ = unit;
  threshold_.reset();
  fill();
  fit();
}

double HistogramPlot::smallest() const { return 0.05 * typical_noise(cells_, unit_).value_or(0.02); }

QString HistogramPlot::axis_name() const {
  if (unit_ == SizeUnit::sigma)
    return noise_ ? QObject::tr("rms / noise (1 = %1 %2)").arg(short_text(noise_), noise_unit_)
                  : QObject::tr("rms / noise");
  // The noise is hatched, and its figure stands in the window's header.
  if (unit_ == SizeUnit::pixel) return QObject::tr("rms of a coordinate (px)");
  if (!distance_name_.isEmpty()) return distance_name_;
  const bool is_of_cameras = noise_unit_ != QStringLiteral("mm");
  return is_of_cameras ? QObject::tr("error of the hand (mm)") : QObject::tr("rms of the markers' distances (mm)");
}

void HistogramPlot::set_selected(ObservationId id) {
  selected_ = id;
  place_selected();
  replot_marks();
}

void HistogramPlot::set_threshold(std::optional<double> size) {
  threshold_ = size;
  place_threshold();
  replot();
}

std::vector<ObservationId> HistogramPlot::beyond_threshold() const {
  std::vector<ObservationId> ids;
  if (!threshold_) return ids;
  for (const ObservationCell& cell : cells_)
    if (counts_in(cell, unit_) && *reported_size(cell).value > *threshold_) ids.push_back(cell.id);
  return ids;
}

void HistogramPlot::place_threshold() {
  bars_->threshold->setVisible(threshold_.has_value());
  bars_->threshold_text->setVisible(threshold_.has_value());
  if (!threshold_) return;
  const double x = place_of_size(*threshold_, smallest());
  bars_->threshold->point1->setCoords(x, 0);
  bars_->threshold->point2->setCoords(x, 1);
  bars_->threshold_text->position->setCoords(x, 0.02);
  const auto used = std::count_if(cells_.begin(), cells_.end(), [this](const auto& c) { return counts_in(c, unit_); });
  bars_->threshold_text->setText(QObject::tr("%1 of %2 beyond").arg(beyond_threshold().size()).arg(used));
  place_threshold_text();
}

/// On the side of the line that has room for it.
void HistogramPlot::place_threshold_text() {
  if (!threshold_) return;
  const double wide = QFontMetricsF(bars_->threshold_text->font()).horizontalAdvance(bars_->threshold_text->text()) + 8;
  const bool is_right = plot_->xAxis->coordToPixel(std::log10(*threshold_)) + wide <= plot_->axisRect()->right();
  bars_->threshold_text->setPositionAlignment((is_right ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignTop);
}

void HistogramPlot::fill() {
  plot_->xAxis->setLabel(axis_name());
  bars_->bins = size_bins(cells_, unit_, smallest());
  // A bar stands on the one of the step below it: each needs a value in every bin.
  QVector<double> x;
  std::array<QVector<double>, 6> y;
  for (const auto& [number, bin] : bars_->bins) {
    x += (number + 0.5) * bin_width;
    for (std::size_t i = 0; i < 6; ++i) y[i] += bin.steps[i];
  }
  for (std::size_t i = 0; i < 6; ++i) bars_->step[i]->setData(x, y[i], true);
  QVector<double> noise_x, noise_y;
  if (noise_ && !bars_->bins.empty())
    for (const auto& [number, expected] : noise_bins(cells_, unit_)) {
      noise_x += (number + 0.5) * bin_width;
      noise_y += expected;
    }
  bars_->noise->setData(noise_x, noise_y, true);
  bars_->noise->setLineStyle(QCPGraph::lsStepCenter);
  place_selected();
  place_threshold();
}

void HistogramPlot::place_selected() {
  const auto selected =
      std::find_if(cells_.begin(), cells_.end(), [this](const ObservationCell& cell) { return cell.id == selected_; });
  const bool is_shown = selected != cells_.end() && counts_in(*selected, unit_);
  bars_->selected->setVisible(is_shown);
  if (!is_shown) return;
  const double place = place_of_size(*reported_size(*selected).value, smallest());
  bars_->selected->point1->setCoords(place, 0);
  bars_->selected->point2->setCoords(place, 1);
}

void HistogramPlot::fit() {
  const double noise_place = std::log10(typical_noise(cells_, unit_).value_or(1));
  double low = noise_place - 0.6, high = noise_place + 0.6, top = 1;
  for (const auto& [number, bin] : bars_->bins) {
    low = std::min(low, (number - 1) * bin_width);
    high = std::max(high, (number + 2) * bin_width);
    top = std::max(top, static_cast<double>(bin.ids.size()));
  }
  const auto noise = bars_->noise->data();
  for (auto point = noise->constBegin(); point != noise->constEnd(); ++point) top = std::max(top, point->value);
  plot_->xAxis->setRange(low, high);
  plot_->yAxis->setRange(0, top * 1.18);
  replot();
}

int HistogramPlot::bin_at(double x) const {
  return static_cast<int>(std::floor(plot_->xAxis->pixelToCoord(x) / bin_width));
}

std::vector<ObservationId> HistogramPlot::ids_in(int bin) const {
  const auto found = bars_->bins.find(bin);
  return found == bars_->bins.end() ? std::vector<ObservationId>() : found->second.ids;
}

QString HistogramPlot::text_at(const QPointF& position) {
  if (!plot_->axisRect()->rect().contains(position.toPoint())) return {};
  const int bin = bin_at(position.x());
  const auto ids = ids_in(bin);
  const QString unit = unit_ == SizeUnit::sigma ? QObject::tr("times the noise") : unit_name(unit_);
  QString text = QObject::tr("%1 to %2 %4: %3 observations")
                     .arg(short_text(std::pow(10, bin * bin_width)), short_text(std::pow(10, (bin + 1) * bin_width)))
                     .arg(ids.size())
                     .arg(unit);
  const auto out = std::count_if(cells_.begin(), cells_.end(), [this](const auto& c) { return !counts_in(c, unit_); });
  if (out > 0) text += QObject::tr("; %1 not shown, without a residual or not used").arg(out);
  return text;
}

void HistogramPlot::clicked_at(const QPointF& position, Qt::KeyboardModifiers) {
  const auto ids = ids_in(bin_at(position.x()));
  if (!ids.empty()) emit observations_selected(std::vector<qint64>(ids.begin(), ids.end()));
}

bool HistogramPlot::eventFilter(QObject* watched, QEvent* event) {
  const auto type = event->type();
  const bool is_mouse =
      type == QEvent::MouseButtonPress || type == QEvent::MouseMove || type == QEvent::MouseButtonRelease;
  if (watched == plot_ && is_mouse && threshold_) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    const bool is_near = std::abs(mouse->position().x() - plot_->xAxis->coordToPixel(std::log10(*threshold_))) < 6;
    if (type == QEvent::MouseButtonPress && mouse->button() == Qt::LeftButton && is_near) {
      is_moving_threshold_ = true;
      setFocus(Qt::MouseFocusReason);
      return true;
    }
    if (type == QEvent::MouseMove && is_moving_threshold_) {
      const QRect rect = plot_->axisRect()->rect();
      const double x = std::clamp<double>(mouse->position().x(), rect.left(), rect.right());
      set_threshold(std::pow(10, plot_->xAxis->pixelToCoord(x)));
      emit threshold_changed(*threshold_);
      return true;
    }
    if (type == QEvent::MouseButtonRelease && is_moving_threshold_) {
      is_moving_threshold_ = false;
      const auto ids = beyond_threshold();
      emit threshold_set(*threshold_, std::vector<qint64>(ids.begin(), ids.end()));
      return true;
    }
    if (type == QEvent::MouseMove && !mouse->buttons()) plot_->setCursor(is_near ? Qt::SplitHCursor : Qt::ArrowCursor);
  }
  return PlotWidget::eventFilter(watched, event);
}

std::vector<PlotColumn> HistogramPlot::columns() const {
  PlotColumn id{QObject::tr("observation id"), {}}, value{QObject::tr("rms (%1)").arg(unit_name(unit_)), {}};
  for (const ObservationCell& cell : cells_) {
    if (!counts_in(cell, unit_)) continue;
    id.values.push_back(static_cast<double>(cell.id));
    value.values.push_back(*reported_size(cell).value);
  }
  return {id, value};
}

}  // namespace handsight::widgets
