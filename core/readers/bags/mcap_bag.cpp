// SPDX-License-Identifier: Apache-2.0
// Bags in MCAP: from front to end, chunk by chunk, so that a file that was broken off or has no summary is read as far
// as it goes.
#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "readers/bags/bag.h"
#include "readers/bags/decompress.h"
#include "readers/bags/mcap_records.h"

namespace handsight {
namespace {

using namespace mcap;

constexpr std::uint64_t largest_record = 1u << 30;  // bytes that are held at once

std::optional<Compression> compression_of(const std::string& name) {
  if (name.empty() || name == "none") return Compression::none;
  if (name == "zstd") return Compression::zstd;
  if (name == "lz4") return Compression::lz4;
  return std::nullopt;
}

class McapBag : public BagFile {
 public:
  McapBag(const std::filesystem::path& file, std::string name) : name_(std::move(name)), file_(file) {
    summary_ = read_summary(file_);
    channels_ = summary_.channels;
    if (!summary_.is_complete) count_messages();
    if (channels_.all.empty())
      throw InputError(
          message("{}: begins as MCAP does and holds no channel: it was broken off before anything was recorded, "
                  "or is damaged; "
                  "expected a recording with messages: record it again, or try `mcap recover`.",
                  name_));
  }

  std::vector<BagTopic> topics() override {
    std::vector<BagTopic> list;
    for (const auto& [id, topic] : channels_.all) list.push_back(topic);
    return list;
  }

  void read(const Wanted& wanted, const Take& take, std::vector<handsight::Message>& lost) override {
    wanted_ = wanted;
    take_ = take;
    lost_ = &lost;
    walk();
  }

 private:
  void count_messages() {
    std::vector<handsight::Message> lost;
    std::map<std::uint16_t, std::int64_t> counts;
    counts_ = &counts;
    lost_ = &lost;
    for (auto& [id, topic] : channels_.all) topic.messages = 0;
    walk();
    counts_ = nullptr;
    for (auto& [id, topic] : channels_.all) topic.messages = counts[id];
  }

  void walk() {
    taken_ = nameless_ = 0;
    crc_ = 0;
    crc_is_whole_ = true;
    add_to_crc(file_.view(0, magic_size));
    for (std::uint64_t at = magic_size; at != 0;) at = after_record_at(at);
    if (nameless_ > 0)
      lost_->push_back(
          message("{}: {} messages are of channels that are described nowhere and are left out.", name_, nameless_));
  }

  /// The next record's place; 0 at the end.
  std::uint64_t after_record_at(std::uint64_t at) {
    Fields head(file_.view(at, record_head_size));
    const auto opcode = head.number<std::uint8_t>();
    const auto length = head.number<std::uint64_t>();
    const std::uint64_t begin = at + record_head_size;
    if (head.ended) return broken_off(at, {});
    if (length > file_.size() - begin)
      return broken_off(at, opcode == op_chunk ? file_.view(begin, largest_record) : "");
    if (opcode == 0 || (opcode > op_last && opcode < 0x80)) return damaged_at(at);
    if (opcode == op_footer) return 0;
    if (opcode == op_data_end) return end_of_data(begin), 0;
    if (length > largest_record) {
      crc_is_whole_ = false;  // an attachment
    } else {
      add_to_crc(file_.view(at, record_head_size + length));
      take_record({opcode, file_.view(begin, length)}, at);
    }
    return begin + length;
  }

  void add_to_crc(std::string_view bytes) {
    if (!counts_ && crc_is_whole_) crc_ = crc32_of(bytes, crc_);
  }

  void end_of_data(std::uint64_t begin) {
    const auto reported = Fields(file_.view(begin, 4)).number<std::uint32_t>();
    if (reported != 0 && crc_is_whole_ && !counts_ && reported != crc_ && lost_->empty())
      lost_->push_back(
          message("{}: its checksum does not agree: some of its bytes have changed since it was written; its messages "
                  "are taken as they are.",
                  name_));
  }

  void take_record(const Record& record, std::uint64_t at) {
    if (record.opcode == op_message) return take_message(record.content);
    if (record.opcode == op_chunk) return take_chunk(record.content, at, true);
    channels_.take(record);
  }

  void take_message(std::string_view content) {
    const auto message = read_message(content);
    const BagTopic* const topic = message ? channels_.find(message->channel) : nullptr;
    if (!topic) {
      ++nameless_;
      return;
    }
    ++taken_;
    if (counts_)
      ++(*counts_)[message->channel];
    else if (wanted_(*topic))
      take_(*topic, message->nanoseconds, message->data);
  }

