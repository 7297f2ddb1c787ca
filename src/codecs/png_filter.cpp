#include "codecs/png_filter.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace sfumato::codecs {
namespace {

// Written as plain loops over 16-bit numbers, which compilers turn into SIMD code.

std::int16_t magnitude(std::int16_t value) {
  return static_cast<std::int16_t>(value < 0 ? -value : value);
}

struct Nothing {
  std::int16_t operator()(std::int16_t, std::int16_t, std::int16_t) const { return 0; }
};

struct Left {
  std::int16_t operator()(std::int16_t left, std::int16_t, std::int16_t) const { return left; }
};

struct Up {
  std::int16_t operator()(std::int16_t, std::int16_t up, std::int16_t) const { return up; }
};

struct Average {
  std::int16_t operator()(std::int16_t left, std::int16_t up, std::int16_t) const {
    return static_cast<std::int16_t>((left + up) >> 1);
  }
};

/// Whichever of the three is nearest to left + up - corner; the first of equals.
struct Paeth {
  std::int16_t operator()(std::int16_t left, std::int16_t up, std::int16_t corner) const {
    const auto to_left = static_cast<std::int16_t>(up - corner);
    const auto to_up = static_cast<std::int16_t>(left - corner);
    const std::int16_t by_left = magnitude(to_left);
    const std::int16_t by_up = magnitude(to_up);
    const std::int16_t by_corner = magnitude(static_cast<std::int16_t>(to_left + to_up));
    const std::int16_t up_or_corner = by_up <= by_corner ? up : corner;
    return by_left <= by_up && by_left <= by_corner ? left : up_or_corner;
  }
};

/// Filters a row and returns the sum of magnitudes.
template <class Predictor>
std::uint32_t apply(const std::uint8_t* current, const std::uint8_t* previous,
                    std::size_t row_bytes, std::size_t pixel_bytes, std::uint8_t* out) {
  const Predictor predicted;
  std::uint32_t sum = 0;
  const auto put = [&](std::size_t i, std::int16_t left, std::int16_t corner) {
    const auto rest = static_cast<std::uint8_t>(current[i] - predicted(left, previous[i], corner));
    out[i] = rest;
    sum +=
        static_cast<std::uint8_t>(std::min<std::uint8_t>(rest, static_cast<std::uint8_t>(-rest)));
  };
  for (std::size_t i = 0; i < pixel_bytes; ++i) put(i, 0, 0);
  for (std::size_t i = pixel_bytes; i < row_bytes; ++i) {
    put(i, current[i - pixel_bytes], previous[i - pixel_bytes]);
  }
  return sum;
}

using Apply = std::uint32_t (*)(const std::uint8_t*, const std::uint8_t*, std::size_t, std::size_t,
                                std::uint8_t*);
/// In the order of PNG's filter numbers.
constexpr Apply kFilters[] = {apply<Nothing>, apply<Left>, apply<Up>, apply<Average>, apply<Paeth>};

}  // namespace

void PngFilter::filter(const std::uint8_t* current, const std::uint8_t* previous,
                       std::uint8_t* out) {
  std::uint32_t best = 0;
  for (std::uint8_t number = 0; number < std::size(kFilters); ++number) {
    const std::uint32_t sum =
        kFilters[number](current, previous, candidate_.size(), pixel_bytes_, candidate_.data());
    if (number > 0 && sum >= best) continue;
    best = sum;
    out[0] = number;
    std::memcpy(out + 1, candidate_.data(), candidate_.size());
  }
}

}  // namespace sfumato::codecs
