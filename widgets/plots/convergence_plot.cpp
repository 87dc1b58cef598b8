// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/convergence_plot.h"

#include <qcustomplot.h>

#include <QFontMetrics>
#include <QObject>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

constexpr double label_height = 15;
constexpr int fewest = 5;  // observations before anything can be said to have settled

}  // namespace

struct ConvergencePlot::Curves {
  std::array<QCPGraph*, 3> value{}, high{}, low{}, settled{};
  std::array<QCPItemText*, 3> label{};
  QCPItemStraightLine* selected = nullptr;
};

ConvergencePlot::ConvergencePlot(const QString& quantity, const QString& unit, const std::array<QString, 3>& names,
                                 QWidget* parent)
    : PlotWidget(parent),
      quantity_(quantity),
      unit_(unit == QStringLiteral("deg") ? QObject::tr("deg") : unit),
      factor_(unit == QStringLiteral("deg") ? 180 / M_PI : 1000),
      names_(names),
      curves_(std::make_shared<Curves>()) {
  for (std::size_t i = 0; i < 3; ++i) {
    curves_->low[i] = plot_->addGraph();
    curves_->high[i] = plot_->addGraph();
    curves_->high[i]->setChannelFillGraph(curves_->low[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    curves_->value[i] = plot_->addGraph();
    curves_->settled[i] = plot_->addGraph();
    curves_->settled[i]->setLineStyle(QCPGraph::lsNone);
    curves_->label[i] = new QCPItemText(plot_);
    curves_->label[i]->setClipToAxisRect(false);
    curves_->label[i]->setPositionAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    curves_->label[i]->position->setType(QCPItemPosition::ptAbsolute);
  }
  curves_->selected = new QCPItemStraightLine(plot_);
  curves_->selected->setLayer(marks_layer);
  plot_->axisRect()->setAutoMargins(QCP::msBottom | QCP::msTop);
  plot_->axisRect()->setMargins(QMargins(64, 4, 76, 8));
  // The letters stand at the curves' ends, pushed apart where they would meet.
  connect(plot_, &QCustomPlot::afterLayout, this, [this] {
    const QRect rect = plot_->axisRect()->rect();
    if (samples_.empty() || rect.isEmpty()) return;
    const double top = rect.top() + 6.0, bottom = rect.bottom() - 4.0;  // clear of the tick labels
    std::array<std::pair<double, std::size_t>, 3> places;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto points = curves_->value[i]->data();
      const double end = points->isEmpty() ? 0 : (points->constEnd() - 1)->value;
      places[i] = {std::clamp(plot_->yAxis->coordToPixel(end), top, bottom), i};
    }
    std::sort(places.begin(), places.end());
    const double middle = (places[0].first + places[2].first) / 2;
    for (std::size_t k = 1; k < 3; ++k) places[k].first = std::max(places[k].first, places[k - 1].first + label_height);
    // All of them together, or those at the border meet after all.
    double shift = middle - (places[0].first + places[2].first) / 2;
    shift = std::max(std::min(shift, bottom - places[2].first), top - places[0].first);
    for (const auto& [y, i] : places) curves_->label[i]->position->setCoords(rect.right() + 6, y + shift);
  });
  connect(plot_, &QCustomPlot::mouseWheel, this, [this] { follows_ = false; });
  style_axes();
  ConvergencePlot::restyle();
}

void ConvergencePlot::restyle() {
  static const std::array<Qt::PenStyle, 3> styles = {Qt::SolidLine, Qt::DashLine, Qt::DashDotLine};
  for (std::size_t i = 0; i < 3; ++i) {
    const QColor color = colors().xyz_curves[i];
    QColor fill = color;
    fill.setAlpha(36);
    curves_->value[i]->setPen(QPen(color, 1.6, styles[i]));
    curves_->high[i]->setPen(Qt::NoPen);
    curves_->low[i]->setPen(Qt::NoPen);
    curves_->high[i]->setBrush(fill);
    curves_->settled[i]->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDiamond, QPen(colors().ink1, 1), color, 9));
    curves_->label[i]->setColor(color);
    curves_->label[i]->setFont(number_font(TextRole::small));
  }
  curves_->selected->setPen(QPen(colors().accent, 1.5));
  plot_->xAxis->setLabel(QObject::tr("observations"));
  fill();
}

void ConvergencePlot::set_samples(std::vector<Sample> samples) {
  samples_ = std::move(samples);
  follows_ = true;
  fill();
  fit();
}

void ConvergencePlot::append(const std::vector<Sample>& samples) {
  if (samples.empty()) return;
  samples_.insert(samples_.end(), samples.begin(), samples.end());
  fill();
  if (follows_)
    fit();
  else
    replot();
}

