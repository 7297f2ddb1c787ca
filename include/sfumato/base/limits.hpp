#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "sfumato/base/status.hpp"

/// Every limit on input and on resources, in one place (documented in docs/limits.md). Passing one
/// is StatusCode::limit, and the message names the limit. Those of struct Limits, below, can be
/// set for each Context.
namespace sfumato::limits {

inline constexpr std::size_t kInputBytes = std::size_t{64} << 20;
/// Bytes that a byte of gzip may become, beside kUnpackedSlack of any input.
inline constexpr std::size_t kUnpackRatio = 200;
inline constexpr std::size_t kUnpackedSlack = std::size_t{1} << 20;
/// Of a PNG that `sfumato compare` reads.
inline constexpr std::size_t kPngBytes = std::size_t{1} << 30;
inline constexpr std::size_t kXmlDepth = 256;
inline constexpr std::size_t kXmlElements = 8'000'000;
/// Of one element.
inline constexpr std::size_t kXmlAttributes = 1024;
/// Values that the rules of style sheets set.
inline constexpr std::size_t kStyleValues = 100'000;
/// Elements that are read through `use`, each as often as it is used.
inline constexpr std::size_t kUsedElements = 1'000'000;
/// Text of elements that is read again, through `use` or by curves of one paint.
inline constexpr std::size_t kUsedBytes = std::size_t{16} << 20;
/// An element's id.
inline constexpr std::size_t kIdBytes = 1024;
inline constexpr std::size_t kCurves = 200'000;
inline constexpr std::size_t kControlPoints = 4'000'000;
inline constexpr std::size_t kStops = 8'000'000;
/// Of one attribute of a curve, or one gradient.
inline constexpr std::size_t kStopsPerList = 10'000;
inline constexpr std::size_t kSegments = 4'000'000;
inline constexpr std::size_t kTriangles = 8'000'000;
inline constexpr std::size_t kNodes = 40'000'000;
inline constexpr std::size_t kLayers = 256;
inline constexpr std::size_t kShadersPerLayer = 64;
/// Layer instances, local curves and groups of one document, after every `use` was followed.
inline constexpr std::size_t kStackItems = 200'000;
/// Groups within groups that are composited by themselves.
inline constexpr std::size_t kGroupDepth = 16;
/// A PNG or JPEG file that a document refers to.
inline constexpr std::size_t kImageFileBytes = std::size_t{64} << 20;
/// Pixels of one texture, and of all.
inline constexpr std::size_t kTexels = 64'000'000;
inline constexpr std::size_t kTextures = 256;
inline constexpr int kRays = 4096;
inline constexpr int kThreads = 1024;
inline constexpr std::size_t kWarnings = 100;

/// Coordinates are finite and at most this large in magnitude, in user units.
inline constexpr double kCoordinate = 1e7;

/// Triangles of all layers, and segments of all local curves, that an HTML viewer takes: graphics
/// of small devices have textures of 4096 rows.
inline constexpr std::size_t kViewerTriangles = 800'000;
inline constexpr std::size_t kViewerStrokeSegments = 1'000'000;

/// Side of a raster image in pixels.
inline constexpr int kImageSide = 16'384;

/// Triangles that an SVG of triangles paints, unless forced; and those above which its author is
/// warned.
inline constexpr std::size_t kSvgTriangles = 40'000;
inline constexpr std::size_t kSvgTrianglesSlow = 10'000;

/// Memory charged by one Context, bytes.
inline constexpr std::size_t kMemoryBytes = std::size_t{2} << 30;

/// Wall-clock time that the command gives a drawing, seconds. A Context has no such limit of
/// itself.
inline constexpr double kSeconds = 60;

}  // namespace sfumato::limits

namespace sfumato {

/// The limits of one Context: those on what an input asks for. The others above are bounds of data
/// structures or of options.
struct Limits {
  std::size_t input_bytes = limits::kInputBytes;
  std::size_t unpack_ratio = limits::kUnpackRatio;
  std::size_t xml_depth = limits::kXmlDepth;
  std::size_t xml_elements = limits::kXmlElements;
  std::size_t xml_attributes = limits::kXmlAttributes;
  std::size_t style_values = limits::kStyleValues;
  std::size_t used_elements = limits::kUsedElements;
  std::size_t used_bytes = limits::kUsedBytes;
  std::size_t id_bytes = limits::kIdBytes;
  std::size_t curves = limits::kCurves;
  std::size_t control_points = limits::kControlPoints;
  std::size_t stops = limits::kStops;
  std::size_t stops_per_list = limits::kStopsPerList;
  std::size_t layers = limits::kLayers;
  std::size_t shaders_per_layer = limits::kShadersPerLayer;
  std::size_t stack_items = limits::kStackItems;
  std::size_t group_depth = limits::kGroupDepth;
  std::size_t image_file_bytes = limits::kImageFileBytes;
  std::size_t textures = limits::kTextures;
  std::size_t texels = limits::kTexels;
  std::size_t segments = limits::kSegments;
  std::size_t triangles = limits::kTriangles;
  std::size_t nodes = limits::kNodes;
  std::size_t image_side = limits::kImageSide;
  std::size_t viewer_triangles = limits::kViewerTriangles;
  std::size_t viewer_stroke_segments = limits::kViewerStrokeSegments;
  std::size_t svg_triangles = limits::kSvgTriangles;
};

/// How one of Limits is called, and how far it can be raised.
struct LimitName {
  std::string_view name;  ///< "stops-per-list"
  std::size_t Limits::*value;
  /// Beyond, numbers or tables that are sized for it would not do.
  std::size_t highest;
};

/// All of Limits, in its order.
std::span<const LimitName> limit_names();

/// Whether none is above its LimitName::highest, which tables and recursion are made for. Error:
/// bad_input, which names the limit.
Status validate(const Limits& limits);

}  // namespace sfumato
