#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace sfumato::test {

using Bytes = std::vector<std::uint8_t>;

struct PngChunk {
  std::string_view type;
  Bytes data;
};

/// Appends four bytes, big end first.
void append_number(std::uint32_t value, Bytes& out);

/// Returns `bytes` compressed by zlib.
Bytes packed(const Bytes& bytes);

/// Returns a PNG from an independent encoder, which writes neither sRGB nor any chunk that is not
/// requested.
/// rows: filter numbers and samples as packed in PNG; for an interlaced one those of its passes
/// before: chunks before the pixels, PLTE and tRNS among them
/// after: chunks after the pixels
Bytes png_of(std::uint32_t width, std::uint32_t height, int depth, int color_type,
             const Bytes& rows, const std::vector<PngChunk>& before = {},
             const std::vector<PngChunk>& after = {}, bool is_interlaced = false);

}  // namespace sfumato::test
