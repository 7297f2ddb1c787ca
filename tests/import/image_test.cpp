// An <image> becomes a rectangle with a texture.
#include <gtest/gtest.h>

#include <algorithm>
#include <variant>

#include "codecs/data_uri_write.hpp"
#include "sfumato/formats/svg/svg.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

/// Returns a PNG of 4 × 2 texels, one of them with this alpha.
std::string png_of_alpha(std::uint8_t alpha) {
  Texture texture{4, 2, std::vector<std::uint8_t>(32, 255), {}, true, {}, {}};
  texture.rgba[0] = 10;
  texture.rgba[3] = alpha;
  Context context;
  TableMemory memory("test");
  const auto uri = codecs::data_uri(context, texture, memory);
  EXPECT_TRUE(uri);
  return uri ? *uri : "";
}

ImportedSvg with_images(const std::string& content, const ResourceLoader* loader = nullptr) {
  Context context;
  auto result = import_svg(
      context,
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink'"
      " xmlns:sf='urn:sfumato:1' viewBox='0 0 100 100'>" +
          content + "</svg>",
      "images.svg", loader);
  EXPECT_TRUE(result) << (result ? "" : result.status().message);
  return result ? std::move(*result) : ImportedSvg{};
}

std::string image(const std::string& attributes, std::uint8_t alpha = 255) {
  return "<image href='" + png_of_alpha(alpha) + "' " + attributes + "/>";
}

Box box_of(const Curve& curve) {
  Box box;
  for (const Vec2 point : curve.control_points) box.extend(point);
  return box;
}

/// The rectangle of a drawing with one image.
struct Placed {
  Box box;
  Texture texture;
};

Placed placed(const std::string& content) {
  const ImportedSvg made = with_images(content);
  EXPECT_TRUE(made.warnings.empty());
  if (made.document.layers.size() != 1 || made.document.layers[0].curves.size() != 1) {
    ADD_FAILURE() << "not one curve: " << content;
    return {};
  }
  const Curve& curve = made.document.layers[0].curves[0];
  EXPECT_EQ(curve.right.color.kind, ShaderKind::image_domain);
  const Shader& shader = made.document.shaders.at(curve.right.color.shader);
  return {box_of(curve), std::get<Texture>(shader.paint)};
}

void expect_near(const Box& a, const Box& b) {
  EXPECT_NEAR(a.min.x, b.min.x, 1e-9);
  EXPECT_NEAR(a.min.y, b.min.y, 1e-9);
  EXPECT_NEAR(a.max.x, b.max.x, 1e-9);
  EXPECT_NEAR(a.max.y, b.max.y, 1e-9);
}

TEST(ImportImage, is_a_rectangle_whose_texture_does_not_repeat) {
  const Placed made = placed(image("x='10' y='20' width='40' height='20'"));
  expect_near(made.box, {{10, 20}, {50, 40}});
  EXPECT_FALSE(made.texture.repeats);
  EXPECT_EQ(made.texture.width, 4);
  EXPECT_EQ(made.texture.layer_from_texture, (Affine{10, 0, 0, 10, 10, 20}));
}

TEST(ImportImage, a_size_that_is_auto_follows_from_the_file) {
  expect_near(placed(image("")).box, {{0, 0}, {4, 2}});
  expect_near(placed(image("width='40'")).box, {{0, 0}, {40, 20}});
  expect_near(placed(image("width='auto' height='40'")).box, {{0, 0}, {80, 40}});
  expect_near(placed(image("style='x:5px;width:50%'")).box, {{5, 0}, {55, 25}});
}

TEST(ImportImage, the_aspect_ratio_leaves_room_or_cuts) {
  const std::string square = "width='40' height='40' preserveAspectRatio=";
  expect_near(placed(image(square + "'xMidYMid'")).box, {{0, 10}, {40, 30}});
  expect_near(placed(image(square + "'xMaxYMax'")).box, {{0, 20}, {40, 40}});
  const Placed cut = placed(image(square + "'xMaxYMid slice'"));
  expect_near(cut.box, {{0, 0}, {40, 40}});
  EXPECT_EQ(cut.texture.layer_from_texture, (Affine{20, 0, 0, 20, -40, 0}));
  const Placed stretched = placed(image(square + "'none'"));
  expect_near(stretched.box, {{0, 0}, {40, 40}});
  EXPECT_EQ(stretched.texture.layer_from_texture, (Affine{10, 0, 0, 20, 0, 0}));
}

