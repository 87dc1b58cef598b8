// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/histogram_plot.h"

#include <qcustomplot.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <map>

#include "widgets/number_text.h"
#include "widgets/theme.h"

namespace handsight::widgets {
namespace {

constexpr double kBin = 0.1;        // of the decimal logarithm
constexpr double kSmallest = 0.05;  // residuals below are counted there

bool counts(const ObservationCell& cell) { return cell.state == CellState::used && cell.rms_over_sigma; }

double place_of(double ratio) { return std::log10(std::max(ratio, kSmallest)); }

int number_of_bin(double place) { return static_cast<int>(std::floor(place / kBin)); }

/// Probability that noise alone gives an rms over sigma of less than `ratio`.
double noise_below(double ratio, int coordinates) {
  const boost::math::chi_squared distribution(std::max(coordinates, 1));
  return boost::math::cdf(distribution, ratio * ratio * std::max(coordinates, 1));
}

}  // namespace

struct HistogramPlot::Bars {
  std::array<QCPBars*, 6> step{};
  QCPGraph* noise = nullptr;
  QCPItemStraightLine *threshold = nullptr, *selected = nullptr;
  QCPItemText* threshold_text = nullptr;
  std::map<int, std::vector<ObservationId>> bins;
};

HistogramPlot::HistogramPlot(QWidget* parent) : PlotWidget(parent), bars_(std::make_shared<Bars>()) {
  bars_->noise = plot_->addGraph();
  for (QCPBars*& bars : bars_->step) {
    bars = new QCPBars(plot_->xAxis, plot_->yAxis);
    bars->setWidth(kBin * 0.9);
    bars->setPen(Qt::NoPen);
  }
  bars_->threshold = new QCPItemStraightLine(plot_);
  bars_->selected = new QCPItemStraightLine(plot_);
  bars_->selected->setLayer(marks_layer);
  bars_->threshold_text = new QCPItemText(plot_);
  bars_->threshold_text->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
  bars_->threshold_text->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
  bars_->threshold_text->setPadding(QMargins(4, 0, 0, 0));
  const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
  for (const double ratio : {0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0})
    ticker->addTick(std::log10(ratio), short_text(ratio, 1));
  plot_->xAxis->setTicker(ticker);
  plot_->yAxis->ticker()->setTickStepStrategy(QCPAxisTicker::tssReadability);
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
  plot_->yAxis->setLabel(QStringLiteral("observations"));
  fill();
}

bool HistogramPlot::is_empty() const { return std::none_of(cells_.begin(), cells_.end(), counts); }

void HistogramPlot::set_cells(std::vector<ObservationCell> cells) {
  const bool was_empty = is_empty();
  cells_ = std::move(cells);
  fill();
  if (was_empty) fit();
  replot();
}

void HistogramPlot::set_noise(std::optional<double> sigma, const QString& unit) {
  noise_ = sigma;
  unit_ = unit;
  fill();
  replot();
}

void HistogramPlot::set_selected(ObservationId id) {
  selected_ = id;
  place_selected();
  replot_marks();
}

void HistogramPlot::set_threshold(std::optional<double> rms_over_sigma) {
  threshold_ = rms_over_sigma;
  place_threshold();
  replot();
}

std::vector<ObservationId> HistogramPlot::beyond_threshold() const {
  std::vector<ObservationId> ids;
  if (!threshold_) return ids;
  for (const ObservationCell& cell : cells_)
    if (counts(cell) && *cell.rms_over_sigma > *threshold_) ids.push_back(cell.id);
  return ids;
}

void HistogramPlot::place_threshold() {
  bars_->threshold->setVisible(threshold_.has_value());
  bars_->threshold_text->setVisible(threshold_.has_value());
  if (!threshold_) return;
  const double x = place_of(*threshold_);
  bars_->threshold->point1->setCoords(x, 0);
  bars_->threshold->point2->setCoords(x, 1);
  bars_->threshold_text->position->setCoords(x, 0.02);
  const auto used = std::count_if(cells_.begin(), cells_.end(), counts);
  bars_->threshold_text->setText(QStringLiteral("%1 of %2 beyond").arg(beyond_threshold().size()).arg(used));
}

void HistogramPlot::fill() {
  plot_->xAxis->setLabel(noise_ ? QStringLiteral("rms / noise (1 = %1 %2)").arg(short_text(noise_), unit_)
                                : QStringLiteral("rms (%1)").arg(unit_));
  bars_->bins.clear();
  std::map<int, int> coordinates;  // how many observations have so many
  for (const ObservationCell& cell : cells_) {
    if (!counts(cell)) continue;
    bars_->bins[number_of_bin(place_of(*cell.rms_over_sigma))].push_back(cell.id);
    ++coordinates[cell.coordinates];
  }
  const auto most = std::max_element(coordinates.begin(), coordinates.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  const int typical = most == coordinates.end() ? 12 : most->first;
  std::array<QVector<double>, 6> x, y;
  for (const auto& [bin, ids] : bars_->bins) {
    const double middle = (bin + 0.5) * kBin;
    const auto step = static_cast<std::size_t>(residual_step(std::pow(10, middle), typical));
    x[step] += middle;
    y[step] += static_cast<double>(ids.size());
  }
  for (std::size_t i = 0; i < 6; ++i) bars_->step[i]->setData(x[i], y[i], true);
  QVector<double> noise_x, noise_y;
  if (noise_ && !coordinates.empty()) {
    for (int bin = -10; bin < 6; ++bin) {
      double expected = 0;
      for (const auto& [n, times] : coordinates)
        expected += times * (noise_below(std::pow(10, (bin + 1) * kBin), n) - noise_below(std::pow(10, bin * kBin), n));
      noise_x += (bin + 0.5) * kBin;
      noise_y += expected;
    }
  }
  bars_->noise->setData(noise_x, noise_y, true);
  bars_->noise->setLineStyle(QCPGraph::lsStepCenter);
  place_selected();
  place_threshold();
}

void HistogramPlot::place_selected() {
  const auto selected =
      std::find_if(cells_.begin(), cells_.end(), [this](const ObservationCell& cell) { return cell.id == selected_; });
  const bool is_shown = selected != cells_.end() && counts(*selected);
  bars_->selected->setVisible(is_shown);
  if (!is_shown) return;
  bars_->selected->point1->setCoords(place_of(*selected->rms_over_sigma), 0);
  bars_->selected->point2->setCoords(place_of(*selected->rms_over_sigma), 1);
}

void HistogramPlot::fit() {
  double low = -0.6, high = 0.6, top = 1;
  for (const auto& [bin, ids] : bars_->bins) {
    low = std::min(low, (bin - 1) * kBin);
    high = std::max(high, (bin + 2) * kBin);
    top = std::max(top, static_cast<double>(ids.size()));
  }
  const auto noise = bars_->noise->data();
  for (auto point = noise->constBegin(); point != noise->constEnd(); ++point) top = std::max(top, point->value);
  plot_->xAxis->setRange(low, high);
  plot_->yAxis->setRange(0, top * 1.18);
  replot();
}

int HistogramPlot::bin_at(double x) const { return number_of_bin(plot_->xAxis->pixelToCoord(x)); }

std::vector<ObservationId> HistogramPlot::ids_in(int bin) const {
  const auto found = bars_->bins.find(bin);
  return found == bars_->bins.end() ? std::vector<ObservationId>() : found->second;
}

QString HistogramPlot::text_at(const QPointF& position) {
  if (!plot_->axisRect()->rect().contains(position.toPoint())) return {};
  const int bin = bin_at(position.x());
  const auto ids = ids_in(bin);
  QString text = QStringLiteral("%1 to %2 times the noise: %3 observations")
                     .arg(short_text(std::pow(10, bin * kBin)), short_text(std::pow(10, (bin + 1) * kBin)))
                     .arg(ids.size());
  const auto out = std::count_if(cells_.begin(), cells_.end(), [](const auto& cell) { return !counts(cell); });
  if (out > 0) text += QStringLiteral("; %1 not shown, without a residual or not used").arg(out);
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
    const bool is_near = std::abs(mouse->position().x() - plot_->xAxis->coordToPixel(place_of(*threshold_))) < 6;
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
  PlotColumn id{QStringLiteral("observation id"), {}}, value{QStringLiteral("rms / noise"), {}};
  for (const ObservationCell& cell : cells_) {
    if (!counts(cell)) continue;
    id.values.push_back(static_cast<double>(cell.id));
    value.values.push_back(*cell.rms_over_sigma);
  }
  return {id, value};
}

}  // namespace handsight::widgets
