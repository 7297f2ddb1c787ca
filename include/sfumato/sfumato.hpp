#pragma once

/// The library's public face. Three verbs: `read_document` (bytes → Document), `diffuse`
/// (Document → Picture) and `rasterize` (Picture → Image; `render_on_gpu` does the same). Images
/// become files by `encode_png`, `encode_jpeg` and `encode_webp`, pictures by `export_html`,
/// `export_pdf`, `export_eps`, `export_svg` and `export_glb`; `write_file` puts them on disk. All
/// take a Context; none throws, prints or exits: errors come back as values.

#include "base/context.hpp"
#include "base/image.hpp"
#include "base/native/file.hpp"
#include "base/native/tbb_executor.hpp"
#include "base/status.hpp"
#include "codecs/jpeg_encode.hpp"
#include "codecs/png.hpp"
#include "codecs/webp_encode.hpp"
#include "document/document.hpp"
#include "export/eps/eps.hpp"
#include "export/glb/glb.hpp"
#include "export/html/html.hpp"
#include "export/pdf/pdf.hpp"
#include "export/svg/svg.hpp"
#include "formats/orzan/orzan.hpp"
#include "formats/read_document.hpp"
#include "formats/svg/svg.hpp"
#include "formats/svg/svg_write.hpp"
#include "gpu/render.hpp"
#include "import/import_svg.hpp"
#include "lint/lint.hpp"
#include "picture/picture.hpp"
#include "raster/rasterize.hpp"
#include "solve/diffuse.hpp"
