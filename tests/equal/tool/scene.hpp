#pragma once

#include <cstdint>
#include <string>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::test {

/// A document with all options for drawing it.
struct Scene {
  std::string name;
  Document document;
  DiffuseOptions diffuse;
  RasterOptions raster;
  bool by_pixels = false;     ///< also drawn by the gather at every pixel
  bool with_outputs = false;  ///< also written in every format
};

/// Returns a random document with options that the seed chooses: scale, viewport, pixel format,
/// dither, orders of patches, errors, rays, and every output for one scene in ten.
Scene random_scene(std::uint64_t seed);

/// Returns the scene of a file: one pixel per unit, at most 512 pixels wide and high. Textures are
/// read beside the file. Returns the errors of reading it.
Result<Scene> file_scene(const std::string& path);

/// Returns the scene of a seed ("17") or a file.
Result<Scene> scene_of(const std::string& seed_or_path);

}  // namespace sfumato::test