TEST(ImportImage, transforms_and_use_move_it) {
  expect_near(placed(image("width='4' transform='scale(2)'")).box, {{0, 0}, {8, 4}});
  const Placed used = placed("<defs>" + image("id='i' width='4'") +
                             "</defs><use xlink:href='#i' x='50' transform='scale(.5)'/>");
  expect_near(used.box, {{25, 0}, {27, 1}});
  EXPECT_EQ(used.texture.layer_from_texture, (Affine{.5, 0, 0, .5, 25, 0}));
}

TEST(ImportImage, opacity_is_that_of_the_layer) {
  const ImportedSvg made = with_images(image("width='9' opacity='.5'"));
  ASSERT_EQ(made.document.stack.size(), 1u);
  EXPECT_EQ(std::get<LayerInstance>(made.document.stack[0]).opacity, .5F);
}

/// Returns the opacity texture of the only curve; none if its opacity is constant.
std::optional<Texture> opacity_texture(const ImportedSvg& made) {
  const Curve& curve = made.document.layers.at(0).curves.at(0);
  if (curve.right.opacity.kind != ShaderKind::image_domain) return std::nullopt;
  return std::get<Texture>(made.document.shaders.at(curve.right.opacity.shader).paint);
}

TEST(ImportImage, alphas_are_a_texture_of_opacity) {
  const std::string tile = "patternUnits='userSpaceOnUse' width='40' height='20'";
  const auto pattern = [&](std::uint8_t alpha) {
    return "<pattern id='p' " + tile + ">" + image("width='40'", alpha) +
           "</pattern><circle cx='50' cy='50' r='30' fill='url(#p)'/>";
  };
  EXPECT_FALSE(opacity_texture(with_images(image("width='40'"))));
  EXPECT_FALSE(opacity_texture(with_images(pattern(255))));
  for (const bool is_pattern : {false, true}) {
    const auto opacity =
        opacity_texture(with_images(is_pattern ? pattern(99) : image("width='40'", 99)));
    ASSERT_TRUE(opacity);
    EXPECT_EQ(opacity->repeats, is_pattern);
    EXPECT_TRUE(opacity->file.empty());
    EXPECT_EQ(opacity->layer_from_texture, (Affine{10, 0, 0, 10, 0, 0}));
    std::vector<std::uint8_t> alphas(32, 255);
    alphas[3] = 99;
    EXPECT_EQ(opacity->rgba, alphas);
  }
}

TEST(ImportImage, what_shines_through_it_stays) {
  const std::string ground = "<path d='M1 1H99V98H1z' fill='#00f'/>";
  EXPECT_EQ(with_images(ground + image("x='9' y='9' width='40'")).document.layers.size(), 1u);
  EXPECT_EQ(with_images(ground + image("x='9' y='9' width='40'", 0)).document.layers.size(), 2u);
}

/// Has no files.
class EmptyLoader final : public ResourceLoader {
 public:
  explicit EmptyLoader(StatusCode code) : code_(code) {}
  Result<std::vector<std::uint8_t>> load(std::string_view) const override {
    return make_error(code_, "no such file");
  }

 private:
  StatusCode code_;
};

TEST(ImportImage, each_file_that_cannot_be_read_costs_its_image_alone) {
  for (const StatusCode code : {StatusCode::bad_input, StatusCode::io}) {
    const EmptyLoader loader(code);
    const ImportedSvg made = with_images(
        "<image href='a.png'/><image href='b.png'/><image href='b.png'/>"
        "<image href='https://example.org/c.png'/><image/>"
        "<image href='data:image/gif;base64,R0lGODlh'/>"
        "<circle cx='50' cy='50' r='9'/>",
        &loader);
    ASSERT_EQ(made.warnings.size(), 5u);
    EXPECT_EQ(made.warnings[0].message, "<image> is left out: \"a.png\": no such file");
    EXPECT_EQ(made.warnings[1].message, "<image> is left out: \"b.png\": no such file");
    EXPECT_EQ(made.document.layers.size(), 1u);
  }
}

TEST(ImportImage, faults_and_no_area_cost_the_image_alone) {
  const std::string circle = "<circle cx='50' cy='50' r='9'/>";
  for (const char* attributes : {"width='0'", "width='9' height='-1'", "width='10%' height='0'",
                                 "visibility='hidden'", "display='none'"}) {
    const ImportedSvg made = with_images(image(attributes) + circle);
    EXPECT_TRUE(made.warnings.empty()) << attributes;
    EXPECT_EQ(made.document.layers.at(0).curves.size(), 1u) << attributes;
  }
  for (const char* attributes :
       {"width='9z'", "preserveAspectRatio='odd'", "width='1e-300'", "x='1e7' width='1e7'"}) {
    const ImportedSvg made = with_images(image(attributes) + circle);
    EXPECT_EQ(made.warnings.size(), 1u) << attributes;
    EXPECT_EQ(made.document.layers.at(0).curves.size(), 1u) << attributes;
  }
}

