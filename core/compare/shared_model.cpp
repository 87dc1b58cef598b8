// SPDX-License-Identifier: Apache-2.0
#include "compare/shared_model.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <map>

#include "base/error.h"
#include "compare/change_normal.h"
#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/noise_model.h"

namespace handsight {
namespace {

/// Of the model's own shared numbers these move what a change of the markers would, or come at one moment.
bool may_be_shared(const Effect& effect) {
  if (effect.scope == EffectScope::marker || effect.id == "body_slip" || effect.is_unnamed()) return false;
  return std::none_of(effect.parameters.begin(), effect.parameters.end(),
                      [](const EffectParameter& p) { return p.is_choice; });
}

}  // namespace

ComparedSide make_side(const Fit& f) {
  const NoiseModel w = noise_model(f);
  const bool is_estimated = f.noise_estimate && w.noise == f.noise_estimate->sigma;
  return {f.problem, 1 / w.noise, is_estimated ? f.noise_estimate->degrees : 0.0};
}

std::vector<EffectTerm> lacking_effects(const Problem& model) {
  std::vector<EffectTerm> terms;
  const auto offer = [&](const Effect& effect, const std::shared_ptr<const Effect>& own) {
    if (!may_be_shared(effect)) return;
    for (const int place : effect_places(effect, model.source->chain))
      if (std::none_of(model.terms.begin(), model.terms.end(),
                       [&](const EffectTerm& t) { return t.id == effect.id && t.place == place; }))
        terms.push_back(term_of(effect, place, own));
  };
  for (const Effect* effect : catalogue_beside(model.source->own_effects)) offer(*effect, nullptr);
  for (const std::shared_ptr<const Effect>& own : model.source->own_effects) offer(*own, own);
  return terms;
}

Problem with_lacking(Problem problem, const std::vector<EffectTerm>& terms) {
  problem.with_motions = true;  // the curves read how joints move the hand
  return std::move(list_candidates(problem, terms).problem);
}

namespace {

Eigen::Index effects_first(const ComparedSides& sides) {
  const Problem& p = sides.after.problem;
  return sides.known ? 6 + p.effect_column() - p.mount_column() : p.effect_column();
}

double scale_at(const Eigen::VectorXd& scales, Eigen::Index i) { return scales.size() > i ? scales[i] : 1.0; }

/// Of what is lacking, those of one name.
std::vector<SizeGroup> effect_groups(const ComparedSides& sides) {
  const Problem& p = sides.after.problem;
  std::map<NumberName, std::vector<Eigen::Index>> columns;
  for (Eigen::Index c = sides.reported_effects; c < p.effect_count(); ++c) {
    const EffectColumn& column = p.columns_of_effects[static_cast<std::size_t>(c)];
    columns[{p.terms[column.term].id, column.parameter}].push_back(c);
  }
  return size_groups(columns);
}

}  // namespace

std::vector<SizeGroup> size_groups(const std::map<NumberName, std::vector<Eigen::Index>>& columns) {
  std::vector<SizeGroup> all;
  for (const auto& [name, of_it] : columns) all.push_back({of_it});
  return all;
}

void add_groups(const std::vector<SharedCurve>& curves, Eigen::Index first, std::vector<SizeGroup>& all) {
  for (const SharedCurve& c : curves) {
    SizeGroup& group = all.emplace_back();
    for (Eigen::Index i = 0; i < c.columns(); ++i) group.columns.push_back(first++);
  }
}

namespace {

/// Values and variances in prior sigmas.
void learn_scales(const std::vector<SizeGroup>& groups, const Eigen::VectorXd& values, const Eigen::VectorXd& variances,
                  Eigen::VectorXd& scales) {
  for (const SizeGroup& group : groups) {
    double squares = 1, settled = 1;  // as if one number of the prior sigma had been seen
    for (const Eigen::Index c : group.columns) {
      squares += values[c] * values[c];
      settled += std::clamp(1 - variances[c] / (scales[c] * scales[c]), 0.0, 1.0);
    }
    for (const Eigen::Index c : group.columns) scales[c] = std::clamp(std::sqrt(squares / settled), 0.03, 30.0);
  }
}

/// Effects' numbers in units of their prior sigmas.
Eigen::VectorXd in_sizes(const Problem& p, const Eigen::VectorXd& effects, Eigen::Index count) {
  Eigen::VectorXd values(count);
  for (Eigen::Index c = 0; c < count; ++c)
    values[c] = effects[c] / p.columns_of_effects[static_cast<std::size_t>(c)].sigma;
  return values;
}

}  // namespace

ComparedSides widened(const ComparedSides& sides, Width width) {
  ComparedSides wide = sides;
  if (width == Width::reported || !sides.before) return wide;
  const std::vector<EffectTerm> terms = lacking_effects(sides.after.problem);
  wide.reported_effects = sides.after.problem.effect_count();
  wide.before->problem = with_lacking(sides.before->problem, terms);
  wide.after.problem = with_lacking(sides.after.problem, terms);
  const Eigen::Index count = wide.after.problem.effect_count();
  Eigen::VectorXd values = Eigen::VectorXd::Zero(count);
  values.head(wide.reported_effects) = sides.start.effects.head(wide.reported_effects);
  wide.start.effects = values;
  wide.effect_scales = Eigen::VectorXd::Ones(count);
  if (width == Width::catalogue_and_curves) wide.curves = shared_curves({&sides.before->problem, &sides.after.problem});
  wide.curve_scales = Eigen::VectorXd::Ones(column_count(wide.curves));
  return wide;
}

void keep_going(const std::function<bool(double share)>& progress, double share) {
  if (progress && !progress(share)) throw InputError("The comparison was stopped.");
}

Eigen::Index shared_columns(const ComparedSides& sides) {
  return effects_first(sides) + sides.after.problem.effect_count() + column_count(sides.curves);
}

SharedState make_start(const ComparedSides& sides) {
  return {sides.start, Eigen::VectorXd::Zero(column_count(sides.curves)), Eigen::VectorXd::Zero(shared_columns(sides))};
}

SharedState moved_by(const ComparedSides& sides, const SharedState& from, const Eigen::VectorXd& step) {
  const Problem& p = sides.after.problem;
  SharedState to{from.unknowns, from.curves, from.moved + step};
  Unknowns& next = to.unknowns;
  Eigen::Index at = 0;
  if (sides.known) {
    const Rigid motion = small_motion<double>(Vector6(step.head<6>()));
    for (Vector3& m : next.markers_in_tcp) m = motion * m;
    at = 6;
  } else {
    for (Vector3& m : next.markers_in_tcp) {
      m += step.segment<3>(at);
      at += 3;
    }
  }
  if (p.mount_is_estimated) {
    next.mount_from_sensor = from.unknowns.mount_from_sensor * small_motion<double>(Vector6(step.segment<6>(at)));
    at += 6;
  }
  for (Eigen::Index c = 0; c < p.effect_count(); ++c)
    next.effects[c] += step[at + c] * p.columns_of_effects[static_cast<std::size_t>(c)].sigma;
  to.curves += step.tail(to.curves.size());
  return to;
}

void add_priors(const ComparedSides& sides, const SharedState& s, const Eigen::VectorXd& change, double change_scale,
                ScatteredNormal& n) {
  const Eigen::Index base = shared_columns(sides), effects = sides.after.problem.effect_count();
  const Eigen::Index first = effects_first(sides);
  if (!sides.known) {
    const Eigen::VectorXd values = in_sizes(sides.after.problem, s.unknowns.effects, effects);
    for (Eigen::Index c = 0; c < effects; ++c) add_prior(n, first + c, values[c], scale_at(sides.effect_scales, c));
    for (Eigen::Index c = 0; c < s.curves.size(); ++c)
      add_prior(n, first + effects + c, s.curves[c], scale_at(sides.curve_scales, c));
  }
  for (Eigen::Index c = 0; c < n.gradient.size() - base; ++c) add_prior(n, base + c, change[c], change_scale);
  if (sides.known) {
    n.information.topLeftCorner(base, base) += *sides.known;
    n.gradient.head(base) -= *sides.known * s.moved;
    n.squares += s.moved.dot(*sides.known * s.moved);
  }
  stiffen(n);
}

void learn_sizes(ComparedSides& sides, const SharedState& state, const ScatteredNormal& n) {
  if (sides.reported_effects < 0) return;
  const Eigen::Index effects = sides.after.problem.effect_count();
  std::vector<SizeGroup> of_curves;
  add_groups(sides.curves, 0, of_curves);
  learn_scales({effects_first(sides), in_sizes(sides.after.problem, state.unknowns.effects, effects), state.curves}, n,
               effect_groups(sides), of_curves, sides.effect_scales, sides.curve_scales);
}

void learn_scales(const SizedValues& at, const ScatteredNormal& n, const std::vector<SizeGroup>& of_effects,
                  const std::vector<SizeGroup>& of_curves, Eigen::VectorXd& effect_scales,
                  Eigen::VectorXd& curve_scales) {
  const Eigen::LDLT<Eigen::MatrixXd> solver(n.information);
  const Eigen::VectorXd step = solver.solve(n.gradient);
  const Eigen::VectorXd variances = solver.solve(Eigen::MatrixXd::Identity(step.size(), step.size())).diagonal().eval();
  const Eigen::Index effects = at.effects.size(), curves = at.curves.size();
  learn_scales(of_effects, at.effects + step.segment(at.first_effect, effects),
               variances.segment(at.first_effect, effects), effect_scales);
  learn_scales(of_curves, at.curves + step.segment(at.first_effect + effects, curves),
               variances.segment(at.first_effect + effects, curves), curve_scales);
}

double settled_parameters(const ScatteredNormal& with_priors, const Eigen::MatrixXd& information) {
  return with_priors.information.ldlt().solve(information).trace();
}

}  // namespace handsight
