#include "export/support.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <sstream>

#include "raster/pictures.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/places.hpp"
#include "support/scenes.hpp"
#include "support/temporary_folder.hpp"

namespace sfumato::test {
namespace {

const std::string kExamples = source_path("examples/");

/// Textures beside the examples.
class ExampleFiles : public ResourceLoader {
 public:
  Result<std::vector<std::uint8_t>> load(std::string_view href) const override {
    const auto bytes = file_bytes(kExamples + std::string(href));
    if (!bytes) return make_error(StatusCode::bad_input, "no such file: " + std::string(href));
    return Bytes(bytes->begin(), bytes->end());
  }
};

/// Replaces IN and OUT by paths in one pass, because the folder's name may contain these letters.
std::string with_paths(const std::string& command, const std::string& in, const std::string& out) {
  std::string text;
  for (std::size_t i = 0; i < command.size();) {
    const bool is_in = command.compare(i, 2, "IN") == 0, is_out = command.compare(i, 3, "OUT") == 0;
    text += is_in ? in : is_out ? out : command.substr(i, 1);
    i += is_in ? 2 : is_out ? 3 : 1;
  }
  return text;
}

Image on_white(const Image& image) {
  Image opaque{image.width, image.height, PixelFormat::rgb8, {}};
  for (std::size_t i = 0; i < image.bytes.size(); i += 4) {
    const int alpha = image.bytes[i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      const int value = image.bytes[i + c] * alpha + 255 * (255 - alpha);
      opaque.bytes.push_back(static_cast<std::uint8_t>((value + 127) / 255));
    }
  }
  return opaque;
}

/// Runs a command in a folder with the file; IN and OUT become paths there.
Said run_in(const TemporaryFolder& folder, const Bytes& file, const std::string& name,
            std::string command) {
  std::ofstream(folder.file(name), std::ios::binary)
      .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
  command = with_paths(command, folder.file(name), folder.file("out.png"));
  const std::string log = folder.file("log.txt");
  const int status = std::system(("timeout 500 " + command + " >" + log + " 2>&1").c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, file_bytes(log).value_or("")};
}

}  // namespace

std::optional<Document> example(const std::string& name) {
  Context context;
  const ExampleFiles files;
  const auto bytes = file_bytes(kExamples + name);
  if (!bytes) {
    ADD_FAILURE() << "no " << name;
    return std::nullopt;
  }
  Result<ReadDocument> read = read_document(context, *bytes, name, &files);
  if (!read) {
    ADD_FAILURE() << to_string(read.status());
    return std::nullopt;
  }
  return std::move(read->document);
}

Picture solved(const Document& document) {
  Context context;
  Result<Picture> picture = diffuse(context, document, {});
  EXPECT_TRUE(picture.ok()) << to_string(picture.status());
  return picture ? std::move(*picture) : Picture{};
}

Rgb sloped(int, Vec2 p) {
  return {static_cast<float>(p.x / 64), 0.5f, static_cast<float>(p.y / 64)};
}

Picture picture_of_one_triangle() {
  RegionMesh mesh;
  mesh.vertex = {{3, 4}, {60, 20}, {11, 44}};
  mesh.add(0, 1, 2, 0);
  Picture picture = make_picture(make_layer(mesh, sloped));
  picture.artboard = picture.viewport = kTriangleBox;
  return picture;
}

std::string text_of(const Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

bool has_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((folder + "/" + name).c_str(), X_OK) == 0) return true;
  return false;
}

Said said_of(const Bytes& file, const std::string& name, const std::string& command) {
  const TemporaryFolder folder;
  return run_in(folder, file, name, command);
}

std::optional<Image> shown_by(const Bytes& file, const std::string& name,
                              const std::string& command) {
  const TemporaryFolder folder;
  const Said said = run_in(folder, file, name, command);
  const auto png = file_bytes(folder.file("out.png"));
  if (said.exit_code != 0 || !png) {
    ADD_FAILURE() << command << " ends with " << said.exit_code << ": " << said.text;
    return std::nullopt;
  }
  Context context;
  Result<Image> image =
      decode_png(context, {reinterpret_cast<const std::uint8_t*>(png->data()), png->size()}, "OUT");
  if (!image || bytes_per_channel(image->format) != 1) {
    ADD_FAILURE() << command << " writes no PNG of 8 bits";
    return std::nullopt;
  }
  return image->format == PixelFormat::rgba8 ? on_white(*image) : std::move(*image);
}

Image reference(const Picture& picture, int width, int height) {
  RasterOptions options;
  options.width = width;
  options.height = height;
  Context context;
  Result<Image> image = rasterize(context, picture, options);
  EXPECT_TRUE(image.ok()) << to_string(image.status());
  return image ? std::move(*image) : Image{};
}

ImageDifference difference(const Image& a, const Image& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  if (a.bytes.size() != b.bytes.size() || a.bytes.empty()) return {255, 255};
  std::array<std::size_t, 256> count{};
  double sum = 0;
  for (std::size_t i = 0; i < a.bytes.size(); ++i) {
    const int step = std::abs(a.bytes[i] - b.bytes[i]);
    ++count[static_cast<std::size_t>(step)];
    sum += step;
  }
  ImageDifference found{sum / static_cast<double>(a.bytes.size()), 0};
  std::size_t below = count[0];
  while (100 * below < 99 * a.bytes.size()) below += count[static_cast<std::size_t>(++found.p99)];
  const std::size_t far = std::accumulate(count.begin() + 65, count.end(), std::size_t{0});
  found.far_percent = 100.0 * static_cast<double>(far) / static_cast<double>(a.bytes.size());
  return found;
}

}  // namespace sfumato::test
