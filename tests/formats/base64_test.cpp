#include "codecs/base64.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace sfumato {
namespace {

std::vector<std::uint8_t> bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

/// RFC 4648, section 10.
TEST(Base64, has_the_values_of_its_standard) {
  const std::pair<const char*, const char*> cases[] = {{"", ""},
                                                       {"f", "Zg=="},
                                                       {"fo", "Zm8="},
                                                       {"foo", "Zm9v"},
                                                       {"foob", "Zm9vYg=="},
                                                       {"fooba", "Zm9vYmE="},
                                                       {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, coded] : cases) EXPECT_EQ(codecs::encode_base64(bytes_of(plain)), coded);
}

TEST(Base64, gives_back_every_byte) {
  std::vector<std::uint8_t> all(256);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint8_t>(i);
  const Context context;
  TableMemory memory("a test");
  std::vector<std::uint8_t> back;
  ASSERT_TRUE(codecs::decode_base64(context, codecs::encode_base64(all), memory, back));
  EXPECT_EQ(back, all);
}

TEST(Base64, appended_in_parts_is_the_same_as_at_once) {
  const std::vector<std::uint8_t> bytes((std::size_t{6} << 20) + 1, 0xa5);
  Context context;
  OutputBuffer text(context, "base64");
  text += "data:,";
  codecs::append_base64(context, bytes, text);
  EXPECT_EQ(text.size(), 6 + codecs::base64_length(bytes.size()));
  const auto appended = text.finish();
  ASSERT_TRUE(appended.ok());
  EXPECT_EQ(std::string(appended->begin(), appended->end()),
            "data:," + codecs::encode_base64(bytes));
}

TEST(Base64, appending_stops_when_cancelled) {
  Context context;
  context.cancel = true;
  OutputBuffer text(context, "base64");
  codecs::append_base64(context, std::vector<std::uint8_t>(1000), text);
  EXPECT_EQ(text.status().code, StatusCode::cancelled);
}

}  // namespace
}  // namespace sfumato
