#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "sfumato/base/status.hpp"

/// Every limit on inputs and on resources, as docs/limits.md lists them. Exceeding one is
/// StatusCode::limit, with a message that names it. Limits that are repeated in struct Limits are
/// defaults, which can be changed for each Context.
namespace sfumato::limits {

/// Bytes of a document's text, after gzip is unpacked.
inline constexpr std::size_t kInputBytes = std::size_t{64} << 20;
/// Bytes that each byte of a gzip file may unpack to, in addition to kUnpackedSlack for the whole.
inline constexpr std::size_t kUnpackRatio = 200;
/// Bytes that any gzip file may unpack to, whatever its ratio: small files pack well.
inline constexpr std::size_t kUnpackedSlack = std::size_t{1} << 20;
/// Bytes of a PNG file that `sfumato compare` reads.
inline constexpr std::size_t kPngBytes = std::size_t{1} << 30;
/// Bytes that replace references to entities of a DTD, over the whole document and however deep;
/// each reference counts as one more.
inline constexpr std::size_t kEntityBytes = std::size_t{1} << 20;
/// Entities of a DTD within each other.
inline constexpr std::size_t kEntityDepth = 16;
/// XML elements within each other.
inline constexpr std::size_t kXmlDepth = 256;
/// XML elements of a document.
inline constexpr std::size_t kXmlElements = 8'000'000;
/// Attributes of one XML element.
inline constexpr std::size_t kXmlAttributes = 1024;
/// Values that the rules of all style sheets set, and parts of their selectors.
inline constexpr std::size_t kStyleValues = 100'000;
/// Steps of matching selectors of several parts with elements.
inline constexpr std::size_t kSelectorSteps = 10'000'000;
/// Bytes that the var() of all values read and write.
inline constexpr std::size_t kVariableBytes = std::size_t{32} << 20;
/// Custom properties and fallbacks of var() within each other.
inline constexpr std::size_t kVariableDepth = 32;
/// Elements that are read through `use`, each as often as it is used, and paints that are read
/// through `href`.
inline constexpr std::size_t kUsedElements = 400'000;
/// Bytes of elements that are read again, through `use` or because curves share a paint. Only what
/// exceeds 256 bytes of an element counts, and classes count sixteenfold.
inline constexpr std::size_t kUsedBytes = std::size_t{16} << 20;
/// Bytes of an element's id.
inline constexpr std::size_t kIdBytes = 1024;
/// Curves of a document, local curves included.
inline constexpr std::size_t kCurves = 200'000;
/// Control points of all curves.
inline constexpr std::size_t kControlPoints = 4'000'000;
/// Dashes of one stroke that is imported.
inline constexpr std::size_t kDashes = 20'000;
/// Lengths in the `stroke-dasharray` of a stroke that is imported.
inline constexpr std::size_t kDashLengths = 1024;
/// Markers that an import draws on the vertices of all shapes.
inline constexpr std::size_t kMarkers = 20'000;
/// Markers within each other.
inline constexpr std::size_t kMarkerDepth = 8;
/// Tiles of vector patterns that an import draws.
inline constexpr std::size_t kPatternTiles = 64;
/// Texels of all these tiles together.
inline constexpr std::size_t kPatternTexels = 4'000'000;
/// Texels on a side of such a tile; larger tiles are drawn at this resolution.
inline constexpr std::size_t kPatternSide = 1024;
/// Shapes in all these tiles: a drawn one takes about a millisecond.
inline constexpr std::size_t kPatternShapes = 1000;
/// Vector patterns within each other.
inline constexpr std::size_t kPatternDepth = 4;
/// Chords of the outline of one shape that is imported, crossings included.
inline constexpr std::size_t kChords = 2'000'000;
/// Pairs of such chords that are compared: about a second.
inline constexpr std::size_t kChordPairs = 150'000'000;
/// Colour, opacity and radius stops of all curves.
inline constexpr std::size_t kStops = 8'000'000;
/// Stops of one attribute of a curve, or of one gradient.
inline constexpr std::size_t kStopsPerList = 10'000;
/// Straight segments of one layer or local curve, after flattening.
inline constexpr std::size_t kSegments = 4'000'000;
/// Triangles of one layer.
inline constexpr std::size_t kTriangles = 8'000'000;
/// Points whose colour is gathered at once, such as the nodes of one layer.
inline constexpr std::size_t kNodes = 40'000'000;
/// Layers of a document.
inline constexpr std::size_t kLayers = 4096;
/// Image-domain shaders that the curves of one layer use.
inline constexpr std::size_t kShadersPerLayer = 64;
/// Items of the stack of a document or a picture, after every `use` is expanded.
inline constexpr std::size_t kStackItems = 200'000;
/// Groups within each other.
inline constexpr std::size_t kGroupDepth = 16;
/// Bytes of a PNG or JPEG file that a document refers to.
inline constexpr std::size_t kImageFileBytes = std::size_t{64} << 20;
/// Texels of all textures of a document together.
inline constexpr std::size_t kTexels = 64'000'000;
/// Textures of a document.
inline constexpr std::size_t kTextures = 256;
/// Random rays per node, for gather::Method::rays.
inline constexpr int kRays = 4096;
/// Threads of an Executor.
inline constexpr int kThreads = 1024;
/// Warnings of one reading; one more counts the rest.
inline constexpr std::size_t kWarnings = 100;

/// Magnitude of coordinates, in user units.
inline constexpr double kCoordinate = 1e7;

/// Triangles of all layers in an HTML viewer. Graphics of small devices have textures of at most
/// 4096 rows, which bounds this and kViewerStrokeSegments.
inline constexpr std::size_t kViewerTriangles = 800'000;
/// Segments of all local curves in an HTML viewer.
inline constexpr std::size_t kViewerStrokeSegments = 1'000'000;

/// Pixels on a side of a raster image.
inline constexpr int kImageSide = 16'384;

/// Triangles that an SVG of triangles paints, every instance counted, unless SvgOptions::force is
/// set.
inline constexpr std::size_t kSvgTriangles = 40'000;
/// Triangles above which ExportNotes warn that such an SVG is slow to open. Not an error.
inline constexpr std::size_t kSvgTrianglesSlow = 10'000;

/// Bytes of memory that a Budget allows by default.
inline constexpr std::size_t kMemoryBytes = std::size_t{2} << 30;

/// Seconds of wall-clock time that the `sfumato` command allows for a drawing. A Context has no
/// Deadline unless the caller sets one.
inline constexpr double kSeconds = 60;

}  // namespace sfumato::limits

