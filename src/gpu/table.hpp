#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "base/charge.hpp"
#include "gpu/device.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::gpu {

/// Texels per row of a data texture (docs/gpu.md).
inline constexpr std::size_t kTableWidth = 2048;

/// The format of the texels of a data texture.
struct TableFormat {
  GLenum internal;
  GLenum format;
  GLenum type;
  std::size_t channels;
  std::size_t channel_bytes;

  std::size_t texel_bytes() const { return channels * channel_bytes; }
};

inline constexpr TableFormat kIndexTable{GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 1, 4};
inline constexpr TableFormat kFlagTable{GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1, 1};
inline constexpr TableFormat kScalarTable{GL_R32F, GL_RED, GL_FLOAT, 1, 4};
inline constexpr TableFormat kPairTable{GL_RG32F, GL_RG, GL_FLOAT, 2, 4};
inline constexpr TableFormat kColorTable{GL_RGBA32F, GL_RGBA, GL_FLOAT, 4, 4};
inline constexpr TableFormat kTexelTable{GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT, 4, 2};

/// A data texture under construction.
class Table {
 public:
  /// Makes room for `texels` texels. Errors: limit (the device's textures, the budget).
  static Result<Table> create(Context& context, const Device& device, const TableFormat& format,
                              std::size_t texels, std::string_view purpose);

  /// Uploads all texels: fill(first, count, out) writes the channels of some of them.
  template <class Channel, class Fill>
  void fill(const Fill& fill_texels) const {
    constexpr std::size_t kChunk = 64 * kTableWidth;
    std::vector<Channel> chunk(std::min(texels_, kChunk) * format_.channels);
    for (std::size_t first = 0; first < texels_; first += kChunk) {
      const std::size_t count = std::min(texels_ - first, kChunk);
      fill_texels(first, count, chunk.data());
      upload(first, count, chunk.data());
    }
  }

  /// Uploads texels [first, first + count) from consecutive memory; `first` is the begin of a row.
  void upload(std::size_t first, std::size_t count, const void* channels) const;

  GLuint name() const { return texture_.name(); }

 private:
  TableFormat format_{};
  std::size_t texels_ = 0;
  GlObject texture_;
  ScopedCharge charge_;
};

}  // namespace sfumato::gpu
