// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/refit.h"

#include <algorithm>

#include "words/counted.h"

namespace handsight::app {

Refit::Refit(Document& document, Jobs& jobs, QObject* parent) : QObject(parent), document_(document), jobs_(jobs) {
  timer_.setSingleShot(true);
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &Refit::start);
  connect(&document, &Document::opened, this, &Refit::schedule);
  connect(&document, &Document::edited, this, &Refit::schedule);
  connect(&document, &Document::settings_changed, this, &Refit::schedule);
  connect(&document, &Document::closed, this, [this] {
    timer_.stop();
    jobs_.cancel("fit");
  });
}

void Refit::hold() { ++holds_; }

void Refit::release() {
  const bool is_reported = document_.model() && document_.model() == document_.shown_model();
  if (--holds_ == 0 && document_.is_open() && !is_reported) schedule();
}

void Refit::schedule() {
  if (holds_ == 0) timer_.start();
}

/// A state that was fitted before: undone, or done again.
void Refit::show(const ModelVersionPointer& known) {
  jobs_.cancel("fit");
  document_.show_version(known);
}

void Refit::start() {
  if (!document_.is_open()) return;
  if (const ModelVersionPointer known = document_.model()) return show(known);
  const Session& session = document_.session();
  const auto used = std::count_if(session.observations.begin(), session.observations.end(), is_used);
  const QString cause = document_.undo_stack().undoText();
  jobs_.start<ModelVersionPointer>(
      "fit", tr("Fitting %1").arg(counted(used, "%n observation(s)")),
      [session = document_.shared_session(), settings = document_.settings(), revision = document_.revision(), cause,
       looks = document_.second_looks(), before = document_.model_before_second_looks()](JobControl& control) {
        return before && before->fit ? inspected_again(*session, *before, revision, looks)
                                     : make_version(*session, settings, revision, cause, looks, going_on(control));
      },
      [this](const ModelVersionPointer& version) { document_.take_version(version); },
      [this](const QString& sentence) { emit document_.noticed(sentence); });
}

}  // namespace handsight::app
