#include "support/windows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/examples.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/places.hpp"
#include "support/random_document.hpp"
#include "support/sanitizers.hpp"
#include "support/scenes.hpp"
#include "support/soak.hpp"

// Windows of an image have the same bytes as the whole image.
namespace sfumato::test {
namespace {

/// The usual tiles; tiles of unusual sides; a few large tiles, for which triangles are found in
/// another way.
constexpr Cut kCuts[] = {{256, 256}, {173, 119, -40, -31}, {600, 90, 0, -17}};

RasterOptions whole_image(const Document& document, int width) {
  RasterOptions options;
  options.width = width;
  const double aspect = document.artboard.height() / document.artboard.width();
  options.height = static_cast<int>(std::lround(width * aspect));
  return options;
}

Picture solved(Context& context, const Document& document, const DiffuseOptions& options) {
  Result<Picture> picture = diffuse(context, document, options);
  EXPECT_TRUE(picture.ok()) << picture.status().message;
  return picture ? std::move(*picture) : Picture{};
}

Image painted(Context& context, const Picture& picture, const RasterOptions& options) {
  Result<Image> image = rasterize(context, picture, options);
  EXPECT_TRUE(image.ok()) << image.status().message;
  return image ? std::move(*image) : Image{};
}

class WindowsOf : public testing::TestWithParam<std::string> {};

TEST_P(WindowsOf, have_the_bytes_of_the_whole_image) {
  Context context;
  const FolderFiles files = example_textures();
  const auto bytes = file_bytes(kExamplesFolder + GetParam());
  ASSERT_TRUE(bytes);
  const Result<ReadDocument> read = read_document(context, *bytes, GetParam(), &files);
  ASSERT_TRUE(read.ok()) << read.status().message;
  constexpr int kDrawnWidth = SFUMATO_HAS_SANITIZER ? 300 : 720;
  DiffuseOptions diffuse;
  diffuse.pixels_per_unit = kDrawnWidth / read->document.artboard.width();
  const Picture picture = solved(context, read->document, diffuse);
  RasterOptions options = whole_image(read->document, kDrawnWidth);
  options.dither = true;
  const Image whole = painted(context, picture, options);
  for (const Cut& cut : kCuts) {
    const std::string where = std::to_string(cut.width) + " pixels wide";
    expect_same_pixels(painted_prepared(context, picture, options, cut), whole, where);
  }
  expect_same_pixels(painted_in_windows(context, picture, options, kCuts[1]), whole, "by itself");
  options.mesh_overlay = true;
  expect_same_pixels(painted_prepared(context, picture, options, kCuts[1]),
                     painted(context, picture, options), "with its mesh");
}

std::vector<std::string> example_stems() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kExamplesFolder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".svg" || extension == ".xml") names.push_back(entry.path().stem());
  }
  return names;
}

std::vector<std::string> example_files() {
  std::vector<std::string> files;
  for (const std::string& name : example_stems()) {
    const bool is_svg = std::filesystem::exists(kExamplesFolder + name + ".svg");
    files.push_back(name + (is_svg ? ".svg" : ".xml"));
  }
  std::sort(files.begin(), files.end());
  return files;
}

INSTANTIATE_TEST_SUITE_P(Examples, WindowsOf, testing::ValuesIn(example_files()),
                         [](const auto& file) {
                           return file.param.substr(0, file.param.find('.'));
                         });

/// In 24 consecutive seeds, each option is on and off several times, and each format occurs with
/// each instruction set.
std::uint64_t last_seed() {
  return random_case_count<std::uint64_t>(SFUMATO_HAS_SANITIZER ? 12 : 24, 300);
}

/// Returns options for everything that pixels depend on, chosen by a seed.
RasterOptions random_options(const Document& document, std::uint64_t seed) {
  RasterOptions options = whole_image(document, 260 + static_cast<int>(seed * 37 % 140));
  options.format = static_cast<PixelFormat>(seed % 4);
  options.dither = seed % 3 != 0;
  options.antialias = seed % 5 != 0;
  options.mesh_overlay = seed % 7 == 0;
  if (seed % 6 == 0) options.background = Rgb{0.2f, 0.4f, 0.9f};
  if (seed % 8 == 0) {
    // A place where the document ends within the image.
    const Vec2 middle = document.artboard.center();
    options.viewport = Box{middle, document.artboard.max + Vec2{20, 35}};
  }
  return options;
}

TEST(RandomWindows, have_the_bytes_of_the_whole_image) {
  ThreadPool three_threads(3);
  for (std::uint64_t seed = 1; seed <= last_seed(); ++seed) {
    const std::string where = "seed " + std::to_string(seed);
    const Document document = random_document(seed);
    const RasterOptions options = random_options(document, seed);
    Context context;
    // With the plain mesh, because the painted picture need not be fine.
    DiffuseOptions plain;
    plain.max_error = 0;
    const Picture picture = solved(context, document, plain);
    const Image whole = painted(context, picture, options);
    context.simd = std::min(static_cast<SimdLevel>(seed % 3), detected_simd_level());
    if (seed % 4 < 2) context.executor = &three_threads;
    const Cut cut{90 + static_cast<int>(seed % 91), 70 + static_cast<int>(seed % 90), -7, -9};
    const auto paint = seed % 2 == 0 ? &painted_in_windows : &painted_prepared;
    expect_same_pixels(paint(context, picture, options, cut), whole, where);
  }
}

}  // namespace
}  // namespace sfumato::test
