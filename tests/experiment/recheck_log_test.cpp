// SPDX-License-Identifier: Apache-2.0
#include "experiment/recheck/recheck_log.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::HasSubstr;

RecheckEntry entry() {
  return {.utc = "2026-11-26T05:09:00Z",
          .id = 12,
          .e_value = 0.25,
          .what = "joint_offset",
          .where = "a3, \"elbow\"",
          .text = message("Joint {} is \"off\" by {:.1f} mrad, or {} & more", "a3", 0.2, verbatim("b")),
          .numbers = {{"joint_offset", "a.3", "offset", 2e-4, 1e-5, "rad"}, {"body_slip", "", "x", -3e-4, 2e-4, "m"}}};
}

std::string find_refusal(const std::filesystem::path& csv) {
  try {
    (void)read_recheck_log(csv);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(RecheckLog, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  const auto csv = folder.path / "recheck.csv";
  EXPECT_TRUE(read_recheck_log(csv).empty()) << "no log yet";
  RecheckEntry second = entry();
  second.changed = true;
  second.e_value = 2500;
  add_to_log(csv, entry());
  add_to_log(csv, second);
  const auto read = read_recheck_log(csv);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].utc, entry().utc);
  EXPECT_EQ(read[0].id, 12);
  EXPECT_EQ(read[0].e_value, 0.25);
  EXPECT_FALSE(read[0].changed);
  EXPECT_EQ(read[0].where, entry().where);
  EXPECT_EQ(read[0].text, entry().text);
  EXPECT_TRUE(read[1].changed);
  ASSERT_EQ(read[0].numbers.size(), 2U);
  EXPECT_EQ(read[0].numbers[0].where, "a.3");
  EXPECT_EQ(read[0].numbers[0].name, "offset");
  EXPECT_DOUBLE_EQ(read[0].numbers[0].value, 2e-4);
  EXPECT_EQ(read[0].numbers[1].what, "body_slip");
  EXPECT_DOUBLE_EQ(read[0].numbers[1].value, -3e-4);
  EXPECT_DOUBLE_EQ(read[0].numbers[1].sigma, 2e-4);
  EXPECT_EQ(read[0].numbers[1].unit, "m");
}

TEST(RecheckLog, KeepsThePartsOfWhatItSaysForTheReadersLanguage) {
  const TemporaryFolder folder;
  const auto csv = folder.path / "recheck.csv";
  add_to_log(csv, entry());
  const Message text = read_recheck_log(csv).front().text;
  EXPECT_EQ(text.form(), entry().text.form());
  ASSERT_EQ(text.arguments().size(), 3U);
  EXPECT_EQ(text.arguments()[1].kind(), Message::Kind::number);
  EXPECT_EQ(text, entry().text);
}

TEST(RecheckLog, WithoutPartsSaysItsEnglish) {
  const TemporaryFolder folder;
  const auto csv = folder.path / "recheck.csv";
  const std::string line = "2026-01-01T00:00:00Z,1,0.5,0,body_slip,\"\",\"it, \"\"moved\"\"\",\"\"";
  replace_file(csv, "utc,id,e_value,changed,what,where,text,numbers\n" + line + "\n");
  EXPECT_EQ(read_recheck_log(csv).front().text, "it, \"moved\"");
  add_to_log(csv, entry());
  EXPECT_EQ(read_recheck_log(csv).back().text, entry().text);
  replace_file(csv, "utc,id,e_value,changed,what,where,text,numbers,parts\n" + line + ",<text><form\n");
  EXPECT_EQ(read_recheck_log(csv).front().text, "it, \"moved\"") << "parts that somebody has cut";
}

TEST(RecheckLog, OneOfBeforeGoesOnAsItWasBegun) {
  const TemporaryFolder folder;
  const auto csv = folder.path / "recheck.csv";
  replace_file(csv, "utc,id,e_value,changed,what,where,text\n2026-01-01T00:00:00Z,1,0.5,0,body_slip,\"\",\"x\"\n");
  add_to_log(csv, entry());
  const auto read = read_recheck_log(csv);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].what, "body_slip");
  EXPECT_TRUE(read[1].numbers.empty());
}

TEST(RecheckLog, ALineThatIsBeingWrittenIsLeftForLater) {
  const TemporaryFolder folder;
  const auto csv = folder.path / "recheck.csv";
  add_to_log(csv, entry());
  replace_file(csv, read_file(csv) + "2026-11-26T06:0");
  EXPECT_EQ(read_recheck_log(csv).size(), 1U);
}

TEST(RecheckLog, WhatIsNoLogIsRefusedWithItsLine) {
  const TemporaryFolder folder;
  const auto csv = folder.path / "recheck.csv";
  replace_file(csv, "a,b\n");
  EXPECT_THAT(find_refusal(csv), HasSubstr("line 1"));
  add_to_log(folder.path / "other.csv", entry());
  const std::string good = read_file(folder.path / "other.csv");
  replace_file(csv, good + "2026-11-26T05:09:00Z,7,nan,0,a,b,c\n");
  EXPECT_THAT(find_refusal(csv), HasSubstr("line 3"));
  replace_file(csv, good + "2026-11-26T05:09:00Z,7\n");
  EXPECT_THAT(find_refusal(csv), HasSubstr("2 columns"));
}

TEST(RecheckLog, AFolderThatIsNotThereIsSaid) {
  EXPECT_THROW(add_to_log("/nowhere/at/all/recheck.csv", entry()), InputError);
}

}  // namespace
}  // namespace handsight
