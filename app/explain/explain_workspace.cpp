// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/explain_workspace.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QHideEvent>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "document/curve_words.h"
#include "document/effect_words.h"
#include "explain/failing_pane.h"
#include "explain/missing_pane.h"
#include "explain/poses_pane.h"
#include "explain/watching_pane.h"
#include "widgets/base/number_text.h"
#include "widgets/explain/candidate_list.h"
#include "widgets/explain/verdict_line.h"
#include "widgets/explain/what_if_slider.h"
#include "workbench/touch_views.h"

namespace handsight::app {
ExplainWorkspace::ExplainWorkspace(Workbench& workbench, QWidget* parent)
    : Workspace(workbench, parent), adding_(workbench) {
  setObjectName("explain");
  make_layout();
  connect_panes();
  connect_workbench();
  blink_.setInterval(500);
  connect(&blink_, &QTimer::timeout, this, &ExplainWorkspace::blink);
  qApp->installEventFilter(this);
}

void ExplainWorkspace::make_layout() {
  verdict_ = new widgets::VerdictLine(this);
  verdict_->setObjectName("verdict");
  auto* tour = new QToolButton(this);
  tour->setObjectName("start_tour");
  tour->setText(tr("Tour"));
  tour->setToolTip(tr("Find the missing effect: shows step by step what to look at and what to do"));
  tour->setAutoRaise(true);
  connect(tour, &QToolButton::clicked, this, &ExplainWorkspace::start_tour);
  failing_ = new FailingPane(workbench_, this);
  missing_ = new MissingPane(workbench_, adding_, this);
  watching_ = new WatchingPane(workbench_, adding_, this);
  auto* columns = new QSplitter(Qt::Horizontal, this);
  // The slider takes its room from the cards, which scroll: the plots are what one looks at while it moves.
  auto* right = new QWidget(this);
  auto* right_column = new QVBoxLayout(right);
  right_column->setContentsMargins(0, 0, 0, 0);
  right_column->setSpacing(4);
  right_column->addWidget(failing_->what_if());
  right_column->addWidget(missing_, 1);
  columns->addWidget(failing_);
  columns->addWidget(right);
  columns->setStretchFactor(0, 56);
  columns->setStretchFactor(1, 44);
  columns->setSizes({592, 464});
  columns->setChildrenCollapsible(false);
  auto* rows = new QSplitter(Qt::Vertical, this);
  rows->addWidget(columns);
  rows->addWidget(watching_);
  rows->setStretchFactor(0, 3);  // on a large screen the robot grows too
  rows->setStretchFactor(1, 1);
  rows->setSizes({440, 210});
  rows->setChildrenCollapsible(false);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(0, 0, 0, 0);
  head->addWidget(verdict_, 1);
  head->addWidget(tour, 0, Qt::AlignVCenter);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->setSpacing(4);
  layout->addLayout(head);
  layout->addWidget(rows, 1);
}

void ExplainWorkspace::connect_panes() {
  connect(verdict_, &widgets::VerdictLine::attribution_clicked, this,
          [this] { emit workbench_.workspace_requested(Place::inspect); });
  connect(missing_, &MissingPane::tried, this, &ExplainWorkspace::try_candidate);
  connect(missing_, &MissingPane::what_if, this, [this](const QString& id) { open_what_if(id); });
  connect(missing_, &MissingPane::export_wanted, this,
          [this] { emit workbench_.workspace_requested(Place::write_out); });
  connect(missing_, &MissingPane::look_wanted, this, [this] { workbench_.diagnosing.set_wanted(true); });
  connect(missing_, &MissingPane::curve_wanted, this, [this] {
    if (const auto d = workbench_.diagnosing.diagnosis())
      for (const DiagnosisCandidate& c : d->candidates)
        if (c.unnamed) return failing_->show_variable(c.unnamed->empirical_error.variable->name);
  });
  connect(missing_, &MissingPane::added_until_it_stopped, watching_, &WatchingPane::show_bill);
  connect(missing_->poses(), &PosesPane::pose_chosen, watching_, &WatchingPane::show_posture);
  connect(missing_->poses(), &PosesPane::closed, watching_, &WatchingPane::show_robot);
  connect(watching_, &WatchingPane::version_chosen, this,
          [this](const ModelVersionPointer& version) { workbench_.document.show_version(version); });
  connect(&adding_, &Adding::began, this, [this] {
    failing_->what_if()->hide();
    stop_trying();
    failing_->end_proof();
    failing_->show_proof(adding_.offered());
    refresh_verdict();
  });
  connect(&adding_, &Adding::ended, this, [this](AdditionEnd end, const QString&) {
    emit status_changed();  // what was refused belongs to the story
    if (end == AdditionEnd::taken) {
      proof_model_ = workbench_.document.model();
      failing_->show_proof_added(adding_.taken());
    } else {
      failing_->end_proof();
    }
    refresh_in_turns();
  });
  in_turns_.setInterval(0);
  connect(&in_turns_, &QTimer::timeout, this, &ExplainWorkspace::refresh_next);
  using widgets::WhatIfSlider;
  WhatIfSlider* slider = failing_->what_if();
  connect(slider, &WhatIfSlider::changed, this, &ExplainWorkspace::slide_what_if);
  connect(slider, &WhatIfSlider::settled, this, &ExplainWorkspace::slide_what_if);
  connect(slider, &WhatIfSlider::place_chosen, this,
          [this](int place) { open_what_if(QString::fromStdString(what_if_id_), place); });
  connect(slider, &WhatIfSlider::parameter_chosen, this, [this](int parameter) {
    what_if_parameter_ = parameter;
    slide_what_if(failing_->what_if()->value());
  });
  connect(slider, &WhatIfSlider::closed, this, [this] {
    failing_->what_if()->hide();
    stop_trying();
  });
}

void ExplainWorkspace::connect_workbench() {
  Diagnosing& d = workbench_.diagnosing;
  connect(&workbench_.document, &Document::opened, this, [this] {
    is_fresh_ = true;
    failing_->what_if()->hide();
    stop_trying();
  });
  connect(&workbench_.document, &Document::closed, this, [this] {
    in_turns_.stop();
    failing_->show_residuals(nullptr, true);
  });
  connect(&workbench_.document, &Document::model_changed, this, [this] {
    emit status_changed();
    is_active() ? refresh_all() : watching_->remember();
  });
  connect(&workbench_.units, &DisplayUnits::changed, this, [this] {
    if (is_active()) refresh_units();
  });
  connect(&workbench_.sessions, &SessionFilter::changed, this, [this] {
    if (is_active()) refresh_units();
  });
  connect(&d, &Diagnosing::residuals_changed, this, [this] {
    if (is_active()) refresh_all();
    renew_what_if();
  });
  connect(&d, &Diagnosing::diagnosis_changed, this, [this] {
    emit status_changed();
    if (!is_active() || adding_.is_running()) return;
    refresh_verdict();
    refresh_lead();
    missing_->refresh();
  });
  connect(&d, &Diagnosing::views_changed, this, [this] {
    if (!is_active() || adding_.is_running()) return;
    failing_->refresh_shows();
    refresh_lead();
    missing_->refresh();
    if (!trying_.isEmpty()) try_candidate(trying_);
  });
  connect(&d, &Diagnosing::inclusion_probabilities_changed, this, [this] {
    if (!is_active() || adding_.is_running()) return;
    missing_->refresh();
    watching_->refresh_bill();
  });
  connect(&d, &Diagnosing::progressed, this, [this] {
    if (!is_active() || adding_.is_running()) return;
    refresh_verdict();
    if (!workbench_.diagnosing.diagnosis()) missing_->refresh();
  });
  connect(&workbench_, &Workbench::blunders_changed, this, [this] {
    emit status_changed();
    if (is_active() && workbench_.document.is_open()) activate();
  });
  connect(&workbench_.explaining, &Jobs::changed, this, [this] {
    if (is_active() && !workbench_.diagnosing.diagnosis() && !adding_.is_running()) missing_->refresh();
  });
}

WorkStatus ExplainWorkspace::status() const {
  const ModelVersionPointer model = workbench_.document.shown_model();
  if (!model || !model->fit) return {WorkState::waiting, tr("waits for a fit")};
  if (!workbench_.blunders().empty()) return {WorkState::care, tr("a mistake in the session")};
  const Story& story = workbench_.story();
  switch (story.state) {
    case StoryState::at_the_noise:
      return story.stands_in.empty() ? WorkStatus{WorkState::done, tr("nothing is missing")}
                                     : WorkStatus{WorkState::care, tr("at the noise, by a stand-in")};
    case StoryState::unnamed_at_the_noise:
      return {WorkState::care, tr("at the noise, not all named")};
    case StoryState::repeatability:
      return {WorkState::care, tr("looks random")};
    case StoryState::missing:
    case StoryState::ambiguous:
      return {WorkState::care, tr("an effect is missing")};
    case StoryState::implausible:
      return {WorkState::care, tr("no plausible cause")};
    case StoryState::unexplained:
    case StoryState::refused:
      return {WorkState::care, tr("unexplained")};
    case StoryState::too_few_observations:
      return {WorkState::waiting, tr("waits for more observations")};
    case StoryState::noise_unknown:
      return {WorkState::open, tr("noise unknown")};
    case StoryState::not_looked:
      break;
  }
  if (model->report->used < fewest_that_tell) return {WorkState::waiting, tr("waits for more observations")};
  const auto ratio = story.error.ratio();
  if (!ratio) return {WorkState::open, tr("noise unknown")};
  return *ratio < most_beside_repeatability ? WorkStatus{WorkState::done, tr("down at the noise")}
                                            : WorkStatus{WorkState::open, tr("above the noise")};
}

void ExplainWorkspace::activate() {
  workbench_.diagnosing.set_wanted(workbench_.blunders().empty());  // causes are nothing to look for in a wrong session
  refresh_all();
}

void ExplainWorkspace::hideEvent(QHideEvent* event) {
  Workspace::hideEvent(event);
  if (event->spontaneous()) return;  // the whole window was minimised: it comes back as it was
  if (!adding_.is_running()) workbench_.diagnosing.set_wanted(false);
  hold_noise(false);
  hold_blink(false);
  stop_trying();
  if (tour_) tour_->stop();
}

void ExplainWorkspace::refresh_in_turns() {
  if (!workbench_.document.is_open()) return;
  refresh_verdict();
  missing_->refresh();
  turn_ = 0;
  in_turns_.start();
}

void ExplainWorkspace::refresh_next() {
  if (turn_++ == 0) return refresh_plots();
  in_turns_.stop();
  watching_->refresh();
  if (tour_) tour_->look();
}

void ExplainWorkspace::refresh_all() {
  if (!workbench_.document.is_open()) return;
  refresh_verdict();
  if (adding_.is_running()) return;
  in_turns_.stop();
  refresh_plots();
  missing_->refresh();
  watching_->refresh();
  if (tour_) tour_->look();
}

void ExplainWorkspace::refresh_plots() {
  const ModelVersionPointer model = workbench_.document.shown_model();
  const bool is_of_proof = model && proof_model_ && same_fit(*model, *proof_model_);
  if (failing_->is_proof_added() && !is_of_proof) failing_->end_proof();  // undone, or another is shown
  std::shared_ptr<const ModelResiduals> residuals = workbench_.diagnosing.residuals();
  if (model && model != workbench_.document.model() && model->fit)
    residuals = workbench_.diagnosing.compute_residuals(model);
  if (residuals || !model || !model->fit) {
    failing_->show_residuals(residuals, is_fresh_);
    is_fresh_ = is_fresh_ && !residuals;
  }
  refresh_lead();
}

/// The proof of the cause that the story goes by. While what was added is looked at in a pause, nothing comes after it.
void ExplainWorkspace::refresh_lead() {
  if (adding_.is_running()) return;
  const StoryCause* lead = workbench_.blunders().empty() ? workbench_.story().lead() : nullptr;
  const auto view = lead && !missing_->is_paused() ? workbench_.diagnosing.find_view(lead->id) : nullptr;
  failing_->show_lead(view ? Proof{title_of_candidate(lead->id), lead->believable, view->proof} : Proof{});
}

void ExplainWorkspace::refresh_units() {
  refresh_all();
  failing_->refresh_units();
  if (adding_.is_running()) return;
  if (failing_->what_if()->isVisible()) return slide_what_if(failing_->what_if()->value());
  if (!trying_.isEmpty()) try_candidate(trying_);
}

void ExplainWorkspace::refresh_verdict() {
  const ModelVersionPointer model = workbench_.document.shown_model();
  widgets::SessionVerdict v;
  if (!model || !model->fit) {
    const auto& observations = workbench_.document.session().observations;
    const bool has_labels = std::any_of(observations.begin(), observations.end(), is_used);
    v.sentence = model                           ? model->refusal
                 : workbench_.refit.is_pending() ? tr("The model is being fitted.")
                 : has_labels                    ? tr("Waits for a fit: play.")
                                                 : tr("Waits for a fit: label three markers, then play.");
  } else {
    v = session_verdict(workbench_, model);
    if (const auto error = workbench_.predicted_error()) {
      const auto tried = workbench_.units.shown(
          as_read(size_of_error(*error, !workbench_.document.session().is_tracker(), model->fit->noise), *model));
      if (tried.unit == workbench_.units.unit()) v.predicted = tried;  // two units in one breath would mislead
    }
  }
  verdict_->set_verdict(std::move(v));
}

void ExplainWorkspace::try_candidate(const QString& id) {
  if (id.isEmpty() || adding_.is_running()) return stop_trying();
  const auto d = workbench_.diagnosing.diagnosis();
  const auto view = workbench_.diagnosing.find_view(id.toStdString());
  if (!d || !view || !failing_->residuals()) return;
  trying_ = id;
  missing_->cards()->set_previewed(id);
  const StoryCause* lead = workbench_.story().lead();
  failing_->show_proof({title_of_candidate(id.toStdString()), lead && lead->id == id.toStdString(), view->proof});
  try_numbers(*view, view->numbers, title_of_candidate(id.toStdString()));
}

QString ExplainWorkspace::title_of_candidate(const std::string& id) const {
  if (const auto d = workbench_.diagnosing.diagnosis())
    for (const DiagnosisCandidate& c : d->candidates)
      if (find_id(c) == id) return display_name(c, workbench_.document.session());
  return effect_text(id, {});
}

void ExplainWorkspace::try_numbers(const CandidateView& view, const Eigen::VectorXd& numbers, const QString& name) {
  const auto residuals = workbench_.diagnosing.residuals();
  if (!residuals) return;
  std::vector<EffectTerm> terms = view.effect.terms;
  for (std::size_t i = 0; i < view.effect.numbers.size(); ++i)
    terms[view.effect.numbers[i].term].values[view.effect.numbers[i].parameter] = numbers[static_cast<Eigen::Index>(i)];
  failing_->set_prediction(&view.effect, numbers);
  watching_->set_prediction(residuals.get(), &view, numbers, terms, tr("with %1").arg(name));
  workbench_.try_out(rms_left(residuals->views, view.effect, numbers),
                     predicted_ratios(*residuals, view.effect, numbers, workbench_.document.session()));
  refresh_verdict();
}

void ExplainWorkspace::stop_trying() {
  const bool was_trying = workbench_.predicted_error().has_value();
  trying_.clear();
  missing_->cards()->set_previewed({});
  if (!adding_.is_running()) failing_->show_proof({});
  if (failing_->what_if()->isVisible() && !adding_.is_running() && isVisible())
    return slide_what_if(failing_->what_if()->value());
  workbench_.try_out(std::nullopt);
  if (!was_trying) return;
  failing_->set_prediction(nullptr, {});
  watching_->set_prediction(nullptr, nullptr, {}, {}, {});
  refresh_verdict();
}

}  // namespace handsight::app