  /// A chunk that is whole, or (the file ends in it) as far as it is there.
  void take_chunk(std::string_view content, std::uint64_t at, bool whole) {
    const auto chunk = read_chunk(content);
    if (!chunk) return lose_chunk(at, "its head is damaged", {});
    const auto compression = compression_of(chunk->compression);
    if (!compression)
      return lose_chunk(at, message("it is compressed with {}, which is not read", in_quotes(chunk->compression, 20)),
                        chunk);
    if (chunk->size > largest_record) return lose_chunk(at, "it says that it is larger than 1 GiB", chunk);
    const Decompressed plain = decompressed(*compression, chunk->records, chunk->size);
    if (whole) {
      if (!plain.fault.empty()) return lose_chunk(at, plain.fault, chunk);
      if (plain.bytes.size() != chunk->size) return lose_chunk(at, "it holds less than it says", chunk);
      if (chunk->crc != 0 && crc32_of(plain.bytes) != chunk->crc)
        return lose_chunk(at, "its checksum does not agree", chunk);
    }
    Fields list(plain.bytes);
    while (const auto record = next_record(list)) take_record_of_chunk(*record);
  }

  void take_record_of_chunk(const Record& record) {
    if (record.opcode == op_message)
      take_message(record.content);
    else
      channels_.take(record);
  }

  void lose_chunk(std::uint64_t at, const handsight::Message& why, const std::optional<Chunk>& chunk) {
    const std::uint64_t count = messages_indexed_behind(at);
    handsight::Message reported = at_most(why, 100);
    if (chunk && chunk->end >= chunk->begin && chunk->end < 1e11)
      reported += message(" ({:.3f} s to {:.3f} s)", chunk->begin, chunk->end);
    if (count > 0) reported += message(", {} messages", count);
    lost_->push_back(message("{}: the chunk at byte {} is left out: {}.", name_, at, reported));
  }

  /// Of the records behind a chunk that say where its messages are.
  std::uint64_t messages_indexed_behind(std::uint64_t at) {
    std::uint64_t count = 0;
    at += record_head_size + length_at(at);
    for (; opcode_at(at) == op_message_index; at += record_head_size + length_at(at)) {
      Fields in(file_.view(at + record_head_size, 6));
      in.number<std::uint16_t>();
      count += in.number<std::uint32_t>() / 16;
    }
    return count;
  }

  std::uint8_t opcode_at(std::uint64_t at) { return Fields(file_.view(at, 1)).number<std::uint8_t>(); }
  std::uint64_t length_at(std::uint64_t at) {
    const auto length = Fields(file_.view(at + 1, 8)).number<std::uint64_t>();
    return std::min(length, file_.size());
  }

  std::uint64_t broken_off(std::uint64_t at, std::string_view chunk) {
    if (const std::uint64_t next = chunk_behind(at)) return skipped_to(at, next);
    if (!chunk.empty()) take_chunk(chunk, at, false);
    lost_->push_back(
        message("{}: it is broken off at byte {} of a record that begins at {}: after {} messages the "
                "rest is lost.",
                name_, file_.size(), at, taken_));
    return 0;
  }

  std::uint64_t damaged_at(std::uint64_t at) {
    if (const std::uint64_t next = chunk_behind(at)) return skipped_to(at, next);
    lost_->push_back(
        message("{}: at byte {} of {} stands no record: it is damaged, and after {} messages the rest is lost.", name_,
                at, file_.size(), taken_));
    return 0;
  }

  std::uint64_t skipped_to(std::uint64_t at, std::uint64_t next) {
    crc_is_whole_ = false;
    lost_->push_back(
        message("{}: is damaged at byte {}: {} bytes up to the next chunk are left out.", name_, at, next - at));
    return next;
  }

  std::uint64_t chunk_behind(std::uint64_t at) const {
    const auto next = std::upper_bound(summary_.chunks.begin(), summary_.chunks.end(), at);
    return next == summary_.chunks.end() ? 0 : *next;
  }

  std::string name_;
  FileBytes file_;
  Summary summary_;
  Channels channels_;
  // Of the walk that goes on.
  Wanted wanted_;
  Take take_;
  std::vector<handsight::Message>* lost_ = nullptr;
  std::map<std::uint16_t, std::int64_t>* counts_ = nullptr;  // not null: they are only counted
  std::uint64_t taken_ = 0, nameless_ = 0;
  std::uint32_t crc_ = 0;
  bool crc_is_whole_ = true;
};

}  // namespace

std::unique_ptr<BagFile> open_mcap_bag(const std::filesystem::path& file, const std::string& name) {
  return std::make_unique<McapBag>(file, name);
}

}  // namespace handsight
