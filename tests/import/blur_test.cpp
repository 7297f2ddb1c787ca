// A filter that only blurs becomes sf:blur.
#include <gtest/gtest.h>

#include "document/gaussian.hpp"
#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

ImportedSvg blurred(const std::string& filter, const std::string& shape) {
  Context context;
  auto result = import_svg(
      context,
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" + filter + shape + "</svg>",
      "blur.svg");
  EXPECT_TRUE(result) << (result ? "" : result.status().message);
  return result ? std::move(*result) : ImportedSvg{};
}

std::string gaussian(const std::string& attributes, const std::string& of_filter = "") {
  return "<filter id='f' " + of_filter + "><feGaussianBlur " + attributes + "/></filter>";
}

const std::string kDisc = "<circle cx='50' cy='50' r='30' fill='#204080' filter='url(#f)'/>";

/// A region that holds all of a blur.
const std::string kWide = "x='-50%' y='-.5' width='200%' height='2'";

double radius_of(const ImportedSvg& made) {
  if (made.document.layers.size() != 1) return -1;
  const Curve& curve = made.document.layers[0].curves.front();
  EXPECT_EQ(curve.left.blur_radius, curve.right.blur_radius);
  return curve.left.blur_radius.stops.empty() ? 0 : curve.left.blur_radius.stops[0].value;
}

TEST(ImportBlur, a_gaussian_is_a_blur_radius) {
  for (const char* deviation : {"4", " 4 4 ", "4,4"}) {
    const auto made =
        blurred(gaussian("stdDeviation='" + std::string(deviation) + "'", kWide), kDisc);
    EXPECT_NEAR(radius_of(made), 4 * kBlurRadiusOfSigma, 1e-5) << deviation;
    EXPECT_TRUE(made.warnings.empty());
  }
  const auto of_style = blurred("", "<circle cx='50' cy='50' r='30' style='filter:blur(2px)'/>");
  EXPECT_NEAR(radius_of(of_style), 2 * kBlurRadiusOfSigma, 1e-5);
}

TEST(ImportBlur, transforms_scale_it) {
  const auto made = blurred(gaussian("in='SourceGraphic' stdDeviation='2'"),
                            "<g transform='scale(.5)'>" + kDisc + "</g>");
  EXPECT_NEAR(radius_of(made), kBlurRadiusOfSigma, 1e-5);
}

TEST(ImportBlur, a_blurred_shape_has_a_layer_of_its_own) {
  const auto made = blurred(gaussian("stdDeviation='2'"),
                            "<rect x='1' y='1' width='98' height='98' fill='#fff'/>" + kDisc +
                                "<rect x='40' y='40' width='9' height='9' fill='red'/>");
  EXPECT_EQ(made.document.layers.size(), 3u);
}

TEST(ImportBlur, other_filters_are_left_out_with_a_warning) {
  const std::string both = "<circle cx='50' cy='50' r='30' stroke='red' filter='url(#f)'/>";
  const std::string offset =
      "<filter id='f'><feOffset dx='3'/><feGaussianBlur stdDeviation='3'/></filter>";
  const std::pair<std::string, std::string> cases[] = {
      {gaussian("stdDeviation='3'"), both},
      {offset, kDisc},
      {gaussian("stdDeviation='3 1'"), kDisc},
      {gaussian("stdDeviation='0'"), kDisc},
      {gaussian("stdDeviation='-3'"), kDisc},
      {gaussian("stdDeviation='x'"), kDisc},
      {gaussian("stdDeviation='3' in='SourceAlpha'"), kDisc},
      {gaussian("stdDeviation='.1'", "primitiveUnits='objectBoundingBox'"), kDisc},
      {"<filter id='f'/>", kDisc},
      {"", kDisc},
  };
  for (const auto& [filter, shape] : cases) {
    const auto made = blurred(filter, shape);
    EXPECT_EQ(radius_of(made) > 0, false) << filter;
    ASSERT_EQ(made.warnings.size(), 1u) << filter;
    EXPECT_NE(made.warnings[0].message.find("filter of <circle>"), std::string::npos);
  }
}

TEST(ImportBlur, a_region_that_cuts_the_blur_has_a_warning) {
  const auto warnings = [](const std::string& region, const std::string& shape = kDisc) {
    return blurred(gaussian("stdDeviation='4'", region), shape).warnings.size();
  };
  EXPECT_EQ(warnings(""), 1u) << "a tenth of the box on each side, by default";
  EXPECT_EQ(warnings(kWide), 0u);
  EXPECT_EQ(warnings("x='-.1' y='-50%' width='2' height='200%'"), 1u);
  EXPECT_EQ(warnings("filterUnits='userSpaceOnUse' x='0' y='0' width='100%' height='100'"), 0u);
  EXPECT_EQ(warnings("filterUnits='userSpaceOnUse' x='15' y='0' width='100%' height='100'"), 1u);
  const std::string line =
      "<path d='M20 50H80' fill='none' stroke-width='40' stroke='red' filter='url(#f)'/>";
  const std::string tight = "filterUnits='userSpaceOnUse' x='-20' width='140' height='";
  EXPECT_EQ(warnings(tight + "80' y='10'", line), 0u);
  EXPECT_EQ(warnings(tight + "50' y='25'", line), 1u) << "the stroke counts";
}

}  // namespace
}  // namespace sfumato
