// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/diagnosing.h"

#include "diagnosis/selection/model_changes.h"
#include "document/curve_words.h"

namespace handsight::app {
namespace {

constexpr std::size_t most_kept = 12;
constexpr int most_for_regions = 1000;  // observations

std::shared_ptr<const CandidateView> make_view(const ModelResiduals& residuals, const Diagnosis& d,
                                               const DiagnosisCandidate& c) {
  auto view = std::make_shared<CandidateView>();
  view->effect = effect_view(residuals.views, c.terms);
  view->numbers = list_numbers(view->effect, c.terms);
  view->rms_left = rms_left(residuals.views, view->effect, view->numbers);
  if (c.ln_bayes_factor >= d.threshold) view->proof = make_proof(d, c);
  return view;
}

}  // namespace

QString titled(const QString& title, const ModelResiduals& residuals) {
  const auto shown = static_cast<int>(residuals.views.problem.observations.size());
  if (shown >= residuals.views.fitted) return title;
  return QObject::tr("%1 (%2 of %3 observations)").arg(title).arg(shown).arg(residuals.views.fitted);
}

std::shared_ptr<const ModelResiduals> make_residuals(const ModelVersion& version) {
  auto made = std::make_shared<ModelResiduals>();
  made->views = residual_views(*version.fit, most_shown, static_cast<std::size_t>(version.report->used));
  made->patterns = find_patterns(made->views.series, made->views.variables);
  return made;
}

Diagnosing::Diagnosing(Document& document, Jobs& jobs, QObject* parent)
    : QObject(parent), document_(document), jobs_(jobs) {
  connect(&document, &Document::model_changed, this, &Diagnosing::follow);
  connect(&document, &Document::closed, this, [this] {
    jobs_.cancel();
    now_.reset();
    earlier_.clear();
  });
  const auto drop = [this] {
    if (now_ && now_->version->revision == document_.revision()) return;
    jobs_.cancel("diagnosis");
    now_.reset();
  };
  connect(&document, &Document::edited, this, drop);
  connect(&document, &Document::settings_changed, this, drop);
}

void Diagnosing::set_wanted(bool wanted) {
  is_wanted_ = wanted;
  if (wanted) follow();  // what runs goes on: who leaves may come back
}

std::shared_ptr<const CandidateView> Diagnosing::find_view(const std::string& id) const {
  if (!now_) return nullptr;
  const auto found = now_->views.find(id);
  return found == now_->views.end() ? nullptr : found->second;
}

Diagnosing::ResultPointer Diagnosing::known(const ModelVersionPointer& version) const {
  for (const ResultPointer& result : earlier_)
    if (same_fit(*result->version, *version)) return result;
  return nullptr;
}

/// A fit that the document has forgotten never comes again.
void Diagnosing::forget_with_the_document() {
  std::erase_if(earlier_, [this](const ResultPointer& r) { return r != now_ && !document_.keeps(*r->version); });
}

void Diagnosing::follow() {
  forget_with_the_document();
  const ModelVersionPointer model = document_.model();
  if (!is_wanted_ || !model || !model->fit) return;
  if (now_ && same_fit(*now_->version, *model)) {
    now_->version = model;
    if (now_->has_views || is_running()) return;
  } else {
    now_ = known(model);
    if (!now_) {
      now_ = std::make_shared<Result>();
      now_->version = model;
      earlier_.push_front(now_);
      if (earlier_.size() > most_kept) earlier_.pop_back();
    }
    now_->version = model;
    emit residuals_changed();
    emit diagnosis_changed();
    emit views_changed();
  }
  if (!now_->has_views) start();
}

void Diagnosing::post(std::function<void()> news) { QMetaObject::invokeMethod(this, std::move(news)); }

void Diagnosing::start() {
  share_ = 0;
  jobs_.start<bool>(
      "diagnosis", tr("Looking for what is missing"),
      [this, result = now_, residuals = now_->residuals, diagnosis = now_->diagnosis, version = now_->version,
       session = document_.shared_session()](JobControl& control) {
        // The result itself belongs to the window's thread: parts are made here and handed over.
        auto part = std::make_shared<Result>();
        part->version = version;
        part->residuals = residuals;
        part->diagnosis = diagnosis;
        const auto hand_over = [this, result, part, &control](void (Diagnosing::*changed)()) {
          if (control.is_cancelled()) return;
          post([this, result, changed, residuals = part->residuals, diagnosis = part->diagnosis, views = part->views,
                has_views = part->has_views] {
            result->residuals = residuals;
            result->diagnosis = diagnosis;
            result->views = views;
            result->has_views = has_views;
            if (result == now_) emit(this->*changed)();
          });
        };
        if (!part->residuals) {
          part->residuals = make_residuals(*version);
          hand_over(&Diagnosing::residuals_changed);
        }
        if (control.is_cancelled()) return false;
        ImprovementOptions options;
        options.effects = version->settings.held;
        options.estimated = version->settings.estimated;
        options.on_progress = [&](double done) {
          control.report(done);
          if (done > share_) share_ = done;
          post([this] { emit progressed(); });
          return !control.is_cancelled();
        };
        if (!part->diagnosis) {
          auto made = std::make_shared<Diagnosis>(diagnosed(*session, options));
          if (made->stopped) return false;
          part->diagnosis = made;
        }
        hand_over(&Diagnosing::diagnosis_changed);
        for (const DiagnosisCandidate& c : part->diagnosis->candidates) {
          if (control.is_cancelled()) return false;
          if (c.terms.empty()) continue;
          part->views[find_id(c)] = make_view(*part->residuals, *part->diagnosis, c);
          if (part->views.size() == 3) hand_over(&Diagnosing::views_changed);
        }
        part->has_views = true;
        hand_over(&Diagnosing::views_changed);
        if (control.is_cancelled()) return true;
        // Of long sessions it would take longer than the search.
        const bool is_short = version->report->used <= most_for_regions;
        const ErrorSummary region = is_short ? region_error(*part->diagnosis) : part->diagnosis->report.held_out_region;
        const auto elsewhere = version->fit->problem.rig ? region.rms_pixel : region.rms_m;
        if (!control.is_cancelled())
          post([this, result, elsewhere] {
            result->elsewhere = elsewhere;
            if (result == now_) emit elsewhere_changed();
          });
        const ModelSettings& settings = version->settings;
        if (static_cast<int>(settings.estimated.size()) == settings.by_hand || control.is_cancelled()) return true;
        auto certain = std::make_shared<const InclusionProbabilities>(handsight::inclusion_probabilities(
            *part->diagnosis, static_cast<std::size_t>(settings.by_hand), [&] { return !control.is_cancelled(); }));
        if (!control.is_cancelled()) post([this, result, certain] { take_inclusion_probabilities(result, certain); });
        return true;
      },
      [this](bool) { emit progressed(); },
      [this](const QString& sentence) {
        emit document_.noticed(sentence);
        emit progressed();
      });
}

void Diagnosing::take_inclusion_probabilities(
    const ResultPointer& result, const std::shared_ptr<const InclusionProbabilities>& inclusion_probabilities) {
  result->inclusion_probabilities = inclusion_probabilities;
  if (result != now_) return;
  if (const ModelVersionPointer model = document_.model(); model && same_fit(*model, *result->version))
    document_.take_version(doubted(document_.session(), *model, inclusion_probabilities->model_uncertainty));
  emit inclusion_probabilities_changed();
}

void Diagnosing::take(const ModelVersionPointer& version, std::shared_ptr<const Diagnosis> diagnosis,
                      std::shared_ptr<const ModelResiduals> residuals) {
  auto result = std::make_shared<Result>();
  result->version = version;
  result->residuals = std::move(residuals);
  result->diagnosis = std::move(diagnosis);
  earlier_.push_front(result);
  if (earlier_.size() > most_kept) earlier_.pop_back();
}

std::shared_ptr<const ModelResiduals> Diagnosing::compute_residuals(const ModelVersionPointer& version) {
  if (!version || !version->fit) return nullptr;
  ResultPointer result = known(version);
  if (!result) {
    result = std::make_shared<Result>();
    result->version = version;
    earlier_.push_front(result);
    if (earlier_.size() > most_kept) earlier_.pop_back();
  }
  if (!result->residuals && is_wanted_ && result == now_) return nullptr;  // they are on their way
  if (!result->residuals) result->residuals = make_residuals(*version);
  return result->residuals;
}

}  // namespace handsight::app
