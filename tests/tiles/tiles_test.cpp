#include <gtest/gtest.h>
#include <tiffio.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "sfumato/base/native/file.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/random_document.hpp"
#include "support/temporary_folder.hpp"
#include "tiles/big_tiff.hpp"
#include "tiles/deep_zoom.hpp"

/// Each level of a pyramid is, pixel for pixel, the picture drawn at that size.
namespace sfumato::tiles {
namespace {

using test::TemporaryFolder;

Picture solved(std::uint64_t seed) {
  Context context;
  Result<Picture> picture =
      diffuse(context, test::random_document(seed), {.pixels_per_unit = 4, .max_error = 4});
  EXPECT_TRUE(picture.ok()) << to_string(picture.status());
  return picture.ok() ? std::move(*picture) : Picture{};
}

DeepZoomOptions options_in(const TemporaryFolder& folder, int width, int height) {
  DeepZoomOptions options;
  options.pyramid = {width, height, 64, 0};
  options.raster = {.width = width, .height = height};
  options.path = folder.file("a.dzi");
  options.fingerprint = "a test";
  return options;
}

constexpr auto as_png = [](Context& context, Image& tile) { return encode_png(context, tile); };

Status write(const Picture& picture, const DeepZoomOptions& options,
             DeepZoomStats* stats = nullptr) {
  ThreadPool pool(3);
  Context context;
  context.executor = &pool;
  const Status status = write_deep_zoom(context, picture, options, as_png, stats);
  EXPECT_EQ(context.budget.used(), 0u);
  return status;
}

/// Returns the files of a folder with their content.
std::map<std::string, std::string> content_of(const std::string& folder) {
  std::map<std::string, std::string> content;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream file(entry.path(), std::ios::binary);
    content[std::filesystem::relative(entry.path(), folder).string()] =
        std::string(std::istreambuf_iterator<char>(file), {});
  }
  return content;
}

Image drawn(const Picture& picture, RasterOptions options, int width, int height) {
  Context context;
  options.width = width;
  options.height = height;
  Result<Image> image = rasterize(context, picture, options);
  EXPECT_TRUE(image.ok()) << to_string(image.status());
  return image.ok() ? std::move(*image) : Image{};
}

/// Returns whether the pixels of `part` are at (x, y) in `whole`.
bool stands_in(const Image& part, const Image& whole, int x, int y) {
  const std::size_t pixel = whole.row_bytes() / static_cast<std::size_t>(whole.width);
  for (int row = 0; row < part.height; ++row) {
    const std::uint8_t* from = whole.bytes.data() +
                               static_cast<std::size_t>(y + row) * whole.row_bytes() +
                               static_cast<std::size_t>(x) * pixel;
    const std::uint8_t* there =
        part.bytes.data() + static_cast<std::size_t>(row) * part.row_bytes();
    if (std::memcmp(from, there, part.row_bytes()) != 0) return false;
  }
  return true;
}

void expect_levels(const Picture& picture, const DeepZoomOptions& options) {
  const Pyramid& pyramid = options.pyramid;
  const std::string files = options.path.substr(0, options.path.size() - 4) + "_files/";
  for (int level = 0; level < pyramid.level_count(); ++level) {
    const Image whole =
        drawn(picture, options.raster, pyramid.level_width(level), pyramid.level_height(level));
    for (int row = 0; row < pyramid.rows(level); ++row) {
      for (int column = 0; column < pyramid.columns(level); ++column) {
        const std::string path = files + std::to_string(level) + "/" + std::to_string(column) +
                                 "_" + std::to_string(row) + ".png";
        const auto bytes = read_bytes(path, std::size_t{1} << 24);
        ASSERT_TRUE(bytes.ok()) << path;
        Context context;
        const bool has_alpha = channel_count(options.raster.format) == 4;
        const auto tile = has_alpha ? decode_png_with_alpha(context, *bytes, path)
                                    : decode_png(context, *bytes, path);
        ASSERT_TRUE(tile.ok()) << path;
        const PixelRect rect = pyramid.tile(level, column, row);
        ASSERT_EQ(tile->width, rect.x1 - rect.x0) << path;
        ASSERT_EQ(tile->height, rect.y1 - rect.y0) << path;
        EXPECT_TRUE(stands_in(*tile, whole, rect.x0, rect.y0)) << path;
      }
    }
  }
}

TEST(DeepZoom, every_level_is_the_picture_at_its_size) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const TemporaryFolder folder;
    DeepZoomOptions options = options_in(folder, 500 + 37 * static_cast<int>(seed), 301);
    options.pyramid.overlap = static_cast<int>(seed % 3);
    options.raster.dither = seed % 2 == 0;
    if (seed % 2 == 1) options.raster.format = PixelFormat::rgba8;
    const Picture picture = solved(seed);
    ASSERT_TRUE(write(picture, options).ok());
    expect_levels(picture, options);
  }
}

