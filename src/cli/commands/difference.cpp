#include "cli/commands/difference.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/try.hpp"

namespace sfumato::cli {
namespace {

constexpr std::uint32_t kUnitsPerCode = 257;  // 65535 / 255
constexpr std::size_t kUnitValues = 65'536;

/// Reads row y as red, green, blue and alpha in 65535ths.
void expand_row(const Image& image, int y, std::vector<std::uint16_t>& rgba) {
  const int channels = channel_count(image.format);
  const bool wide = bytes_per_channel(image.format) == 2;
  const std::uint8_t* source = image.bytes.data() + image.row_bytes() * y;
  for (int x = 0; x < image.width; ++x) {
    std::uint16_t* pixel = &rgba[4 * static_cast<std::size_t>(x)];
    pixel[3] = kUnitValues - 1;
    if (wide) {
      std::memcpy(pixel, source, 2 * static_cast<std::size_t>(channels));
    } else {
      for (int c = 0; c < channels; ++c) {
        pixel[c] = static_cast<std::uint16_t>(source[c] * kUnitsPerCode);
      }
    }
    source += channels * (wide ? 2 : 1);
  }
}

/// Calls visit(difference) with the absolute differences of the four channels of every pixel, row
/// by row. Error: cancelled.
template <class Visit>
Status for_each_pixel_difference(const Context& context, const Image& a, const Image& b,
                                 Visit visit) {
  std::vector<std::uint16_t> row_a(4 * static_cast<std::size_t>(a.width));
  std::vector<std::uint16_t> row_b(row_a.size());
  for (int y = 0; y < a.height; ++y) {
    if (context.cancelled()) return context.cancel_status();
    expand_row(a, y, row_a);
    expand_row(b, y, row_b);
    for (std::size_t i = 0; i < row_a.size(); i += 4) {
      std::array<std::uint32_t, 4> difference;
      for (std::size_t c = 0; c < 4; ++c) {
        difference[c] = static_cast<std::uint32_t>(std::abs(row_a[i + c] - row_b[i + c]));
      }
      visit(difference);
    }
  }
  return ok_status();
}

}  // namespace

Result<Difference> Difference::of(const Context& context, const Image& a, const Image& b) {
  const std::size_t channels =
      static_cast<std::size_t>(std::max(channel_count(a.format), channel_count(b.format)));
  Difference counted;
  counted.count_of_.resize(kUnitValues);
  const auto count = [&](const std::array<std::uint32_t, 4>& difference) {
    for (std::size_t c = 0; c < channels; ++c) ++counted.count_of_[difference[c]];
  };
  SFUMATO_TRY(for_each_pixel_difference(context, a, b, count));
  counted.sample_count_ =
      static_cast<std::uint64_t>(a.width) * static_cast<std::uint64_t>(a.height) * channels;
  return counted;
}

double Difference::rms() const {
  // At most 2^30 samples of 2^32 each: the sum is exact in 64 bits.
  std::uint64_t sum_of_squares = 0;
  for (std::uint64_t units = 0; units < kUnitValues; ++units) {
    sum_of_squares += count_of_[units] * units * units;
  }
  const double mean = static_cast<double>(sum_of_squares) / static_cast<double>(sample_count_);
  return std::sqrt(mean) / kUnitsPerCode;
}

double Difference::maximum() const {
  return percentile(1000);
}

double Difference::psnr_db() const {
  const double error = rms();
  if (error == 0) return std::numeric_limits<double>::infinity();
  return 20 * std::log10(255 / error);
}

double Difference::percentile(int per_mille) const {
  const auto share = static_cast<std::uint64_t>(per_mille);
  const std::uint64_t rank = (sample_count_ * share + 999) / 1000;
  std::uint64_t seen = 0;
  std::size_t units = 0;
  while (units + 1 < kUnitValues && (seen += count_of_[units]) < rank) ++units;
  return static_cast<double>(units) / kUnitsPerCode;
}

Result<Image> difference_image(const Context& context, const Image& a, const Image& b, double scale,
                               TableMemory& memory) {
  Image image{a.width, a.height, PixelFormat::rgb8, {}};
  const std::size_t size = image.row_bytes() * static_cast<std::size_t>(a.height);
  SFUMATO_TRY(memory.reserve(context, image.bytes, size));
  const auto append = [&](const std::array<std::uint32_t, 4>& difference) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double units = std::max(difference[c], difference[3]);
      const double code = std::min(255.0, units / kUnitsPerCode * scale + 0.5);
      image.bytes.push_back(static_cast<std::uint8_t>(code));
    }
  };
  SFUMATO_TRY(for_each_pixel_difference(context, a, b, append));
  return image;
}

}  // namespace sfumato::cli
