#include "export/facets/end_bands.hpp"

#include <algorithm>
#include <cmath>

#include "base/try.hpp"
#include "export/facets/end_loops.hpp"
#include "export/facets/facet_patch.hpp"

namespace sfumato::outputs {
namespace {

/// The error allowed in colours; they show in pixels that a curve cuts.
constexpr double kColorError = 1.5 / 255;
constexpr int kMostEndColumns = 8;
/// The most columns written for an edge: two where it meets the edge before, and the last one.
constexpr std::size_t kMostWritten = 2 * (kMostEndColumns + 2);
/// Sine of the turn of a curve at a vertex that the band needs no corner for.
constexpr double kSmallTurn = 0.35;
/// How far a band may miss the curve, of its width: it lies under the mesh there, or ends before
/// it by less than shows.
constexpr double kCurveError = 0.02;
constexpr int kMostSkipped = 7;
/// How far a band reaches under the mesh, as a share of its width. The band has fewer vertices
/// along the curve than the mesh, and Splash rounds the vertices of both to pixels, so pixels
/// between them would stay free. If a part is narrower than this, the mask cuts off the excess.
constexpr double kUnderMesh = 0.5;

using Value = FacetPatch::Value;

bool is_near(const Value& a, const Value& b) {
  for (std::size_t c = 0; c < a.size(); ++c)
    if (std::fabs(a[c] - b[c]) > kColorError) return false;
  return true;
}

/// Strips from one column to the next, each outwards through a point of a curve, from under the
/// mesh.
class EndBand {
 public:
  EndBand(const PatchLayer& layer, InterpolationSpace space, const FacetSource& source,
          double width, FacetMesh* mesh)
      : layer_(layer), space_(space), source_(source), width_(width), mesh_(*mesh) {
    mesh->channel_count = channel_count_of(source);
  }

  void add_edge(std::uint32_t half_edge);
  /// The next edge does not continue from the last one.
  void finish();

 private:
  struct Column {
    Vec2 at, outwards;  ///< of length 1
    Value value{};
    std::uint32_t low = 0, high = 0;  ///< vertices, where it is written
  };

  void add(const Column& next);
  bool meets(const Column& next);
  bool is_between(const Column& next) const;
  void write_held();

  const PatchLayer& layer_;
  InterpolationSpace space_;
  const FacetSource& source_;
  double width_;
  FacetMesh& mesh_;
  Column last_, held_;  ///< that was written last, and the one after it
  bool has_last_ = false, has_held_ = false;
  int skipped_ = 0;  ///< between them
};

void EndBand::add_edge(std::uint32_t half_edge) {
  const std::uint32_t k = half_edge % 3;
  const Vec2 a = layer_.vertex_position[layer_.triangle_vertex[half_edge]];
  const Vec2 b = layer_.vertex_position[layer_.triangle_vertex[next_half_edge(half_edge)]];
  const FacetPatch patch(layer_, space_, source_, half_edge / 3, kColorError);
  const auto along = [&](double t) {
    Barycentric at{};
    at[k] = 1 - t;
    at[(k + 1) % 3] = t;
    return at;
  };
  int count = 1;
  double bend = patch.bend(along(0), along(1));
  for (; count < kMostEndColumns && bend > kColorError; bend /= 4) count *= 2;
  const Vec2 outwards = left_of(b - a) / length(b - a);
  for (int i = 0; i <= count; ++i) {
    const double t = 1.0 * i / count;
    add({lerp(a, b, t), outwards, patch.shown(along(t))});
  }
}

void EndBand::finish() {
  if (has_held_) write_held();
  has_last_ = has_held_ = false;
}

void EndBand::add(const Column& next) {
  if (has_held_ && held_.at == next.at) {
    if (meets(next)) return;
  } else if (has_held_) {
    if (has_last_ && is_between(next)) {
      ++skipped_;
    } else {
      write_held();
    }
  }
  held_ = next;
  has_held_ = true;
}

/// At a vertex: whether the column before it is to be the one after it too.
bool EndBand::meets(const Column& next) {
  const double turn = cross(held_.outwards, next.outwards);
  const Vec2 sum = held_.outwards + next.outwards;
  const bool is_smooth = is_near(held_.value, next.value);
  if (is_smooth && std::fabs(turn) < kSmallTurn && dot(held_.outwards, next.outwards) > 0) {
    held_.outwards = sum / length(sum);
    return true;
  }
  write_held();
  // Strips along edges that turn towards nothing overlap; the others leave a corner free.
  if (!is_smooth || turn < 0) {
    has_last_ = false;
  } else if (length(sum) > kSmallTurn) {
    held_.outwards = sum / length(sum);
    write_held();
  }
  return false;
}

/// Returns whether the column that is held lies between the last and the next one, nearly.
bool EndBand::is_between(const Column& next) const {
  const Vec2 whole = next.at - last_.at, part = held_.at - last_.at;
  if (skipped_ >= kMostSkipped || dot(last_.outwards, next.outwards) < 0.98) return false;
  const double size = length(whole);
  if (!(size > 0) || std::fabs(cross(whole, part)) > kCurveError * width_ * size) return false;
  const double t = dot(whole, part) / (size * size);
  Value between{};
  for (std::size_t c = 0; c < between.size(); ++c)
    between[c] = last_.value[c] + t * (next.value[c] - last_.value[c]);
  return t > 0 && t < 1 && is_near(between, held_.value);
}

/// Facets from the last column to the one that is held, which becomes the last.
void EndBand::write_held() {
  const bool is_corner = has_last_ && last_.at == held_.at;
  held_.low = mesh_.add_vertex(held_.at - held_.outwards * (kUnderMesh * width_), held_.value);
  held_.high = mesh_.add_vertex(held_.at + held_.outwards * width_, held_.value);
  const auto add_facet = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    for (std::uint32_t vertex : {a, b, c}) mesh_.facet_vertex.push_back(vertex);
  };
  if (is_corner) {
    // Its first side leads through the corner itself.
    add_facet(last_.low, last_.high, held_.high);
  } else if (has_last_) {
    add_facet(last_.low, last_.high, held_.low);
    add_facet(last_.high, held_.high, held_.low);
  }
  last_ = held_;
  has_last_ = true;
  skipped_ = 0;
}

}  // namespace

