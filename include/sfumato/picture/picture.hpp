#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/color.hpp"
#include "sfumato/base/vec2.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato {

namespace picture {
class PointFields;
}

/// The number of nodes of a patch, for every PatchOrder.
inline constexpr int kNodesPerTriangle = 10;

/// Returns the index in PatchField::triangle_node of a triangle's node; `place` is 0 to 9, in the
/// order that PatchField describes.
constexpr std::size_t node_slot(std::size_t triangle, std::size_t place) {
  return kNodesPerTriangle * triangle + place;
}

/// The polynomial that interpolates inside a triangle (paper appendix A). Ten nodes are stored for
/// each order: a quadratic takes the middles of the edges from the cubics along them, and a linear
/// patch uses the corners only.
enum class PatchOrder : std::uint8_t {
  linear,     ///< barycentric, from the corners
  quadratic,  ///< eq. 17, from the corners and the middles of the edges
  cubic       ///< eq. 18, from all ten nodes
};

/// Values that are interpolated over the triangles of a layer.
///
/// The ten nodes of a triangle with corners 0, 1, 2 are stored in this order (paper Fig. 3, eq.
/// 18): Z0, Z1, Z2, Z01, Z10, Z12, Z21, Z20, Z02, Z012. Zi is corner i, Zij lies on the edge from
/// corner i to corner j at a third of the way, and Z012 is the barycentre. In the paper's notation
/// the barycentric weights of the corners are w, u and v.
struct PatchField {
  int channel_count = 0;                     ///< 0: the layer has no such field
  std::vector<std::uint32_t> triangle_node;  ///< node indices, kNodesPerTriangle per triangle
  std::vector<float> node_value;             ///< channel_count per node
  /// Indices into Picture::shaders. The last channels are the weights W_s/W of these shaders.
  std::vector<std::uint32_t> shader;
};

/// One side of an edge whose blur is too fine for triangles. The triangles show the edge sharp, and
/// outputs in pixels average the blur of eq. 8 over it: at distance r from the edge the side shows
/// a share 1 - β(r/R) of the colour across the edge. The radius R, where that ends, is linear along
/// the edge.
struct SoftEdge {
  static constexpr std::uint32_t kNone = 0xffffffff;  ///< no triangle on this side

  std::uint32_t front = kNone;  ///< 3 t + k for edge k of the side's triangle t; kNone: transparent
  std::uint32_t back = kNone;   ///< the same edge in the triangle across
  /// Vectors in the layer frame from the two ends of `front`, its origin first, to the end of the
  /// blur. On a straight curve their length is R. Where two edges meet at a corner they lead to the
  /// common corner of both blurs. They are shorter where another curve is near.
  Vec2 reach[2];
  /// The colour across the edge is front + contrast × (back - front). The contrast is 2 where the
  /// triangle across shows the mean of both sides on the edge, because the mesh itself shows its
  /// blur; otherwise 1.
  float contrast = 1;
};

/// An edge of a picture for a pixel grid, and the curve that strays from it. The triangles end at
/// the edge; pixels get the area between edge and curve in the colour of its side of the curve.
struct CurveBow {
  std::uint32_t front = SoftEdge::kNone;  ///< as SoftEdge
  std::uint32_t back = SoftEdge::kNone;   ///< as SoftEdge
  /// Distances of the curve from the edge in the layer frame: at the two ends of `front`, its
  /// origin first, and between them in the middle of the edge. The curve is a parabola over the
  /// edge. Positive: on the side of `front`.
  float height[3] = {};
};

/// Returns the triangle that paints a SoftEdge or a CurveBow: the triangle of its own side, or if
/// there is none the one across.
template <class Edge>
std::uint32_t painting_triangle(const Edge& edge) {
  return (edge.front != SoftEdge::kNone ? edge.front : edge.back) / 3;
}

/// The effects of a half-edge of an ExactLayer on rays.
enum class RayEdge : std::uint8_t {
  open,  ///< none: the ray continues into the triangle across
  stop,  ///< ends the ray without a value: a barrier, or the border
  side   ///< a side of a curve, with a value
};

/// The side of a curve that the triangle of a half-edge lies on. Values, ExactField::channel_count
/// channels each, are linear from the half-edge's origin to its target.
struct ExactSide {
  float from[4] = {};   ///< values at the half-edge's origin
  float to[4] = {};     ///< values at its target
  float weight = 1;     ///< k of eq. 4
  float blur_from = 0;  ///< R of eq. 8, layer units; 0 at both ends: sharp
  float blur_to = 0;    ///< the same at the target
};

/// The free end of a curve, whose term is added to the gathered values (docs/mathematics.md, "Free
/// ends").
struct ExactEnd {
  Vec2 position;            ///< layer frame
  Vec2 direction;           ///< unit vector, out of the curve
  float bend = 0;           ///< of the curve behind it
  float reach = 0;          ///< the distance at which the term ends
  float weight = 0;         ///< c k
  float blur_positive = 0;  ///< R where cross(direction, p - position) > 0
  float blur_negative = 0;  ///< R on the other side
  float positive[4] = {};   ///< values of the first side
  float negative[4] = {};   ///< values of the other side
};

/// One attribute on the triangles of an ExactLayer.
struct ExactField {
  int channel_count = 0;        ///< 3 for a colour, 1 for an opacity
  std::vector<RayEdge> edge;    ///< 3 per triangle, as PatchLayer::edge_is_curve
  std::vector<ExactSide> side;  ///< for the half-edges with RayEdge::side, in order
  std::vector<ExactEnd> end;    ///< free ends of its curves
};

