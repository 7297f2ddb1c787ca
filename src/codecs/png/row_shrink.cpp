#include "codecs/png/row_shrink.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::codecs {
namespace {

constexpr double kMostOf16Bits = 65535;

/// Returns the channels of a pixel from 0 to 1, colours times alpha.
template <bool is_wide>
std::array<double, 4> premultiplied(const std::uint8_t* pixel, bool has_alpha) {
  const auto number = [pixel](std::size_t c) {
    if constexpr (!is_wide) return pixel[c] * (1 / 255.0);
    std::uint16_t wide;
    std::memcpy(&wide, pixel + 2 * c, 2);
    return wide * (1 / kMostOf16Bits);
  };
  const double alpha = has_alpha ? number(3) : 1.0;
  return {alpha * number(0), alpha * number(1), alpha * number(2), alpha};
}

std::uint16_t in_16_bits(double value) {
  return static_cast<std::uint16_t>(std::lround(kMostOf16Bits * std::clamp(value, 0.0, 1.0)));
}

}  // namespace

RowShrinker::Cover RowShrinker::cover_of(std::size_t at, std::size_t small_count,
                                         std::size_t count) {
  const double ratio = static_cast<double>(small_count) / static_cast<double>(count);
  const double from = static_cast<double>(at) * ratio, to = from + ratio;
  const auto first = std::min(static_cast<std::size_t>(from), small_count - 1);
  const double border = static_cast<double>(first + 1);
  Cover cover{static_cast<std::uint32_t>(first), {std::min(to, border) - from, 0}};
  if (to > border && first + 1 < small_count) cover.share[1] = to - border;
  return cover;
}

Status RowShrinker::create(const Context& context, int width, int height, PixelFormat format,
                           int to) {
  width_ = width;
  height_ = height;
  format_ = format;
  const double scale = static_cast<double>(to) / std::max(width, height);
  small_width_ = std::max(1, static_cast<int>(std::lround(width * scale)));
  small_height_ = std::max(1, static_cast<int>(std::lround(height * scale)));
  const auto columns = static_cast<std::size_t>(width);
  const auto small_columns = static_cast<std::size_t>(small_width_);
  SFUMATO_TRY(memory_.reserve(context, column_, columns));
  for (std::size_t x = 0; x < columns; ++x) {
    column_.push_back(cover_of(x, small_columns, columns));
  }
  return memory_.resize(context, sum_, 4 * small_columns * static_cast<std::size_t>(small_height_));
}

void RowShrinker::add(std::size_t y, std::span<const std::uint8_t> row, const Columns& columns) {
  const Cover rows =
      cover_of(y, static_cast<std::size_t>(small_height_), static_cast<std::size_t>(height_));
  const bool is_wide = bytes_per_channel(format_) == 2;
  const int channels = channel_count(format_);
  const auto pixel_bytes = static_cast<std::size_t>(channels * bytes_per_channel(format_));
  for (std::size_t x = columns.first; x < column_.size(); x += columns.step) {
    const std::uint8_t* const at = &row[x * pixel_bytes];
    const auto pixel =
        is_wide ? premultiplied<true>(at, channels == 4) : premultiplied<false>(at, channels == 4);
    const Cover& cover = column_[x];
    for (std::size_t j = 0; j < 2; ++j) {
      if (rows.share[j] == 0) continue;
      const std::size_t first =
          (rows.first + j) * static_cast<std::size_t>(small_width_) + cover.first;
      for (std::size_t i = 0; i < 2; ++i) {
        if (cover.share[i] == 0) continue;
        double* const sum = &sum_[4 * (first + i)];
        const double share = rows.share[j] * cover.share[i];
        for (std::size_t c = 0; c < 4; ++c) sum[c] += share * pixel[c];
      }
    }
  }
}

Status RowShrinker::finish(const Context& context, bool has_alpha, TableMemory& memory,
                           Image& out) {
  out = {small_width_, small_height_, has_alpha ? PixelFormat::rgba16 : PixelFormat::rgb16, {}};
  const std::size_t channels = has_alpha ? 4 : 3;
  SFUMATO_TRY(
      memory.resize(context, out.bytes, out.row_bytes() * static_cast<std::size_t>(small_height_)));
  RarePoll<65536> poll(context);
  for (std::size_t i = 0; i < sum_.size() / 4; ++i) {
    if (poll.cancelled()) return context.cancel_status();
    const double* const sum = &sum_[4 * i];
    std::uint16_t pixel[4] = {};
    for (std::size_t c = 0; c < 3; ++c) pixel[c] = sum[3] > 0 ? in_16_bits(sum[c] / sum[3]) : 0;
    pixel[3] = in_16_bits(sum[3]);
    std::memcpy(&out.bytes[2 * channels * i], pixel, 2 * channels);
  }
  return {};
}

}  // namespace sfumato::codecs
