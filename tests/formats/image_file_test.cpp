#include "codecs/image_file.hpp"

#include <gtest/gtest.h>

#include "sfumato/codecs/png.hpp"

namespace sfumato {
namespace {

TEST(ImageFile, a_png_of_16_bits_is_charged_beside_what_it_becomes) {
  Image image{256, 256, PixelFormat::rgba16, {}};
  image.bytes.resize(image.row_bytes() * 256, 7);
  Context writer;
  const auto png = encode_png(writer, image);
  ASSERT_TRUE(png.ok()) << png.status().message;
  const std::size_t deep = image.bytes.size(), both = deep / 2 * 3;
  Context small{.budget = Budget(both - 1)};
  EXPECT_EQ(codecs::decode_image(small, *png).status().code, StatusCode::limit);
  EXPECT_EQ(small.budget.used(), 0u);
  Context large{.budget = Budget(both)};
  EXPECT_TRUE(codecs::decode_image(large, *png).ok());
  EXPECT_EQ(large.budget.used(), 0u);
}

}  // namespace
}  // namespace sfumato
