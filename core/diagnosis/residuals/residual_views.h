// SPDX-License-Identifier: Apache-2.0
// What a fitted model leaves, as a user looks at it: motions of the body along axes and errors of joints, the corners'
// residuals in the images, and how both would look with noise alone or with an effect of any size.
#pragma once

#include "diagnosis/evidence/noise_model.h"
#include "diagnosis/residuals/patterns.h"

namespace handsight {

/// One corner's residual, measured - predicted: px; of a tracker's point its x and y in the tracker's frame, m.
struct CornerResidual {
  int place = 0;  // into ResidualViews::problem.observations
  int marker = 0;
  int camera = 0;  // of the rig; by_tracker
  Vector2 residual;
};

struct ResidualViews {
  Problem problem;  // the model's, with motions
  Unknowns unknowns;
  NoiseModel noise_model;
  LinearModel model;                   // no candidates
  std::vector<Variable> variables;     // what residuals may follow
  std::vector<ResidualAxis> axes;      // one for each series
  std::vector<ResidualSeries> series;  // measured
  std::vector<CornerResidual> corners;
  double degrees = 1;  // rows less unknowns
  int fitted = 0;      // observations that the model was fitted to: those of `problem`, or more
};

ResidualViews residual_views(const Fit& model);

/// So many of a problem's observations, evenly over the session, the first and the last among them; all where there are
/// no more. `most` is 2 at least.
std::vector<ProblemObservation> evenly(std::vector<ProblemObservation> all, std::size_t most);

/// What all observations of a long session would show, in a part of the memory: of more than `most` by so many of them,
/// taken `evenly`. Where the model's problem holds only some already, `fitted` says to how many it was fitted.
ResidualViews residual_views(const Fit& model, std::size_t most, std::size_t fitted = 0);

/// Every corner at other unknowns than those the problem stands at, to first order in the effects' numbers.
std::vector<CornerResidual> corner_residuals(const Problem& problem, const Unknowns& unknowns);

/// The series as they would look if only noise were left: a new draw for each seed. Per series, as
/// ResidualSeries::values.
std::vector<Eigen::VectorXd> noise_alone(const ResidualViews& views, std::uint64_t seed);

/// One number of an effect that is looked at.
struct EffectNumber {
  std::size_t term = 0;       // into EffectView::terms
  std::size_t parameter = 0;  // of the effect
  double plausible = 0;       // the prior sigma, in the number's unit
};

/// What effects would do to the residuals of this model on these poses once TCP->Body, markers, mount and the model's
/// own effects have taken up what they can. Linear: everything is per unit of the numbers.
struct EffectView {
  std::vector<EffectTerm> terms;
  std::vector<EffectNumber> numbers;
  std::vector<Eigen::MatrixXd> series;  // per series: observations x numbers
  Eigen::MatrixXd corners;              // (2 corners) x numbers
  Eigen::VectorXd best, best_sigma;     // the numbers that fit best, with the prior sigmas as priors
  Eigen::MatrixXd information;          // of the numbers; squares in units of the noise
  Eigen::VectorXd gradient;
  double squares = 0;  // of the model as it is
};

/// The choices of `terms` count, their numbers do not.
EffectView effect_view(const ResidualViews& views, const std::vector<EffectTerm>& terms);

/// The numbers of the terms as they stand, in the order of EffectView::numbers.
Eigen::VectorXd list_numbers(const EffectView& view, const std::vector<EffectTerm>& terms);

/// The rms error as it is reported (as_reported; px or m) that would be left if the effects had these numbers and were
/// in the model.
double rms_left(const ResidualViews& views, const EffectView& view, const Eigen::VectorXd& numbers);

}  // namespace handsight
