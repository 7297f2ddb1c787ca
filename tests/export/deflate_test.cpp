#include "codecs/deflate.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <vector>

namespace sfumato::outputs {
namespace {

std::vector<std::uint8_t> unpacked(const std::vector<std::uint8_t>& packed, std::size_t size) {
  std::vector<std::uint8_t> bytes(size + 1);
  uLongf length = bytes.size();
  EXPECT_EQ(uncompress(bytes.data(), &length, packed.data(), packed.size()), Z_OK);
  bytes.resize(length);
  return bytes;
}

/// Hard to pack, so that the result takes more than one piece.
std::vector<std::uint8_t> noise(std::size_t size) {
  std::vector<std::uint8_t> bytes(size);
  std::uint32_t state = 1;
  for (std::uint8_t& byte : bytes) {
    state = state * 1664525 + 1013904223;
    byte = static_cast<std::uint8_t>(state >> 24);
  }
  return bytes;
}

TEST(Deflate, gives_back_what_it_packed) {
  Context context;
  for (std::size_t size : {0, 1, 1000, 262'144, 1'000'000}) {
    const std::vector<std::uint8_t> bytes = noise(size);
    const auto packed = codecs::deflated(context, bytes);
    ASSERT_TRUE(packed);
    EXPECT_EQ(unpacked(*packed, size), bytes) << size;
  }
}

TEST(Deflate, packs_what_repeats) {
  Context context;
  const auto packed = codecs::deflated(context, std::vector<std::uint8_t>(1'000'000, 7));
  ASSERT_TRUE(packed);
  EXPECT_LT(packed->size(), 2000u);
}

TEST(Deflate, charges_its_memory_and_gives_it_back) {
  Context small{.budget = Budget(100'000)};
  const auto refused = codecs::deflated(small, noise(1'000'000));
  EXPECT_EQ(refused.status().code, StatusCode::limit);
  Context context;
  ASSERT_TRUE(codecs::deflated(context, noise(1000)));
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(Deflate, stops_when_cancelled) {
  Context context;
  context.cancel = true;
  EXPECT_EQ(codecs::deflated(context, noise(1000)).status().code, StatusCode::cancelled);
}

}  // namespace
}  // namespace sfumato::outputs
