// The examples: each reads without a warning, renders, and matches its description in the gallery.
#include "pipeline/examples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "codecs/photo/photo.hpp"
#include "sfumato/api/render_pixels.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/draw.hpp"
#include "support/picture_quality.hpp"
#include "support/places.hpp"
#include "support/planes.hpp"
#include "support/sanitizers.hpp"
#include "support/scenes.hpp"
#include "support/soak.hpp"

namespace sfumato {
namespace {

Document example(const std::string& name) {
  Context context;
  const test::FolderFiles files = test::example_textures();
  const auto bytes = test::file_bytes(test::kExamplesFolder + name);
  if (!bytes) {
    ADD_FAILURE() << "no " << name;
    return {};
  }
  Result<ReadDocument> read = read_document(context, *bytes, name, &files);
  if (!read) {
    ADD_FAILURE() << read.status().message;
    return {};
  }
  for (const Diagnostic& warning : read->warnings) ADD_FAILURE() << name << ": " << warning.message;
  return std::move(read->document);
}

std::vector<std::string> example_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(test::kExamplesFolder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".svg" || extension == ".xml") names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Returns a picture 256 pixels wide.
Image drawn_256_wide(const Document& document) {
  Context context;
  const double width = document.artboard.max.x - document.artboard.min.x;
  const double height = document.artboard.max.y - document.artboard.min.y;
  RasterOptions raster;
  raster.width = 256;
  raster.height = static_cast<int>(std::lround(256 * height / width));
  DiffuseOptions options;
  options.pixels_per_unit = 256 / width;
  const Result<Picture> picture = diffuse(context, document, options);
  if (!picture) {
    ADD_FAILURE() << picture.status().message;
    return {};
  }
  Result<Image> image = rasterize(context, *picture, raster);
  if (!image) {
    ADD_FAILURE() << image.status().message;
    return {};
  }
  return std::move(*image);
}

std::size_t color_count(const Image& image) {
  std::set<std::uint32_t> colors;
  for (std::size_t i = 0; i + 2 < image.bytes.size(); i += 3) {
    colors.insert(image.bytes[i] | std::uint32_t{image.bytes[i + 1]} << 8 |
                  std::uint32_t{image.bytes[i + 2]} << 16);
  }
  return colors.size();
}

/// Returns the items of one kind in the stack, bottom first.
template <class Item>
std::vector<Item> items(const Document& document) {
  std::vector<Item> found;
  for (const StackItem& item : document.stack) {
    if (const Item* one = std::get_if<Item>(&item)) found.push_back(*one);
  }
  return found;
}

const Layer* layer_of(const Document& document, const std::string& id) {
  const auto at = std::find_if(document.layers.begin(), document.layers.end(),
                               [&](const Layer& layer) { return layer.id == id; });
  return at == document.layers.end() ? nullptr : &*at;
}

std::size_t curve_count(const Document& document) {
  std::size_t count = 0;
  for (const Layer& layer : document.layers) count += layer.curves.size();
  return count;
}

template <class Paint>
std::size_t paint_count(const Document& document) {
  return static_cast<std::size_t>(std::count_if(
      document.shaders.begin(), document.shaders.end(),
      [](const Shader& shader) { return std::holds_alternative<Paint>(shader.paint); }));
}

float smallest(const ScalarStops& list) {
  float least = list.empty() ? 0 : list.stops.front().value;
  for (const Stop<float>& stop : list.stops) least = std::min(least, stop.value);
  return least;
}

float largest(const ScalarStops& list) {
  float most = 0;
  for (const Stop<float>& stop : list.stops) most = std::max(most, stop.value);
  return most;
}

class Example : public testing::TestWithParam<std::string> {};

TEST_P(Example, reads_without_warnings_and_renders) {
  const Document document = example(GetParam());
  ASSERT_FALSE(HasFailure());
  const Image image = drawn_256_wide(document);
  ASSERT_EQ(image.width, 256);
  EXPECT_GT(color_count(image), 1000u);
}

/// Bands across a drawing with every eighth row of pixels, in `make soak` every fourth.
constexpr int kBands = 5;

/// Returns a band at the drawing's own size, drawn pixel by pixel.
Image drawn_exactly(const Document& document, int band, std::optional<double> tolerance) {
  ThreadPool executor(2);
  Context context{.executor = &executor};
  const Box& whole = document.artboard;
  const double share = test::is_soak() ? 1.0 / 4 : 1.0 / 8;
  const double height = std::round(share * whole.height() / kBands);
  const double top = whole.min.y + std::floor((band + 0.5 - share / 2) * whole.height() / kBands);
  RasterOptions raster;
  raster.viewport = Box{{whole.min.x, top}, {whole.max.x, top + height}};
  raster.width = static_cast<int>(std::lround(whole.width()));
  raster.height = static_cast<int>(height);
  raster.format = PixelFormat::rgb16;
  raster.antialias = false;
  DiffuseOptions options;
  options.tolerance = tolerance;
  Result<Image> image = render_pixels(context, document, options, raster);
  EXPECT_TRUE(image.ok()) << image.status().message;
  return image ? std::move(*image) : Image{};
}

/// Returns the number of pixels that differ by more than a code value of 255; both have 16 bits.
std::size_t differing_pixels(const Image& a, const Image& b) {
  const auto channel = [](const Image& image, std::size_t i) {
    std::uint16_t value;
    std::memcpy(&value, image.bytes.data() + 2 * i, 2);
    return int{value};
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.bytes.size() / 6; ++i) {
    const auto differs = [&](std::size_t c) {
      return std::abs(channel(a, c) - channel(b, c)) > 257;
    };
    count += differs(3 * i) || differs(3 * i + 1) || differs(3 * i + 2);
  }
  return count;
}

TEST_P(Example, shows_chords_finer_than_the_default_in_a_pixel_of_a_thousand_only) {
  if (SFUMATO_HAS_SANITIZER) GTEST_SKIP() << "minutes under sanitizers";
  const Document document = example(GetParam());
  std::size_t pixels = 0, off = 0;
  for (int band = 0; band < kBands; ++band) {
    const Image fine = drawn_exactly(document, band, 0.02);
    const Image plain = drawn_exactly(document, band, {});
    ASSERT_FALSE(fine.bytes.empty());
    ASSERT_EQ(fine.bytes.size(), plain.bytes.size());
    pixels += fine.bytes.size() / 6;
    off += differing_pixels(fine, plain);
  }
  EXPECT_LE(1000 * off, pixels) << off << " of " << pixels;
}

INSTANTIATE_TEST_SUITE_P(Examples, Example, testing::ValuesIn(example_names()),
                         [](const testing::TestParamInfo<std::string>& parameter) {
                           std::string name = parameter.param;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

TEST(Examples, the_apple_has_a_texture_a_gradient_and_local_highlights) {
  const Document document = example("apple.svg");
  EXPECT_EQ(paint_count<Texture>(document), 1u);
  EXPECT_GE(paint_count<GradientFill>(document), 1u);
  EXPECT_GE(items<LocalStroke>(document).size(), 2u);
}

TEST(Examples, the_lily_has_petals_whose_blur_grows_towards_the_tip) {
  const Document document = example("flower.svg");
  const Layer* petal = layer_of(document, "petal-top");
  ASSERT_NE(petal, nullptr);
  const ScalarStops& blur = petal->curves.front().right.blur_radius;
  EXPECT_GT(largest(blur), 4 * smallest(blur));
  EXPECT_GT(smallest(blur), 0);
}

TEST(Examples, the_portrait_has_more_than_100_curves) {
  EXPECT_GT(curve_count(example("portrait.svg")), 100u);
}

TEST(Examples, one_soft_fish_is_drawn_50_times_with_falling_opacity) {
  const Document document = example("fish.svg");
  const Layer* fish = layer_of(document, "fish-body");
  ASSERT_NE(fish, nullptr);
  const Side& inside = fish->curves.front().right;
  EXPECT_EQ(inside.opacity.kind, ShaderKind::curve_domain);
  EXPECT_GT(largest(inside.blur_radius), 0);

  std::size_t count = 0, mirrored = 0;
  double least = 1e9, most = 0;
  for (const LayerInstance& instance : items<LayerInstance>(document)) {
    if (&document.layers[instance.layer] != fish) continue;
    const double determinant = instance.artboard_from_layer.determinant();
    ++count;
    mirrored += determinant < 0;
    least = std::min(least, std::abs(determinant));
    most = std::max(most, std::abs(determinant));
  }
  EXPECT_EQ(count, 50u);
  EXPECT_GT(mirrored, 5u);
  EXPECT_LT(mirrored, count - 5);
  EXPECT_GT(most, 100 * least);
  std::set<float> opacities;
  for (const GroupBegin& group : items<GroupBegin>(document)) opacities.insert(group.opacity);
  EXPECT_GE(opacities.size(), 20u);
  EXPECT_LT(*opacities.begin(), .25f);
}

TEST(Examples, the_board_of_blur_has_every_kind_of_transition) {
  const Document document = example("blur.svg");
  for (const std::string row : {"colours", "plane"}) {
    const auto side = [&](const std::string& column, bool left) {
      const Layer* layer = layer_of(document, row + "-" + column);
      if (!layer) ADD_FAILURE() << "no layer " << row << "-" << column;
      if (!layer) return Side{};
      return left ? layer->curves.back().left : layer->curves.back().right;
    };
    EXPECT_EQ(largest(side("sharp", true).blur_radius), 0);
    EXPECT_EQ(smallest(side("along", true).blur_radius), 0);
    EXPECT_GT(largest(side("along", true).blur_radius), 0);
    EXPECT_EQ(side("along", true).blur_radius, side("along", false).blur_radius);
    EXPECT_NE(side("sides", true).blur_radius, side("sides", false).blur_radius);
    EXPECT_GT(smallest(side("sides", true).blur_radius), 0);
    const ShaderKind kind = row == "plane" ? ShaderKind::image_domain : ShaderKind::curve_domain;
    for (const char* column : {"sharp", "along", "sides"}) {
      EXPECT_EQ(side(column, true).color.kind, kind);
      EXPECT_EQ(side(column, false).color.kind, kind);
    }
  }
  EXPECT_EQ(paint_count<Texture>(document), 1u);
  EXPECT_EQ(paint_count<GradientFill>(document), 1u);
}

TEST(Examples, two_curves_bear_colours_on_one_side_and_a_texture_on_the_other) {
  const Document document = example("textures.svg");
  EXPECT_EQ(paint_count<Texture>(document), 2u);
  ASSERT_EQ(curve_count(document), 2u);
  const Curve &above = document.layers[0].curves[0], &below = document.layers[0].curves[1];
  EXPECT_EQ(above.left.color.kind, ShaderKind::curve_domain);
  EXPECT_EQ(above.right.color.kind, ShaderKind::image_domain);
  EXPECT_EQ(below.left.color.kind, ShaderKind::image_domain);
  EXPECT_EQ(below.right.color.kind, ShaderKind::curve_domain);
  EXPECT_NE(above.right.color.shader, below.left.color.shader);
}

TEST(Examples, the_feather_is_made_of_local_curves_and_stands_there_twice) {
  const Document document = example("strokes.svg");
  const std::vector<LocalStroke> strokes = items<LocalStroke>(document);
  EXPECT_GT(strokes.size(), 600u);
  EXPECT_EQ(strokes.size() % 2, 0u);
  std::set<double> alphas;
  std::set<float> radii;
  for (const LocalStroke& stroke : strokes) {
    alphas.insert(stroke.curve.alpha);
    radii.insert(largest(stroke.curve.influence_radius));
  }
  EXPECT_GT(alphas.size(), 10u);
  EXPECT_GT(radii.size(), 10u);
  // The half on paper has nothing below: the only layer lies in the other half.
  EXPECT_EQ(items<LayerInstance>(document).size(), 1u);
}

TEST(Examples, the_dusk_shows_one_fir_four_times_and_has_clouds_softer_above_than_below) {
  const Document document = example("dusk.svg");
  EXPECT_EQ(items<LocalStroke>(document).size(), 4u);
  std::vector<std::size_t> times(document.layers.size());
  for (const LayerInstance& instance : items<LayerInstance>(document)) ++times[instance.layer];
  ASSERT_FALSE(times.empty());
  EXPECT_EQ(*std::max_element(times.begin(), times.end()), 4u);
  const std::vector<Curve>& sky = document.layers[0].curves;
  const auto is_cloud = [](const Curve& curve) {
    return largest(curve.left.blur_radius) > 3 * largest(curve.right.blur_radius) &&
           largest(curve.right.blur_radius) > 0;
  };
  EXPECT_EQ(std::count_if(sky.begin(), sky.end(), is_cloud), 2);
}

TEST(Examples, the_red_apple_is_shaded_by_colour_stops_over_two_multiplied_shadows) {
  const Document document = example("red_apple.svg");
  EXPECT_TRUE(document.shaders.empty());
  EXPECT_TRUE(items<LocalStroke>(document).empty());
  const std::vector<LayerInstance> layers = items<LayerInstance>(document);
  EXPECT_EQ(
      std::count_if(layers.begin(), layers.end(),
                    [](const LayerInstance& layer) { return layer.blend == BlendMode::multiply; }),
      2);
}

TEST(Examples, the_logo_is_a_crescent_with_a_gradient_and_an_edge_like_smoke_on_nothing) {
  const Document document = example("logo.svg");
  EXPECT_FALSE(document.background.has_value());
  EXPECT_EQ(paint_count<GradientFill>(document), 1u);
  ASSERT_EQ(document.layers.size(), 3u);
  const Side& crescent = document.layers[0].curves.at(0).right;
  EXPECT_EQ(crescent.color.kind, ShaderKind::image_domain);
  EXPECT_EQ(smallest(crescent.blur_radius), 0);
  EXPECT_GT(largest(crescent.blur_radius), 40);
}

class TracedExample : public testing::TestWithParam<const char*> {};

TEST_P(TracedExample, has_one_layer_of_at_most_2000_control_points_with_blur_of_its_own_each) {
  const Document document = example(std::string(GetParam()) + ".svg");
  ASSERT_EQ(document.layers.size(), 1u);
  EXPECT_GT(curve_count(document), 200u);
  std::size_t points = 0;
  std::set<float> radii;
  for (const Curve& curve : document.layers[0].curves) {
    points += curve.control_points.size();
    radii.insert(largest(curve.left.blur_radius));
  }
  EXPECT_LE(points, 2000u);
  EXPECT_GT(radii.size(), 50u);
}

TEST_P(TracedExample, looks_like_its_photo) {
  const std::string file = std::string("photos/") + GetParam() + ".jpg";
  const auto bytes = test::file_bytes(test::kExamplesFolder + file);
  ASSERT_TRUE(bytes.has_value());
  Context context;
  const Result<Image> photo = codecs::read_photo(
      context, {reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()}, file,
      nullptr);
  ASSERT_TRUE(photo.ok()) << to_string(photo.status());
  const Document document = example(std::string(GetParam()) + ".svg");
  const Result<Image> image =
      test::draw(context, document, photo->width, photo->height, PixelFormat::rgb8);
  ASSERT_TRUE(image.ok()) << to_string(image.status());
  EXPECT_GE(test::psnr_db(test::planes_of(*image), test::planes_of(*photo)), 29.5);
}

INSTANTIATE_TEST_SUITE_P(Examples, TracedExample, testing::Values("still_life", "lake"),
                         [](const auto& instance) { return std::string(instance.param); });

}  // namespace
}  // namespace sfumato
