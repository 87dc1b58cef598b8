// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibrate/player.h"

#include <algorithm>

#include "model/chain.h"

namespace handsight::app {

/// What one play works on, in the worker's hands alone while a step runs.
struct Player::Run {
  Session session;  // a copy, as it was when the play began
  Chain chain;
  OnlineCalibration online;
  Session frame;            // the session without its observations
  std::vector<char> known;  // markers that some accepted observation showed

  explicit Run(const Session& from)
      : session(from),
        chain(chain_of(session)),
        online(session),
        frame(session),
        known(static_cast<std::size_t>(session.marker_count), 0) {
    frame.observations.clear();
    frame.source.reset();
  }
};

namespace {

/// The images of an observation; the sentence where one cannot be read.
std::optional<ImagePair> read_pair(const Session& session, const Observation& o, std::string& refusal) {
  if (o.left_image.empty() || o.right_image.empty() || !session.stereo || o.decision == Decision::excluded)
    return std::nullopt;
  const ShownImage left = read_shown_image(folder(session) / o.left_image, o.left_image, session.stereo->left);
  const ShownImage right = read_shown_image(folder(session) / o.right_image, o.right_image, session.stereo->right);
  for (const ShownImage* shown : {&left, &right})
    if (shown->image.isNull()) {
      refusal = shown->refusal.toStdString();
      return std::nullopt;
    }
  return ImagePair{grey_image(left.image), grey_image(right.image)};
}

}  // namespace

Player::Player(Workbench& bench, QObject* parent) : QObject(parent), bench_(bench) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &Player::next);
  connect(&bench.document, &Document::closed, this, &Player::rewind);
  connect(&bench.document, &Document::edited, this, [this](const std::vector<std::int64_t>& ids) {
    if (!is_own_edit_ && !ids.empty()) rewind();
  });
}

bool Player::is_finished() const { return run_ && steps_.size() == bench_.document.session().observations.size(); }

const PlayedStep* Player::step_of(std::int64_t id) const {
  const int index = bench_.document.index_of(id);
  return index >= 0 && static_cast<std::size_t>(index) < steps_.size() ? &steps_[static_cast<std::size_t>(index)]
                                                                       : nullptr;
}

void Player::play() {
  if (!bench_.document.is_open() || is_playing_) return;
  if (is_finished()) rewind();
  is_playing_ = true;
  is_single_ = false;
  if (!holds_refit_) bench_.refit.hold();
  holds_refit_ = true;
  emit state_changed();
  if (!is_busy_) next();
}

void Player::pause() {
  if (!is_playing_) return;
  stop();
  emit state_changed();
}

void Player::step() {
  if (!bench_.document.is_open() || is_busy_) return;
  if (is_playing_) stop();
  if (is_finished()) rewind();
  is_single_ = true;
  next();
}

void Player::stop() {
  is_playing_ = false;
  timer_.stop();
  if (holds_refit_) {
    holds_refit_ = false;
    bench_.refit.release();
  }
}

void Player::rewind() {
  if (is_playing_) stop();
  run_.reset();
  steps_.clear();
  accepted_ = 0;
  is_busy_ = false;
  bench_.jobs.cancel("play");
  emit rewound();
  emit state_changed();
}

void Player::next() {
  if (is_busy_ || !(is_playing_ || is_single_)) return;
  if (!run_) {
    try {
      run_ = std::make_shared<Run>(bench_.document.session());
    } catch (const std::exception& error) {
      stop();
      emit bench_.document.noticed(QString::fromStdString(error.what()));
      emit state_changed();
      return;
    }
    join_ = bench_.document.new_join();
  }
  const std::size_t index = steps_.size();
  if (index >= run_->session.observations.size()) return pause();
  is_busy_ = true;
  begun_.start();
  bench_.jobs.start<std::shared_ptr<PlayedStep>>(
      "play", tr("Playing"),
      [run = run_, index](JobControl&) {
        const Observation& o = run->session.observations[index];
        auto played = std::make_shared<PlayedStep>();
        std::string refusal;
        const auto images = read_pair(run->session, o, refusal);
        if (refusal.empty()) {
          played->step = run->online.add(o, images ? &*images : nullptr);
        } else {
          played->step.id = o.id;
          played->step.reason = refusal;
        }
        const IncrementalFit* fit = run->online.estimate();
        played->row.id = o.id;
        played->row.index = static_cast<int>(index);
        played->row.is_used = played->step.accepted;
        if (!fit) return played;
        Session one = run->frame;
        one.observations = {o};
        one.observations[0].decision = Decision::none;
        if (played->step.from_images) one.observations[0].sightings = played->step.sightings;
        if (played->step.accepted)
          for (const Sighting& s : one.observations[0].sightings) run->known[static_cast<std::size_t>(s.marker)] = 1;
        const Problem problem = make_problem(one, run->chain);
        if (!problem.observations.empty())
          inspect_observation(problem, problem.observations[0], fit->unknowns(), run->online.noise(), run->known,
                              played->row);
        return played;
      },
      [this, run = run_](const std::shared_ptr<PlayedStep>& played) {
        if (run == run_) take(played);
      },
      [this, run = run_](const QString& sentence) {
        if (run != run_) return;
        is_busy_ = false;
        stop();
        emit bench_.document.noticed(sentence);
        emit state_changed();
      });
}

void Player::take(std::shared_ptr<PlayedStep> played) {
  is_busy_ = false;
  is_single_ = false;
  accepted_ += played->step.accepted ? 1 : 0;
  played->accepted = accepted_;
  steps_.push_back(*played);
  const Observation* o = bench_.document.find(played->step.id);
  if (o && o->decision != Decision::excluded) {
    Observation decided = *o;
    keep_step(played->step, decided);
    Edit edit = bench_.document.edit_of(
        tr("played to observation %1: %2 of %3 taken").arg(played->step.id).arg(accepted_).arg(steps_.size()),
        {{o->id, state_of(decided)}});
    edit.joins = join_;
    is_own_edit_ = true;
    bench_.document.perform(std::move(edit));
    is_own_edit_ = false;
  }
  emit stepped(steps_.back());
  if (is_finished()) stop();
  emit state_changed();
  if (is_playing_) {
    const auto pause = per_second_ > 0 ? static_cast<qint64>(1000 / per_second_) - begun_.elapsed() : 0;
    timer_.start(static_cast<int>(std::max<qint64>(0, pause)));
  }
}

}  // namespace handsight::app
