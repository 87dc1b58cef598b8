// SPDX-License-Identifier: Apache-2.0
#include "jobs/jobs.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>
#include <stdexcept>

namespace handsight::app {
namespace {

void run_until_idle(Jobs& jobs) {
  if (!jobs.is_busy()) return;
  QEventLoop loop;
  QObject::connect(&jobs, &Jobs::idle, &loop, &QEventLoop::quit);
  QTimer::singleShot(20000, &loop, &QEventLoop::quit);
  loop.exec();
  ASSERT_FALSE(jobs.is_busy());
}

TEST(JobsTest, ResultsComeBackInTheCallersThread) {
  Jobs jobs;
  QThread* worker = nullptr;
  QThread* back = nullptr;
  int result = 0;
  jobs.start<int>(
      "add", "Adding",
      [&](JobControl&) {
        worker = QThread::currentThread();
        return 42;
      },
      [&](int sum) {
        back = QThread::currentThread();
        result = sum;
      });
  run_until_idle(jobs);
  EXPECT_EQ(result, 42);
  EXPECT_EQ(back, QThread::currentThread());
  EXPECT_NE(worker, back);
}

TEST(JobsTest, OnlyTheNewestOfAKindCounts) {
  Jobs jobs;
  std::vector<int> results;
  for (int n = 0; n < 20; ++n)
    jobs.start<int>(
        "fit", "Fitting", [n](JobControl&) { return n; }, [&](int result) { results.push_back(result); });
  run_until_idle(jobs);
  EXPECT_EQ(results, std::vector<int>{19});
}

TEST(JobsTest, ProgressNeverRunsBack) {
  Jobs jobs;
  std::atomic<int> reported{0};
  std::atomic<bool> may_end{false};
  jobs.start<int>(
      "long", "Long work",
      [&](JobControl& control) {
        control.report(0.97);
        control.report(0.60);
        reported = 1;
        while (!may_end && !control.is_cancelled()) QThread::msleep(1);
        return 0;
      },
      [](int) {});
  while (reported == 0) QCoreApplication::processEvents();
  EXPECT_EQ(jobs.state().share, 0.97);
  may_end = true;
  run_until_idle(jobs);
}

TEST(JobsTest, CancelStopsAndDropsTheResult) {
  Jobs jobs;
  bool done = false, saw_cancel = false;
  QString stopped;
  QObject::connect(&jobs, &Jobs::stopped, [&](const QString& title) { stopped = title; });
  jobs.start<int>(
      "long", "Long work",
      [&](JobControl& control) {
        for (int i = 0; i < 100000 && !control.is_cancelled(); ++i) {
          control.report(i / 100000.0);
          QThread::usleep(100);
        }
        saw_cancel = control.is_cancelled();
        return 1;
      },
      [&](int) { done = true; });
  QTimer::singleShot(30, [&] {
    EXPECT_TRUE(jobs.state().is_running);
    EXPECT_EQ(jobs.state().title, "Long work");
    jobs.stop();
  });
  run_until_idle(jobs);
  EXPECT_TRUE(saw_cancel);
  EXPECT_FALSE(done);
  EXPECT_EQ(stopped, "Long work");
}

TEST(JobsTest, AFailureIsASentenceNotACrash) {
  Jobs jobs;
  QString failure;
  bool next = false;
  jobs.start<int>(
      "bad", "Bad", [](JobControl&) -> int { throw std::runtime_error("The robot has no joints."); }, [](int) {},
      [&](const QString& sentence) { failure = sentence; });
  jobs.start<int>(
      "good", "Good", [](JobControl&) { return 1; }, [&](int) { next = true; });
  run_until_idle(jobs);
  EXPECT_EQ(failure, "The robot has no joints.");
  EXPECT_TRUE(next);
}

TEST(JobsTest, DestroyedWhileWorkingItStops) {
  bool done = false;
  {
    Jobs jobs;
    jobs.start<int>(
        "long", "Long",
        [](JobControl& control) {
          while (!control.is_cancelled()) QThread::usleep(100);
          return 1;
        },
        [&](int) { done = true; });
    QThread::msleep(5);
  }
  EXPECT_FALSE(done);
}

TEST(Jobs, OneThatIsHeldCanBeCancelledHoweverQuickItIs) {
  Jobs jobs;
  jobs.hold(true);
  std::atomic<bool> has_run{false};
  bool is_done = false;
  jobs.start<int>(
      "quick", "Quick",
      [&](JobControl&) {
        has_run = true;
        return 1;
      },
      [&](int) { is_done = true; });
  EXPECT_TRUE(jobs.is_busy("quick"));
  jobs.cancel("quick");
  while (jobs.is_busy()) QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
  EXPECT_FALSE(has_run);
  EXPECT_FALSE(is_done);
  jobs.start<int>(
      "quick", "Quick", [](JobControl&) { return 1; }, [&](int) { is_done = true; });
  jobs.hold(false);
  while (jobs.is_busy()) QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
  EXPECT_TRUE(is_done);
}

}  // namespace
}  // namespace handsight::app
