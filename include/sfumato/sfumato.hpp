#pragma once

/// @file
/// Includes the whole public interface.
///
/// Three verbs make a picture: read_document() (bytes → Document), diffuse() (Document → Picture)
/// and rasterize() (Picture → Image), or render_on_gpu() in its place. encode_png(), encode_jpeg()
/// and encode_webp() encode images; export_html(), export_pdf(), export_eps(), export_svg(),
/// export_glb(), export_npz(), export_json() and export_ply() encode pictures; write_file() writes
/// the bytes to disk. These functions take a Context, and none throws, prints or exits: errors are
/// returned as values.

/// @namespace sfumato
/// The library: everything public is declared here, in limits and in gather.

#include "sfumato/api/draw_document.hpp"
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
#include "sfumato/document/change.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/document/stop_place.hpp"
#include "sfumato/export/eps/eps.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/export/html/html.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/export/tables/tables.hpp"
#include "sfumato/formats/orzan/orzan.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/formats/svg/svg.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/gpu/render.hpp"
#include "sfumato/import/combine.hpp"
#include "sfumato/import/import_svg.hpp"
#include "sfumato/lint/lint.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/picture/picture_file.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "sfumato/solve/point_evaluator.hpp"
#include "sfumato/solve/solution.hpp"
