// SPDX-License-Identifier: Apache-2.0
#include "base/threads.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <latch>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace handsight {
namespace {

class Threads : public testing::Test {
 protected:
  void SetUp() override { most_threads() = 4; }
  void TearDown() override { most_threads() = 0; }
};

/// How many threads did four parts of which each takes a while.
std::size_t threads_of_slow_parts() {
  std::set<std::thread::id> seen;
  std::mutex one_at_a_time;
  each_part(4, true, [&](int) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const std::scoped_lock lock(one_at_a_time);
    seen.insert(std::this_thread::get_id());
  });
  return seen.size();
}

TEST_F(Threads, DoEachPartOnce) {
  for (const int count : {0, 1, 3, 1000}) {
    std::vector<int> done(static_cast<std::size_t>(count), 0);
    each_part(count, true, [&](int i) { ++done[static_cast<std::size_t>(i)]; });
    EXPECT_EQ(done, std::vector<int>(static_cast<std::size_t>(count), 1));
  }
}

TEST_F(Threads, LetWhatGoesWrongBeHeardWhereverItDoes) {
  for (const int wrong : {0, 50, 99})
    EXPECT_THROW(each_part(100, true,
                           [&](int i) {
                             if (i == wrong) throw std::runtime_error("here");
                           }),
                 std::runtime_error);
  EXPECT_FALSE(is_a_part());
}

TEST_F(Threads, AreNotBegunByPartsOfPartsWhileAllAreAtWork) {
  std::latch all_begin(4), all_end(4);
  std::atomic<int> elsewhere{0};
  each_part(4, true, [&](int) {
    all_begin.arrive_and_wait();
    const auto here = std::this_thread::get_id();
    each_part(8, true, [&](int) { elsewhere += std::this_thread::get_id() != here ? 1 : 0; });
    all_end.arrive_and_wait();
  });
  EXPECT_EQ(elsewhere, 0);
  EXPECT_EQ(threads_for(8), 4);
  EXPECT_EQ(threads_at_work(), 0);
}

TEST_F(Threads, ThatAreIdleHelpThePartThatIsLeft) {
  std::latch others_end(3);
  std::size_t helped = 0;
  each_part(4, true, [&](int i) {
    if (i > 0) return others_end.count_down();
    others_end.wait();
    while (threads_at_work() > 1) std::this_thread::yield();
    EXPECT_EQ(threads_for(8), 4);
    helped = threads_of_slow_parts();
  });
  EXPECT_GT(helped, 1U);
  EXPECT_EQ(threads_at_work(), 0);
}

TEST_F(Threads, AreNotBegunWhereItIsNotWorthIt) {
  const auto here = std::this_thread::get_id();
  each_part(8, false, [&](int) { EXPECT_EQ(std::this_thread::get_id(), here); });
}

TEST_F(Threads, AreNotBegunAnewForEveryWork) {
  std::set<std::thread::id> seen;
  std::mutex one_at_a_time;
  for (int work = 0; work < 200; ++work)
    each_part(4, true, [&](int) {
      const std::scoped_lock lock(one_at_a_time);
      seen.insert(std::this_thread::get_id());
    });
  EXPECT_LE(seen.size(), 8U) << "of 600: one that was about to be idle as another work began may have made it one more";
}

TEST_F(Threads, HelpSeveralCallersAtOnce) {
  std::atomic<int> done{0};
  std::vector<std::thread> callers;
  for (int caller = 0; caller < 8; ++caller)
    callers.emplace_back([&] {
      for (int work = 0; work < 200; ++work) each_part(10, true, [&](int) { ++done; });
    });
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(done, 8 * 200 * 10);
}

TEST_F(Threads, HelpInAChildProcessToo) {
  EXPECT_GT(threads_of_slow_parts(), 1U);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) _exit(threads_of_slow_parts() > 1 ? 0 : 1);
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace handsight
