// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/adding.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "diagnosis/selection/begin_of_names.h"
#include "diagnosis/selection/improvement.h"
#include "diagnosis/selection/model_changes.h"
#include "diagnosis/selection/simple_models.h"
#include "document/curve_words.h"
#include "document/effect_words.h"
#include "document/model_edits.h"

namespace handsight::app {
namespace {

constexpr int ms_between_pictures = 120;  // from one to the next the cloud moves on

/// What an addition or removal is of, in words; `id` may be of several effects that went together.
QString step_text(const std::string& id, const ImprovementStep& s, const Session& session) {
  if (!s.terms.empty() && s.terms.front().id == id) return display_name(s.terms, session);
  return list_effects(id);
}

QString model_alternative_text(const ImprovementStep& s) {
  if (!s.background.empty())
    return QObject::tr("added small deviations at each joint: %1")
        .arg(list_effects(fmt::format("{}", fmt::join(s.background, ", "))));
  if (s.removed.empty() && s.exchanged.empty()) return QObject::tr("moved what is in the model to other places");
  const QString come = list_effects(fmt::format("{}", fmt::join(s.exchanged, ", ")));
  if (s.removed.empty()) return QObject::tr("added %1").arg(come);
  const QString gone = list_effects(s.removed);
  if (s.exchanged.empty()) return QObject::tr("took out %1, no longer needed").arg(gone);
  return QObject::tr("exchanged %1 for %2").arg(gone, come);
}

QString sentence_of(const ModelChange& change, const Session& session) {
  QStringList parts;
  for (const ImprovementStep& s : change.steps) {
    if (s.added.empty())
      parts << model_alternative_text(s);
    else if (s.likely)
      parts << QObject::tr("added %1, which is likely beside the rest").arg(step_text(s.added, s, session));
    else if (s.removed.empty())
      parts << (s.terms.empty() || s.terms.front().id != s.added
                    ? QObject::tr("added %1").arg(step_text(s.added, s, session))
                    : addition_text(s.terms, session));
    else
      parts << QObject::tr("exchanged %1 for %2").arg(list_effects(s.removed), step_text(s.added, s, session));
  }
  return parts.join(", ");
}

/// Where an observation is among those that a diagnosis went by; one near it where it was not among them.
int locate(const std::vector<Observation>& observations, std::int64_t id) {
  const auto found = std::find_if(observations.begin(), observations.end(), [id](const auto& o) { return o.id >= id; });
  return static_cast<int>(
      std::min<std::ptrdiff_t>(found - observations.begin(), static_cast<std::ptrdiff_t>(observations.size()) - 1));
}

/// For the eye the candidate's full fit, as the diagnosis ran it: from the model as it stands over the linear estimate
/// to the answer, from which the model's next fit starts.
void show_the_fit(const Diagnosis& before, const DiagnosisCandidate& candidate, std::int64_t observation,
                  FitWatch& watch) {
  std::vector<EffectTerm> estimated = before.model_options.estimated;
  estimated.insert(estimated.end(), candidate.terms.begin(), candidate.terms.end());
  watch.begin(before.model.session, before.model_options.effects, estimated,
              locate(before.model.session.observations, observation));
  Unknowns start = estimate(before.model.fit);
  const Eigen::Index known = start.effects.size();
  start.effects.conservativeResize(watch.effect_count());
  start.effects.tail(watch.effect_count() - known).setZero();
  watch.iteration(before.model.fit.solution.normal.data_cost(), start);
  for (const FitIteration& i : candidate.path) watch.iteration(i.cost, i.unknowns);
}

/// A long session's diagnosis went by a sample: the model is that of all observations.
std::shared_ptr<ModelVersion> version_of_all(const Session& session, const ModelSettings& settings,
                                             std::int64_t revision, const QString& cause, const SecondLooks& looks,
                                             const std::function<bool()>& goes_on) {
  const ModelVersionPointer made = make_version(session, settings, revision, cause, looks, goes_on);
  if (!made->fit && goes_on()) throw InputError(verbatim(made->refusal.toStdString()));
  return std::make_shared<ModelVersion>(*made);
}

/// What is not taken was not asked for.
ModelChange found_by_seeking(const Session& session, ImprovementOptions options, const Diagnosis& before,
                             Adding::Seeking what) {
  ModelChange change;
  const auto is_done = [&] { return change.model || change.stopped; };
  if (what == Adding::Seeking::other_names) change = search_models(session, options, before);
  if (!is_done() && what != Adding::Seeking::thoroughly)
    change = add_likely(
        session, options, before,
        inclusion_probabilities(before, begin_of_names(before.model_options.estimated, options.estimated.size()),
                                [&] { return options.on_progress(0.97); }));
  if (!is_done() && what != Adding::Seeking::thoroughly) change = seek_simpler_model(session, options, before);
  if (!is_done()) {
    options.is_thorough = what == Adding::Seeking::thoroughly;
    if (options.is_thorough) options.most_models = most_models_of_thorough;
    change = improve_on(session, options, before);
  }
  change.refused.clear();
  return change;
}

QString refusal_sentence(const Diagnosis& before, const DiagnosisCandidate& c, const Session& session) {
  const bool in_pixels = before.report.held_out.rms_pixel.has_value();
  const auto now = in_pixels ? before.report.held_out.rms_pixel : before.report.held_out.rms_m;
  return QObject::tr("Not added: with %1 the error on unseen observations would not fall below %2. It would fit noise.")
      .arg(display_name(c, session), error_with_unit(now.value_or(0), in_pixels));
}

}  // namespace

Adding::Adding(Workbench& workbench, QObject* parent) : QObject(parent), workbench_(workbench) {
  timer_.setInterval(ms_between_pictures);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, [this] { show_news(false); });
  connect(&workbench.document, &Document::opened, this, [this] {
    workbench_.refused.clear();
    models_ = 0;
  });
  const auto look = [this] {
    if (is_running_ && !is_taking_ && !workbench_.explaining.is_busy("add")) stop();
  };
  connect(&workbench.explaining, &Jobs::stopped, this, look);
  connect(&workbench.explaining, &Jobs::changed, this, look);
  connect(&workbench.document, &Document::closed, this, look);
  // What changes the model meanwhile makes the addition stale.
  const auto stale = [this] {
    if (is_running_ && !is_taking_) workbench_.explaining.cancel("add");
  };
  connect(&workbench.document, &Document::edited, this, stale);
  connect(&workbench.document, &Document::settings_changed, this, stale);
}

