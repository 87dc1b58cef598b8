// SPDX-License-Identifier: GPL-3.0-or-later
#include "findings/pattern_plots.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "diagnosis/residuals/trend.h"
#include "document/curve_words.h"
#include "document/effect_words.h"
#include "widgets/base/number_text.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

struct Found {
  std::size_t series = 0, variable = 0;
};

std::optional<Found> find(const PlotKey& key, const ResidualViews& views) {
  const auto series = std::find_if(views.series.begin(), views.series.end(),
                                   [&](const ResidualSeries& s) { return s.name == key.residual; });
  const auto variable = std::find_if(views.variables.begin(), views.variables.end(),
                                     [&](const Variable& v) { return v.name == key.variable; });
  if (series == views.series.end() || variable == views.variables.end()) return std::nullopt;
  return Found{static_cast<std::size_t>(series - views.series.begin()),
               static_cast<std::size_t>(variable - views.variables.begin())};
}

double root_mean_square(const Eigen::VectorXd& v) {
  return v.size() ? std::sqrt(v.squaredNorm() / static_cast<double>(v.size())) : 0;
}

double median_of(const Eigen::VectorXd& v) { return median({v.data(), v.data() + v.size()}); }

/// Time and the order of the observations, two angles that a mimic joint ties: plots against them are the same picture.
bool tell_the_same(const Variable& a, const Variable& b) {
  if (a.values.size() != b.values.size() || a.values.size() < 3) return false;
  const Eigen::ArrayXd x = a.values.array() - a.values.mean(), y = b.values.array() - b.values.mean();
  return std::abs((x * y).sum()) > 0.999 * std::sqrt(x.square().sum() * y.square().sum());
}

/// Values of a series as they are shown.
struct ShownSeries {
  Eigen::VectorXd values;
  double noise = 1;
  QString unit;
};

ShownSeries shown_series(const ResidualSeries& series, const Eigen::VectorXd& values, widgets::SizeUnit unit) {
  if (unit == widgets::SizeUnit::sigma && (series.sigmas.array() > 0).all())
    return {values.cwiseQuotient(series.sigmas), 1, widgets::unit_name(unit)};
  const ShownUnit own = shown_unit(series.unit);
  return {own.scale * values, own.scale * root_mean_square(series.sigmas), own.unit};
}

/// Null where there is none or the observation shows no markers.
const InspectionRow* row_at(const PlottedSession& of, int index) {
  if (!of.inspection || static_cast<std::size_t>(index) >= of.inspection->rows.size()) return nullptr;
  const InspectionRow& row = of.inspection->rows[static_cast<std::size_t>(index)];
  return row.markers.empty() ? nullptr : &row;
}

std::vector<widgets::TrendPoint> shown_trend(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  std::vector<widgets::TrendPoint> line;
  if (x.size() == 0) return line;
  std::vector<double> places(x.begin(), x.end());
  std::sort(places.begin(), places.end());
  const double near = 0.05 * (places.back() - places.front());
  // Between points that are far apart the curve is a guess: it goes straight from one to the other there.
  const auto is_near_one = [&](double at) {
    const auto after = std::lower_bound(places.begin(), places.end(), at);
    return (after != places.end() && *after - at <= near) || (after != places.begin() && at - *(after - 1) <= near);
  };
  for (const TrendPoint& p : compute_trend(x, y))
    if (is_near_one(p.x)) line.push_back({p.x, p.y, p.low, p.high});
  return line;
}

}  // namespace

std::vector<PlotKey> strongest_plots(const ModelResiduals& residuals) {
  constexpr std::ptrdiff_t most_of_a_series = 3;  // nine plots of one joint's error say less than three of each
  std::vector<PlotKey> keys;
  std::vector<std::size_t> variables, series;
  for (const Pattern& p : residuals.patterns) {
    if (keys.size() == widgets::PatternPage::plot_count) break;
    const auto is_same = [&](std::size_t other) {
      return tell_the_same(residuals.views.variables[other], residuals.views.variables[p.variable]);
    };
    if (std::any_of(variables.begin(), variables.end(), is_same) ||
        std::count(series.begin(), series.end(), p.series) >= most_of_a_series)
      continue;
    variables.push_back(p.variable);
    series.push_back(p.series);
    keys.push_back({residuals.views.series[p.series].name, residuals.views.variables[p.variable].name});
  }
  return keys;
}

std::optional<widgets::PatternPlot> pattern_plot(const PlotKey& key, const ModelResiduals& residuals,
                                                 const Workbench& workbench,
                                                 const std::vector<Eigen::VectorXd>* values) {
  auto plot = pattern_plot(
      key, residuals,
      PlottedSession{workbench.document.session(), values ? nullptr : workbench.inspection(), workbench.units.unit()},
      values);
  if (plot) workbench.sessions.apply(plot->points);
  return plot;
}

