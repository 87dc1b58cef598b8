// SPDX-License-Identifier: Apache-2.0
#include "base/files.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <vector>

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

TEST(Files, PipesAndDevicesAreNeitherReadNorWrittenOver) {
  const TemporaryFolder folder;
  const fs::path pipe = folder.path / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0666), 0);
  EXPECT_THAT(refusal([&] { read_file(pipe); }), testing::HasSubstr("a device or a pipe"));
  EXPECT_THAT(refusal([] { read_file("/dev/zero"); }), testing::HasSubstr("a device or a pipe"));
  EXPECT_THAT(refusal([&] { replace_file(pipe, "x"); }), testing::HasSubstr("a device or a pipe"));
  EXPECT_THAT(refusal([] { replace_file("/dev/null", "x"); }), testing::HasSubstr("a device or a pipe"));
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(Files, WriteProtectedFilesStay) {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "a.txt";
  replace_file(file, "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::group_read);
  EXPECT_THAT(refusal([&] { replace_file(file, "new"); }), testing::HasSubstr("write protected"));
  EXPECT_EQ(read_file(file), "old");
}

TEST(Files, WhatAnotherProgramWroteIsNotReplaced) {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "a.txt";
  replace_file(file, "first");
  const FileDigest read = *compute_digest(file);
  EXPECT_EQ(read, digest_of_content("first"));
  replace_unchanged_file(file, "second", read);
  EXPECT_THAT(refusal([&] { replace_unchanged_file(file, "third", read); }),
              testing::HasSubstr("another program has changed the file"));
  EXPECT_EQ(read_file(file), "second");
  fs::remove(file);
  EXPECT_THAT(refusal([&] { replace_unchanged_file(file, "third", read); }), testing::HasSubstr("another program"));
  EXPECT_FALSE(fs::exists(file));
  EXPECT_EQ(count_files(folder.path), 0) << "a temporary file was left";
  EXPECT_FALSE(compute_digest(file));
}

TEST(Files, TwoWritersLoseNothingOfEachOther) {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "count.txt";
  replace_file(file, "0");
  constexpr int rounds = 100;
  std::vector<pid_t> writers;
  for (int w = 0; w < 2; ++w) {
    const pid_t writer = ::fork();
    ASSERT_GE(writer, 0);
    if (writer > 0) {
      writers.push_back(writer);
      continue;
    }
    for (int done = 0; done < rounds;) {
      const std::string content = read_file(file);
      try {
        replace_unchanged_file(file, std::to_string(std::stoi(content) + 1), digest_of_content(content));
        ++done;
      } catch (const InputError&) {  // the other was quicker: once more on what is there now
      }
    }
    ::_exit(0);
  }
  for (const pid_t writer : writers) ::waitpid(writer, nullptr, 0);
  EXPECT_EQ(read_file(file), std::to_string(2 * rounds));
}

TEST(Files, WhatAKilledRunLeftIsRemovedByTheNext) {
  const TemporaryFolder folder;
  const pid_t gone = ::fork();
  if (gone == 0) ::_exit(0);
  ::waitpid(gone, nullptr, 0);
  const fs::path left = folder.path / (".handsight-" + std::to_string(gone) + "-1.tmp"),
                 part = folder.path / (".handsight-" + std::to_string(gone) + "-2.part"),
                 working = folder.path / (".handsight-" + std::to_string(::getppid()) + "-1.tmp"),
                 foreign = folder.path / ".handsight-notes.tmp", users = folder.path / "d.part";
  fs::create_directories(part / "images");
  fs::create_directories(users);
  for (const fs::path& file : {left, working, foreign, part / "session.xml"}) std::ofstream(file) << "x";
  replace_file(folder.path / "a.txt", "new");
  EXPECT_FALSE(fs::exists(left));
  EXPECT_FALSE(fs::exists(part));
  EXPECT_TRUE(fs::exists(working)) << "a run that goes on";
  EXPECT_TRUE(fs::exists(foreign));
  EXPECT_TRUE(fs::exists(users));
}

TEST(Files, TemporaryFoldersAreNew) {
  const TemporaryFolder folder;
  const fs::path first = make_temporary_folder(folder.path), second = make_temporary_folder(folder.path);
  EXPECT_NE(first, second);
  EXPECT_TRUE(fs::is_empty(first));
}

}  // namespace
}  // namespace handsight
