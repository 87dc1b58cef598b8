// SPDX-License-Identifier: GPL-3.0-or-later
// What if: an effect of any size, at any of its places, on the session's own poses.
#include "document/effect_words.h"
#include "explain/explain_workspace.h"
#include "explain/failing_pane.h"
#include "widgets/explain/what_if_slider.h"
#include "workbench/touch_views.h"

namespace handsight::app {

void ExplainWorkspace::open_what_if(const QString& id, int place) {
  const Effect* effect = find_effect(id.toStdString());
  const auto residuals = workbench_.diagnosing.residuals();
  if (!effect || !residuals || adding_.is_running()) return;
  const Session& session = workbench_.document.session();
  if (place < 0 || what_if_id_ != effect->id) {
    what_if_id_ = effect->id;
    what_if_places_ = effect_terms(effect->id, residuals->views.problem.source->chain);
    what_if_parameter_ = 0;
    place = 0;
    // Where the diagnosis would put it, its choices too.
    if (const auto d = workbench_.diagnosing.diagnosis())
      for (const DiagnosisCandidate& c : d->candidates)
        if (c.id == effect->id && !c.terms.empty())
          for (std::size_t i = 0; i < what_if_places_.size(); ++i)
            for (const EffectTerm& term : c.terms)
              if (term.place == what_if_places_[i].place) {
                for (std::size_t p = 0; p < term.values.size(); ++p)
                  if (effect->parameters[p].is_choice) what_if_places_[i].values[p] = term.values[p];
                if (term.place == c.terms.front().place) place = static_cast<int>(i);
              }
  }
  what_if_place_ = place;
  what_if_view_.effect = effect_view(residuals->views, {what_if_places_[static_cast<std::size_t>(place)]});
  what_if_view_.numbers = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(what_if_view_.effect.numbers.size()));
  widgets::WhatIfState state{.id = id, .title = effect_text(effect->id, {})};
  for (const EffectTerm& term : what_if_places_)
    if (const std::string name = place_name(*effect, term.place, session.robot); !name.empty())
      state.places.push_back(place_text(name));
  state.place = place;
  for (std::size_t i = 0; i < what_if_view_.effect.numbers.size(); ++i) {
    const EffectParameter& p = effect->parameters[what_if_view_.effect.numbers[i].parameter];
    const ShownUnit unit = shown_unit(p.unit);
    const auto at = static_cast<Eigen::Index>(i);
    state.parameters.push_back({.name = number_title(p.name),
                                .unit = unit.unit,
                                .plausible = unit.scale * p.sigma,
                                .best = unit.scale * what_if_view_.effect.best[at],
                                .best_sigma = unit.scale * what_if_view_.effect.best_sigma[at],
                                .value = unit.scale * p.sigma});
  }
  if (state.parameters.empty()) return;
  what_if_parameter_ = std::min(what_if_parameter_, static_cast<int>(state.parameters.size()) - 1);
  state.parameter = what_if_parameter_;
  const double value = state.parameters[static_cast<std::size_t>(what_if_parameter_)].value;
  failing_->what_if()->set_state(std::move(state));
  failing_->what_if()->show();
  slide_what_if(value);
}

/// The same slider over other residuals: the view of the effect belongs to those that it was made of.
void ExplainWorkspace::renew_what_if() {
  if (!failing_->what_if()->isVisibleTo(this) || !workbench_.diagnosing.residuals() || adding_.is_running()) return;
  const double value = failing_->what_if()->value();
  open_what_if(QString::fromStdString(what_if_id_), what_if_place_);
  failing_->what_if()->set_value(value);
  slide_what_if(value);
}

void ExplainWorkspace::slide_what_if(double value) {
  if (!workbench_.diagnosing.residuals() || what_if_view_.effect.numbers.empty()) return;
  const Effect& effect = *find_effect(what_if_id_);
  const auto at = static_cast<std::size_t>(what_if_parameter_);
  const double scale = shown_unit(effect.parameters[what_if_view_.effect.numbers[at].parameter].unit).scale;
  what_if_view_.numbers[static_cast<Eigen::Index>(at)] = value / scale;
  try_numbers(what_if_view_, what_if_view_.numbers, effect_text(what_if_id_, {}));
  const ResidualViews& views = workbench_.diagnosing.residuals()->views;
  const double left = rms_left(views, what_if_view_.effect, what_if_view_.numbers);
  ResidualSize reported = size_of_error(left, !workbench_.document.session().is_tracker(), views.noise_model.noise);
  if (const ModelVersionPointer now = workbench_.document.shown_model()) reported = as_read(reported, *now);
  failing_->what_if()->set_answer(tr("With this the error would be %1.").arg(workbench_.units.text(reported)));
}

}  // namespace handsight::app
