// Patterns with an image: the places of texels, repetition, files and data: URIs.
#include <gtest/gtest.h>

#include <cstring>
#include <optional>
#include <span>
#include <utility>

#include "codecs/image_file.hpp"
#include "formats/image_files.hpp"
#include "formats/svg/svg_support.hpp"
#include "sfumato/codecs/png.hpp"

namespace sfumato::test {
namespace {

MemoryLoader wood() {
  MemoryLoader loader;
  loader.files["wood.png"] = png_file(4, 2);
  return loader;
}

/// Returns the shaders of one curve from (10, 20) to (30, 60) that is painted by the pattern.
std::vector<Shader> shaders_of(const std::string& pattern, const std::string& curve_attributes = "",
                               const ResourceLoader* loader = nullptr) {
  const MemoryLoader files = wood();
  return read(svg("<defs>" + pattern + "</defs><g sf:diffuse='true'><path " + curve_attributes +
                  " d='M10 20 L30 60' sf:left='url(#p)'/></g>"),
              loader ? loader : &files)
      .document.shaders;
}

Texture texture_of(const std::string& pattern, const std::string& curve_attributes = "") {
  std::vector<Shader> shaders = shaders_of(pattern, curve_attributes);
  if (shaders.size() != 1 || !std::holds_alternative<Texture>(shaders[0].paint)) {
    ADD_FAILURE() << "not one texture";
    return {};
  }
  return std::get<Texture>(shaders[0].paint);
}

std::string pattern(const std::string& attributes, const std::string& image_attributes) {
  return "<pattern id='p' " + attributes + "><image href='wood.png' " + image_attributes +
         "/></pattern>";
}

const std::string kUser = "patternUnits='userSpaceOnUse' ";

TEST(SvgTexture, texels_fill_the_image_and_repeat_with_the_tile) {
  const Texture texture =
      texture_of(pattern(kUser + "width='40' height='20'", "width='40' height='20'"));
  EXPECT_EQ(texture.width, 4);
  EXPECT_EQ(texture.height, 2);
  EXPECT_EQ(texture.rgba.size(), 32u);
  EXPECT_EQ(texture.layer_from_texture, (Affine{10, 0, 0, 10, 0, 0}));
  EXPECT_EQ(texture.period, (Vec2{0, 0}));
  EXPECT_TRUE(texture.repeats);
}

TEST(SvgTexture, its_edge_is_extended_where_it_does_not_repeat) {
  const auto texture = [](const std::string& repeats) {
    return texture_of(pattern(kUser + "width='90' height='90' sf:repeats='" + repeats + "'",
                              "width='40' height='20'"));
  };
  EXPECT_TRUE(texture("true").repeats);
  EXPECT_FALSE(texture("false").repeats);
  EXPECT_EQ(texture("false").period, (Vec2{0, 0}));
}

/// Has pixels only for files with the bytes "abc".
class DecodedLoader final : public ResourceLoader {
 public:
  ImagePixels pixels{};

