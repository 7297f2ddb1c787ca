#include "display/paint_table.hpp"

#include <gtest/gtest.h>

#include <array>

namespace sfumato::outputs {
namespace {

Picture picture_with(std::vector<Shader> shaders, std::vector<std::uint32_t> named) {
  Picture picture;
  picture.shaders = std::move(shaders);
  picture.layers.emplace_back();
  picture.layers.back().color.shader = std::move(named);
  return picture;
}

display::PaintTable table_of(const Picture& picture) {
  static Context context;  // must outlive the tables charged to it
  Result<display::PaintTable> table =
      display::make_paint_table(context, picture, display::PaintTexels::kept);
  EXPECT_TRUE(table.ok()) << to_string(table.status());
  return table.ok() ? std::move(*table) : display::PaintTable{};
}

std::array<float, 4> value(const display::PaintTable& table, std::size_t texel) {
  std::array<float, 4> all{};
  for (std::size_t c = 0; c < 4; ++c) all[c] = table.values.at(4 * texel + c);
  return all;
}

using Texel = std::array<float, 4>;

Shader gradient_of_two_stops() {
  GradientFill fill;
  fill.shape = LinearGradient{{0, 0}, {10, 0}};
  fill.spread = SpreadMethod::reflect;
  fill.stops = {{0.0, {1, 0, 0}, 1}, {1.0, {0, 0, 1}, 0.5f}};
  return {"g", fill};
}

Shader texture_of(int width, int height) {
  Texture texture;
  texture.width = width;
  texture.height = height;
  texture.rgba.assign(4 * static_cast<std::size_t>(width * height), 255);
  return {"t", texture};
}

TEST(DisplayPaintTable, a_gradient_lies_as_documented) {
  const display::PaintTable table = table_of(picture_with({gradient_of_two_stops()}, {0}));
  ASSERT_EQ(table.values.size(), 4u * (5 + 4));
  EXPECT_EQ(value(table, 0), (Texel{0, 1, 1, 0}));
  EXPECT_EQ(value(table, 2), (Texel{1, 0, 0, 1}));
  EXPECT_EQ(value(table, 3), (Texel{0, 0, 1, 0.5f}));
  EXPECT_EQ(value(table, 5), (Texel{0, 1, 0, 0}));
  EXPECT_EQ(value(table, 7), (Texel{-1, 0, 1, -0.5f}));
  // The integral of alpha from 1 to 1/2.
  EXPECT_FLOAT_EQ(value(table, 4)[3], 0.75f);
  EXPECT_DOUBLE_EQ(table.paint_from_layer[0]({5, 3}).x, 0.5);
}

TEST(DisplayPaintTable, levels_of_a_texture_stand_one_after_another) {
  const display::PaintTable table = table_of(picture_with({texture_of(4, 2)}, {0}));
  EXPECT_EQ(value(table, 0), (Texel{2, 1, 3, 1}));
  EXPECT_EQ(value(table, 1), (Texel{4, 2, 0, 0}));
  EXPECT_EQ(value(table, 3), (Texel{2, 1, 8, 0}));
  EXPECT_EQ(value(table, 4), (Texel{0.5f, 0.5f, 2, 1}));
  EXPECT_EQ(value(table, 5), (Texel{1, 1, 10, 0}));
  EXPECT_EQ(table.texels.size(), 4u * 11);
  EXPECT_EQ(table.texels[0], 65535);
}

TEST(DisplayPaintTable, rows_of_texels_are_counted) {
  const display::PaintTable table = table_of(picture_with({texture_of(64, 64)}, {0}));
  EXPECT_EQ(value(table, 3), (Texel{32, 32, 0, 2}));
}

TEST(DisplayPaintTable, what_no_layer_names_is_left_out) {
  const display::PaintTable table =
      table_of(picture_with({texture_of(4, 4), gradient_of_two_stops()}, {1}));
  EXPECT_EQ(table.first_value[1], 0u);
  EXPECT_TRUE(table.texels.empty());
}

TEST(DisplayPaintTable, memory_is_charged) {
  const Picture picture = picture_with({texture_of(64, 64)}, {0});
  Context context{.budget = Budget(64 * 64 * 8)};
  const Result<display::PaintTable> table =
      display::make_paint_table(context, picture, display::PaintTexels::kept);
  ASSERT_FALSE(table.ok());
  EXPECT_EQ(table.status().code, StatusCode::limit);
  EXPECT_EQ(context.budget.used(), 0u);
}

}  // namespace
}  // namespace sfumato::outputs
