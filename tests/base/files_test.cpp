// SPDX-License-Identifier: Apache-2.0
#include "base/files.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "base/error.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

std::string refusal(auto&& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

int count_files(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Files, WhatIsWrittenIsRead) {
  const TemporaryFolder folder;
  std::string content = "line 1\r\nline 2 \xC3\xBC";
  content += '\0';
  content += std::string(200000, 'z');
  replace_file(folder.path / "a.txt", content);
  EXPECT_EQ(read_file(folder.path / "a.txt"), content);
  replace_file(folder.path / "a.txt", "short");
  EXPECT_EQ(read_file(folder.path / "a.txt"), "short");
  EXPECT_EQ(count_files(folder.path), 1) << "a temporary file was left";
}

TEST(Files, PermissionsAreKept) {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "a.txt";
  replace_file(file, "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  replace_file(file, "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST(Files, NewFilesFollowTheUsersMask) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  replace_file(folder.path / "a.txt", "new");
  ::umask(before);
  EXPECT_EQ(static_cast<unsigned>(fs::status(folder.path / "a.txt").permissions()), 0640u);
}

TEST(Files, LinksStayLinks) {
  const TemporaryFolder folder;
  replace_file(folder.path / "real.txt", "old");
  fs::create_symlink("real.txt", folder.path / "link.txt");
  replace_file(folder.path / "link.txt", "new");
  EXPECT_TRUE(fs::is_symlink(folder.path / "link.txt"));
  EXPECT_EQ(read_file(folder.path / "real.txt"), "new");
}

TEST(Files, WhatCannotBeReadIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal([&] { read_file(folder.path / "none.txt"); }),
              testing::HasSubstr("none.txt: the file cannot be opened"));
  EXPECT_THAT(refusal([&] { read_file(folder.path); }), testing::HasSubstr("cannot be read"));
}

TEST(Files, AFailureLeavesTheOldFile) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal([&] { replace_file(folder.path / "no_folder" / "a.txt", "x"); }),
              testing::HasSubstr("cannot be written"));
  // A folder of that name: the rename fails after everything was written.
  fs::create_directory(folder.path / "taken");
  replace_file(folder.path / "taken" / "inside.txt", "old");
  EXPECT_THAT(refusal([&] { replace_file(folder.path / "taken", "x"); }), testing::HasSubstr("is as it was"));
  EXPECT_EQ(read_file(folder.path / "taken" / "inside.txt"), "old");
  EXPECT_EQ(count_files(folder.path), 1) << "a temporary file was left";
}

TEST(Files, ADiskThatFillsUpLeavesTheOldFile) {
  const TemporaryFolder folder;
  replace_file(folder.path / "a.txt", "old");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string said = refusal([&] { replace_file(folder.path / "a.txt", std::string(5000, 'x')); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_THAT(said, testing::HasSubstr("is as it was"));
  EXPECT_EQ(read_file(folder.path / "a.txt"), "old");
  EXPECT_EQ(count_files(folder.path), 1) << "a temporary file was left";
}

}  // namespace
}  // namespace handsight