void Adding::add(const std::string& id) {
  const auto before = workbench_.diagnosing.diagnosis();
  if (is_running_ || !before || !workbench_.document.model()) return;
  const auto found = std::find_if(before->candidates.begin(), before->candidates.end(),
                                  [&](const DiagnosisCandidate& c) { return can_be_added(c) && find_id(c) == id; });
  if (found == before->candidates.end()) return;
  const QString name = display_name(*found, workbench_.document.session());
  const auto view = workbench_.diagnosing.find_view(id);
  start({before, *found, workbench_.document.revision()}, tr("Adding %1").arg(name),
        {name, workbench_.story().lead() && workbench_.story().lead()->id == id,
         view ? view->proof : make_proof(*before, *found)});
}

void Adding::seek(Seeking what) {
  const auto before = workbench_.diagnosing.diagnosis();
  if (is_running_ || !before || !workbench_.document.model()) return;
  start({before, std::nullopt, workbench_.document.revision(), what},
        what == Seeking::thoroughly ? tr("Beginning again from other names")
                                    : tr("Seeking other names for what is in the model"),
        {});
}

void Adding::start(Run run, const QString& what, Proof offered) {
  const std::int64_t observation =
      workbench_.selection.current().observation.value_or(workbench_.document.session().observations.front().id);
  watch_ = std::make_shared<FitWatch>();
  enough_ = std::make_shared<std::atomic<bool>>(false);
  pictures_ = skipped_ = 0;
  is_running_ = true;
  offered_ = std::move(offered);
  taken_ = {};
  emit began(what);
  timer_.start();
  workbench_.explaining.start<Outcome>(
      "add", what,
      [session = workbench_.document.shared_session(), settings = workbench_.document.settings(), run, observation,
       watch = watch_, enough = enough_, looks = workbench_.document.second_looks()](JobControl& control) {
        if (run.candidate) show_the_fit(*run.before, *run.candidate, observation, *watch);
        return make_outcome(run, *session, settings, looks, *enough, control);
      },
      [this, run](const Outcome& outcome) { finish(run, outcome); },
      [this](const QString& sentence) { end(AdditionEnd::failed, sentence); });
}