TEST(ImportImage, a_picture_to_trace_over_is_ignored) {
  const ImportedSvg made = with_images(image("sf:reference='true'"));
  EXPECT_TRUE(made.document.layers.empty());
  EXPECT_TRUE(made.warnings.empty());
}

TEST(ImportImage, a_rectangle_over_it_is_no_background) {
  const ImportedSvg made =
      with_images(image("width='9'") + "<rect width='100' height='100' fill='#0f0'/>");
  EXPECT_FALSE(made.document.background);
  EXPECT_EQ(made.document.layers.size(), 2u);
}

TEST(ImportImage, an_open_size_is_that_of_the_image) {
  Context context;
  const auto made = import_svg(
      context, "<svg xmlns='http://www.w3.org/2000/svg'>" + image("x='3' y='2'") + "</svg>", "");
  ASSERT_TRUE(made);
  expect_near(made->document.artboard, {{3, 2}, {7, 4}});
}

TEST(ImportImage, is_written_and_read_again) {
  const ImportedSvg made = with_images(image("id='i' x='1' y='2' width='40'", 7));
  Context context;
  const auto text = write_svg(context, made.document);
  ASSERT_TRUE(text) << text.status().message;
  const auto read = read_svg(context, *text, "");
  ASSERT_TRUE(read) << read.status().message;
  EXPECT_TRUE(read->warnings.empty());
  ASSERT_EQ(read->document.shaders.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& before = std::get<Texture>(made.document.shaders[i].paint);
    const auto& after = std::get<Texture>(read->document.shaders[i].paint);
    EXPECT_FALSE(after.repeats);
    EXPECT_EQ(after.rgba, before.rgba);
    EXPECT_EQ(after.layer_from_texture, before.layer_from_texture);
  }
}

TEST(ImportImage, texels_that_should_be_hard_are_named) {
  const auto warning = [](const std::string& attributes) -> std::string {
    const ImportedSvg made = with_images("<g " + attributes + ">" + image("width='40'") + "</g>");
    return made.warnings.empty() ? "" : made.warnings[0].message;
  };
  EXPECT_EQ(warning("image-rendering='pixelated'"),
            "image-rendering of <image> is not followed: what should be hard is smooth");
  EXPECT_NE(warning("style='image-rendering:crisp-edges'"), "");
  EXPECT_EQ(warning("image-rendering='auto'"), "");
}

TEST(ImportImage, textures_are_limited) {
  Context context;
  context.limits.texels = 7;
  const auto made = import_svg(
      context, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'>" + image("") + "</svg>",
      "");
  EXPECT_EQ(made.status().code, StatusCode::limit);
}

TEST(ImportImage, a_clip_and_a_mask_cut_it) {
  const std::string half = "<rect width='50' height='100' fill='#fff'/>";
  const std::string place = "width='80' height='40' ";
  const Box cut{{0, 0}, {50, 40}};
  EXPECT_EQ(
      placed("<clipPath id='c'>" + half + "</clipPath>" + image(place + "clip-path='url(#c)'")).box,
      cut);
  EXPECT_EQ(placed("<clipPath id='c'>" + half + "</clipPath><g clip-path='url(#c)'>" +
                   image(place) + "</g>")
                .box,
            cut);
  EXPECT_EQ(placed("<mask id='m' maskUnits='userSpaceOnUse'>" + half + "</mask>" +
                   image(place + "mask='url(#m)'"))
                .box,
            cut);
  const std::string in_box =
      "<mask id='m' maskContentUnits='objectBoundingBox'>"
      "<rect width='.5' height='1' fill='#fff'/></mask>";
  EXPECT_EQ(placed(in_box + image("mask='url(#m)'")).box, (Box{{0, 0}, {2, 2}}));
  EXPECT_EQ(placed(in_box + "<g mask='url(#m)'>" + image(place) + "</g>").box,
            (Box{{0, 0}, {40, 40}}));
}

TEST(ImportImage, in_a_mask_it_is_an_opacity) {
  const ImportedSvg made =
      with_images("<mask id='m'>" + image("width='80' height='40'", 0) +
                  "</mask><rect width='80' height='80' fill='red' mask='url(#m)'/>");
  EXPECT_TRUE(made.warnings.empty());
  const Curve& curve = made.document.layers.at(0).curves.at(0);
  EXPECT_EQ(box_of(curve).max.y, 40);
  ASSERT_EQ(curve.right.opacity.kind, ShaderKind::image_domain);
  EXPECT_EQ(std::get<Texture>(made.document.shaders.at(curve.right.opacity.shader).paint).width, 4);
}

}  // namespace
}  // namespace sfumato
