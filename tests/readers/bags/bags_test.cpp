// SPDX-License-Identifier: Apache-2.0
// One recording in every kind of bag comes to the same numbers.
#include <sys/resource.h>

#include "base/files.h"
#include "readers/bags/bag.h"
#include "readers/bags/small_bag.h"
#include "session/session_texts.h"

namespace handsight {
namespace {

using fixture::small_recording;
using testing::HasSubstr;

class Bags : public testing::Test {
 protected:
  std::filesystem::path written(const std::string& name, const std::string& bytes) {
    fixture::write_file(folder_.path / name, bytes);
    return folder_.path / name;
  }
  TemporaryFolder folder_;
};

TEST_F(Bags, McapOfEveryStyle) {
  int n = 0;
  for (const bool ros1 : {false, true})
    for (const char* compression : {"", "lz4", "zstd"})
      for (const bool summary : {true, false})
        for (const bool sums : {true, false}) {
          const auto name = fmt::format("{}_{}_{}_{}_{}.mcap", n++, ros1 ? "ros1" : "cdr", compression, summary, sums);
          expect_whole(written(name, fixture::mcap_of(small_recording(ros1), {compression, true, summary, sums})));
        }
  for (const bool summary : {true, false})
    expect_whole(written(fmt::format("plain_{}.mcap", summary),
                         fixture::mcap_of(small_recording(false), {"", false, summary, true})));
}

TEST_F(Bags, Ros1OfEveryCompressionClosedOrNot) {
  for (const char* compression : {"none", "bz2", "lz4"})
    for (const bool closed : {true, false})
      expect_whole(written(fmt::format("{}{}", compression, closed ? ".bag" : ".bag.active"),
                           fixture::ros1_bag_of(small_recording(true), compression, closed)));
}

TEST_F(Bags, SqliteCompressedWithZstdAsFilesOrMessageByMessage) {
  fixture::write_sqlite_bag(folder_.path / "plain" / "bag_0.db3", small_recording(false));
  expect_whole(folder_.path / "plain");
  fixture::write_sqlite_bag(folder_.path / "messages" / "bag_0.db3", small_recording(false), true);
  expect_whole(folder_.path / "messages");
  const std::string database = read_file(folder_.path / "plain" / "bag_0.db3");
  expect_whole(written("files/bag_0.db3.zstd", fixture::zstd_of(database)).parent_path());
  written("both/bag_0.db3.zstd", fixture::zstd_of(database));
  expect_whole(written("both/bag_0.db3", database).parent_path());  // as `ros2 bag play` leaves it: not read twice
  expect_whole(written("mcap/bag_0.mcap.zstd", fixture::zstd_of(fixture::mcap_of(small_recording(false)))));
}

TEST_F(Bags, FilesOfOneRecordingAreReadOneAfterTheOther) {
  fixture::Recording first = small_recording(false), second = first;
  first.messages.resize(100);
  second.messages.erase(second.messages.begin(), second.messages.begin() + 100);
  written("long/long_2.mcap", fixture::mcap_of(first, {"zstd"}));
  written("long/long_10.mcap", fixture::mcap_of(second, {"zstd"}));
  written("long/metadata.yaml", "rosbag2_bagfile_information: {}");
  expect_whole(folder_.path / "long");
}

TEST_F(Bags, MessagesThatWereRecordedOutOfOrderArePutInOrder) {
  fixture::Recording r = small_recording(false);
  std::reverse(r.messages.begin(), r.messages.end());
  expect_whole(written("reversed.mcap", fixture::mcap_of(r, {"lz4"})));
}

/// 256 MB of images in chunks of 4 MB, and a bag of ROS 1 of as many: no more than a few chunks are in memory.
TEST_F(Bags, OneChunkAtATimeIsInMemory) {
  constexpr int chunks = 64;
  const fixture::Recording r = small_recording(false);
  const std::string payload(std::size_t{4} << 20, 'x');
  const auto mcap = folder_.path / "large.mcap", ros1 = folder_.path / "large.bag";
  {
    fixture::Recording one = r;
    one.messages.resize(1);
    std::ofstream out(mcap, std::ios::binary);
    const std::string begin = fixture::mcap_of(one, {"", false, false, false});
    out << begin.substr(0, begin.size() - 9 - 4 - 9 - 20 - 8);  // without what closes it
    std::ofstream old(ros1, std::ios::binary);
    one.ros1 = true;
    old << fixture::ros1_bag_of(one, "none", false);
    for (int i = 0; i < chunks; ++i) {
      const std::string message =
          fixture::mcap_record(5, fixture::raw(std::uint16_t{60}) + fixture::raw(0u) + fixture::raw(std::uint64_t{1}) +
                                      fixture::raw(std::uint64_t{1}) + payload);
      out << fixture::mcap_record(6, fixture::raw(std::uint64_t{1}) + fixture::raw(std::uint64_t{1}) +
                                         fixture::raw(static_cast<std::uint64_t>(message.size())) + fixture::raw(0u) +
                                         fixture::prefixed("") +
                                         fixture::raw(static_cast<std::uint64_t>(message.size())) + message);
      const std::string record =
          fixture::bag_record(fixture::field("op", "\2") + fixture::field("conn", fixture::raw(6u)) +
                                  fixture::field("time", fixture::raw(std::uint64_t{1})),
                              payload);
      old << fixture::bag_record(fixture::field("op", "\5") + fixture::field("compression", "none") +
                                     fixture::field("size", fixture::raw(static_cast<std::uint32_t>(record.size()))),
                                 record);
    }
  }
  const auto megabytes = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
  };
  const long before = megabytes();
  for (const auto& file : {mcap, ros1}) {
    std::size_t bytes = 0;
    read_bag(
        open_bag(file), [](const BagTopic& t) { return t.name == "/chatter"; },
        [&](const BagTopic&, std::int64_t, std::string_view message) { bytes += message.size(); });
    EXPECT_EQ(bytes, chunks * payload.size()) << file;
  }
  EXPECT_LT(megabytes() - before, 48);
}

TEST_F(Bags, WhatIsNoBagIsNamedForWhatItIs) {
  const auto refused = [&](const std::filesystem::path& file) { return find_refusal([&] { open_bag(file); }); };
  EXPECT_THAT(refused(written("a.mcap", "\x89MCAP0\r\n")), HasSubstr("holds no channel"));
  EXPECT_THAT(refused(written("b.mcap", std::string("\x89MCAP0\r\n") + std::string(200, '\0'))),
              HasSubstr("holds no channel"));
  EXPECT_THAT(refused(written("c.bag", "#ROSBAG V1.2\nand so on")), HasSubstr("rosbag fix"));
  EXPECT_THAT(refused(written("d.bag", "#ROSBAG V2.0\n")), HasSubstr("without a connection"));
  EXPECT_THAT(refused(written("e.bag", "PK and so on, a zip")), HasSubstr("does not begin as a bag does"));
  EXPECT_THAT(refused(written("f.db3", "SQLite format 3 it is not")), HasSubstr("no ROS 2 bag"));
  EXPECT_THAT(refused(written("g.db3.zstd", "no zstd")), HasSubstr("compressed with zstd, and damaged"));
  const std::string head = fixture::field("op", "\3") + fixture::field("encryptor", "rosbag/AesCbcEncryptor");
  EXPECT_THAT(refused(written("h.bag", "#ROSBAG V2.0\n" + fixture::bag_record(head, "   "))),
              HasSubstr("rosbag decrypt"));
}

TEST_F(Bags, TopicsOfOtherEncodingsAreLeftOutByName) {
  fixture::Recording r = small_recording(false);
  std::string bytes = fixture::mcap_of(r, {"", true, false, false});
  const std::string from = fixture::prefixed("/board") + fixture::prefixed("cdr"),
                    to = fixture::prefixed("/board") + fixture::prefixed("cbr");
  for (std::size_t at = bytes.find(from); at != std::string::npos; at = bytes.find(from, at + 1))
    bytes.replace(at, to.size(), to);
  const BagContents c = contents_of(written("other.mcap", bytes));
  EXPECT_THAT(c.notes,
              testing::Contains(HasSubstr("/board (geometry_msgs/PoseStamped as cbr, 40 messages) is left out")));
  EXPECT_FALSE(c.frames.contains("/board"));
}

}  // namespace
}  // namespace handsight