namespace sfumato {

/// The limits of one Context, which bound what an input may ask for. Each can be lowered, down to
/// 0, and raised up to its LimitName::highest.
struct Limits {
  /// @name Limits on an input
  /// @{

  /// Bounds the same quantity as the constant in its initialiser, which is the default.
  std::size_t input_bytes = limits::kInputBytes;
  std::size_t unpack_ratio = limits::kUnpackRatio;
  std::size_t entity_bytes = limits::kEntityBytes;
  std::size_t entity_depth = limits::kEntityDepth;
  std::size_t xml_depth = limits::kXmlDepth;
  std::size_t xml_elements = limits::kXmlElements;
  std::size_t xml_attributes = limits::kXmlAttributes;
  std::size_t style_values = limits::kStyleValues;
  std::size_t selector_steps = limits::kSelectorSteps;
  std::size_t variable_bytes = limits::kVariableBytes;
  std::size_t variable_depth = limits::kVariableDepth;
  std::size_t used_elements = limits::kUsedElements;
  std::size_t used_bytes = limits::kUsedBytes;
  std::size_t id_bytes = limits::kIdBytes;
  std::size_t curves = limits::kCurves;
  std::size_t control_points = limits::kControlPoints;
  std::size_t dashes = limits::kDashes;
  std::size_t dash_lengths = limits::kDashLengths;
  std::size_t markers = limits::kMarkers;
  std::size_t marker_depth = limits::kMarkerDepth;
  std::size_t pattern_tiles = limits::kPatternTiles;
  std::size_t pattern_texels = limits::kPatternTexels;
  std::size_t pattern_side = limits::kPatternSide;
  std::size_t pattern_shapes = limits::kPatternShapes;
  std::size_t pattern_depth = limits::kPatternDepth;
  std::size_t chords = limits::kChords;
  std::size_t chord_pairs = limits::kChordPairs;
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
  /// @}
};

/// The name of one member of Limits, and how far it can be raised.
struct LimitName {
  std::string_view name;       ///< as in messages and in the command's `--limit`: "stops-per-list"
  std::size_t Limits::*value;  ///< the member
  std::size_t highest;         ///< the largest value that tables and recursion allow
};

/// Returns the names of all members of Limits, in their order.
std::span<const LimitName> limit_names();

/// Checks that no limit is above its LimitName::highest. Error: bad_input, which names the limit.
Status validate(const Limits& limits);

}  // namespace sfumato
