// SPDX-License-Identifier: Apache-2.0
#include "base/helping_threads.h"

#include <pthread.h>

#include <condition_variable>
#include <exception>
#include <list>
#include <mutex>
#include <thread>

namespace handsight {
namespace {

struct Call {
  const std::function<void()>* work;
  int wanted;       // helpers that may still begin
  int working = 0;  // helpers that have begun and not ended
  std::exception_ptr wrong;
};

class HelpingThreads {
 public:
  void offer(Call& call) {
    const int wanted = call.wanted;
    {
      const std::scoped_lock lock(mutex_);
      calls_.push_back(&call);
      while (idle_ < wanted && begin_thread()) {
      }
    }
    for (int i = 0; i < wanted; ++i) has_work_.notify_one();
  }

  void withdraw(Call& call) {
    std::unique_lock lock(mutex_);
    calls_.remove(&call);
    has_ended_.wait(lock, [&] { return call.working == 0; });
  }

 private:
  /// False where there are no more threads to be had: those that are there do the rest.
  bool begin_thread() {
    try {
      std::thread([this] { help(); }).detach();
    } catch (const std::exception&) {
      return false;
    }
    ++idle_;
    return true;
  }

  void help() {
    std::unique_lock lock(mutex_);
    for (;;) {
      has_work_.wait(lock, [&] { return !calls_.empty(); });
      Call& call = *calls_.front();
      if (--call.wanted == 0) calls_.pop_front();
      ++call.working;
      --idle_;
      lock.unlock();
      std::exception_ptr wrong;
      try {
        (*call.work)();
      } catch (...) {
        wrong = std::current_exception();
      }
      lock.lock();
      ++idle_;
      if (wrong) call.wrong = wrong;
      if (--call.working == 0) has_ended_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable has_work_, has_ended_;
  std::list<Call*> calls_;  // of which helpers are wanted, the oldest first
  int idle_ = 0;            // threads without work, those that are about to begin among them
};

// Never destroyed: its threads wait for work until the program ends.
HelpingThreads* shared = nullptr;

void begin_anew() { shared = new HelpingThreads; }

HelpingThreads& helping_threads() {
  // A child process has none of its parent's threads.
  static const int registered = (begin_anew(), pthread_atfork(nullptr, nullptr, begin_anew));
  static_cast<void>(registered);
  return *shared;
}

}  // namespace

void work_with_helpers(int helpers, const std::function<void()>& work) {
  if (helpers <= 0) return work();
  Call call{&work, helpers, 0, nullptr};
  helping_threads().offer(call);
  std::exception_ptr wrong;
  try {
    work();
  } catch (...) {
    wrong = std::current_exception();
  }
  helping_threads().withdraw(call);
  if (!wrong) wrong = call.wrong;
  if (wrong) std::rethrow_exception(wrong);
}

}  // namespace handsight