Adding::Outcome Adding::make_outcome(const Run& run, const Session& session, const ModelSettings& settings,
                                     const SecondLooks& looks, const std::atomic<bool>& enough, JobControl& control) {
  ImprovementOptions options;
  options.effects = settings.held;
  options.estimated.assign(settings.estimated.begin(), settings.estimated.begin() + settings.by_hand);
  const auto goes_on = [&] { return !control.is_cancelled() && !enough; };
  options.on_progress = [&](double done) {
    control.report(done);
    return goes_on();
  };
  options.on_iteration = [&](int, double, const Unknowns&) { return goes_on(); };
  Outcome outcome{run.candidate ? add_candidate(session, options, *run.before, *run.candidate)
                                : found_by_seeking(session, options, *run.before, run.seeking)};
  if (!outcome.change.model) return outcome;
  outcome.model = std::make_shared<const Diagnosis>(std::move(*outcome.change.model));
  outcome.change.model.reset();
  const Diagnosis& made = *outcome.model;
  const ModelSettings after = with_estimated(settings, made.model_options.estimated);
  const QString cause = sentence_of(outcome.change, session);
  outcome.version = made.sample ? version_of_all(session, after, run.revision, cause, looks, going_on(control))
                                : build_version(session, made, after, run.revision, cause, looks);
  outcome.change.stopped = control.is_cancelled();
  if (outcome.change.stopped) return outcome;
  outcome.residuals = make_residuals(*outcome.version);
  if (run.candidate)
    outcome.proof = make_proof(made.sample ? made.model.session : session,
                               made.sample ? made.model.fit : *outcome.version->fit, run.candidate->terms);
  return outcome;
}

void Adding::show_news(bool is_end) {
  if (!watch_) return;
  const FitWatch::News news = watch_->fetch(is_end);
  for (const auto& [iteration, rms] : news.costs) emit iterated(iteration, rms);
  skipped_ += news.skipped;
  if (!news.picture) return;
  ++pictures_;
  emit pictured(*news.picture);
}

void Adding::finish(const Run& run, const Outcome& outcome) {
  show_news(true);
  const ModelChange& change = outcome.change;
  models_ += change.models;
  if (change.stopped || run.revision != workbench_.document.revision()) return stop();
  for (const RefusedStep& r : change.refused)
    workbench_.refused.push_back({r.id, r.where, find_refusal(run), workbench_.document.undo_stack().undoText(),
                                  workbench_.document.undo_stack().index(), workbench_.document.revision()});
  if (!outcome.version) return end(AdditionEnd::refused, find_refusal(run));
  const std::shared_ptr<ModelVersion>& version = outcome.version;
  is_taking_ = true;
  workbench_.document.perform(
      {.sentence = version->cause, .settings = SettingsEdit{workbench_.document.settings(), version->settings}});
  if (!(workbench_.document.settings() == version->settings)) {
    is_taking_ = false;
    return end(AdditionEnd::failed, tr("Not added: it could not be written down; make room on the disk."));
  }
  version->revision = workbench_.document.revision();
  workbench_.diagnosing.take(version, outcome.model, outcome.residuals);
  workbench_.document.take_version(version);
  is_taking_ = false;
  added_likely_ = change.steps.back().likely.has_value();
  const auto is_background = [](const ImprovementStep& s) { return !s.background.empty(); };
  added_background_ = std::any_of(change.steps.begin(), change.steps.end(), is_background);
  found_other_names_ = !std::all_of(change.steps.begin(), change.steps.end(), is_background);
  taken_ = {offered_.name, offered_.leads, outcome.proof};
  end(AdditionEnd::taken, version->cause.left(1).toUpper() + version->cause.mid(1) + '.');
}

QString Adding::find_refusal(const Run& run) const {
  if (!run.candidate) return {};
  return refusal_sentence(*run.before, *run.candidate, workbench_.document.session());
}

void Adding::stop() { end(AdditionEnd::stopped, tr("Stopped. Everything is as before.")); }

void Adding::end(AdditionEnd end, const QString& sentence) {
  if (!is_running_) return;
  timer_.stop();
  is_running_ = false;
  if (!sentence.isEmpty()) emit workbench_.document.noticed(sentence);
  emit ended(end, sentence);
}

}  // namespace handsight::app