  Result<std::vector<std::uint8_t>> load(std::string_view) const override {
    return std::vector<std::uint8_t>{'a', 'b', 'c'};
  }
  std::optional<ImagePixels> decoded(std::span<const std::uint8_t> file) const override {
    const bool is_known = file.size() == 3 && file[0] == 'a';
    return is_known ? std::optional(pixels) : std::nullopt;
  }
};

TEST(SvgTexture, pixels_that_the_caller_has_decoded_are_its_texels) {
  const std::vector<std::uint8_t> rgba{1, 2, 3, 4, 5, 6, 7, 8};
  DecodedLoader loader;
  loader.pixels = {2, 1, rgba};
  for (const char* href : {"wood.png", "data:,abc", "data:;base64,YWJj"}) {
    const std::vector<Shader> shaders = shaders_of(
        "<pattern id='p' patternUnits='userSpaceOnUse' width='4' height='2'><image "
        "width='4' height='2' href='" +
            std::string(href) + "'/></pattern>",
        "", &loader);
    ASSERT_EQ(shaders.size(), 1u);
    const Texture& texture = std::get<Texture>(shaders[0].paint);
    EXPECT_EQ(texture.width, 2);
    EXPECT_EQ(texture.rgba, rgba) << href;
    EXPECT_EQ(texture.file, (std::vector<std::uint8_t>{'a', 'b', 'c'}));
  }
}

TEST(SvgTexture, pixels_that_are_no_image_are_refused_with_the_place) {
  const std::vector<std::uint8_t> rgba(8);
  const std::string text = svg("<defs>" + pattern(kUser + "width='4' height='2'", "width='4'") +
                               "</defs><g sf:diffuse='true'><path d='M1 2 L3 4' "
                               "sf:left='url(#p)'/></g>");
  DecodedLoader loader;
  const auto status = [&](int width, int height, const Limits& limits = {}) {
    loader.pixels = {width, height, rgba};
    return status_of(text, &loader, limits);
  };
  for (const auto& [width, height] : {std::pair{1, 1}, {0, 2}, {2, 0}, {-1, -2}, {1, 3}}) {
    EXPECT_EQ(to_string(status(width, height)),
              "a.svg:2:74: \"wood.png\": pixels that are no image were given for it");
  }
  EXPECT_EQ(status(1 << 20, 1).code, StatusCode::limit);
  EXPECT_EQ(status(2, 1, {.texels = 1}).code, StatusCode::limit);
  EXPECT_TRUE(status(2, 1).message.find("pixels that") == std::string::npos);
}

TEST(SvgTexture, keeps_its_file) {
  EXPECT_EQ(texture_of(pattern(kUser + "width='4' height='2'", "width='4' height='2'")).file,
            png_file(4, 2));
}

TEST(SvgTexture, smaller_tile_cuts_the_image) {
  const Texture texture =
      texture_of(pattern(kUser + "x='5' y='6' width='20' height='10'", "width='40' height='20'"));
  EXPECT_EQ(texture.layer_from_texture, (Affine{10, 0, 0, 10, 5, 6}));
  EXPECT_EQ(texture.period, (Vec2{2, 1}));
}

TEST(SvgTexture, image_keeps_its_shape_unless_told_otherwise) {
  EXPECT_EQ(texture_of(pattern(kUser + "width='40' height='40'", "width='40' height='40'"))
                .layer_from_texture,
            (Affine{10, 0, 0, 10, 0, 10}));
  EXPECT_EQ(texture_of(pattern(kUser + "width='40' height='40'",
                               "width='40' height='40' preserveAspectRatio='none'"))
                .layer_from_texture,
            (Affine{10, 0, 0, 20, 0, 0}));
  EXPECT_EQ(texture_of(pattern(kUser + "width='40' height='40'", "width='40'")).layer_from_texture,
            (Affine{10, 0, 0, 10, 0, 0}));
  EXPECT_EQ(texture_of(pattern(kUser + "width='4' height='2'", "")).layer_from_texture, Affine{});
}

TEST(SvgTexture, image_that_leaves_a_part_of_its_tile_is_told) {
  const MemoryLoader files = wood();
  const ReadDocument read_document =
      read(svg("<defs>" + pattern(kUser + "width='50' height='20'", "width='40' height='20'") +
               "</defs><g sf:diffuse='true'><path d='M10 20 L30 60' sf:left='url(#p)'/></g>"),
           &files);
  ASSERT_EQ(read_document.warnings.size(), 1u);
  EXPECT_EQ(to_string(read_document.warnings[0]),
            "a.svg:2:76: the <image> does not cover the pattern's tile; the colours at its edge "
            "are drawn on");
  EXPECT_EQ(std::get<Texture>(read_document.document.shaders[0].paint).period, (Vec2{5, 2}));
}

TEST(SvgTexture, transforms_of_pattern_and_shape_are_in_its_place) {
  EXPECT_EQ(texture_of(pattern(kUser + "width='4' height='2' patternTransform='rotate(90)'", ""),
                       "transform='translate(10 0)'")
                .layer_from_texture,
            (Affine{0, 1, -1, 0, 10, 0}));
}

TEST(SvgTexture, tile_in_the_bounding_box) {
  EXPECT_EQ(texture_of(pattern("width='1' height='1' patternContentUnits='objectBoundingBox'",
                               "width='1' height='1' preserveAspectRatio='none'"))
                .layer_from_texture,
            (Affine{5, 0, 0, 20, 10, 20}));
  const Texture half = texture_of(pattern("x='.5' width='50%' height='.5'", ""));
  EXPECT_EQ(half.layer_from_texture, (Affine{1, 0, 0, 1, 20, 20}));
  EXPECT_EQ(half.period, (Vec2{10, 20}));
}

TEST(SvgTexture, view_box_of_the_pattern) {
  EXPECT_EQ(texture_of(pattern(kUser + "viewBox='0 0 4 2' width='40' height='20'", ""))
                .layer_from_texture,
            (Affine{10, 0, 0, 10, 0, 0}));
}

TEST(SvgTexture, pattern_inherits_its_image_and_size) {
  const std::string base = "<pattern id='base' " + kUser +
                           "width='4' height='2'><title>wood</title><image href='wood.png'/>"
                           "</pattern>";
  EXPECT_EQ(texture_of(base + "<pattern id='p' href='#base' patternTransform='scale(3)'/>")
                .layer_from_texture,
            (Affine{3, 0, 0, 3, 0, 0}));
}

TEST(SvgTexture, data_uris_are_decoded) {
  for (const std::string& uri :
       {"data:image/png;base64," + base64_of(png_file(4, 2)),
        "data:image/png;BASE64,\n " + base64_of(png_file(4, 2)).insert(8, " \n\t"),
        "data:," + percent_of(png_file(4, 2))}) {
    const std::vector<Shader> shaders = shaders_of(
        "<pattern id='p' " + kUser + "width='4' height='2'><image href='" + uri + "'/></pattern>");
    ASSERT_EQ(shaders.size(), 1u);
    EXPECT_EQ(std::get<Texture>(shaders[0].paint).file, png_file(4, 2));
  }
}

TEST(SvgTexture, jpeg_is_decoded_whatever_its_channels) {
  for (const int channels : {1, 3, 4}) {
    MemoryLoader files;
    files.files["wood.png"] = jpeg_file(16, 8, channels, {200, 100, 50, 0});
    const auto shaders = shaders_of(pattern(kUser + "width='16' height='8'", ""), "", &files);
    ASSERT_EQ(shaders.size(), 1u);
    const auto& texture = std::get<Texture>(shaders[0].paint);
    ASSERT_EQ(texture.rgba.size(), 4u * 16 * 8);
    // Gray uses the first channel; CMYK as Adobe writes it is the remainder of white.
    const int red = texture.rgba[0], green = texture.rgba[1], alpha = texture.rgba[3];
    EXPECT_NEAR(red, channels == 4 ? 0 : 200, 3) << channels;
    EXPECT_NEAR(green, channels == 1 ? 200 : channels == 3 ? 100 : 0, 3) << channels;
    EXPECT_EQ(alpha, 255);
  }
}

TEST(SvgTexture, cmyk_of_adobe_is_inverted) {
  MemoryLoader files;
  files.files["wood.png"] = jpeg_file(16, 8, 4, {200, 100, 50, 255});
  const auto shaders = shaders_of(pattern(kUser + "width='16' height='8'", ""), "", &files);
  const auto& texture = std::get<Texture>(shaders[0].paint);
  EXPECT_NEAR(texture.rgba[0], 200, 3);
  EXPECT_NEAR(texture.rgba[1], 100, 3);
  EXPECT_NEAR(texture.rgba[2], 50, 3);
}

TEST(SvgTexture, sixteen_bits_and_gray_become_eight_bits_of_rgba) {
  Context context;
  Image image{1, 1, PixelFormat::rgba16, std::vector<std::uint8_t>(8)};
  const std::uint16_t values[4] = {0xFFFF, 0x8080, 0x0000, 0x4040};
  std::memcpy(image.bytes.data(), values, 8);
  const auto png = encode_png(context, image);
  ASSERT_TRUE(png.ok());
  const auto decoded = codecs::decode_image(context, *png);
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(decoded->rgba, (std::vector<std::uint8_t>{255, 128, 0, 64}));
}

TEST(SvgTexture, each_file_is_loaded_once) {
  const MemoryLoader files = wood();
  const Document document =
      read(svg("<defs>" + pattern(kUser + "width='4' height='2'", "") +
               "</defs><g sf:diffuse='true'><path d='M0 0 h9' sf:left='url(#p)'/>"
               "<path transform='scale(2)' d='M0 5 h9' sf:left='url(#p)'/>"
               "<path d='M0 9 h9' sf:left='url(#p)'/></g>"),
           &files)
          .document;
  EXPECT_EQ(files.load_count, 1);
  EXPECT_EQ(document.shaders.size(), 2u);
}

TEST(SvgTexture, names_of_files_are_percent_decoded) {
  MemoryLoader files;
  files.files["my wood.png"] = png_file(4, 2);
  const std::string text =
      "<pattern id='p' " + kUser + "width='4' height='2'><image href='my%20wood.png'/></pattern>";
  EXPECT_EQ(shaders_of(text, "", &files).size(), 1u);
}

}  // namespace
}  // namespace sfumato::test