TEST(DeepZoom, blocks_meet_without_a_seam) {
  const TemporaryFolder folder;
  DeepZoomOptions options = options_in(folder, 4500, 2100);
  options.pyramid.tile_side = 512;
  options.pyramid.overlap = 1;
  const Picture picture = solved(7);
  ASSERT_TRUE(write(picture, options).ok());
  expect_levels(picture, options);
}

TEST(DeepZoom, shards_make_what_one_call_makes) {
  const Picture picture = solved(3);
  const TemporaryFolder whole, parts;
  DeepZoomOptions options = options_in(whole, 5000, 2300);
  options.pyramid.tile_side = 256;
  DeepZoomStats all;
  ASSERT_TRUE(write(picture, options, &all).ok());
  options.path = parts.file("a.dzi");
  DeepZoomStats sum;
  for (const int index : {2, 0, 1}) {
    options.shard = {index, 3};
    DeepZoomStats part;
    ASSERT_TRUE(write(picture, options, &part).ok());
    EXPECT_GT(part.tiles, 0u);
    sum.tiles += part.tiles;
    sum.blocks += part.blocks;
    sum.bytes += part.bytes;
  }
  EXPECT_EQ(sum.tiles, all.tiles);
  EXPECT_EQ(sum.blocks, all.blocks);
  EXPECT_EQ(sum.bytes, all.bytes);
  EXPECT_TRUE(content_of(whole.path()) == content_of(parts.path()));
}

TEST(DeepZoom, more_shards_than_blocks_is_no_error) {
  const TemporaryFolder folder;
  DeepZoomOptions options = options_in(folder, 100, 50);
  options.shard = {900, 1000};
  DeepZoomStats stats;
  ASSERT_TRUE(write(solved(1), options, &stats).ok());
  EXPECT_EQ(stats.blocks, 0u);
  EXPECT_EQ(stats.tiles, 0u);
}

TEST(DeepZoom, a_second_call_writes_what_is_missing) {
  const Picture picture = solved(4);
  const TemporaryFolder folder;
  DeepZoomOptions options = options_in(folder, 5000, 2300);
  options.pyramid.tile_side = 256;
  ASSERT_TRUE(write(picture, options).ok());
  const auto content = content_of(folder.path());
  DeepZoomStats stats;
  ASSERT_TRUE(write(picture, options, &stats).ok());
  EXPECT_EQ(stats.tiles, 0u);
  EXPECT_EQ(stats.skipped_blocks, stats.blocks);
  // A call that was interrupted leaves a block without its last tile, and files without final
  // names.
  std::filesystem::remove(folder.file("a_files/13/7_7.png"));
  std::filesystem::remove(folder.file("a_files/13/3_2.png"));
  ASSERT_TRUE(write(picture, options, &stats).ok());
  EXPECT_EQ(stats.tiles, 64u);
  EXPECT_TRUE(content_of(folder.path()) == content);
}

TEST(DeepZoom, tiles_of_two_pictures_are_not_mixed) {
  const TemporaryFolder folder;
  DeepZoomOptions options = options_in(folder, 300, 200);
  const Picture picture = solved(5);
  ASSERT_TRUE(write(picture, options).ok());
  const auto content = content_of(folder.path());
  for (int change = 0; change < 4; ++change) {
    DeepZoomOptions other = options;
    if (change == 0) other.fingerprint = "another";
    if (change == 1) other.pyramid.width = other.raster.width = 301;
    if (change == 2) other.pyramid.overlap = 1;
    if (change == 3) other.pyramid.tile_side = 32;
    const Status status = write(picture, other);
    EXPECT_EQ(status.code, StatusCode::io) << change;
    EXPECT_NE(status.message.find("another picture, size or format"), std::string::npos);
  }
  EXPECT_TRUE(content_of(folder.path()) == content);
}

TEST(DeepZoom, failures_leave_no_half_files_and_no_charge) {
  const Picture picture = solved(6);
  const TemporaryFolder folder;
  const DeepZoomOptions options = options_in(folder, 700, 500);
  {
    Context context{.budget = Budget(std::size_t{100} << 10)};
    EXPECT_EQ(write_deep_zoom(context, picture, options, as_png, nullptr).code, StatusCode::limit);
    EXPECT_EQ(context.budget.used(), 0u);
  }
  int tiles = 0;
  const auto fails_late = [&](Context& context, Image& tile) -> Result<std::vector<std::uint8_t>> {
    if (++tiles == 30) return make_error(StatusCode::out_of_memory, "no more");
    return encode_png(context, tile);
  };
  Context context;
  EXPECT_EQ(write_deep_zoom(context, picture, options, fails_late, nullptr).code,
            StatusCode::out_of_memory);
  for (const auto& [name, bytes] : content_of(folder.path())) {
    EXPECT_EQ(name.find(".tmp"), std::string::npos) << name;
    EXPECT_GT(bytes.size(), 60u) << name;
  }
  ASSERT_TRUE(write(picture, options).ok());
  expect_levels(picture, options);
}