/// A layer as rays meet it, without patches: its curves as straight edges in a triangulation, with
/// the values of their sides. The exact value at any point is gathered from this (paper eq. 2 to
/// 11).
struct ExactLayer {
  /// The largest distance of edges from their curves, layer units, where the curves are flattened
  /// as finely as the visible part requires.
  double tolerance = 0;
  std::vector<Vec2> vertex_position;           ///< layer frame
  std::vector<std::uint32_t> triangle_vertex;  ///< 3 per triangle, cross(01, 02) > 0
  std::vector<ExactField> field;               ///< the colour, and the opacity if there is one
};

/// A shared reference to exact fields that the solver made.
class PointFieldsRef {
 public:
  PointFieldsRef() = default;
  /// Takes over a reference to `fields`; null: refers to nothing.
  explicit PointFieldsRef(const picture::PointFields* fields) : fields_(fields) {}
  /// Shares the fields of `other`.
  PointFieldsRef(const PointFieldsRef& other);
  /// Takes over the reference of `other`.
  PointFieldsRef(PointFieldsRef&& other) noexcept
      : fields_(std::exchange(other.fields_, nullptr)) {}
  /// Exchanges the references.
  PointFieldsRef& operator=(PointFieldsRef other) noexcept {
    std::swap(fields_, other.fields_);
    return *this;
  }
  ~PointFieldsRef();

  /// Returns the fields; null: none.
  const picture::PointFields* get() const { return fields_; }
  /// Does get().
  const picture::PointFields* operator->() const { return fields_; }
  /// Returns whether there are fields.
  explicit operator bool() const { return fields_ != nullptr; }

 private:
  const picture::PointFields* fields_ = nullptr;
};

/// One solved layer: triangular patches over shared nodes (equations 6 and 10 of the paper).
///
/// The colour at a point is channels 0 to 2 of `color`, in the space of Picture::interpolation,
/// plus each shader's weight times its colour there. The opacity is channel 0 of `opacity`, plus
/// each shader's weight times its alpha × luminance. Nothing is painted where there is no triangle.
struct PatchLayer {
  Box frame;                                   ///< the rectangle of the layer frame that was solved
  PatchOrder order = PatchOrder::cubic;        ///< the interpolation of all its patches
  std::vector<Vec2> vertex_position;           ///< layer frame
  std::vector<std::uint32_t> triangle_vertex;  ///< 3 per triangle, cross(01, 02) > 0
  /// 3 per triangle, for edge k from corner k to corner (k+1)%3: 1 where colours may jump across
  /// the edge or the layer ends there, otherwise 0.
  std::vector<std::uint8_t> edge_is_curve;
  std::vector<SoftEdge> soft_edge;  ///< sorted by painting_triangle()
  std::vector<CurveBow> bow;        ///< sorted by painting_triangle(); only for a pixel grid
  PatchField color{3, {}, {}, {}};  ///< 3 channels, and one for each of its shaders
  PatchField opacity;  ///< 1 channel, and one for each of its shaders; no channels: opaque
  /// Has fields only with DiffuseOptions::exact_fields, and where no side has an image-domain
  /// shader.
  ExactLayer exact;
  /// For a pixel grid: the exact fields, which pixels show instead of patches. Then `color` and
  /// `opacity` have channels and shaders, but no nodes. Null: pixels show the patches.
  PointFieldsRef exact_points;

  /// Returns the number of triangles; 0 where no instance shows a part of the layer.
  std::uint32_t triangle_count() const {
    return static_cast<std::uint32_t>(triangle_vertex.size() / 3);
  }
};

/// A solved layer painted at one place of the stacking order.
struct PatchInstance {
  std::uint32_t layer = 0;              ///< index into Picture::layers
  Affine artboard_from_layer;           ///< invertible
  float opacity = 1;                    ///< of the whole, 0 to 1
  BlendMode blend = BlendMode::normal;  ///< with the colours below
};

/// One item of Picture::stack.
using PictureItem = std::variant<PatchInstance, LocalStroke, GroupBegin, GroupEnd>;

/// A solved picture. Every output is made from it; it is independent of resolution unless it was
/// made for a pixel grid. Plain data: several threads can read it at once.
struct Picture {
  Box artboard;  ///< the document's: user units, y down
  Box viewport;  ///< the part of the artboard frame that was solved
  InterpolationSpace interpolation = InterpolationSpace::srgb;  ///< space of `layers`
  std::optional<Rgb> background;  ///< behind all items; none: transparent
  /// Made with DiffuseOptions::pixel_grid: only rasterize() takes it, at most at the resolution
  /// that it was made for.
  bool for_pixel_grid = false;
  std::vector<Shader> shaders;     ///< the document's shaders, without Texture::file
  std::vector<PatchLayer> layers;  ///< one for each of Document::layers
  std::vector<PictureItem> stack;  ///< bottom first; groups nest and are closed
};

/// @name Memory of parts of a picture
/// @{

/// Returns roughly the bytes of memory that the object's vectors take, without the object itself.
/// diffuse() charges these to the Budget only while it works; a caller who keeps a picture may
/// charge them again.
std::size_t bytes_of(const ExactLayer& layer);
std::size_t bytes_of(const PatchLayer& layer);
std::size_t bytes_of(const Picture& picture);
/// @}

}  // namespace sfumato
