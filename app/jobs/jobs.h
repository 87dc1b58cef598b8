// SPDX-License-Identifier: GPL-3.0-or-later
// Background work: one worker thread that does one job after the other on copies, and hands results back to the
// window's thread.
#pragma once

#include <QObject>
#include <QString>
#include <QThread>
#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>

namespace handsight::app {

/// What a job sees of the outside.
class JobControl {
 public:
  bool is_cancelled() const { return cancelled_; }
  /// Share that is done, 0 to 1; one that is less than was reported before is kept to oneself.
  void report(double share) {
    if (share > share_) share_ = share;
  }

 private:
  friend class Jobs;
  std::atomic<bool> cancelled_{false};
  std::atomic<double> share_{0};
};

/// The job that runs, for people.
struct JobState {
  bool is_running = false;
  QString title;
  double share = 0;                    // 0 to 1; 0: the job does not say
  double seconds = 0;                  // since it began
  std::optional<double> seconds_left;  // nothing while too little is done to tell
};

class Jobs : public QObject {
  Q_OBJECT

 public:
  explicit Jobs(QObject* parent = nullptr);
  /// Cancels what runs and waits for it.
  ~Jobs() override;

  /// Runs `work` in the background, then `done` with its result in this thread. A job of the same `kind` that waits or
  /// runs is cancelled and its result dropped: only the newest counts. A sentence that `work` throws goes to `failed`,
  /// and to the signal of that name where there is none.
  template <class Result>
  void start(const QString& kind, const QString& title, std::function<Result(JobControl&)> work,
             std::function<void(Result)> done, std::function<void(QString)> failed = {}) {
    auto result = std::make_shared<std::optional<Result>>();
    enqueue(
        kind, title, [result, work = std::move(work)](JobControl& control) { result->emplace(work(control)); },
        [result, done = std::move(done)] {
          if (*result) done(std::move(**result));
        },
        std::move(failed));
  }

  /// Drops the jobs of that kind, or all where no kind is given, with their results.
  void cancel(const QString& kind = {});
  /// The same for all, at the user's wish: `stopped` is said.
  void stop();
  /// While held, a job waits at its beginning until it is let go or cancelled: who presses Cancel is never too late.
  void hold(bool held) { held_ = held; }
  bool is_busy() const { return running_ != nullptr || !waiting_.empty(); }
  bool is_busy(const QString& kind) const;
  /// Has a job of that kind not begun?
  bool is_waiting(const QString& kind) const;
  JobState state() const;

 signals:
  /// A job began, ended, or went on.
  void changed();
  void stopped(const QString& title);
  /// Why a job that nobody answers for came to nothing.
  void failed(const QString& sentence);
  void idle();

 private:
  struct Job {
    QString kind, title;
    std::function<void(JobControl&)> work;
    std::function<void()> done;
    std::function<void(QString)> failed;
    JobControl control;
    QString failure;
    std::chrono::steady_clock::time_point begin;
  };
  void enqueue(const QString& kind, const QString& title, std::function<void(JobControl&)> work,
               std::function<void()> done, std::function<void(QString)> failed);
  void start_next();
  void finish(const std::shared_ptr<Job>& job);

  QThread thread_;
  QObject* worker_;
  std::atomic<bool> held_{false};
  std::shared_ptr<Job> running_;
  std::deque<std::shared_ptr<Job>> waiting_;
};

/// What a long computation asks from time to time: may it go on?
inline std::function<bool()> going_on(const JobControl& control) {
  return [&control] { return !control.is_cancelled(); };
}

}  // namespace handsight::app