std::optional<widgets::PatternPlot> pattern_plot(const PlotKey& key, const ModelResiduals& residuals,
                                                 const PlottedSession& of, const std::vector<Eigen::VectorXd>* values) {
  const ResidualViews& v = residuals.views;
  const auto found = find(key, v);
  if (!found) return std::nullopt;
  const ResidualSeries& series = v.series[found->series];
  const Variable& variable = v.variables[found->variable];
  const ShownSeries shown = shown_series(series, values ? (*values)[found->series] : series.values, of.unit);
  const Eigen::VectorXd& y = shown.values;
  widgets::PatternPlot plot;
  plot.id = QString::fromStdString(key.residual + " / " + key.variable);
  plot.what = translated(series.name);
  plot.against = translated(variable.name);
  if (variable.unit != "number") plot.x_unit = QString::fromStdString(variable.unit);  // an order has no unit
  plot.y_unit = shown.unit;
  constexpr double weak = 2.5;
  const double usual = median_of(series.sigmas);
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const ProblemObservation& o = v.problem.observations[static_cast<std::size_t>(i)];
    const std::int64_t id = id_at(of.session, o.index);
    const InspectionRow* row = row_at(of, o.index);
    plot.points.push_back({.observation = id,
                           .x = variable.values[i],
                           .y = y[i],
                           .rms_over_sigma = row ? row->ratio : std::nullopt,
                           .coordinates = row && row->coordinates > 0 ? row->coordinates : 12,
                           .is_weak = series.sigmas[i] > weak * usual});
  }
  plot.trend = shown_trend(variable.values, y);
  plot.noise = shown.noise;
  for (const Pattern& p : residuals.patterns)
    if (p.series == found->series && p.variable == found->variable) {
      plot.strength = p.strength;
      plot.is_chance = p.p_value > 1e-3;
    }
  return plot;
}

QString as_if_alone(const PlotKey& key, const Repeatability& repeatability) {
  constexpr std::string_view compute_error = "error of ";
  if (repeatability.joints <= 0 || !key.residual.starts_with(compute_error)) return {};
  return QObject::tr(
             "Each point: as if %1 alone had made the whole error. It is more than the %2 mrad to which the joints "
             "repeat, for all of them had their share.")
      .arg(QString::fromStdString(key.residual.substr(compute_error.size())),
           widgets::short_text(1e3 * repeatability.joints));
}

std::vector<widgets::TrendPoint> predicted_trend(const PlotKey& key, const ModelResiduals& residuals,
                                                 const EffectView& view, const Eigen::VectorXd& numbers,
                                                 widgets::SizeUnit unit) {
  const auto found = find(key, residuals.views);
  if (!found || found->series >= view.series.size()) return {};
  const Eigen::VectorXd& x = residuals.views.variables[found->variable].values;
  if (view.series[found->series].rows() != x.size()) return {};  // of a version with other observations
  const ShownSeries shown =
      shown_series(residuals.views.series[found->series], view.series[found->series] * numbers, unit);
  std::vector<widgets::TrendPoint> line = shown_trend(x, shown.values);
  for (widgets::TrendPoint& p : line) p.low = p.high = p.y;
  return line;
}

bool shows_there(const PlotKey& key, const ModelResiduals& residuals, const Diagnosing& diagnosing,
                 const std::string& id) {
  constexpr double most_of_it = 0.5;
  const auto found = find(key, residuals.views);
  const auto view = diagnosing.find_view(id);
  if (!found || !view) return false;
  const Eigen::VectorXd& x = residuals.views.variables[found->variable].values;
  // Where an earlier version is shown, the views are of another one, maybe of other observations.
  if (found->series >= view->effect.series.size() || view->effect.series[found->series].rows() != x.size())
    return false;
  const Eigen::VectorXd y = view->effect.series[found->series] * view->numbers;
  const double noise = root_mean_square(residuals.views.series[found->series].sigmas);
  return root_mean_square(y) >= noise && followed_share(x, y) > most_of_it;
}

bool follows_by_chance(const ModelResiduals& residuals) {
  return residuals.patterns.empty() || residuals.patterns.front().p_value > 1e-3;
}

std::unordered_map<std::int64_t, double> predicted_ratios(const ModelResiduals& residuals, const EffectView& view,
                                                          const Eigen::VectorXd& numbers, const Session& session) {
  const ResidualViews& v = residuals.views;
  const Eigen::VectorXd change = view.corners * numbers;
  std::vector<double> squares(v.problem.observations.size(), 0);
  std::vector<int> rows(v.problem.observations.size(), 0);
  for (std::size_t c = 0; c < v.corners.size(); ++c) {
    const auto place = static_cast<std::size_t>(v.corners[c].place);
    squares[place] += (v.corners[c].residual - change.segment<2>(static_cast<Eigen::Index>(2 * c))).squaredNorm();
    rows[place] += 2;
  }
  std::unordered_map<std::int64_t, double> ratios;
  for (std::size_t i = 0; i < squares.size(); ++i)
    if (rows[i] > 0)
      ratios[id_at(session, v.problem.observations[i].index)] = std::sqrt(squares[i] / rows[i]) / v.noise_model.noise;
  return ratios;
}

}  // namespace handsight::app
