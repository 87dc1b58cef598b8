// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibrate/player.h"

#include <algorithm>

#include "chain/chain.h"
#include "detection/target_finding.h"
#include "words/core_words.h"
#include "workbench/session_parts.h"

namespace handsight::app {

/// What one play works on, in the worker's hands alone while a step runs.
struct Player::Run {
  Session session;  // a copy, as it was when the play began
  Chain chain;
  OnlineCalibration online;
  Session frame;                       // the session without its observations
  std::vector<char> known;             // markers that some accepted observation showed
  std::optional<TargetFinder> finder;  // of a session with a target: its points need no label

  explicit Run(const Session& from)
      : session(from),
        chain(make_chain(session)),
        online(session),
        frame(session),
        known(static_cast<std::size_t>(session.marker_count), 0) {
    if (session.target && session.rig) finder.emplace(session);
    frame.observations.clear();
    frame.source.reset();
  }
};

namespace {

/// The images of an observation; the sentence where one cannot be read.
std::optional<ImagePair> read_pair(const Session& session, const Observation& o, QString& refusal) {
  if (o.images[0].empty() || o.images[1].empty() || !session.rig || !is_pair(*session.rig) ||
      o.decision == Decision::excluded)
    return std::nullopt;
  const ShownImage left = read_shown_image(folder(session) / o.images[0], o.images[0], session.rig->at(0).camera);
  const ShownImage right = read_shown_image(folder(session) / o.images[1], o.images[1], session.rig->at(1).camera);
  for (const ShownImage* shown : {&left, &right})
    if (shown->image.isNull()) {
      refusal = shown->refusal;
      return std::nullopt;
    }
  return ImagePair{grey_image(left.image), grey_image(right.image)};
}

/// How an observation stood against the estimate of its moment.
InspectionRow stand_of(Player::Run& run, const Observation& o, std::size_t index, const OnlineStep& step) {
  InspectionRow row;
  row.id = o.id;
  row.index = static_cast<int>(index);
  row.is_used = step.accepted;
  const IncrementalFit* fit = run.online.estimate();
  if (!fit) return row;
  Session one = run.frame;
  one.observations = {o};
  one.observations[0].decision = Decision::none;
  if (step.from_images) one.observations[0].sightings = step.sightings;
  if (step.accepted)
    for (const Sighting& s : one.observations[0].sightings) run.known[static_cast<std::size_t>(s.marker)] = 1;
  const Problem problem = make_problem(one, run.chain);
  if (!problem.observations.empty())
    inspect_observation(problem, problem.observations[0], fit->unknowns(), run.online.noise(), run.known, row);
  return row;
}

PlayedStep played_step(Player::Run& run, std::size_t index, OnlineStep step) {
  PlayedStep played{.step = std::move(step)};
  played.row = stand_of(run, run.session.observations[index], index, played.step);
  played.search = run.online.mount_progress();
  return played;
}

/// By its target where it has one, else by its images or labels.
OnlineStep decided(Player::Run& run, const Observation& o) {
  if (run.finder && has_images(o) && o.decision != Decision::excluded) {
    TargetFinding found = run.finder->find(o);
    Observation seen = o;
    seen.sightings = std::move(found.sightings);
    return run.online.add(seen, nullptr, found.reason);
  }
  QString refusal;
  const auto images = read_pair(run.session, o, refusal);
  if (refusal.isEmpty()) return run.online.add(o, images ? &*images : nullptr);
  OnlineStep step;
  step.id = o.id;
  step.reason = verbatim(refusal.toStdString());
  return step;
}

/// The step of one observation, after those of earlier ones that are decided with it.
void play_one(Player::Run& run, std::size_t index, std::vector<PlayedStep>& played) {
  const Observation& o = run.session.observations[index];
  OnlineStep step = decided(run, o);
  const auto& all = run.session.observations;
  for (OnlineStep& revised : run.online.take_revised()) {
    const auto earlier = std::find_if(all.begin(), all.end(), [&](const Observation& x) { return x.id == revised.id; });
    played.push_back(played_step(run, static_cast<std::size_t>(earlier - all.begin()), std::move(revised)));
  }
  played.push_back(played_step(run, index, std::move(step)));
}

}  // namespace

Player::Player(Workbench& workbench, QObject* parent) : QObject(parent), workbench_(workbench) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &Player::next);
  connect(&workbench.document, &Document::closed, this, &Player::rewind);
  connect(&workbench.document, &Document::edited, this, [this](const std::vector<std::int64_t>& ids) {
    if (is_own_edit_ || ids.empty()) return;
    const bool goes_on = wants_label().has_value();
    rewind();
    if (goes_on) play();
  });
  // What was under way is dropped: the online estimate would not know of it, or know too much.
  connect(&workbench.jobs, &Jobs::stopped, this, [this] {
    if (is_busy_) rewind();
  });
}

