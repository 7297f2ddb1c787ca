#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/agreement.hpp"
#include "sfumato/api/render_pixels.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/formats/svg/svg.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/random_document.hpp"
#include "support/sanitizers.hpp"
#include "support/soak.hpp"

// Documents with all features of the format, from the document to pixels and to SVG and back.
namespace sfumato::test {
namespace {

const auto kSeeds = random_case_count<std::uint64_t>(SFUMATO_HAS_SANITIZER ? 6 : 24, 60);
/// For tests that solve a document several times.
const auto kFewSeeds = random_case_count<std::uint64_t>(SFUMATO_HAS_SANITIZER ? 4 : 8, 20);

RasterOptions one_pixel_a_unit(const Document& document, PixelFormat format) {
  RasterOptions options;
  options.width = static_cast<int>(std::lround(document.artboard.width()));
  options.height = static_cast<int>(std::lround(document.artboard.height()));
  options.format = format;
  return options;
}

/// Expects that no channel of a field leaves the range of mixtures of its curves' values.
void expect_mixtures(const PatchField& field, bool is_oklab) {
  constexpr float kRounding = 1e-5f;
  for (std::size_t i = 0; i < field.node_value.size(); ++i) {
    const auto channel = static_cast<int>(i % static_cast<std::size_t>(field.channel_count));
    const bool is_chroma = is_oklab && (channel == 1 || channel == 2);
    const float least = is_chroma ? -0.5f : 0, most = is_chroma ? 0.5f : 1;
    ASSERT_TRUE(field.node_value[i] >= least - kRounding && field.node_value[i] <= most + kRounding)
        << field.node_value[i] << " in channel " << channel;
  }
}

Picture solved(Context& context, const Document& document) {
  Result<Picture> picture = diffuse(context, document, {});
  EXPECT_TRUE(picture.ok()) << picture.status().message;
  if (!picture) return {};
  for (const PatchLayer& layer : picture->layers) {
    expect_mixtures(layer.color, picture->interpolation == InterpolationSpace::oklab);
    expect_mixtures(layer.opacity, false);
  }
  return std::move(*picture);
}

Image drawn(Context& context, const Document& document, PixelFormat format) {
  const Picture picture = solved(context, document);
  Result<Image> image = rasterize(context, picture, one_pixel_a_unit(document, format));
  EXPECT_TRUE(image.ok()) << image.status().message;
  return image ? std::move(*image) : Image{};
}

TEST(RandomDocuments, give_the_same_bytes_for_any_number_of_threads_and_instruction_set) {
  ThreadPool three_threads(3);
  for (std::uint64_t seed = 1; seed <= kFewSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const Document document = random_document(seed);
    Context best;
    const Image expected = drawn(best, document, PixelFormat::rgba16);
    for (SimdLevel level : {SimdLevel::sse2, SimdLevel::avx2, SimdLevel::avx512}) {
      if (level > detected_simd_level()) continue;
      Context context;
      context.simd = level;
      if (level == SimdLevel::sse2) context.executor = &three_threads;
      EXPECT_EQ(drawn(context, document, PixelFormat::rgba16).bytes, expected.bytes)
          << "level " << static_cast<int>(level);
    }
  }
}

/// Returns the document without very heavy curves, whose shadows have borders as sharp as curves.
Document with_moderate_weights(Document document) {
  for (Layer& layer : document.layers) {
    for (Curve& curve : layer.curves) curve.weight = std::clamp(curve.weight, 0.1, 10.0);
  }
  return document;
}

TEST(RandomDocuments, are_drawn_from_patches_as_from_the_gather_at_every_pixel) {
  int compared = 0, differing = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const Document document = with_moderate_weights(random_document(seed));
    Context context;
    const Image sparse = drawn(context, document, PixelFormat::rgb8);
    RasterOptions options = one_pixel_a_unit(document, PixelFormat::rgb8);
    options.antialias = false;
    const Result<Image> exact = render_pixels(context, document, {}, options);
    ASSERT_TRUE(exact.ok()) << exact.status().message;
    const Agreement agreement = compare_pictures(document, sparse, *exact);
    EXPECT_LE(agreement.percentile_99, 1);
    // Shadows of curves have sharp borders too, and some blend modes increase differences.
    EXPECT_LE(agreement.differing, 60)
        << agreement.worst << " at " << agreement.worst_x << ", " << agreement.worst_y;
    compared += agreement.compared;
    differing += agreement.differing;
  }
  EXPECT_LE(differing, compared / 2000);
  RecordProperty("compared", compared);
  RecordProperty("differing", differing);
}

std::string written(Context& context, const Document& document) {
  Result<std::string> text = write_svg(context, document);
  EXPECT_TRUE(text.ok()) << text.status().message;
  return text ? std::move(*text) : std::string();
}

Document read_back(Context& context, const std::string& text) {
  Result<ReadDocument> read = read_svg(context, text, "random.svg");
  EXPECT_TRUE(read.ok()) << to_string(read.status());
  return read ? std::move(read->document) : Document{};
}

TEST(RandomDocuments, come_back_from_svg_as_the_same_picture_and_the_same_text) {
  for (std::uint64_t seed = 1; seed <= kFewSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const Document document = random_document(seed);
    Context context;
    const Document read = read_back(context, written(context, document));
    const std::string text = written(context, read);
    EXPECT_EQ(written(context, read_back(context, text)), text);
    EXPECT_EQ(drawn(context, read, PixelFormat::rgba16).bytes,
              drawn(context, document, PixelFormat::rgba16).bytes);
  }
}

}  // namespace
}  // namespace sfumato::test
