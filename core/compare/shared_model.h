// SPDX-License-Identifier: Apache-2.0
// The model that both sides of a comparison share: its problem, what is known of it beforehand, and how prior sigmas
// are learnt from what both sides measured. Internal to comparison.cpp.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/change_rows.h"
#include "estimation/fit/fit_result.h"

namespace handsight {

struct ComparedSide {
  Problem problem;
  double weight = 1;         // of its rows: the noise's inverse
  double noise_degrees = 0;  // of freedom that the noise was estimated from; 0: declared
};

/// A session that was fitted by itself.
ComparedSide make_side(const Fit& fit);

struct ComparedSides {
  std::optional<ComparedSide> before;  // absent: what is known of it is `known`
  ComparedSide after;
  Unknowns start;
  /// Without a first side: the precision of the shared unknowns about `start`, by the columns xi of the markers
  /// together (m, rad, TCP frame), mount where it is estimated, effects in units of their prior sigma.
  std::optional<Eigen::MatrixXd> known;
  Matrix6 repeatability = Matrix6::Zero();  // of the body in the sensor's frame; with a first side it is found
  /// What the model may lack on both sides alike is fitted beside it.
  Eigen::Index reported_effects = -1;  // effect columns of the model itself; those after it are lacking. -1: all
  std::vector<SharedCurve> curves;     // none: only effects are lacking
  Eigen::VectorXd effect_scales, curve_scales;  // sizes by the plausible ones; empty: 1
  std::function<bool(double share)> progress;   // ComparisonProgress; empty: nobody listens
};

/// Tells how far a comparison is; InputError where it is to stop.
void keep_going(const std::function<bool(double share)>& progress, double share = 0);

/// How much wider than its own model a comparison is.
enum class Width { reported, catalogue, catalogue_and_curves };

/// The same sides with everything of the catalogue in both that may be there, at 0, and smooth curves.
ComparedSides widened(const ComparedSides& sides, Width width);

/// Everything of the catalogue, and of the session's own, that sides may share and that is not in the model yet.
std::vector<EffectTerm> lacking_effects(const Problem& model);

/// The problem with these terms behind its own, and with what curves read.
Problem with_lacking(Problem problem, const std::vector<EffectTerm>& terms);

Eigen::Index shared_columns(const ComparedSides& sides);

/// At the start, nothing moved.
SharedState make_start(const ComparedSides& sides);

/// Where the shared unknowns go by a step of their columns.
SharedState moved_by(const ComparedSides& sides, const SharedState& from, const Eigen::VectorXd& step);

/// Adds what is known beforehand: the effects' and curves' prior sigmas, the changes' at `change_scale` times
/// theirs, the body.
void add_priors(const ComparedSides& sides, const SharedState& state, const Eigen::VectorXd& change,
                double change_scale, ScatteredNormal& normal);

/// Sizes of what is lacking, one for each effect's parameter over all its places and one for each curve, made as large
/// as the data have them (MacKay 1992), drawn to the plausible ones. `normal`: with priors, changes included.
void learn_sizes(ComparedSides& sides, const SharedState& state, const ScatteredNormal& normal);

/// Columns that have one size in common; places in the scales.
struct SizeGroup {
  std::vector<Eigen::Index> columns;
};

/// An effect's id and which of its numbers.
using NumberName = std::pair<std::string, std::size_t>;
std::vector<SizeGroup> size_groups(const std::map<NumberName, std::vector<Eigen::Index>>& columns);

/// Each curve is a group; its columns begin at `first`.
void add_groups(const std::vector<SharedCurve>& curves, Eigen::Index first, std::vector<SizeGroup>& groups);

/// Where effects and curves stand, in prior sigmas, and where their columns begin: effects, then curves.
struct SizedValues {
  Eigen::Index first_effect = 0;
  Eigen::VectorXd effects, curves;
};

/// learn_sizes of these groups.
void learn_scales(const SizedValues& at, const ScatteredNormal& normal, const std::vector<SizeGroup>& of_effects,
                  const std::vector<SizeGroup>& of_curves, Eigen::VectorXd& effect_scales,
                  Eigen::VectorXd& curve_scales);

/// How many parameters the data settle, of all columns.
double settled_parameters(const ScatteredNormal& with_priors, const Eigen::MatrixXd& information);

}  // namespace handsight
