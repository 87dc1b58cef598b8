// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/adding_on.h"

#include "words/counted.h"

namespace handsight::app {

AddingOn::AddingOn(Workbench& bench, Adding& adding, widgets::CandidateList& cards, QObject* parent)
    : QObject(parent), bench_(bench), adding_(adding), cards_(cards) {
  connect(&adding, &Adding::ended, this, [this](AdditionEnd end, const QString&) {
    if (end == AdditionEnd::taken) ++added_;
    if (is_running_ && (end == AdditionEnd::stopped || end == AdditionEnd::failed)) this->end({});
  });
  next_.setSingleShot(true);
  next_.setInterval(200);
  connect(&next_, &QTimer::timeout, this, &AddingOn::add_first);
  connect(&bench.document, &Document::closed, this, [this] { end({}); });
}

void AddingOn::start() {
  if (is_running_) return;
  is_running_ = true;
  is_paused_ = false;
  added_ = 0;
  emit changed();
  look();
}

void AddingOn::stop() {
  if (!is_running_) return;
  end({});
  if (adding_.is_running()) bench_.explaining.stop();
}

void AddingOn::pause() {
  if (!is_running_ || is_paused_) return;
  is_paused_ = true;
  next_.stop();
  emit changed();
}

void AddingOn::go_on() {
  if (!is_paused_) return;
  is_paused_ = false;
  emit changed();
  look();
}

void AddingOn::end(const QString& sentence) {
  if (!is_running_) return;
  is_running_ = is_paused_ = false;
  next_.stop();
  emit changed();
  if (!sentence.isEmpty()) emit bench_.document.noticed(sentence);
}

bool AddingOn::is_waiting() const {
  return adding_.is_running() || bench_.refit.is_pending() || !bench_.document.model() ||
         !bench_.diagnosing.diagnosis() || cards_.count() == 0;
}

void AddingOn::look() {
  if (is_running_ && !is_paused_ && !is_waiting()) next_.start();
}

void AddingOn::add_first() {
  if (!is_running_ || is_paused_ || is_waiting()) return;
  const widgets::CardState& first = cards_.card(0)->state();
  if (first.kind == widgets::CardKind::candidate && first.can_add && first.caution.isEmpty())
    return adding_.add(first.id.toStdString());
  const QString added = counted(added_, "%n cause(s)");
  end(first.kind == widgets::CardKind::adequate ? tr("Done: %1 added, and nothing is missing any more.").arg(added)
                                                : tr("Stopped by itself: %1 added, and nothing plausible is left that "
                                                     "would help. The first card says what is left.")
                                                      .arg(added));
}

}  // namespace handsight::app
