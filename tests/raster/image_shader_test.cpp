#include "raster/shaders/image_shader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "sfumato/base/color_space.hpp"

namespace sfumato::test {
namespace {

using raster::ImageShader;

Shader gradient_shader() {
  GradientFill fill;
  fill.shape = LinearGradient{{0, 0}, {100, 30}};
  fill.spread = SpreadMethod::reflect;
  fill.stops = {{0, {1, 0, 0}, 1}, {0.3, {0, 0.5f, 0.25f}, 0.2f}, {1, {0.1f, 0.9f, 1}, 0.9f}};
  return {"gradient", fill};
}

Shader texture_shader() {
  Texture texture;
  texture.width = 5;
  texture.height = 4;
  for (int i = 0; i < 80; ++i) texture.rgba.push_back(static_cast<std::uint8_t>(97 * i + 13));
  texture.layer_from_texture = {2, 0.5, -0.3, 1.5, 10, 20};
  return {"texture", texture};
}

ImageShader shader_of(const Shader& shader, InterpolationSpace space) {
  static Context context;  // must outlive the tables charged to it
  Result<ImageShader> result = ImageShader::create(context, shader, space);
  EXPECT_TRUE(result.ok()) << to_string(result.status());
  return std::move(*result);
}

struct Row {
  std::vector<float> plane[4];

  Row(const ImageShader& shader, const Affine& map, double x, double y, int count) {
    for (auto& values : plane) values.resize(static_cast<std::size_t>(count));
    shader.evaluate(map, x, y, count, plane[0].data(), plane[1].data(), plane[2].data(),
                    plane[3].data());
  }
};

TEST(ImageShader, a_row_is_made_of_its_points) {
  for (const Shader& document : {gradient_shader(), texture_shader()}) {
    const ImageShader shader = shader_of(document, InterpolationSpace::srgb);
    for (double scale : {0.2, 1.0, 3.0}) {
      const Affine map{scale, 0.1, -0.2, scale, -5, 3};
      const Row row(shader, map, -7, 11, 40);
      for (int i = 0; i < 40; ++i) {
        const ImageShader::Sample s = shader.at(map, {-7 + i + 0.5, 11.5});
        const std::size_t k = static_cast<std::size_t>(i);
        EXPECT_EQ(s.color, (Rgb{row.plane[0][k], row.plane[1][k], row.plane[2][k]}));
        EXPECT_EQ(s.alpha, row.plane[3][k]);
      }
    }
  }
}

TEST(ImageShader, a_pixel_does_not_depend_on_how_rows_are_cut) {
  for (const Shader& document : {gradient_shader(), texture_shader()}) {
    const ImageShader shader = shader_of(document, InterpolationSpace::oklab);
    const Affine map{0.7, 0.1, -0.2, 0.9, -5, 3};
    const Row whole(shader, map, 0, 4, 64), part(shader, map, 23, 4, 41);
    for (const auto& [a, b] :
         {std::pair{&whole.plane[0], &part.plane[0]}, {&whole.plane[3], &part.plane[3]}}) {
      EXPECT_TRUE(std::equal(b->begin(), b->end(), a->begin() + 23));
    }
  }
}

TEST(ImageShader, colours_are_filtered_as_code_values_and_converted_afterwards) {
  for (const Shader& document : {gradient_shader(), texture_shader()}) {
    const ImageShader code = shader_of(document, InterpolationSpace::srgb);
    for (InterpolationSpace space : {InterpolationSpace::linear, InterpolationSpace::oklab}) {
      const ImageShader shader = shader_of(document, space);
      for (double x = 0.5; x < 40; ++x) {
        const ImageShader::Sample expected = code.at({}, {x, 9}), actual = shader.at({}, {x, 9});
        EXPECT_EQ(actual.color, from_srgb(space, expected.color));
        EXPECT_EQ(actual.alpha, expected.alpha);
      }
    }
  }
}

TEST(ImageShader, an_instance_shows_the_layers_texture_where_the_layer_lies) {
  const ImageShader shader = shader_of(texture_shader(), InterpolationSpace::srgb);
  const Affine layer_from_image{0.1, 0, 0, 0.1, 3, 4};
  const Affine moved = layer_from_image * Affine{1, 0, 0, 1, -50, 20};
  const ImageShader::Sample here = shader.at(layer_from_image, {70.5, 160.5});
  const ImageShader::Sample there = shader.at(moved, {120.5, 140.5});
  EXPECT_NEAR(here.color.r, there.color.r, 1e-5);
  EXPECT_NEAR(here.alpha, there.alpha, 1e-5);
}

TEST(ImageShader, a_budget_that_is_too_small_is_a_limit_error) {
  for (const Shader& document : {gradient_shader(), texture_shader()}) {
    Context context{.budget = Budget(16)};
    EXPECT_EQ(ImageShader::create(context, document, InterpolationSpace::srgb).status().code,
              StatusCode::limit);
  }
}

}  // namespace
}  // namespace sfumato::test