bool Player::is_finished() const { return run_ && steps_.size() == workbench_.document.session().observations.size(); }

const PlayedStep* Player::find_step(std::int64_t id) const {
  const int index = workbench_.document.find_index(id);
  return index >= 0 && static_cast<std::size_t>(index) < steps_.size() ? &steps_[static_cast<std::size_t>(index)]
                                                                       : nullptr;
}

std::optional<OnlineCalibration::MountProgress> Player::wants_label() const {
  return is_finished() && !is_playing_ && !steps_.empty() ? steps_.back().search : std::nullopt;
}

/// Sessions of a collection are played one by one, each opened by itself.
bool Player::can_play() const { return workbench_.document.is_open() && !is_joined(workbench_.document.session()); }

void Player::play() {
  if (!can_play() || is_playing_) return;
  if (is_finished() && !is_live_) rewind();
  is_playing_ = true;
  is_single_ = false;
  start_clock();
  hold_refit(true);
  emit state_changed();
  if (!is_busy_) next();
}

void Player::pause() {
  if (!is_playing_) return;
  stop();
  emit state_changed();
}

void Player::step() {
  if (!can_play() || is_busy_) return;
  if (is_playing_) stop();
  if (is_finished()) rewind();
  is_single_ = true;
  next();
}

void Player::stop() {
  is_playing_ = false;
  timer_.stop();
  hold_refit(false);
}

void Player::hold_refit(bool held) {
  if (held == holds_refit_) return;
  holds_refit_ = held;
  held ? workbench_.refit.hold() : workbench_.refit.release();
}

void Player::set_live(bool live) {
  if (live == is_live_) return;
  is_live_ = live;
  if (!live && is_playing_ && is_finished() && !is_busy_) pause();
  emit state_changed();
}

void Player::arrive(const std::vector<Observation>& arrived) {
  if (arrived.empty() || !workbench_.document.is_open()) return;
  // With its decision it is one action, and so are those that come while it is decided.
  if (arrival_join_ == 0) arrival_join_ = workbench_.document.new_join();
  Edit edit{.sentence = arrived.size() == 1
                            ? tr("observation %1 arrived").arg(arrived.front().id)
                            : tr("observations %1 to %2 arrived").arg(arrived.front().id).arg(arrived.back().id),
            .joins = arrival_join_,
            .added = arrived};
  is_own_edit_ = true;
  const bool is_done = workbench_.document.perform(std::move(edit));
  is_own_edit_ = false;
  if (!is_done) {
    arrival_join_ = 0;
    return;
  }
  if (run_) arrived_.insert(arrived_.end(), arrived.begin(), arrived.end());
  emit state_changed();
  if (!is_playing_) arrival_join_ = 0;
  if (is_playing_ && !is_busy_ && !timer_.isActive()) {
    start_clock();
    next();
  }
}

void Player::rewind() {
  if (is_playing_) stop();
  run_.reset();
  steps_.clear();
  arrived_.clear();
  arrival_join_ = 0;
  accepted_ = 0;
  is_busy_ = false;
  workbench_.label_wanted.reset();
  workbench_.jobs.cancel("play");
  emit rewound();
  emit state_changed();
}

std::size_t Player::due() const {
  constexpr std::size_t most = 64;
  if (is_single_) return 1;
  if (per_second_ <= 0) return most;
  const auto by_now = static_cast<std::size_t>(1e-3 * static_cast<double>(clock_.elapsed()) * per_second_) + 1;
  return std::clamp<std::size_t>(by_now - std::min(by_now, steps_.size() - clock_from_), 1, most);
}

