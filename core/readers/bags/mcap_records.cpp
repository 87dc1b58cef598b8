// SPDX-License-Identifier: Apache-2.0
#include "readers/bags/mcap_records.h"

#include <algorithm>

#include "base/text.h"
#include "readers/bags/decompress.h"
#include "readers/bags/messages.h"

namespace handsight::mcap {

std::optional<Record> next_record(Fields& list) {
  Record record{list.number<std::uint8_t>(), {}};
  record.content = list.bytes(list.number<std::uint64_t>());
  if (list.ended) return std::nullopt;
  return record;
}

std::optional<Message> read_message(std::string_view content) {
  Fields in(content);
  Message m;
  m.channel = in.number<std::uint16_t>();
  in.number<std::uint32_t>();  // sequence
  m.nanoseconds = in.number<std::int64_t>();
  in.number<std::uint64_t>();  // when it was published
  m.data = in.left();
  if (in.ended) return std::nullopt;
  return m;
}

std::optional<Chunk> read_chunk(std::string_view content) {
  Fields in(content);
  Chunk c;
  c.begin = 1e-9 * static_cast<double>(in.number<std::uint64_t>());
  c.end = 1e-9 * static_cast<double>(in.number<std::uint64_t>());
  c.size = in.number<std::uint64_t>();
  c.crc = in.number<std::uint32_t>();
  c.compression = in.text();
  const auto length = in.number<std::uint64_t>();
  if (in.ended) return std::nullopt;
  c.records = in.left().substr(0, length);
  return c;
}

void Channels::take(const Record& record) {
  Fields in(record.content);
  const auto id = in.number<std::uint16_t>();
  if (record.opcode == op_schema) {
    const std::string name(in.text());
    if (!in.ended) schemas_[id] = name;
  } else if (record.opcode == op_channel) {
    const auto schema = schemas_.find(in.number<std::uint16_t>());
    BagTopic topic;
    topic.name = shortened(in.text(), longest_topic);
    topic.encoding = shortened(in.text(), 20);
    if (schema != schemas_.end()) topic.type = ros::find_type(schema->second);
    if (!in.ended) all.emplace(id, std::move(topic));  // said again in the summary
  }
}

const BagTopic* Channels::find(std::uint16_t channel) const {
  const auto found = all.find(channel);
  return found == all.end() ? nullptr : &found->second;
}

namespace {

/// Messages of each channel.
void take_statistics(std::string_view content, Summary& s) {
  Fields in(content);
  in.number<std::uint64_t>();                              // messages
  in.number<std::uint16_t>();                              // schemas
  for (int i = 0; i < 4; ++i) in.number<std::uint32_t>();  // channels, attachments, metadata, chunks
  for (int i = 0; i < 2; ++i) in.number<std::uint64_t>();  // first and last time
  Fields counts(in.text());
  s.is_complete = !in.ended;
  while (counts.more()) {
    const auto channel = counts.number<std::uint16_t>();
    const auto count = counts.number<std::uint64_t>();
    const auto found = s.channels.all.find(channel);
    s.is_complete = s.is_complete && found != s.channels.all.end() && count < (1ull << 62);
    if (s.is_complete) found->second.messages = static_cast<std::int64_t>(count);
  }
}

}  // namespace

Summary read_summary(FileBytes& file) {
  constexpr std::uint64_t footer_size = record_head_size + 20, largest = 256u << 20;
  Summary s;
  if (file.size() < 2 * magic_size + footer_size) return s;
  const std::uint64_t footer_at = file.size() - magic_size - footer_size;
  Fields footer(file.view(footer_at, footer_size));
  if (footer.number<std::uint8_t>() != op_footer || footer.number<std::uint64_t>() != 20) return s;
  const auto begin = footer.number<std::uint64_t>();
  footer.number<std::uint64_t>();  // where the summary's offsets are
  const auto crc = footer.number<std::uint32_t>();
  if (begin < magic_size || begin >= footer_at || footer_at - begin > largest) return s;
  const std::string_view summed = file.view(begin, file.size() - magic_size - 4 - begin);
  if (crc != 0 && crc32_of(summed) != crc) return s;
  Fields list(summed.substr(0, footer_at - begin));
  while (const auto record = next_record(list)) {
    s.channels.take(*record);
    if (record->opcode == op_statistics) take_statistics(record->content, s);
    if (record->opcode != op_chunk_index) continue;
    Fields in(record->content);
    in.bytes(16);
    const auto at = in.number<std::uint64_t>();
    if (!in.ended && at >= magic_size && at < begin) s.chunks.push_back(at);
  }
  std::sort(s.chunks.begin(), s.chunks.end());
  return s;
}

}  // namespace handsight::mcap
