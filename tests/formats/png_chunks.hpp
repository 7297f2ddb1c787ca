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

/// Four bytes, the big end first.
void append_number(std::uint32_t value, Bytes& out);

/// `bytes` as zlib packs them.
Bytes packed(const Bytes& bytes);

/// A PNG by another encoder than ours, which writes neither sRGB nor anything else that is not
/// asked for.
/// rows    filter numbers and samples as PNG packs them
/// before  chunks before the pixels, PLTE and tRNS among them
/// after   chunks after the pixels
Bytes png_of(std::uint32_t width, std::uint32_t height, int depth, int color_type,
             const Bytes& rows, const std::vector<PngChunk>& before = {},
             const std::vector<PngChunk>& after = {});

}  // namespace sfumato::test
