// SPDX-License-Identifier: Apache-2.0
#include "readers/bags/decompress.h"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>

#include "base/error.h"
#include "base/text.h"

namespace handsight {
namespace {

/// What one call of a library has done.
struct Step {
  std::size_t taken = 0, made = 0;
  bool at_end = false;  // of a frame
  Message fault = {};
};

class ZstdStream {
 public:
  Step operator()(std::string_view in, char* out, std::size_t room) {
    ZSTD_inBuffer from{in.data(), in.size(), 0};
    ZSTD_outBuffer into{out, room, 0};
    const std::size_t left = ZSTD_decompressStream(stream_.get(), &into, &from);
    Step step{from.pos, into.pos, left == 0};
    if (ZSTD_isError(left)) step.fault = "its zstd blocks are damaged";
    return step;
  }

 private:
  struct Free {
    void operator()(ZSTD_DStream* s) const { ZSTD_freeDStream(s); }
  };
  std::unique_ptr<ZSTD_DStream, Free> stream_{ZSTD_createDStream()};
};

class Lz4Stream {
 public:
  Lz4Stream() {
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context_, LZ4F_VERSION))) throw std::bad_alloc();
  }
  ~Lz4Stream() { LZ4F_freeDecompressionContext(context_); }
  Lz4Stream(const Lz4Stream&) = delete;
  Lz4Stream& operator=(const Lz4Stream&) = delete;

  Step operator()(std::string_view in, char* out, std::size_t room) {
    std::size_t taken = in.size(), made = room;
    const std::size_t left = LZ4F_decompress(context_, out, &made, in.data(), &taken, nullptr);
    if (LZ4F_isError(left)) return {0, 0, false, "its lz4 blocks are damaged"};
    return {taken, made, left == 0};
  }

 private:
  LZ4F_dctx* context_ = nullptr;
};

class Bz2Stream {
 public:
  Bz2Stream() {
    if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK) throw std::bad_alloc();
  }
  ~Bz2Stream() { BZ2_bzDecompressEnd(&stream_); }
  Bz2Stream(const Bz2Stream&) = delete;
  Bz2Stream& operator=(const Bz2Stream&) = delete;

  Step operator()(std::string_view in, char* out, std::size_t room) {
    constexpr std::size_t most = 1u << 30;  // what its counters hold
    stream_.next_in = const_cast<char*>(in.data());
    stream_.avail_in = static_cast<unsigned>(std::min(in.size(), most));
    stream_.next_out = out;
    stream_.avail_out = static_cast<unsigned>(std::min(room, most));
    const unsigned in_before = stream_.avail_in, out_before = stream_.avail_out;
    const int status = BZ2_bzDecompress(&stream_);
    Step step{in_before - stream_.avail_in, out_before - stream_.avail_out, status == BZ_STREAM_END};
    if (status != BZ_OK && status != BZ_STREAM_END) step.fault = "its bz2 blocks do not agree with their sums";
    return step;
  }

 private:
  bz_stream stream_{};
};

template <class Stream>
Decompressed pumped(std::string_view in, std::size_t most, Stream&& stream) {
  Decompressed all;
  std::string& out = all.bytes;
  for (bool at_end = false;;) {
    if (at_end && in.empty()) return all;
    const std::size_t begin = out.size();
    if (begin > most) {
      out.resize(most);
      all.fault = "it holds more than it says";
      return all;
    }
    out.resize(std::min(most + 1, begin + std::max<std::size_t>(begin, 1 << 16)));  // one more shows what is too much
    const Step step = stream(in, out.data() + begin, out.size() - begin);
    out.resize(begin + step.made);
    in.remove_prefix(step.taken);
    at_end = step.at_end;
    all.fault = step.fault;
    if (all.fault.empty() && !at_end && step.taken == 0 && step.made == 0) all.fault = "it ends too early";
    if (!all.fault.empty()) return all;
  }
}

Decompressed as_they_are(std::string_view bytes, std::size_t most) {
  return {std::string(bytes.substr(0, most)), bytes.size() > most ? Message("it holds more than it says") : Message()};
}

}  // namespace

Decompressed decompressed(Compression compression, std::string_view bytes, std::size_t most) {
  switch (compression) {
    case Compression::none:
      return as_they_are(bytes, most);
    case Compression::zstd:
      return pumped(bytes, most, ZstdStream());
    case Compression::lz4:
      return pumped(bytes, most, Lz4Stream());
    case Compression::bz2:
      return pumped(bytes, most, Bz2Stream());
  }
  return {};
}

bool begins_as_zstd(std::string_view bytes) { return bytes.starts_with("\x28\xB5\x2F\xFD"); }

Message decompress_file(const std::filesystem::path& from, const std::filesystem::path& into) {
  std::ifstream in(from, std::ios::binary);
  std::ofstream out(into, std::ios::binary);
  ZstdStream stream;
  std::string piece(1 << 18, '\0'), made(1 << 20, '\0');
  bool at_end = false;
  while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())), in.gcount() > 0) {
    std::string_view left(piece.data(), static_cast<std::size_t>(in.gcount()));
    for (std::size_t full = made.size(); !left.empty() || full == made.size();) {
      const Step step = stream(left, made.data(), made.size());
      out.write(made.data(), static_cast<std::streamsize>(step.made));
      if (!step.fault.empty()) return step.fault;
      left.remove_prefix(step.taken);
      full = step.made;
      at_end = step.at_end;
      if (step.taken == 0 && step.made == 0) break;
    }
    if (!out)
      throw InputError(
          message("{}: there is no room to decompress it in {}; make room there, or name another folder "
                  "in TMPDIR.",
                  shown_path(from), shown_path(into.parent_path())));
  }
  return at_end ? "" : "it ends too early";
}

namespace {

std::array<std::array<std::uint32_t, 256>, 8> crc_tables() {
  std::array<std::array<std::uint32_t, 256>, 8> all{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t sum = i;
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xEDB88320u : 0u);
    all[0][i] = sum;
  }
  for (std::size_t k = 1; k < 8; ++k)
    for (std::size_t i = 0; i < 256; ++i) all[k][i] = all[k - 1][i] >> 8 ^ all[0][all[k - 1][i] & 255];
  return all;
}

}  // namespace

std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before) {
  static const auto t = crc_tables();
  std::uint32_t sum = ~before;
  const auto* p = reinterpret_cast<const unsigned char*>(bytes.data());
  std::size_t left = bytes.size();
  for (; left >= 8; left -= 8, p += 8) {  // eight bytes at a time (Kounavis and Berry, 2005)
    sum ^= static_cast<std::uint32_t>(p[0]) | static_cast<std::uint32_t>(p[1]) << 8 |
           static_cast<std::uint32_t>(p[2]) << 16 | static_cast<std::uint32_t>(p[3]) << 24;
    sum = t[7][sum & 255] ^ t[6][sum >> 8 & 255] ^ t[5][sum >> 16 & 255] ^ t[4][sum >> 24] ^ t[3][p[4]] ^ t[2][p[5]] ^
          t[1][p[6]] ^ t[0][p[7]];
  }
  for (; left > 0; --left, ++p) sum = sum >> 8 ^ t[0][(sum ^ *p) & 255];
  return ~sum;
}

}  // namespace handsight
