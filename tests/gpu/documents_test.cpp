// Whole documents drawn by GPU and CPU: the examples, a public scene, and random ones with all
// features of the format.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support.hpp"
#include "support/folder_files.hpp"
#include "support/places.hpp"
#include "support/random_document.hpp"
#include "support/scenes.hpp"
#include "support/soak.hpp"

namespace sfumato::test {
namespace {

/// Their shaders take longest to compile, and other examples have all of their features.
const std::set<std::string> kLong{"apple.svg", "blur.svg", "fish.svg"};

void expect_drawn_near(const Document& document, double pixels_per_unit, PixelFormat format) {
  Context context;
  ThreadPool executor;
  context.executor = &executor;
  DiffuseOptions options;
  options.pixels_per_unit = pixels_per_unit;
  const Result<Picture> picture = diffuse(context, document, options);
  ASSERT_TRUE(picture.ok()) << to_string(picture.status());
  const auto pixels = [&](double units) {
    return static_cast<int>(std::lround(pixels_per_unit * units));
  };
  expect_near(*picture, image_size(pixels(document.artboard.width()),
                                   pixels(document.artboard.height()), format));
}

TEST(GpuDocuments, every_example_agrees) {
  SFUMATO_NEEDS_GPU();
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kExamplesFolder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".svg" && extension != ".xml") continue;
    const std::string name = entry.path().filename().string();
    if (!is_soak() && kLong.contains(name)) continue;
    SCOPED_TRACE(name);
    Context context;
    const FolderFiles files(kExamplesFolder);
    const auto bytes = file_bytes(entry.path().string());
    ASSERT_TRUE(bytes);
    const Result<ReadDocument> read = read_document(context, *bytes, "example", &files);
    ASSERT_TRUE(read.ok()) << to_string(read.status());
    expect_drawn_near(read->document, 200 / read->document.artboard.width(), PixelFormat::rgb8);
    ++count;
  }
  EXPECT_GE(count, 8);
}

TEST(GpuDocuments, lady_bug_agrees) {
  SFUMATO_NEEDS_GPU();
  const std::optional<Document> document = shared_scene("lady_bug.xml");
  if (!document) GTEST_SKIP() << "no public scene lady_bug.xml";
  expect_drawn_near(*document, 1, PixelFormat::rgb8);
}

TEST(GpuDocuments, random_documents_agree) {
  SFUMATO_NEEDS_GPU();
  for (const std::uint64_t seed : random_seeds(0, 9, {3, 6, 7, 9})) {
    SCOPED_TRACE(seed);
    expect_drawn_near(random_document(seed), 1, seed % 2 ? PixelFormat::rgba8 : PixelFormat::rgb8);
  }
}

TEST(GpuDocuments, random_documents_agree_when_enlarged) {
  SFUMATO_NEEDS_GPU();
  for (const std::uint64_t seed : random_seeds(7, 23, {11, 15, 23}))
    expect_drawn_near(random_document(seed), 2.5, PixelFormat::rgb8);
}

}  // namespace
}  // namespace sfumato::test
