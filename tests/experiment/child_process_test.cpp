// SPDX-License-Identifier: Apache-2.0
#include "experiment/driver/child_process.h"

#include <gtest/gtest.h>

#include <csignal>

namespace handsight {
namespace {

/// In a program that does nothing about signals, as one that uses the library may be.
class ChildProcesses : public testing::Test {
 protected:
  void SetUp() override { before_ = std::signal(SIGPIPE, SIG_DFL); }
  void TearDown() override { std::signal(SIGPIPE, before_); }

 private:
  void (*before_)(int) = SIG_DFL;
};

TEST_F(ChildProcesses, OneThatIsGoneDoesNotTakeTheProgramAlong) {
  ChildProcess child("exit 3");
  EXPECT_EQ(child.ending().english(), "ended with exit code 3");
  EXPECT_EQ(child.write_line("hello", 1), LineEnd::ended);
  EXPECT_EQ(child.write_line("hello", 1), LineEnd::ended) << "nor the second time";
  sigset_t pending;
  sigpending(&pending);
  EXPECT_EQ(sigismember(&pending, SIGPIPE), 0) << "no signal is left behind";
  std::string line;
  EXPECT_EQ(child.read_line(line, 1), LineEnd::ended);
}

TEST_F(ChildProcesses, LinesComeBackAsTheyWere) {
  ChildProcess child("cat");
  ASSERT_EQ(child.write_line("look", 1), LineEnd::whole);
  std::string line;
  ASSERT_EQ(child.read_line(line, 5), LineEnd::whole);
  EXPECT_EQ(line, "look");
}

}  // namespace
}  // namespace handsight
