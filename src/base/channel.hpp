#pragma once

#include <cstdint>
#include <cstring>

namespace sfumato {

/// Returns a channel of 16 bits, in the machine's byte order, rounded to 8 bits.
inline std::uint8_t rounded_to_8_bits(const std::uint8_t* channel) {
  std::uint16_t value = 0;
  std::memcpy(&value, channel, sizeof value);
  return static_cast<std::uint8_t>((value * 255u + 32767u) / 65535u);
}

}  // namespace sfumato
