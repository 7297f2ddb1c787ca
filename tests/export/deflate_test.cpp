#include "codecs/deflate.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "codecs/gunzip.hpp"

namespace sfumato::outputs {
namespace {

std::vector<std::uint8_t> unpacked(const std::vector<std::uint8_t>& packed, std::size_t size) {
  std::vector<std::uint8_t> bytes(size + 1);
  uLongf length = bytes.size();
  EXPECT_EQ(uncompress(bytes.data(), &length, packed.data(), packed.size()), Z_OK);
  bytes.resize(length);
  return bytes;
}

/// Returns data that hardly compress, so that the result needs more than one piece.
std::vector<std::uint8_t> noise(std::size_t size) {
  std::vector<std::uint8_t> bytes(size);
  std::uint32_t state = 1;
  for (std::uint8_t& byte : bytes) {
    state = state * 1664525 + 1013904223;
    byte = static_cast<std::uint8_t>(state >> 24);
  }
  return bytes;
}

Result<std::vector<std::uint8_t>> packed(const Context& context,
                                         const std::vector<std::uint8_t>& bytes) {
  TableMemory memory("packed bytes");
  return codecs::deflated(context, bytes, memory);
}

TEST(Deflate, gives_back_what_it_packed) {
  Context context;
  for (std::size_t size : {0, 1, 1000, 262'144, 1'000'000}) {
    const std::vector<std::uint8_t> bytes = noise(size);
    const auto result = packed(context, bytes);
    ASSERT_TRUE(result);
    EXPECT_EQ(unpacked(*result, size), bytes) << size;
  }
}

TEST(Deflate, packs_what_repeats) {
  Context context;
  const auto result = packed(context, std::vector<std::uint8_t>(1'000'000, 7));
  ASSERT_TRUE(result);
  EXPECT_LT(result->size(), 2000u);
}

TEST(Deflate, packs_a_gzip_file_without_a_time) {
  Context context;
  const std::vector<std::uint8_t> bytes = noise(100'000);
  TableMemory memory("packed bytes");
  const auto result = codecs::gzipped(context, bytes, memory);
  ASSERT_TRUE(result);
  for (std::size_t i = 4; i < 8; ++i) EXPECT_EQ((*result)[i], 0);
  const std::string_view text(reinterpret_cast<const char*>(result->data()), result->size());
  const auto text_again = codecs::gunzip(context, text, memory);
  ASSERT_TRUE(text_again.ok());
  EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), text_again->begin(), text_again->end(),
                         [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); }));
}

TEST(Deflate, charges_its_memory_and_gives_it_back) {
  Context small{.budget = Budget(100'000)};
  const auto refused = packed(small, noise(1'000'000));
  EXPECT_EQ(refused.status().code, StatusCode::limit);
  Context context;
  ASSERT_TRUE(packed(context, noise(1000)));
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(Deflate, stops_when_cancelled) {
  Context context;
  context.cancel = true;
  EXPECT_EQ(packed(context, noise(1000)).status().code, StatusCode::cancelled);
}

}  // namespace
}  // namespace sfumato::outputs
