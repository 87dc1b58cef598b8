// SPDX-License-Identifier: Apache-2.0
// A window that is killed at any moment leaves whole files: the session, its journal, the exported calibration and the
// reports. HANDSIGHT_KILLS says how often.
#include "app/document/kills.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "app/document/killed_writer.h"
#include "app/window/desk.h"
#include "base/files.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

bool ends_with(const std::filesystem::path& file, const std::string& end) {
  std::string text = read_file(file);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.ends_with(end);
}

/// What is there at all is whole.
void expect_whole(const std::filesystem::path& out) {
  for (const auto& [name, end] : {std::pair{"out.xml", "</handsight_calibration>"}, std::pair{"out.html", "</html>"},
                                  std::pair{"out.pdf", "%%EOF"}})
    if (std::filesystem::exists(out / name)) {
      EXPECT_TRUE(ends_with(out / name, end)) << name;
    }
}

TEST(Kills, AWindowLeavesWholeFilesAndLosesNoAction) {
  const TemporaryFolder folder;
  const auto out = folder.path / "out";
  std::filesystem::create_directories(out);
  const auto session = copy_of_sample(folder.path, "thesis_simulation");
  std::mt19937 random(5);
  std::uniform_int_distribution<useconds_t> microseconds(1000, 1500000);
  std::ptrdiff_t known = 0;
  for (int round = 0; round < kills(4); ++round) {
    const auto said = said_before_killed("--work-until-killed", {session.string(), out.string()}, microseconds(random));
    ASSERT_FALSE(said.empty()) << "the process died by itself";
    expect_whole(out);
    EXPECT_NO_THROW(read_session(session));
    const auto done = known + std::count(said.begin(), said.end(), "action\n");
    app::Document document;
    document.open(session);
    const int index = document.undo_stack().index();
    ASSERT_TRUE(index == done || index == done + 1) << "round " << round << ": said " << done << ", found " << index;
    known = index;
    if (document.is_saved()) {  // closed like this, nothing would be left to recover
      document.perform(numbered_action(document, static_cast<int>(++known)));
    }
    if (round % 10 != 9) continue;  // the history stays short
    document.undo_all();
    document.save();
    document.close();
    known = 0;
  }
  replace_file(out / "out.xml", "");  // the next writer clears what killed ones have left
  for (const auto& file : std::filesystem::directory_iterator(out))
    EXPECT_TRUE(std::set<std::string>({"out.xml", "out.html", "out.pdf"}).contains(file.path().filename()))
        << file.path();
}

}  // namespace
}  // namespace handsight::test