void ConvergencePlot::set_selected(ObservationId id) {
  selected_ = id;
  place_selected();
  replot_marks();
}

void ConvergencePlot::set_show_settled(bool shown) {
  shows_settled_ = shown;
  fill();
  replot();
}

int ConvergencePlot::settled_at(int curve) const {
  const auto i = static_cast<std::size_t>(curve);
  if (static_cast<int>(samples_.size()) < fewest || samples_.back().sigma[i] <= 0) return 0;
  const double last = samples_.back().value[i], near = 2 * samples_.back().sigma[i];
  std::size_t first = samples_.size();
  while (first > 0 && std::abs(samples_[first - 1].value[i] - last) <= near) --first;
  return first + 1 >= samples_.size() ? 0 : samples_[first].count;
}

/// In full where the axis is as long as that; else the title says what the axis cannot.
void ConvergencePlot::name_y_axis() {
  constexpr int beside_axis = 40;  // px, above and below it, less what a label may stand over
  const bool has_bands = !samples_.empty() && samples_.back().sigma[0] > 0;
  const QString name =
      origin_ ? QObject::tr("change from the first (%1)").arg(unit_) : QObject::tr("change from final (%1)").arg(unit_);
  const bool has_room = QFontMetrics(plot_->yAxis->labelFont()).horizontalAdvance(name) <= height() - beside_axis;
  const bool is_change = has_bands || origin_;
  plot_->yAxis->setLabel(is_change && has_room ? name : unit_);
  set_title_note(!is_change || has_room ? QString()
                 : origin_              ? QObject::tr("change from the first")
                                        : QObject::tr("change from final"));
}

void ConvergencePlot::resizeEvent(QResizeEvent* event) {
  PlotWidget::resizeEvent(event);
  // Of fewer only one may be in sight, from which nobody can read a size.
  plot_->yAxis->ticker()->setTickCount(std::max(plot_->yAxis->ticker()->tickCount(), 3));
  name_y_axis();
}

void ConvergencePlot::fill() {
  const double factor = factor_;
  const bool has_bands = !samples_.empty() && samples_.back().sigma[0] > 0;
  name_y_axis();
  for (std::size_t i = 0; i < 3; ++i) {
    // Where a band says how well a value is known, what matters is the way to the last one.
    const double origin = origin_ ? (*origin_)[i] : has_bands ? samples_.back().value[i] : 0;
    QVector<double> x, y, low, high;
    for (const Sample& sample : samples_) {
      x += sample.count;
      y += (sample.value[i] - origin) * factor;
      high += y.back() + 2 * sample.sigma[i] * factor;
      low += y.back() - 2 * sample.sigma[i] * factor;
    }
    curves_->value[i]->setData(x, y, true);
    curves_->high[i]->setData(has_bands ? x : QVector<double>(), has_bands ? high : QVector<double>(), true);
    curves_->low[i]->setData(has_bands ? x : QVector<double>(), has_bands ? low : QVector<double>(), true);
    const QString end = samples_.empty() ? QString() : fixed_text(samples_.back().value[i] * factor, 2);
    curves_->label[i]->setText(names_[i] + QLatin1Char(' ') + end);
    curves_->label[i]->setVisible(!samples_.empty());
  }
  mark_settled();
  place_selected();
}

void ConvergencePlot::place_selected() {
  const auto found =
      std::find_if(samples_.begin(), samples_.end(), [this](const Sample& s) { return s.observation == selected_; });
  curves_->selected->setVisible(found != samples_.end());
  if (found != samples_.end()) {
    curves_->selected->point1->setCoords(found->count, 0);
    curves_->selected->point2->setCoords(found->count, 1);
  }
}

void ConvergencePlot::mark_settled() {
  for (std::size_t i = 0; i < 3; ++i) {
    const int count = shows_settled_ ? settled_at(static_cast<int>(i)) : 0;
    QVector<double> x, y;
    const auto value = curves_->value[i]->data();
    const auto at = value->findBegin(count, false);
    if (count > 0 && at != value->constEnd()) {
      x += at->key;
      y += at->value;
    }
    curves_->settled[i]->setData(x, y, true);
  }
}

void ConvergencePlot::set_origin(const std::optional<std::array<double, 3>>& origin) {
  origin_ = origin;
  fill();
  fit();
}

