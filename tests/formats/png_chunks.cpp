#include "formats/png_chunks.hpp"

#include <zlib.h>

namespace sfumato::test {
namespace {

void append_chunk(const PngChunk& chunk, Bytes& out) {
  append_number(static_cast<std::uint32_t>(chunk.data.size()), out);
  const std::size_t begin = out.size();
  out.insert(out.end(), chunk.type.begin(), chunk.type.end());
  out.insert(out.end(), chunk.data.begin(), chunk.data.end());
  const uLong sum = crc32(0, &out[begin], static_cast<uInt>(out.size() - begin));
  append_number(static_cast<std::uint32_t>(sum), out);
}

}  // namespace

void append_number(std::uint32_t value, Bytes& out) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    out.push_back(static_cast<std::uint8_t>(value >> shift));
  }
}

Bytes packed(const Bytes& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  Bytes result(size);
  compress(result.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()));
  result.resize(size);
  return result;
}

Bytes png_of(std::uint32_t width, std::uint32_t height, int depth, int color_type,
             const Bytes& rows, const std::vector<PngChunk>& before,
             const std::vector<PngChunk>& after, bool is_interlaced) {
  Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  PngChunk header{"IHDR", {}};
  append_number(width, header.data);
  append_number(height, header.data);
  for (const int value : {depth, color_type, 0, 0, is_interlaced ? 1 : 0}) {
    header.data.push_back(static_cast<std::uint8_t>(value));
  }
  append_chunk(header, png);
  for (const PngChunk& chunk : before) append_chunk(chunk, png);
  append_chunk({"IDAT", packed(rows)}, png);
  for (const PngChunk& chunk : after) append_chunk(chunk, png);
  append_chunk({"IEND", {}}, png);
  return png;
}

}  // namespace sfumato::test
