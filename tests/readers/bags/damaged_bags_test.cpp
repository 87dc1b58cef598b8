// SPDX-License-Identifier: Apache-2.0
// Bags that were broken off or changed: what can be read is read, what is lost is named, and nothing ends the program.
#include <random>

#include "base/files.h"
#include "readers/bags/bag.h"
#include "readers/bags/small_bag.h"

namespace handsight {
namespace {

using fixture::small_recording;
using testing::Contains;
using testing::HasSubstr;

class DamagedBags : public testing::Test {
 protected:
  /// How many messages are read, and what is lost.
  struct Reading {
    std::size_t messages = 0;
    std::vector<Message> lost;
  };
  Reading read(const std::string& name, const std::string& bytes) {
    fixture::write_file(folder_.path / name, bytes);
    const Bag bag = open_bag(folder_.path / name);
    Reading r;
    r.lost = read_bag(
        bag, [](const BagTopic&) { return true; },
        [&](const BagTopic&, std::int64_t, std::string_view) { ++r.messages; });
    return r;
  }
  TemporaryFolder folder_;
};

TEST_F(DamagedBags, AnMcapThatIsBrokenOffIsReadAsFarAsItGoes) {
  const fixture::Recording r = small_recording(false);
  for (const char* compression : {"", "lz4", "zstd"}) {
    const fixture::McapWriter writer(r, {compression});
    ASSERT_GE(writer.chunks().size(), 5u);
    // In the middle of the third chunk: two are whole, of the third some.
    const std::uint64_t in_third = writer.chunks()[2] + (writer.chunks()[3] - writer.chunks()[2]) / 2;
    const Reading reading = read("broken.mcap", writer.bytes().substr(0, in_third));
    EXPECT_GE(reading.messages, 60u) << compression;
    EXPECT_LT(reading.messages, 90u) << compression;
    ASSERT_EQ(reading.lost.size(), 1u);
    EXPECT_THAT(reading.lost[0], HasSubstr(fmt::format("after {} messages the rest is lost", reading.messages)));
  }
  const fixture::McapWriter plain(r, {""});
  const Reading part = read("part.mcap", plain.bytes().substr(0, plain.chunks()[2] + 1000));
  EXPECT_GT(part.messages, 60u) << "of a chunk without compression what is there is taken";
}

TEST_F(DamagedBags, AChunkWhoseSumDoesNotAgreeIsLeftOutAndCounted) {
  const fixture::Recording r = small_recording(false);
  for (const char* compression : {"", "lz4", "zstd"}) {
    const fixture::McapWriter writer(r, {compression});
    std::string bytes = writer.bytes();
    bytes[(writer.chunks()[1] + writer.chunks()[2]) / 2 - 100] ^= 4;
    const Reading reading = read("changed.mcap", bytes);
    EXPECT_EQ(reading.messages, r.messages.size() - 30) << compression;
    ASSERT_EQ(reading.lost.size(), 1u) << testing::PrintToString(reading.lost);
    EXPECT_THAT(reading.lost[0], HasSubstr(fmt::format("the chunk at byte {} is left out: ", writer.chunks()[1])));
    EXPECT_THAT(reading.lost[0], HasSubstr(", 30 messages."));
  }
}

TEST_F(DamagedBags, WhereARecordsLengthIsWrongTheSummaryLeadsToTheNextChunk) {
  const fixture::Recording r = small_recording(false);
  const fixture::McapWriter writer(r, {"zstd"});
  std::string bytes = writer.bytes();
  bytes[writer.chunks()[1] + 5] = '\x7F';  // the third chunk's length is now some hundred GB
  const Reading reading = read("length.mcap", bytes);
  EXPECT_EQ(reading.messages, r.messages.size() - 30);
  EXPECT_THAT(reading.lost, Contains(HasSubstr("up to the next chunk are left out")));
}

TEST_F(DamagedBags, ChangedBytesOfAnMcapWithoutChunksAreTold) {
  std::string bytes = fixture::mcap_of(small_recording(false), {"", false});
  bytes[bytes.find("tag_7") + 2] = 'x';
  EXPECT_THAT(read("plain.mcap", bytes).lost, Contains(HasSubstr("its checksum does not agree")));
}

TEST_F(DamagedBags, Ros1BagsLoseOneChunkOrTheirEnd) {
  const fixture::Recording r = small_recording(true);
  for (const char* compression : {"none", "bz2", "lz4"}) {
    std::string bytes = fixture::ros1_bag_of(r, compression);
    const std::string chunk_head = fixture::field("op", "\5");
    const std::size_t first = bytes.find(chunk_head), second = bytes.find(chunk_head, first + 1),
                      third = bytes.find(chunk_head, second + 1);
    const Reading broken = read("broken.bag", bytes.substr(0, third + 200));
    EXPECT_EQ(broken.messages, 60u) << compression;
    EXPECT_EQ(broken.lost.size(), 1u);
    bytes[second + 200] ^= 16;
    const Reading changed = read("changed.bag", bytes);
    EXPECT_GE(changed.messages, r.messages.size() - 30) << compression;
    if (std::string(compression) != "none") {
      EXPECT_EQ(changed.messages, r.messages.size() - 30);
      EXPECT_THAT(changed.lost, Contains(HasSubstr("is left out")));
    }
  }
}

TEST_F(DamagedBags, OneDamagedMessageIsLeftOutAndCountedAllOfATopicAreRefused) {
  fixture::Recording r = small_recording(false);
  std::size_t shortened_ones = 0;
  for (auto& message : r.messages)
    if (message.topic == 0 && shortened_ones++ == 5) message.bytes.resize(30);
  fixture::write_file(folder_.path / "one.mcap", fixture::mcap_of(r));
  const BagContents c = contents_of(folder_.path / "one.mcap");
  EXPECT_EQ(c.joints.positions.size(), 39u);
  EXPECT_THAT(c.notes, Contains(HasSubstr("topic /joint_states: 1 of 40 messages are damaged")));
  for (auto& message : r.messages)
    if (message.topic == 0) message.bytes.resize(30);
  fixture::write_file(folder_.path / "all.mcap", fixture::mcap_of(r));
  EXPECT_THROW(contents_of(folder_.path / "all.mcap"), InputError);
}

TEST_F(DamagedBags, ChanceDamageNeverEndsTheProgram) {
  std::mt19937 random(11);
  const fixture::Recording cdr = small_recording(false), ros1 = small_recording(true);
  fixture::write_sqlite_bag(folder_.path / "seed.db3", cdr);
  const std::string database = read_file(folder_.path / "seed.db3");
  const std::vector<std::pair<std::string, std::string>> seeds = {
      {"a.mcap", fixture::mcap_of(cdr, {"zstd"})},
      {"b.mcap", fixture::mcap_of(cdr, {"lz4", true, false})},
      {"c.mcap", fixture::mcap_of(ros1, {"", true, true})},
      {"d.mcap", fixture::mcap_of(cdr, {"", false, true, false})},
      {"e.bag", fixture::ros1_bag_of(ros1, "none")},
      {"f.bag", fixture::ros1_bag_of(ros1, "bz2")},
      {"g.bag", fixture::ros1_bag_of(ros1, "lz4", false)},
      {"h.db3.zstd", fixture::zstd_of(database)},
      {"i.db3", database}};
  int read_in_part = 0, refused = 0;
  for (const auto& [name, good] : seeds)
    for (int run = 0; run < 60; ++run) {
      std::string bytes = good;
      const std::size_t cut = random() % 3 == 0 ? random() % bytes.size() : bytes.size();
      bytes.resize(cut);
      for (unsigned flips = random() % 8; flips > 0 && !bytes.empty(); --flips) {
        const std::size_t at = random() % bytes.size();
        const unsigned bit = random() % 8;
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
      }
      fixture::write_file(folder_.path / name, bytes);
      try {
        const BagContents c = contents_of(folder_.path / name);
        for (const Eigen::VectorXd& q : c.joints.positions) ASSERT_TRUE(q.allFinite());
        ++read_in_part;
      } catch (const InputError& error) {
        const std::string sentence = error.what();
        ASSERT_TRUE(sentence.size() >= 20 && sentence.size() <= 600 && is_utf8(sentence)) << sentence;
        ++refused;
      }
    }
  EXPECT_GT(read_in_part, 100);
  EXPECT_GT(refused, 10);
}

}  // namespace
}  // namespace handsight
