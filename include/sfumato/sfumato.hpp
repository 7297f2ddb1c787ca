#pragma once

/// The library's public face. Three verbs: `read_document` (bytes → Document), `diffuse`
/// (Document → Picture) and `rasterize` (Picture → Image; `render_on_gpu` does the same). Images
/// become files by `encode_png`, `encode_jpeg` and `encode_webp`, pictures by `export_html`,
/// `export_pdf`, `export_eps`, `export_svg` and `export_glb`; `write_file` puts them on disk. All
/// take a Context; none throws, prints or exits: errors come back as values.

#include "sfumato/api/render_pixels.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/codecs/webp_encode.hpp"
#include "sfumato/document/build.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/export/eps/eps.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/export/html/html.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/formats/orzan/orzan.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/formats/svg/svg.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/gpu/render.hpp"
#include "sfumato/import/import_svg.hpp"
#include "sfumato/lint/lint.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "sfumato/solve/point_evaluator.hpp"
