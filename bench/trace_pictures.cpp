#include "trace_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string_view>

#include "codecs/image_file.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/import/import_svg.hpp"
#include "support/draw.hpp"
#include "support/folder_files.hpp"
#include "support/places.hpp"

namespace sfumato::bench {
namespace {

constexpr int kDrawingPixels = 512;

bool has_extension(const std::string& path, std::span<const std::string_view> extensions) {
  const std::string own = std::filesystem::path(path).extension();
  return std::ranges::find(extensions, own) != extensions.end();
}

/// Returns the image without alpha if all its pixels are opaque.
Image without_needless_alpha(Image image) {
  Image opaque{image.width, image.height, PixelFormat::rgb8, {}};
  for (std::size_t i = 0; i < image.bytes.size(); i += 4) {
    if (image.bytes[i + 3] != 255) return image;
    opaque.bytes.insert(opaque.bytes.end(), image.bytes.begin() + static_cast<std::ptrdiff_t>(i),
                        image.bytes.begin() + static_cast<std::ptrdiff_t>(i + 3));
  }
  return opaque;
}

Result<Image> read_photo(Context& context, const std::string& path) {
  Result<std::vector<std::uint8_t>> bytes = read_bytes(path, limits::kImageFileBytes);
  if (!bytes) return bytes.status();
  if (path.ends_with(".png")) return decode_png(context, *bytes, path);
  Result<codecs::RgbaImage> decoded = codecs::decode_image(context, *bytes);
  if (!decoded) return decoded.status();
  return without_needless_alpha(
      {decoded->width, decoded->height, PixelFormat::rgba8, std::move(decoded->rgba)});
}

struct Drawing {
  Document document;
  double pixels_per_unit = 1;
};

Result<Drawing> read_drawing(Context& context, const std::string& path) {
  const Result<std::string> text = read_file(path, limits::kInputBytes);
  if (!text) return text.status();
  const test::FolderFiles files(std::filesystem::path(path).parent_path());
  Result<ReadDocument> read = read_document(context, *text, path, &files);
  if (!read) return read.status();
  if (!read->is_foreign) {
    const Box& artboard = read->document.artboard;
    const double scale = kDrawingPixels / std::max(artboard.width(), artboard.height());
    return Drawing{std::move(read->document), scale};
  }
  Result<ImportedSvg> imported = import_svg(context, *text, path, &files);
  if (!imported) return imported.status();
  return Drawing{std::move(imported->document)};
}

void append_files(const std::string& folder, std::span<const std::string_view> extensions,
                  std::vector<std::string>& paths) {
  const std::size_t before = paths.size();
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    if (has_extension(entry.path(), extensions)) paths.push_back(entry.path());
  }
  std::sort(paths.begin() + static_cast<std::ptrdiff_t>(before), paths.end());
  if (paths.size() == before) {
    std::fprintf(stderr, "trace: %s has no such pictures here\n", folder.c_str());
  }
}

constexpr std::string_view kPhotoTypes[] = {".png", ".jpg", ".jpeg"};
constexpr std::string_view kDrawingTypes[] = {".svg", ".xml"};

}  // namespace

Result<TracePicture> read_trace_picture(Context& context, const std::string& path) {
  const std::filesystem::path place = std::filesystem::absolute(path);
  TracePicture picture{
      place.parent_path().filename().string() + '/' + place.filename().string(), {}, {}};
  if (!has_extension(path, kDrawingTypes)) {
    Result<Image> image = read_photo(context, path);
    if (!image) return image.status();
    picture.image = std::move(*image);
    return picture;
  }
  Result<Drawing> drawing = read_drawing(context, path);
  if (!drawing) return drawing.status();
  const auto pixels = [&](double side) {
    return std::max(1, static_cast<int>(std::lround(drawing->pixels_per_unit * side)));
  };
  const Box& artboard = drawing->document.artboard;
  Result<Image> image = test::draw(context, drawing->document, pixels(artboard.width()),
                                   pixels(artboard.height()), PixelFormat::rgba8);
  if (!image) return image.status();
  picture.image = without_needless_alpha(std::move(*image));
  picture.truth = std::move(drawing->document);
  return picture;
}

std::vector<std::string> trace_group(const std::string& name) {
  std::vector<std::string> paths;
  if (name == "photos") {
    append_files(test::source_path("examples/photos"), kPhotoTypes, paths);
    append_files(test::shared_path("photos"), kPhotoTypes, paths);
  } else if (name == "drawings") {
    append_files(test::source_path("examples"), kDrawingTypes, paths);
    for (const char* const scene : {"poivron_orzan", "zephyr", "lady_bug", "drape"}) {
      const std::string path = test::shared_path("scenes/") + scene + ".xml";
      if (std::filesystem::exists(path)) {
        paths.push_back(path);
      } else {
        std::fprintf(stderr, "trace: the public scene %s is not at hand\n", scene);
      }
    }
  } else if (name == "flat") {
    append_files(test::source_path("tests/trace/flat"), kDrawingTypes, paths);
  }
  return paths;
}

}  // namespace sfumato::bench
