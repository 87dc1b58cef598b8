// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/adding_on.h"

#include <algorithm>
#include <utility>

#include "diagnosis/selection/model_changes.h"
#include "diagnosis/selection/regrowing.h"
#include "diagnosis/verdict/finding.h"
#include "document/effect_words.h"
#include "document/refusal.h"
#include "words/counted.h"

namespace handsight::app {

AddingOn::AddingOn(Workbench& workbench, Adding& adding, widgets::CandidateList& cards, QObject* parent)
    : QObject(parent), workbench_(workbench), adding_(adding), cards_(cards) {
  connect(&adding, &Adding::ended, this, [this](AdditionEnd end, const QString&) {
    if (end == AdditionEnd::taken) note_taken();
    const bool was_longer = std::exchange(is_seeking_longer_, false);
    const bool found_none = std::exchange(is_seeking_, false) && end == AdditionEnd::refused;
    if (found_none) (was_longer ? sought_longer_at_ : sought_at_) = workbench_.document.revision();
    if (is_running_ && found_none)
      this->end(was_longer ? tr("Nothing better was found from any other beginning.") : reported_at_the_end());
    if (is_running_ && (end == AdditionEnd::stopped || end == AdditionEnd::failed)) this->end({});
  });
  next_.setSingleShot(true);
  next_.setInterval(200);
  connect(&next_, &QTimer::timeout, this, &AddingOn::add_first);
  connect(&workbench.document, &Document::closed, this, [this] {
    sought_at_.reset();
    sought_longer_at_.reset();
    end({});
  });
}

void AddingOn::note_taken() {
  if (is_seeking_ && !adding_.added_likely()) {
    found_others_ = found_others_ || adding_.found_other_names();
    found_background_ = found_background_ || adding_.added_background();
    return;
  }
  // Other names are sought by more evidence than it has: it would be taken out again.
  only_likely_ = only_likely_ || is_seeking_;
  ++added_;
}

void AddingOn::start() {
  if (is_running_) return;
  is_running_ = true;
  is_paused_ = false;
  added_ = sought_ = 0;
  found_others_ = found_background_ = only_likely_ = false;
  emit changed();
  if (can_seek_longer() && !is_waiting() && !first_to_add()) return seek(Adding::Seeking::thoroughly);
  look();
}

void AddingOn::stop() {
  if (!is_running_) return;
  end({});
  if (!adding_.is_running()) return;
  if (is_seeking_longer_)
    adding_.settle();
  else
    workbench_.explaining.stop();
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
  if (sentence.isEmpty()) return;
  emit workbench_.document.noticed(sentence);
  emit done();
}

bool AddingOn::is_waiting() const {
  return adding_.is_running() || workbench_.refit.is_pending() || !workbench_.document.model() ||
         !workbench_.diagnosing.diagnosis() || cards_.count() == 0;
}

void AddingOn::look() {
  if (is_running_ && !is_paused_ && !is_waiting()) next_.start();
}

std::optional<std::string> AddingOn::first_to_add() const {
  const auto diagnosis = workbench_.diagnosing.diagnosis();
  const std::set<std::string> refused = refused_now(workbench_.refused, workbench_.document);
  for (const DiagnosisCandidate* c : candidates_to_try(*diagnosis, true)) {
    const std::string id = find_id(*c);
    if (can_be_added(*c) && !refused.contains(id)) return id;
  }
  return std::nullopt;
}

void AddingOn::add_first() {
  if (!is_running_ || is_paused_ || is_waiting()) return;
  if (const auto id = first_to_add())
    adding_.add(*id);
  else
    seek_or_end();
}

bool AddingOn::can_seek() const {
  if (!workbench_.document.is_open() || sought_at_ == workbench_.document.revision()) return false;
  const ModelSettings& settings = workbench_.document.settings();
  return static_cast<int>(settings.estimated.size()) > settings.by_hand;
}

bool AddingOn::can_seek_longer() const {
  if (!workbench_.document.is_open() || sought_at_ != workbench_.document.revision()) return false;
  const auto diagnosis = workbench_.diagnosing.diagnosis();
  return diagnosis && sought_longer_at_ != workbench_.document.revision() &&
         is_worth_seeking(*diagnosis, static_cast<std::size_t>(workbench_.document.settings().by_hand));
}

void AddingOn::seek_or_end() {
  if (!can_seek() || sought_++ >= 2 * most_times_sought) return end(reported_at_the_end());
  seek(only_likely_ || sought_ > most_times_sought ? Adding::Seeking::likely : Adding::Seeking::other_names);
}

void AddingOn::seek(Adding::Seeking what) {
  is_seeking_ = true;
  is_seeking_longer_ = what == Adding::Seeking::thoroughly;
  adding_.seek(what);
}

/// As the story says it: done is what agrees with the measurements, and stands in for nothing.
QString AddingOn::reported_at_the_end() const {
  const Story& story = workbench_.find_story(workbench_.document.model());
  QStringList done;
  if (added_ > 0 || (!found_others_ && !found_background_)) done << tr("%1 added").arg(counted(added_, "%n cause(s)"));
  if (found_others_) done << tr("other names found for what was added");
  if (found_background_) done << tr("small deviations at each joint taken in");
  QString sentence = (story.state == StoryState::at_the_noise && story.stands_in.empty()
                          ? tr("Done: %1, and nothing is missing any more.")
                      : story.state == StoryState::at_the_noise || story.state == StoryState::unnamed_at_the_noise
                          ? tr("Stopped at the noise: %1.")
                          : tr("Stopped by itself: %1, and nothing is left that would help."))
                         .arg(done.join(", "));
  QStringList stand_ins;
  for (const StandIn& s : story.stands_in) stand_ins << effect_text(s.id, s.where);
  // First what is to be doubted: where there is little room the rest is cut off.
  if (stand_ins.isEmpty()) return sentence;
  return tr("Larger than robots are built, so it stands in for another cause: %1.").arg(stand_ins.join(", ")) + ' ' +
         sentence;
}

}  // namespace handsight::app
