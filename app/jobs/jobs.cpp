// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/jobs.h"

#include <algorithm>
#include <exception>

#include "base/freed_memory.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

/// A thread inherits the registers of the one that starts it. Where that one has just painted with AVX, their upper
/// halves hold something, and everything compiled for SSE2 runs at less than half its speed until they are cleared.
void clear_upper_registers() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx")) asm volatile("vzeroupper" ::: "memory");
#endif
}

/// What a long job has freed goes back to the system, rather than staying with this process for the next one.
void give_back_memory(std::chrono::steady_clock::time_point begin) {
  constexpr auto is_long = std::chrono::seconds(1);
  if (std::chrono::steady_clock::now() - begin > is_long) give_back_freed_memory();
}

}  // namespace

Jobs::Jobs(QObject* parent) : QObject(parent), worker_(new QObject) {
  worker_->moveToThread(&thread_);
  connect(&thread_, &QThread::finished, worker_, &QObject::deleteLater);
  thread_.start();
}

Jobs::~Jobs() {
  waiting_.clear();
  held_ = false;
  if (running_) running_->control.cancelled_ = true;
  thread_.quit();
  thread_.wait();
}

void Jobs::enqueue(const QString& kind, const QString& title, std::function<void(JobControl&)> work,
                   std::function<void()> done, std::function<void(QString)> failed) {
  std::erase_if(waiting_, [&](const auto& job) { return job->kind == kind; });
  if (running_ && running_->kind == kind) running_->control.cancelled_ = true;
  auto job = std::make_shared<Job>();
  job->kind = kind;
  job->title = title;
  job->work = std::move(work);
  job->done = std::move(done);
  job->failed = std::move(failed);
  waiting_.push_back(std::move(job));
  if (!running_) start_next();
}

void Jobs::start_next() {
  if (waiting_.empty()) {
    emit changed();
    emit idle();
    return;
  }
  running_ = waiting_.front();
  waiting_.pop_front();
  running_->begin = std::chrono::steady_clock::now();
  emit changed();
  QMetaObject::invokeMethod(worker_, [this, job = running_] {
    clear_upper_registers();
    constexpr unsigned long ms_of_a_look = 2;
    while (held_ && !job->control.is_cancelled()) QThread::msleep(ms_of_a_look);
    try {
      if (!job->control.is_cancelled()) job->work(job->control);
    } catch (const std::exception& error) {
      job->failure = translated_error(error);
      if (job->failure.isEmpty()) job->failure = tr("The job failed without saying why.");
    }
    job->work = nullptr;  // what it worked on, often a whole session, goes here: the window does not wait for it
    give_back_memory(job->begin);
    QMetaObject::invokeMethod(this, [this, job] { finish(job); });
  });
}

void Jobs::finish(const std::shared_ptr<Job>& job) {
  running_.reset();
  if (!job->control.is_cancelled()) {
    if (!job->failure.isEmpty()) {
      job->failed ? job->failed(job->failure) : emit failed(tr("%1: %2").arg(job->title, job->failure));
    } else {
      job->done();
    }
  }
  if (!running_) start_next();
}

void Jobs::cancel(const QString& kind) {
  const bool any = kind.isEmpty();
  std::erase_if(waiting_, [&](const auto& job) { return any || job->kind == kind; });
  if (!running_ || !(any || running_->kind == kind)) return;
  running_->control.cancelled_ = true;
  emit changed();
}

void Jobs::stop() {
  if (!running_) return;
  const QString title = running_->title;
  cancel();
  emit stopped(title);
}

bool Jobs::is_waiting(const QString& kind) const {
  return std::any_of(waiting_.begin(), waiting_.end(), [&](const auto& job) { return job->kind == kind; });
}

bool Jobs::is_busy(const QString& kind) const {
  return (running_ && running_->kind == kind && !running_->control.is_cancelled()) || is_waiting(kind);
}

JobState Jobs::state() const {
  if (!running_ || running_->control.is_cancelled()) return {};
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - running_->begin).count();
  JobState state{true, running_->title, running_->control.share_, seconds, {}};
  // A guess from little of the work jumps about: the first parts of a job are not like the others.
  if (state.share > 0.05 && seconds > (state.share > 0.2 ? 1 : 4))
    state.seconds_left = seconds * (1 - state.share) / state.share;
  return state;
}

}  // namespace handsight::app
