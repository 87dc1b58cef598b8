// SPDX-License-Identifier: GPL-3.0-or-later
#include <qcustomplot.h>

#include <QGridLayout>
#include <QObject>

#include "widgets/plots/convergence_plot.h"

namespace handsight::widgets {
namespace {

using Sample = ConvergencePlot::Sample;

/// Which three of the six, as one of the four plots shows them; nothing where they are not known.
std::optional<Sample> take_sample(const ConvergencePoint& point, std::size_t plot) {
  const bool is_body = plot < 2;
  if (!is_body && !point.tcp_from_tcp_est) return std::nullopt;
  const Vector6& values = is_body ? point.tcp_from_body : *point.tcp_from_tcp_est;
  const int first = plot % 2 == 0 ? 0 : 3;
  Sample sample{.count = point.count, .observation = point.observation};
  for (int i = 0; i < 3; ++i) {
    sample.value[static_cast<std::size_t>(i)] = values[first + i];
    (is_body ? sample.sigma : sample.noise)[static_cast<std::size_t>(i)] =
        is_body ? point.sigma[first + i] : point.deviation_sigma[first + i];
  }
  return sample;
}

std::vector<Sample> samples_of(const std::vector<ConvergencePoint>& points, std::size_t plot) {
  std::vector<Sample> samples;
  for (const ConvergencePoint& point : points)
    if (const auto sample = take_sample(point, plot)) samples.push_back(*sample);
  return samples;
}

}  // namespace

ConvergenceBoard::ConvergenceBoard(QWidget* parent) : QWidget(parent) {
  const std::array<QString, 3> lengths = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  const std::array<QString, 3> angles = {QStringLiteral("rx"), QStringLiteral("ry"), QStringLiteral("rz")};
  const QString mm = QStringLiteral("mm"), deg = QStringLiteral("deg");
  plots_ = {new ConvergencePlot(QObject::tr("position"), mm, lengths, this),
            new ConvergencePlot(QObject::tr("rotation"), deg, angles, this),
            new ConvergencePlot(QObject::tr("position"), mm, lengths, this),
            new ConvergencePlot(QObject::tr("rotation"), deg, angles, this)};
  const std::array<QString, 4> titles = {QObject::tr("TCP→Body, position"), QObject::tr("TCP→Body, rotation"),
                                         QObject::tr("TCP→TCPest, position"), QObject::tr("TCP→TCPest, rotation")};
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(1);
  for (std::size_t i = 0; i < 4; ++i) {
    ConvergencePlot* plot = plots_[i];
    plot->set_title(titles[i]);
    layout->addWidget(plot, static_cast<int>(i) / 2, static_cast<int>(i) % 2);
    connect(plot, &ConvergencePlot::observation_selected, this, &ConvergenceBoard::observation_selected);
    connect(plot, &ConvergencePlot::observation_hovered, this, &ConvergenceBoard::observation_hovered);
    connect(plot, &PlotWidget::read_out, this, &ConvergenceBoard::read_out);
    connect(plot, &PlotWidget::message, this, &ConvergenceBoard::message);
    // One x axis for all four.
    connect(plot->plot()->xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this,
            [this, plot](const QCPRange& range) {
              for (ConvergencePlot* other : plots_) {
                if (other == plot || other->plot()->xAxis->range() == range) continue;
                other->plot()->xAxis->setRange(range);
                other->plot()->replot(QCustomPlot::rpQueuedReplot);
              }
            });
  }
}

void ConvergenceBoard::set_points(const std::vector<ConvergencePoint>& points) {
  for (std::size_t i = 0; i < 4; ++i) plots_[i]->set_samples(samples_of(points, i));
}

void ConvergenceBoard::append(const std::vector<ConvergencePoint>& points) {
  for (std::size_t i = 0; i < 4; ++i) plots_[i]->append(samples_of(points, i));
}

void ConvergenceBoard::set_selected(ObservationId id) {
  for (ConvergencePlot* plot : plots_) plot->set_selected(id);
}

void ConvergenceBoard::set_empty_text(const QString& sentence) {
  for (ConvergencePlot* plot : plots_) plot->set_empty_text(sentence);
}

}  // namespace handsight::widgets