TEST(DeepZoom, cancelled_work_ends) {
  const TemporaryFolder folder;
  Context context;
  context.cancel = true;
  EXPECT_EQ(write_deep_zoom(context, solved(1), options_in(folder, 99, 99), as_png, nullptr).code,
            StatusCode::cancelled);
}

TEST(DeepZoom, a_folder_that_is_a_file_is_an_error) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("a_files")) << "x";
  EXPECT_EQ(write(solved(1), options_in(folder, 99, 99)).code, StatusCode::io);
}

/// Returns the image of the current directory.
Image tiff_level(TIFF* file) {
  std::uint32_t width = 0, height = 0, side = 0;
  std::uint16_t channels = 0;
  TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(file, TIFFTAG_IMAGELENGTH, &height);
  TIFFGetField(file, TIFFTAG_TILEWIDTH, &side);
  TIFFGetField(file, TIFFTAG_SAMPLESPERPIXEL, &channels);
  Image image{static_cast<int>(width),
              static_cast<int>(height),
              channels == 3 ? PixelFormat::rgb8 : PixelFormat::rgba8,
              {}};
  image.bytes.resize(image.row_bytes() * height);
  std::vector<std::uint8_t> tile(static_cast<std::size_t>(TIFFTileSize(file)));
  for (std::uint32_t y = 0; y < height; y += side) {
    for (std::uint32_t x = 0; x < width; x += side) {
      EXPECT_GT(TIFFReadTile(file, tile.data(), x, y, 0, 0), 0);
      const std::uint32_t shown = std::min(side, width - x);
      for (std::uint32_t row = 0; row < std::min(side, height - y); ++row) {
        std::memcpy(image.bytes.data() + (y + row) * image.row_bytes() + std::size_t{x} * channels,
                    tile.data() + std::size_t{row} * side * channels,
                    std::size_t{shown} * channels);
      }
    }
  }
  return image;
}

TEST(BigTiff, every_level_is_the_picture_at_its_size) {
  for (std::uint64_t seed = 10; seed < 13; ++seed) {
    const TemporaryFolder folder;
    BigTiffOptions options;
    options.pyramid = {700 + static_cast<int>(seed), 433, 64, 0};
    options.raster = {.width = options.pyramid.width, .height = 433};
    if (seed % 2 == 0) options.raster.format = PixelFormat::rgba8;
    options.path = folder.file("a.tif");
    const Picture picture = solved(seed);
    Context context;
    BigTiffStats stats;
    ASSERT_TRUE(write_big_tiff(context, picture, options, &stats).ok());
    EXPECT_EQ(context.budget.used(), 0u);
    EXPECT_EQ(folder.entry_count(), 1u);
    TIFF* file = TIFFOpen(options.path.c_str(), "r");
    ASSERT_TRUE(file);
    EXPECT_TRUE(TIFFIsBigTIFF(file));
    EXPECT_EQ(TIFFNumberOfDirectories(file), 5u);
    EXPECT_EQ(stats.levels, 5);
    for (int level = options.pyramid.level_count() - 1, page = 0; page < 5; --level, ++page) {
      ASSERT_TRUE(TIFFSetDirectory(file, static_cast<tdir_t>(page)));
      std::uint32_t kind = 0;
      TIFFGetField(file, TIFFTAG_SUBFILETYPE, &kind);
      EXPECT_EQ(kind, page == 0 ? 0u : 1u);
      const Image image = tiff_level(file);
      const Image whole = drawn(picture, options.raster, options.pyramid.level_width(level),
                                options.pyramid.level_height(level));
      EXPECT_EQ(image.width, whole.width);
      EXPECT_TRUE(image.bytes == whole.bytes) << page;
    }
    TIFFClose(file);
  }
}

TEST(BigTiff, failures_leave_nothing_behind) {
  const TemporaryFolder folder;
  BigTiffOptions options;
  options.pyramid = {300, 200, 64, 0};
  options.raster = {.width = 300, .height = 200};
  options.path = folder.file("a.tif");
  const Picture picture = solved(1);
  {
    Context context;
    context.cancel = true;
    EXPECT_EQ(write_big_tiff(context, picture, options, nullptr).code, StatusCode::cancelled);
  }
  {
    Context context{.budget = Budget(1000)};
    EXPECT_EQ(write_big_tiff(context, picture, options, nullptr).code, StatusCode::limit);
  }
  EXPECT_EQ(folder.entry_count(), 0u);
  options.path = folder.file("none/a.tif");
  Context context;
  EXPECT_EQ(write_big_tiff(context, picture, options, nullptr).code, StatusCode::io);
}

}  // namespace
}  // namespace sfumato::tiles