bool has_ends(const CurveEdges& edges) {
  return std::ranges::any_of(edges.side,
                             [&](std::uint32_t side) { return edges.twin[side] == kNoHalfEdge; });
}

Result<FacetMesh> make_end_band(Context& context, const PatchLayer& layer, InterpolationSpace space,
                                const FacetSource& source, const CurveEdges& edges, double width) {
  FacetMesh mesh;
  mesh.memory = TableMemory("bands beyond curves");
  EndBand band(layer, space, source, width, &mesh);
  const auto make_room = [&] {
    return mesh.make_room(context, 2 * kMostWritten, 2 * kMostWritten);
  };
  const auto add = [&](std::uint32_t half_edge, bool is_first) {
    const bool is_curve = layer.edge_is_curve[half_edge] != 0;
    SFUMATO_TRY(make_room());
    if (is_first || !is_curve) band.finish();
    if (is_curve) band.add_edge(half_edge);
    return ok_status();
  };
  SFUMATO_TRY(for_each_end_loop(context, edges.twin, add));
  SFUMATO_TRY(make_room());
  band.finish();
  return mesh;
}

Result<LayerOutline> outline_of_ends(Context& context, const PatchLayer& layer,
                                     const CurveEdges& edges, double margin) {
  LayerOutline outline;
  bool is_seen = false;  // the area inside the last line, not a gap between triangles
  const auto add = [&](std::uint32_t h, bool is_first) {
    if (is_first && (is_seen || outline.loop.empty()))
      SFUMATO_TRY(outline.memory.push_back(context, outline.loop, {}));
    SFUMATO_TRY(outline.memory.make_room(context, outline.loop.back(), 2));
    std::vector<Vec2>& loop = outline.loop.back();
    if (is_first) {
      loop.clear();
      is_seen = false;
    }
    const Vec2 a = layer.vertex_position[layer.triangle_vertex[h]];
    const Vec2 b = layer.vertex_position[layer.triangle_vertex[next_half_edge(h)]];
    const bool is_frame = layer.edge_is_curve[h] == 0 && is_on_frame(a, b, layer.frame);
    is_seen |= is_frame || layer.edge_is_curve[h] != 0;
    const Vec2 outwards = left_of(b - a) * (is_frame ? margin / length(b - a) : 0);
    if (loop.empty() || loop.back() != a + outwards) loop.push_back(a + outwards);
    loop.push_back(b + outwards);
    Status room;
    return room;
  };
  SFUMATO_TRY(for_each_end_loop(context, edges.twin, add));
  if (!is_seen && !outline.loop.empty()) {
    outline.memory.free(outline.loop.back());
    outline.loop.pop_back();
  }
  return outline;
}

}  // namespace sfumato::outputs
