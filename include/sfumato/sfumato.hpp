#pragma once

/// The library's public face. Three verbs: `read_document` (bytes → Document), `diffuse`
/// (Document → Picture) and `rasterize` (Picture → Image); `encode_png` and `write_file` put an
/// image on disk. All take a Context; none throws, prints or exits: errors come back as values.

#include "base/context.hpp"
#include "base/image.hpp"
#include "base/native/file.hpp"
#include "base/native/tbb_executor.hpp"
#include "base/status.hpp"
#include "document/document.hpp"
#include "formats/orzan.hpp"
#include "formats/png.hpp"
#include "formats/read_document.hpp"
#include "formats/svg.hpp"
#include "formats/svg_write.hpp"
#include "lint/lint.hpp"
#include "patches/diffuse.hpp"
#include "patches/picture.hpp"
#include "raster/rasterize.hpp"
