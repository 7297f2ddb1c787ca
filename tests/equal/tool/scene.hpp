#pragma once

#include <cstdint>
#include <string>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::test {

/// A document and all that is asked of it.
struct Scene {
  std::string name;
  Document document;
  DiffuseOptions diffuse;
  RasterOptions raster;
  bool by_pixels = false;     ///< also drawn by the gather at every pixel
  bool with_outputs = false;  ///< also written in every format
};

/// A random document, and options that the seed decides on: scale, viewport, pixel format, dither,
/// orders of patches, errors, rays, and for one scene in ten every output.
Scene random_scene(std::uint64_t seed);

/// A file, one pixel a unit, at most 512 pixels wide and high. Textures are looked for beside it.
/// Errors: those of reading it.
Result<Scene> file_scene(const std::string& path);

/// The scene of a seed ("17") or a file.
Result<Scene> scene_of(const std::string& seed_or_path);

}  // namespace sfumato::test
