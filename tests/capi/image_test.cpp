#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "capi/handles.hpp"
#include "codecs/image_file.hpp"

/// Pixels that the caller decodes.
namespace sfumato::test {
namespace {

std::int32_t load_example(void*, const char* href, sfumato_deliver_fn deliver, void* sink) {
  const std::string bytes = example(href);
  deliver(sink, bytes.data(), bytes.size());
  return 0;
}
constexpr sfumato_loader kLoader{load_example, nullptr};

/// A curve whose left side has an image in a data: URI: the bytes "image", which are not an image
/// file.
constexpr const char* kTexturedText = R"svg(<svg xmlns="http://www.w3.org/2000/svg"
    xmlns:sf="urn:sfumato:1" viewBox="0 0 8 8" sf:version="1">
  <defs><pattern id="p" patternUnits="userSpaceOnUse" width="8" height="8">
    <image href="data:;base64,aW1hZ2U=" width="8" height="8"/></pattern></defs>
  <g sf:diffuse="true"><path d="M-9 9 L20 9" sf:left="url(#p)"/></g>
</svg>)svg";
constexpr std::string_view kFile = "image";

std::vector<std::uint8_t> pixels_of(sfumato_context* context, const sfumato_document* document,
                                    int side) {
  const PictureHandle picture = solve(context, document);
  const auto row_bytes = 4 * static_cast<std::size_t>(side);
  std::vector<std::uint8_t> pixels(row_bytes * static_cast<std::size_t>(side));
  const sfumato_image image{pixels.data(), row_bytes, side, side, SFUMATO_RGBA8};
  EXPECT_EQ(sfumato_raster(context, picture.get(), &image, ""), SFUMATO_OK);
  return pixels;
}

class CImage : public testing::Test {
 protected:
  std::int32_t read(const std::string& text, const sfumato_loader* loader) {
    sfumato_document* out = nullptr;
    const std::int32_t code =
        sfumato_read(context.get(), text.data(), text.size(), "t", loader, &out);
    document.reset(out);
    return code;
  }

  /// Adds 2 × 1 pixels for the bytes "image". Texels are interpolated, so each half has one colour.
  std::int32_t add(const void* pixels, std::int32_t format, std::size_t row_bytes = 16) {
    const sfumato_image image{const_cast<void*>(pixels), row_bytes, 2, 1, format};
    return sfumato_add_image(context.get(), kFile.data(), kFile.size(), &image);
  }

  /// Returns the colour in the middle of the left half, then of the right half.
  std::vector<int> halves() {
    const std::vector<std::uint8_t> pixels = pixels_of(context.get(), document.get(), 8);
    const std::span left(pixels.data() + 4 * (8 * 4 + 1), 3);
    const std::span right(pixels.data() + 4 * (8 * 4 + 6), 3);
    std::vector<int> colors(left.begin(), left.end());
    colors.insert(colors.end(), right.begin(), right.end());
    return colors;
  }

  ContextHandle context{sfumato_context_new("threads=1 max-memory=200")};
  DocumentHandle document;
};

TEST_F(CImage, of_any_bytes_and_any_format_is_the_texture) {
  const std::uint8_t rgb8[] = {200, 0, 100, 200, 0, 100};
  const std::uint8_t rgba8[] = {200, 0, 100, 255, 200, 0, 100, 255};
  const std::uint16_t rgb16[] = {200 * 257, 100, 100 * 257, 200 * 257, 0, 100 * 257};
  const std::uint16_t rgba16[] = {200 * 257, 100, 100 * 257, 65535, 200 * 257, 0, 100 * 257, 65535};
  EXPECT_EQ(read(kTexturedText, nullptr), SFUMATO_BAD_INPUT);
  const std::vector<std::pair<const void*, std::int32_t>> given{{rgb8, SFUMATO_RGB8},
                                                                {rgba8, SFUMATO_RGBA8},
                                                                {rgb16, SFUMATO_RGB16},
                                                                {rgba16, SFUMATO_RGBA16}};
  for (const auto& [pixels, format] : given) {
    ASSERT_EQ(add(pixels, format), SFUMATO_OK);
    ASSERT_EQ(read(kTexturedText, nullptr), SFUMATO_OK) << sfumato_error_text(context.get());
    EXPECT_EQ(halves(), (std::vector<int>{200, 0, 100, 200, 0, 100})) << format;
  }
  ASSERT_EQ(sfumato_add_image(context.get(), kFile.data(), kFile.size(), nullptr), SFUMATO_OK);
  EXPECT_EQ(read(kTexturedText, nullptr), SFUMATO_BAD_INPUT);
}

TEST_F(CImage, goes_before_what_the_library_would_decode_and_equals_it) {
  const std::string text = example("textures.svg");
  ASSERT_EQ(read(text, &kLoader), SFUMATO_OK);
  const std::vector<std::uint8_t> own = pixels_of(context.get(), document.get(), 64);
  for (const char* name : {"waves.png", "hemp.png"}) {
    const std::string file = example(name);
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
    Context work;
    Result<codecs::RgbaImage> decoded = codecs::decode_image(work, bytes);
    ASSERT_TRUE(decoded.ok());
    for (const bool is_black : {true, false}) {
      std::vector<std::uint8_t> rgba = decoded->rgba;
      if (is_black) std::ranges::fill(rgba, std::uint8_t{0});
      const sfumato_image image{rgba.data(), 4 * static_cast<std::size_t>(decoded->width),
                                decoded->width, decoded->height, SFUMATO_RGBA8};
      ASSERT_EQ(sfumato_add_image(context.get(), bytes.data(), bytes.size(), &image), SFUMATO_OK);
      ASSERT_EQ(read(text, &kLoader), SFUMATO_OK);
      EXPECT_EQ(pixels_of(context.get(), document.get(), 64) == own, !is_black) << name;
    }
  }
}

TEST_F(CImage, that_is_too_large_is_a_limit) {
  const std::uint8_t rgb8[6] = {};
  const ContextHandle small(sfumato_context_new("limit.texels=1"));
  const sfumato_image image{const_cast<std::uint8_t*>(rgb8), 6, 2, 1, SFUMATO_RGB8};
  EXPECT_EQ(sfumato_add_image(small.get(), kFile.data(), kFile.size(), &image), SFUMATO_LIMIT);
  const std::vector<std::uint8_t> file(std::size_t{300} << 20);
  EXPECT_EQ(sfumato_add_image(context.get(), file.data(), file.size(), &image), SFUMATO_LIMIT);
}

TEST_F(CImage, is_charged_until_it_is_replaced_or_its_context_freed) {
  const std::vector<std::uint8_t> pixels(std::size_t{100} << 20);
  const sfumato_image image{const_cast<std::uint8_t*>(pixels.data()), 4 * 5120, 5120, 5120,
                            SFUMATO_RGBA8};
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(sfumato_add_image(context.get(), "same", 4, &image), SFUMATO_OK) << i;
  }
  EXPECT_EQ(sfumato_add_image(context.get(), "other", 5, &image), SFUMATO_LIMIT);
  ASSERT_EQ(sfumato_add_image(context.get(), "same", 4, nullptr), SFUMATO_OK);
  EXPECT_EQ(sfumato_add_image(context.get(), "other", 5, &image), SFUMATO_OK);
}

}  // namespace
}  // namespace sfumato::test
