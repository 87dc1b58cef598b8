// SPDX-License-Identifier: GPL-3.0-or-later
// Plays a session through the online calibration, observation by observation, in the background.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

#include "estimation/online/online.h"
#include "workbench/workbench.h"

namespace handsight::app {

/// One observation as it was decided, with how it stood against the estimate of that moment.
struct PlayedStep {
  OnlineStep step;
  InspectionRow row;  // without markers where nothing was estimated or found
  std::size_t accepted = 0;
  std::optional<OnlineCalibration::MountProgress> search;  // while the mount is looked for
};

class Player : public QObject {
  Q_OBJECT

 public:
  explicit Player(Workbench& workbench, QObject* parent = nullptr);

  bool is_playing() const { return is_playing_; }
  bool is_finished() const;
  bool is_live() const { return is_live_; }
  std::size_t position() const { return steps_.size(); }  // observations decided in this play
  const std::vector<PlayedStep>& steps() const { return steps_; }
  const PlayedStep* find_step(std::int64_t id) const;
  /// The play is over and the mount still unknown: which observation to label next. It goes on by itself when one is.
  std::optional<OnlineCalibration::MountProgress> wants_label() const;
  struct Run;

  /// From where it stopped; from the beginning where it was finished, or where the session was changed since.
  void play();
  void pause();
  void step();
  void rewind();
  /// Live: at the end of what there is the play waits for more and goes on by itself.
  void set_live(bool live);
  /// New observations for the end of the session: they become part of it, and are decided at once where a play waits
  /// for them. An arrival is one action with its decision.
  void arrive(const std::vector<Observation>& arrived);
  /// Observations a second; 0: as fast as it goes.
  void set_speed(double per_second);

 signals:
  /// One or more, as many as were decided since the last time; among them may be earlier ones, decided after all.
  void stepped(const std::vector<PlayedStep>& steps);
  void state_changed();
  void rewound();

 private:
  bool can_play() const;
  std::size_t due() const;  // how many observations the next job is to decide
  void next();
  void take(std::vector<PlayedStep> played);
  bool write_down(const std::vector<PlayedStep>& played);
  void start_clock();
  void stop();
  void hold_refit(bool held);

  Workbench& workbench_;
  std::shared_ptr<Run> run_;
  std::vector<PlayedStep> steps_;
  QTimer timer_;
  QElapsedTimer clock_;         // since playing began or its speed changed ...
  std::size_t clock_from_ = 0;  // ... with this many decided
  double per_second_ = 10;
  std::int64_t join_ = 0;
  std::vector<Observation> arrived_;  // in the document, not yet in the play
  std::int64_t arrival_join_ = 0;     // of those that are not decided yet; 0: all are
  bool is_live_ = false;
  std::size_t accepted_ = 0;
  bool is_playing_ = false, is_single_ = false, is_busy_ = false, holds_refit_ = false, is_own_edit_ = false;
};

}  // namespace handsight::app
