// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/expecting.h"

#include "diagnosis/selection/choosing.h"
#include "diagnosis/selection/improvement.h"
#include "estimation/fit/sure_fit.h"

namespace handsight::app {
namespace {

const QString job = QStringLiteral("expect");

std::optional<ErrorSummary> choose_without_each(const Session& session, const Fit& chosen,
                                                const ModelSettings& settings, const JobControl& control) {
  ImprovementOptions options;
  options.effects = settings.held;
  options.estimated.assign(settings.estimated.begin(), settings.estimated.begin() + settings.by_hand);
  options.with_choosing = false;
  options.on_progress = [&control](double) { return !control.is_cancelled(); };
  return error_with_choosing(session, chosen, [&](const Session& part) -> std::optional<Fit> {
    Improvement without = improve(part, options);
    if (without.stopped || control.is_cancelled()) return std::nullopt;
    return std::move(without.last.model.fit);
  });
}

}  // namespace

Expecting::Expecting(Workbench& workbench, const Adding& adding, QObject* parent)
    : QObject(parent), workbench_(workbench), adding_(adding) {
  // Whoever goes on does not wait for it.
  const auto drop = [this] { workbench_.explaining.cancel(job); };
  connect(&adding, &Adding::began, this, drop);
  connect(&workbench.document, &Document::edited, this, drop);
  connect(&workbench.document, &Document::settings_changed, this, drop);
  connect(&workbench.document, &Document::closed, this, drop);
}

bool Expecting::is_asked_of(const ModelVersion& model) const {
  const bool has_chosen = static_cast<int>(model.settings.estimated.size()) > model.settings.by_hand;
  return has_chosen && workbench_.document.session().parts.empty() && !has_no_answer(*model.fit) &&
         are_few_to_choose_by(*model.fit) && is_cheap_to_choose(*model.fit, adding_.models());
}

void Expecting::start() {
  const ModelVersionPointer model = workbench_.document.model();
  if (!model || !model->fit || fit_ == model->fit || !is_asked_of(*model)) return;
  workbench_.explaining.start<std::optional<ErrorSummary>>(
      job, tr("Choosing the causes without a part of the poses"),
      [session = workbench_.document.shared_session(), model](JobControl& control) {
        return choose_without_each(*session, *model->fit, model->settings, control);
      },
      [this, model](const std::optional<ErrorSummary>& error) {
        fit_ = model->fit;
        error_ = error;
        emit changed();
      });
}

QString Expecting::sentence(const ModelVersionPointer& model) const {
  if (!model || !error_ || !fit_ || model->fit != fit_) return {};
  const bool in_pixels = error_->rms_pixel.has_value();
  const auto error = in_pixels ? error_->rms_pixel : error_->rms_m;
  if (!error) return {};
  return tr("Expect %1 on new poses: so much is left of poses that took no part in choosing the causes, which few "
            "poses "
            "do by chance, too.")
      .arg(error_with_unit(*error, in_pixels));
}

}  // namespace handsight::app
