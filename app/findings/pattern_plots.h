// SPDX-License-Identifier: GPL-3.0-or-later
// "Where it fails" as data for plots: which residual against what, points, trends, predictions.
#pragma once

#include "widgets/explain/pattern_page.h"
#include "workbench/workbench.h"

namespace handsight::app {

/// A residual against a variable, by their names, so that it means the same in every version of the model.
struct PlotKey {
  std::string residual, variable;
  auto operator<=>(const PlotKey&) const = default;  // NOLINT(modernize-use-nullptr): what compilers make of it
};

/// Whose residuals are plotted, and in which unit.
struct PlottedSession {
  const Session& session;
  const Inspection* inspection = nullptr;  // for the points' colours; null: none
  widgets::SizeUnit unit = widgets::SizeUnit::pixel;
};

/// Up to nine, most structured first, each against another variable.
std::vector<PlotKey> strongest_plots(const ModelResiduals& residuals);

/// The plot of a key; nothing where these residuals do not have it. `values` (per series) stand in for the measured
/// ones: noise alone. Points have the colours of the window's observations. A series has a unit of its own (mm of a
/// body, mrad of a joint), in which it is reported; in sigma each point is over its own.
std::optional<widgets::PatternPlot> pattern_plot(const PlotKey& key, const ModelResiduals& residuals,
                                                 const Workbench& workbench,
                                                 const std::vector<Eigen::VectorXd>* values = nullptr);

std::optional<widgets::PatternPlot> pattern_plot(const PlotKey& key, const ModelResiduals& residuals,
                                                 const PlottedSession& of,
                                                 const std::vector<Eigen::VectorXd>* values = nullptr);

/// Where all joints scatter, the whole error told as one joint's alone is more than that joint scatters: what to say
/// beside such a plot; empty for any other.
QString as_if_alone(const PlotKey& key, const Repeatability& repeatability);

/// What a candidate with these numbers would show there; empty where the plot is not known.
std::vector<widgets::TrendPoint> predicted_trend(const PlotKey& key, const ModelResiduals& residuals,
                                                 const EffectView& view, const Eigen::VectorXd& numbers,
                                                 widgets::SizeUnit unit);

/// Does the candidate of this find_id show there: more than the noise, and most of it follows the variable?
bool shows_there(const PlotKey& key, const ModelResiduals& residuals, const Diagnosing& diagnosing,
                 const std::string& id);

/// Do these residuals follow nothing beyond what chance would show?
bool follows_by_chance(const ModelResiduals& residuals);

/// rms of one coordinate over the noise that each observation (by id) would have with a candidate of these numbers.
std::unordered_map<std::int64_t, double> predicted_ratios(const ModelResiduals& residuals, const EffectView& view,
                                                          const Eigen::VectorXd& numbers, const Session& session);

}  // namespace handsight::app
