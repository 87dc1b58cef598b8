// SPDX-License-Identifier: Apache-2.0
// Records of MCAP (https://mcap.dev/spec, version 0): an opcode, a length of 64 bit, and the content.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "readers/bags/bag.h"
#include "readers/bags/file_bytes.h"

namespace handsight::mcap {

enum Opcode : std::uint8_t {
  op_footer = 0x02,
  op_schema = 0x03,
  op_channel = 0x04,
  op_message = 0x05,
  op_chunk = 0x06,
  op_message_index = 0x07,
  op_chunk_index = 0x08,
  op_statistics = 0x0B,
  op_data_end = 0x0F,
  op_last = 0x0F
};

inline constexpr std::uint64_t magic_size = 8, record_head_size = 9;

struct Record {
  std::uint8_t opcode = 0;
  std::string_view content;
};

/// The next record of a list; nothing where it has ended, or ends in the middle of one.
std::optional<Record> next_record(Fields& list);

struct Message {
  std::uint16_t channel = 0;
  std::int64_t nanoseconds = 0;  // when it was recorded
  std::string_view data;
};
std::optional<Message> read_message(std::string_view content);

struct Chunk {
  double begin = 0, end = 0;  // s
  std::uint64_t size = 0;     // of what is in it, without compression
  std::uint32_t crc = 0;      // of that; 0: not given
  std::string compression;
  std::string_view records;  // as they are in the file
};
/// Of a file that is broken off in it, as far as it is there; nothing where its head is not whole.
std::optional<Chunk> read_chunk(std::string_view content);

/// What schemas and channels say, as they come.
class Channels {
 public:
  void take(const Record& record);  // others than these are passed over
  const BagTopic* find(std::uint16_t channel) const;
  std::map<std::uint16_t, BagTopic> all;

 private:
  std::map<std::uint16_t, std::string> schemas_;
};

/// What stands at the end of a whole file.
struct Summary {
  Channels channels;
  bool is_complete = false;           // it counts the messages of each channel
  std::vector<std::uint64_t> chunks;  // where they begin
};
Summary read_summary(FileBytes& file);

}  // namespace handsight::mcap
