#pragma once

#include <cstddef>
#include <cstdint>

/// Every limit on input and on resources, in one place (documented in docs/limits.md). Passing one
/// is StatusCode::limit, and the message names the limit.
namespace sfumato::limits {

inline constexpr std::size_t kInputBytes = std::size_t{64} << 20;
/// Of a PNG that `sfumato compare` reads.
inline constexpr std::size_t kPngBytes = std::size_t{1} << 30;
inline constexpr int kXmlDepth = 256;
inline constexpr std::size_t kXmlElements = 8'000'000;
/// Values that the rules of style sheets set.
inline constexpr std::size_t kStyleValues = 100'000;
/// Elements that are read through `use`, each as often as it is used.
inline constexpr std::size_t kUsedElements = 1'000'000;
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
inline constexpr int kGroupDepth = 16;
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

/// Memory charged by one Context, bytes; --max-memory changes it.
inline constexpr std::size_t kMemoryBytes = std::size_t{2} << 30;

}  // namespace sfumato::limits
