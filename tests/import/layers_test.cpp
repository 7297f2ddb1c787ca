// The shapes of an import that share a layer.
#include <gtest/gtest.h>

#include <string>

#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

std::string picture(const std::string& content) {
  return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>\n" + content + "</svg>";
}

/// Returns the ids of each layer's curves, layers in the order of the stack.
std::string layers_of(const std::string& content) {
  Context context;
  const Result<ImportedSvg> made = import_svg(context, picture(content), "a.svg");
  EXPECT_TRUE(made) << (made ? "" : to_string(made.status()));
  if (!made) return {};
  std::string ids;
  for (const StackItem& item : made->document.stack) {
    if (std::holds_alternative<GroupBegin>(item)) ids += "( ";
    if (std::holds_alternative<GroupEnd>(item)) ids += ") ";
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (!instance) continue;
    for (const Curve& curve : made->document.layers[instance->layer].curves) ids += curve.id;
    ids += ' ';
  }
  return ids;
}

std::string rect(const std::string& id, double x, double y, double size,
                 const std::string& attributes = "fill='red'") {
  return "<rect id='" + id + "' x='" + std::to_string(x) + "' y='" + std::to_string(y) +
         "' width='" + std::to_string(size) + "' height='" + std::to_string(size) + "' " +
         attributes + "/>\n";
}

TEST(ImportLayers, shapes_side_by_side_share_one_and_shapes_that_meet_do_not) {
  EXPECT_EQ(layers_of(rect("a", 0, 0, 9) + rect("b", 20, 0, 9)), "ab ");
  EXPECT_EQ(layers_of(rect("a", 0, 0, 9) + rect("b", 9, 0, 9)), "a b ");
  EXPECT_EQ(layers_of(rect("a", 0, 0, 9) + rect("b", 5, 0, 9)), "a b ");
}

TEST(ImportLayers, a_shape_goes_below_those_that_it_does_not_meet) {
  // b lies over a; c meets neither, d meets only b.
  const std::string pair = rect("a", 0, 0, 9) + rect("b", 5, 5, 9);
  EXPECT_EQ(layers_of(pair + rect("c", 50, 50, 9)), "ac b ");
  EXPECT_EQ(layers_of(pair + rect("d", 12, 12, 9)), "a b d ");
  EXPECT_EQ(layers_of(pair + rect("d", 12, 12, 9) + rect("e", 3, 3, 3)), "a b de ");
  // On the ground of the lowest shape.
  EXPECT_EQ(layers_of(rect("a", 0, 0, 90) + rect("b", 85, 0, 9) + rect("c", 20, 20, 9)), "ac b ");
}

TEST(ImportLayers, groups_and_other_opacities_keep_their_order) {
  const std::string half = "fill='red' fill-opacity='.5'";
  EXPECT_EQ(layers_of(rect("a", 0, 0, 9, half) + rect("b", 5, 5, 9, half) +
                      rect("c", 50, 0, 9, half) + rect("d", 70, 0, 9)),
            "ac b d ");
  EXPECT_EQ(layers_of(rect("a", 0, 0, 90, half) + rect("b", 5, 5, 9, half)), "a b ");
  EXPECT_EQ(layers_of(rect("a", 0, 0, 9) + "<g opacity='.5'>" + rect("b", 20, 0, 9) +
                      rect("c", 25, 5, 9) + "</g>" + rect("d", 50, 0, 9)),
            "a ( b c ) d ");
}

TEST(ImportLayers, cells_that_touch_take_few_layers) {
  std::string cells;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 30; ++x) cells += rect("c", 3 * x, 3 * y, 3);
  }
  Context context;
  const Result<ImportedSvg> made = import_svg(context, picture(cells), "a.svg");
  ASSERT_TRUE(made);
  EXPECT_EQ(made->document.layers.size(), 88u);  // 2 y + x
}

TEST(ImportLayers, six_hundred_that_overlap_are_within_the_limit) {
  std::string circles;
  for (int i = 0; i < 600; ++i)
    circles += "<circle cx='50' cy='50' r='" + std::to_string(40 - .05 * i) + "' opacity='.5'/>";
  Context context;
  const Result<ImportedSvg> made = import_svg(context, picture(circles), "a.svg");
  ASSERT_TRUE(made) << to_string(made.status());
  EXPECT_EQ(made->document.layers.size(), 600u);
}

TEST(ImportLayers, too_many_name_the_limit_and_the_line) {
  Context context{.limits = {.layers = 2}};
  const Result<ImportedSvg> made = import_svg(
      context, picture(rect("a", 0, 0, 9) + rect("b", 5, 0, 9) + rect("c", 8, 0, 9)), "a.svg");
  ASSERT_FALSE(made);
  EXPECT_EQ(to_string(made.status()), "a.svg:4:1: more than the limit of 2 layers");
  EXPECT_EQ(made.status().limit, "layers");
}

}  // namespace
}  // namespace sfumato
