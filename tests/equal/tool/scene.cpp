#include "equal/tool/scene.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <random>
#include <utility>

#include "sfumato/base/native/file.hpp"
#include "sfumato/formats/read_document.hpp"
#include "support/folder_files.hpp"
#include "support/random_document.hpp"

namespace sfumato::test {
namespace {

constexpr double kFileSidePx = 512;

/// Sets scale, image and viewport, with `scale` pixels per unit of the visible part.
void set_size(const Box& shown, double scale, Scene& scene) {
  scene.diffuse.viewport = shown;
  scene.diffuse.pixels_per_unit = scale;
  scene.raster.width = std::max(1, static_cast<int>(std::lround(shown.width() * scale)));
  scene.raster.height = std::max(1, static_cast<int>(std::lround(shown.height() * scale)));
}

class SceneOptions {
 public:
  /// Uses other random numbers than the document of this seed.
  explicit SceneOptions(std::uint64_t seed) : bits_(~seed) {}

  void choose(Scene& scene) {
    choose_size(scene);
    choose_solution(scene.diffuse);
    choose_pixels(scene.raster);
    scene.by_pixels = chance(0.1) && scene.raster.width < 200;
    scene.with_outputs = chance(0.1);
  }

 private:
  double real(double from, double to) {
    return from + (to - from) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  bool chance(double share) { return real(0, 1) < share; }
  int whole(int from, int to) {
    return from + static_cast<int>(bits_() % static_cast<std::uint64_t>(to - from + 1));
  }

  void choose_size(Scene& scene) {
    Box shown = scene.document.artboard;
    if (chance(0.25)) {
      const Vec2 corner{real(0, 0.4) * shown.width(), real(0, 0.4) * shown.height()};
      const Vec2 size{real(0.3, 0.9) * shown.width(), real(0.3, 0.9) * shown.height()};
      shown = {shown.min + corner, shown.min + corner + size};
    }
    // The large ones have several stripes of a PNG, and more tiles than threads.
    set_size(shown, chance(0.03) ? real(2, 3.5) : real(0.4, 1.2), scene);
  }

  void choose_solution(DiffuseOptions& diffuse) {
    constexpr double kErrors[] = {0, 1, 2, 4};
    diffuse.max_error = kErrors[whole(0, 3)];
    if (chance(0.3)) diffuse.order = static_cast<PatchOrder>(whole(0, 2));
    if (chance(0.15)) diffuse.gather = {gather::Method::rays, whole(1, 12), bits_()};
    if (chance(0.1)) diffuse.min_angle_deg = whole(0, 30);
    if (chance(0.1)) diffuse.tolerance = real(0.02, 2);
    diffuse.ignore_blur = chance(0.05);
    if (chance(0.2)) diffuse.ends = gather::Ends::paper;
  }

  void choose_pixels(RasterOptions& raster) {
    raster.format = static_cast<PixelFormat>(whole(0, 3));
    raster.dither = bytes_per_channel(raster.format) == 1 && chance(0.4);
    raster.antialias = chance(0.9);
    raster.mesh_overlay = chance(0.1);
    if (chance(0.15)) raster.background = Rgb{0.25f, 0.5f, 1};
  }

  std::mt19937_64 bits_;
};

std::optional<std::uint64_t> parse_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, seed);
  if (error != std::errc() || end != last) return std::nullopt;
  return seed;
}

}  // namespace

Scene random_scene(std::uint64_t seed) {
  Scene scene;
  scene.name = std::to_string(seed);
  scene.document = random_document(seed);
  SceneOptions(seed).choose(scene);
  return scene;
}

Result<Scene> file_scene(const std::string& path) {
  Context context;
  Result<std::string> bytes = read_file(path, limits::kInputBytes);
  if (!bytes) return bytes.status();
  const FolderFiles files(std::filesystem::absolute(path).parent_path().string());
  Result<ReadDocument> read = read_document(context, *bytes, path, &files);
  if (!read) return read.status();
  Scene scene;
  scene.name = path;
  scene.document = std::move(read->document);
  const Box& artboard = scene.document.artboard;
  const double side = std::max(artboard.width(), artboard.height());
  set_size(artboard, std::min(1.0, kFileSidePx / side), scene);
  return scene;
}

Result<Scene> scene_of(const std::string& seed_or_path) {
  if (const auto seed = parse_seed(seed_or_path)) return random_scene(*seed);
  return file_scene(seed_or_path);
}

}  // namespace sfumato::test