void Player::next() {
  if (is_busy_ || !(is_playing_ || is_single_)) return;
  if (!run_) {
    try {
      run_ = std::make_shared<Run>(workbench_.document.session());
    } catch (const std::exception& error) {
      stop();
      emit workbench_.document.noticed(translated_error(error));
      emit state_changed();
      return;
    }
    join_ = workbench_.document.new_join();
  }
  for (Observation& o : arrived_) run_->session.observations.push_back(std::move(o));
  arrived_.clear();
  const std::size_t index = steps_.size();
  if (index >= run_->session.observations.size()) return is_live_ ? hold_refit(false) : pause();
  if (is_playing_) hold_refit(true);
  is_busy_ = true;
  const std::size_t end = std::min(index + due(), run_->session.observations.size());
  workbench_.jobs.start<std::shared_ptr<std::vector<PlayedStep>>>(
      "play", tr("Playing"),
      [run = run_, index, end](JobControl& control) {
        constexpr qint64 longest = 25;  // ms: then the window may show what there is
        auto played = std::make_shared<std::vector<PlayedStep>>();
        QElapsedTimer begun;
        begun.start();
        for (std::size_t i = index; i < end && !control.is_cancelled(); ++i) {
          if (i > index && begun.elapsed() >= longest) break;
          play_one(*run, i, *played);
        }
        return played;
      },
      [this, run = run_](const std::shared_ptr<std::vector<PlayedStep>>& played) {
        if (run == run_) take(std::move(*played));
      },
      [this, run = run_](const QString& sentence) {
        if (run != run_) return;
        is_busy_ = false;
        stop();
        emit workbench_.document.noticed(sentence);
        emit state_changed();
      });
}

bool Player::write_down(const std::vector<PlayedStep>& played) {
  std::vector<std::pair<std::int64_t, EditableState>> after;
  for (const PlayedStep& p : played) {
    std::erase_if(after, [&](const auto& one) { return one.first == p.step.id; });  // the last word counts
    const Observation* o = workbench_.document.find(p.step.id);
    if (!o || o->decision == Decision::excluded) continue;
    Observation decided = *o;
    keep_step(p.step, decided);
    after.push_back({o->id, read_state(decided)});
  }
  if (after.empty()) return true;
  Edit edit = workbench_.document.make_edit(
      tr("played to observation %1: %2 of %3 taken").arg(after.back().first).arg(accepted_).arg(steps_.size()), after);
  edit.joins = join_;
  if (arrival_join_ != 0) {
    edit.joins = arrival_join_;
    edit.sentence = tr("observation %1 arrived: %2")
                        .arg(after.back().first)
                        .arg(played.back().step.accepted ? tr("taken") : tr("rejected"));
  }
  is_own_edit_ = true;
  const bool is_done = workbench_.document.perform(std::move(edit));
  is_own_edit_ = false;
  return is_done;
}

void Player::take(std::vector<PlayedStep> played) {
  is_busy_ = false;
  is_single_ = false;
  for (PlayedStep& p : played) {
    const auto place = static_cast<std::size_t>(workbench_.document.find_index(p.step.id));
    const bool is_again = place < steps_.size();
    if (is_again) accepted_ -= steps_[place].step.accepted ? 1 : 0;
    accepted_ += p.step.accepted ? 1 : 0;
    p.accepted = accepted_;
    if (is_again) {
      steps_[place] = p;
    } else {
      steps_.push_back(p);
    }
  }
  // Decisions that cannot be written down are not there: the play starts over when there is room again.
  if (!write_down(played)) return rewind();
  if (is_finished()) workbench_.label_wanted = steps_.back().search ? steps_.back().search->label_next : std::nullopt;
  emit stepped(played);
  if (is_finished() && is_live_ && is_playing_) {
    hold_refit(false);
    arrival_join_ = 0;
    emit state_changed();
    return;
  }
  if (is_finished()) stop();
  emit state_changed();
  if (!is_playing_) return;
  const double next_at = per_second_ > 0 ? 1e3 * static_cast<double>(steps_.size() - clock_from_) / per_second_ : 0;
  timer_.start(std::max(0, static_cast<int>(next_at) - static_cast<int>(clock_.elapsed())));
}

void Player::set_speed(double per_second) {
  per_second_ = per_second;
  start_clock();
}

void Player::start_clock() {
  clock_.start();
  clock_from_ = steps_.size();
}

}  // namespace handsight::app