void ConvergencePlot::share_axes(const std::vector<std::vector<ConvergencePlot*>>& rows) {
  std::vector<ConvergencePlot*> all;
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  for (const auto& row : rows)
    for (ConvergencePlot* plot : row) {
      plot->row_ = row;
      plot->all_ = all;
      const auto follow = [plot](std::vector<ConvergencePlot*> others, QCPAxis* QCustomPlot::*axis) {
        connect(plot->plot_->*axis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), plot,
                [plot, others = std::move(others), axis](const QCPRange& range) {
                  for (ConvergencePlot* other : others) {
                    if (other == plot || (other->plot_->*axis)->range() == range) continue;
                    (other->plot_->*axis)->setRange(range);
                    other->replot();
                  }
                });
      };
      follow(all, &QCustomPlot::xAxis);
      follow(row, &QCustomPlot::yAxis);
    }
}

std::optional<ConvergencePlot::Reach> ConvergencePlot::reach() const {
  if (samples_.empty()) return std::nullopt;
  const double factor = factor_;
  double low = 1e300, high = -1e300;
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double y = (curves_->value[i]->data()->constBegin() + static_cast<int>(k))->value;
      // The first estimates know little: their bands would flatten all the rest.
      const double band = 5 * k >= samples_.size() ? 2 * samples_[k].sigma[i] * factor : 0;
      low = std::min(low, y - band);
      high = std::max(high, y + band);
    }
  }
  double sigma = 0;
  for (std::size_t i = 0; i < 3; ++i)
    sigma = std::max({sigma, factor * samples_.back().sigma[i], factor * samples_.back().noise[i]});
  const double short_by = std::max(6 * sigma - (high - low), 0.0);
  low -= short_by / 2;
  high += short_by / 2;
  const double margin = std::max(0.08 * (high - low), 1e-4);
  const double first = samples_.front().count, last = samples_.back().count;
  return Reach{std::min(first, 1.0), std::max(last, first + 4), low - margin, high + margin};
}

void ConvergencePlot::fit() {
  follows_ = true;
  std::optional<Reach> wanted = reach();
  const auto widen = [&wanted](const std::optional<Reach>& other, bool in_row) {
    if (!other) return;
    if (!wanted) wanted = other;
    wanted->left = std::min(wanted->left, other->left);
    wanted->right = std::max(wanted->right, other->right);
    if (in_row) wanted->low = std::min(wanted->low, other->low);
    if (in_row) wanted->high = std::max(wanted->high, other->high);
  };
  for (const ConvergencePlot* other : row_) widen(other->reach(), true);
  for (const ConvergencePlot* other : all_) widen(other->reach(), false);
  if (!wanted) return replot();
  plot_->yAxis->setRange(wanted->low, wanted->high);
  plot_->xAxis->setRange(wanted->left, wanted->right);
  replot();
}

const ConvergencePlot::Sample* ConvergencePlot::sample_at(const QPointF& position) const {
  if (!plot_->axisRect()->rect().contains(position.toPoint())) return nullptr;
  const double x = plot_->xAxis->pixelToCoord(position.x());
  const Sample* best = nullptr;
  for (const Sample& sample : samples_)
    if (!best || std::abs(sample.count - x) < std::abs(best->count - x)) best = &sample;
  return best;
}

QString ConvergencePlot::text_at(const QPointF& position) {
  const Sample* sample = sample_at(position);
  emit observation_hovered(sample ? sample->observation : no_observation);
  if (!sample) return {};
  const double factor = factor_;
  QStringList parts;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto sigma = sample->sigma[i] > 0 ? std::optional(sample->sigma[i] * factor) : std::nullopt;
    parts += names_[i] + QLatin1Char(' ') + with_sigma_text(sample->value[i] * factor, sigma);
  }
  return QObject::tr("after %1 (obs %2): %3 %4")
      .arg(sample->count)
      .arg(sample->observation)
      .arg(parts.join(QStringLiteral(", ")), unit_);
}

void ConvergencePlot::clicked_at(const QPointF& position, Qt::KeyboardModifiers) {
  if (const Sample* sample = sample_at(position)) emit observation_selected(sample->observation);
}

std::vector<PlotColumn> ConvergencePlot::columns() const {
  std::vector<PlotColumn> all(8);
  all[0].name = QObject::tr("observations");
  all[1].name = QObject::tr("observation id");
  for (std::size_t i = 0; i < 3; ++i) {
    all[2 + i].name = QStringLiteral("%1 (%2)").arg(names_[i], unit_);
    all[5 + i].name = QObject::tr("sigma of %1 (%2)").arg(names_[i], unit_);
  }
  for (const Sample& sample : samples_) {
    all[0].values.push_back(sample.count);
    all[1].values.push_back(static_cast<double>(sample.observation));
    for (std::size_t i = 0; i < 3; ++i) {
      all[2 + i].values.push_back(sample.value[i] * factor_);
      all[5 + i].values.push_back(sample.sigma[i] * factor_);
    }
  }
  return all;
}

}  // namespace handsight::widgets
