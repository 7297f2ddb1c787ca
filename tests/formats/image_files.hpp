#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sfumato::test {

/// Returns a PNG of some colours.
std::vector<std::uint8_t> png_file(int width, int height);

/// Returns a JPEG of one colour: 1 channel is gray, 3 are RGB, 4 CMYK with Adobe's marker.
std::vector<std::uint8_t> jpeg_file(int width, int height, int channels,
                                    std::array<std::uint8_t, 4> color, bool progressive = false);

std::string base64_of(const std::vector<std::uint8_t>& bytes);
std::string percent_of(const std::vector<std::uint8_t>& bytes);

}  // namespace sfumato::test
