// SPDX-License-Identifier: GPL-3.0-or-later
// Adds the best candidate again and again until none is left that helps, stair by stair before the user's eyes.
#pragma once

#include "explain/adding.h"
#include "widgets/explain/candidate_list.h"

namespace handsight::app {

class AddingOn : public QObject {
  Q_OBJECT

 public:
  AddingOn(Workbench& workbench, Adding& adding, widgets::CandidateList& cards, QObject* parent = nullptr);

  /// Seeks longer where that alone is left to do.
  void start();
  /// What is being added now is stopped with it; of what seeks longer, what it has found is taken.
  void stop();
  /// What is being added is added to its end; then it rests, on the proof of what came last, until it goes on.
  void pause();
  void go_on();
  bool is_running() const { return is_running_; }
  bool is_paused() const { return is_paused_; }
  /// Something was added, and other names for it were not sought yet: there is something to do without any card.
  bool can_seek() const;
  /// All that is quick was done, and more than noise is left: other ends may be sought, which takes minutes.
  bool can_seek_longer() const;
  /// The cards are up to date: takes the first where it can be added, else it is done.
  void look();

 signals:
  void changed();
  void done();  // it has come to its end by itself

 private:
  void note_taken();
  void end(const QString& sentence);
  bool is_waiting() const;
  void add_first();
  /// In the order of `improve`, not of the cards, which put first what robots usually have.
  std::optional<std::string> first_to_add() const;
  /// Nothing is left to add: other names for what was added, then the end.
  void seek_or_end();
  void seek(Adding::Seeking what);
  QString reported_at_the_end() const;

  Workbench& workbench_;
  Adding& adding_;
  widgets::CandidateList& cards_;
  QTimer next_;  // a stair stands for a moment before the next one
  bool is_running_ = false, is_paused_ = false;
  int added_ = 0, sought_ = 0;  // causes; how often other names were sought
  bool is_seeking_ = false, is_seeking_longer_ = false, found_others_ = false, found_background_ = false;
  bool only_likely_ = false;  // a name was taken for being likely: other names are no longer sought
  std::optional<std::int64_t> sought_at_, sought_longer_at_;  // the document's revision
};

}  // namespace handsight::app
