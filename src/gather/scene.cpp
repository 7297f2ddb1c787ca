#include "gather/scene.hpp"

#include <algorithm>

#include "base/box.hpp"

namespace sfumato::gather {
namespace {

/// The side of a piece that faces half-edge h, and the piece's fractions at h's origin and target.
struct FacingPiece {
  const curves::SegmentColor* color;
  float u_origin;
  float u_target;
};

// The half-edge's triangle lies on the screen right of it, hence on the right of a segment that
// runs the same way.
FacingPiece facing_piece(const curves::SegmentAttributes& attributes,
                         const mesh::SegmentPiece& piece, bool half_edge_runs_as_constraint) {
  const bool segment_runs_as_constraint = piece.u_from <= piece.u_to;
  const bool same_way = segment_runs_as_constraint == half_edge_runs_as_constraint;
  const auto& side = same_way ? attributes.right : attributes.left;
  if (half_edge_runs_as_constraint) return {&side[piece.segment], piece.u_from, piece.u_to};
  return {&side[piece.segment], piece.u_to, piece.u_from};
}

/// How far a piece lay to the side of the half-edge's triangle before the weld moved it, user
/// units.
double reach_to_side(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
                     const mesh::SegmentPiece& piece, std::uint32_t half_edge) {
  const Vec2 origin = mesh.vertex_position[mesh.origin(half_edge)];
  const Vec2 along = mesh.vertex_position[mesh.target(half_edge)] - origin;
  const Vec2 middle = lerp(attributes.vertex[piece.segment], attributes.vertex[piece.segment + 1],
                           0.5 * (double{piece.u_from} + double{piece.u_to}));
  return cross(along, middle - origin) / length(along);
}

class SceneBuilder {
 public:
  SceneBuilder(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
               Scene& scene)
      : mesh_(mesh), attributes_(attributes), scene_(scene) {}

  void build() {
    Box box;
    for (Vec2 p : mesh_.vertex_position) box.extend(p);
    scene_.origin = box.empty() ? Vec2{} : box.center();
    const auto half_edge_count = static_cast<std::uint32_t>(mesh_.triangle_vertex.size());
    codes_.resize(half_edge_count);
    for (std::uint32_t h = 0; h < half_edge_count; ++h) codes_[h] = code(h);
    normalize_weights();
    scene_.edge_beyond.resize(half_edge_count);
    for (std::uint32_t h = 0; h < half_edge_count; ++h) {
      if (codes_[h] >= 0) scene_.edge_beyond[h] = beyond(h);
    }
    scene_.triangle.resize(mesh_.triangle_count());
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) scene_.triangle[t] = triangle(t);
  }

 private:
  float x(std::uint32_t vertex) const {
    return static_cast<float>(mesh_.vertex_position[vertex].x - scene_.origin.x);
  }
  float y(std::uint32_t vertex) const {
    return static_cast<float>(mesh_.vertex_position[vertex].y - scene_.origin.y);
  }

  EdgeCode code(std::uint32_t h) {
    if (mesh_.half_edge_constraint[h] != mesh::kNone) {
      const Facing facing = facing_color(mesh_, attributes_, h);
      if (facing.kind == ShaderKind::barrier) {
        scene_.barrier.push_back(stop_edge(h, facing));
        return kBorder;
      }
      if (facing.kind != ShaderKind::open) {
        scene_.stop.push_back(stop_edge(h, facing));
        return stop_code(static_cast<std::uint32_t>(scene_.stop.size() - 1));
      }
    }
    return mesh_.half_edge_twin[h] == mesh::kNone ? kBorder : static_cast<EdgeCode>(h);
  }

  StopEdge stop_edge(std::uint32_t h, const Facing& facing) const {
    StopEdge edge{};
    edge.ax = x(mesh_.origin(h)), edge.ay = y(mesh_.origin(h));
    edge.bx = x(mesh_.target(h)), edge.by = y(mesh_.target(h));
    edge.ex = edge.bx - edge.ax, edge.ey = edge.by - edge.ay;
    edge.length_squared = edge.ex * edge.ex + edge.ey * edge.ey;
    edge.kind = static_cast<std::uint32_t>(facing.kind);
    edge.shader = facing.shader;
    edge.weight = facing.kind == ShaderKind::barrier ? 0.0f : facing.weight;
    if (facing.kind != ShaderKind::curve_domain) return edge;
    const float from[] = {facing.from.r, facing.from.g, facing.from.b};
    const float to[] = {facing.to.r, facing.to.g, facing.to.b};
    for (int c = 0; c < 3; ++c) {
      edge.middle[c] = 0.5f * (from[c] + to[c]);
      edge.half_change[c] = 0.5f * (to[c] - from[c]);
    }
    return edge;
  }

  // Only ratios of weights matter; the largest becomes 1, so that no sum overflows.
  void normalize_weights() {
    float largest = 0;
    for (const StopEdge& edge : scene_.stop) largest = std::max(largest, edge.weight);
    if (!(largest > 0)) return;
    for (StopEdge& edge : scene_.stop) {
      edge.weight /= largest;
      for (float& c : edge.middle) c *= edge.weight;
      for (float& c : edge.half_change) c *= edge.weight;
    }
  }

  EdgeBeyond beyond(std::uint32_t h) const {
    const auto twin = static_cast<std::uint32_t>(mesh_.half_edge_twin[h]);
    const std::uint32_t apex = mesh_.apex(twin);
    return {x(apex), y(apex), codes_[mesh::TriangleMesh::next(twin)],
            codes_[mesh::TriangleMesh::previous(twin)]};
  }

  SceneTriangle triangle(std::uint32_t t) const {
    SceneTriangle triangle{};
    for (std::uint32_t k = 0; k < 3; ++k) {
      triangle.x[k] = x(mesh_.origin(3 * t + k));
      triangle.y[k] = y(mesh_.origin(3 * t + k));
      triangle.edge[k] = codes_[3 * t + k];
      triangle.twin[k] = mesh_.half_edge_twin[3 * t + k];
    }
    return triangle;
  }

  const mesh::TriangleMesh& mesh_;
  const curves::SegmentAttributes& attributes_;
  Scene& scene_;
  std::vector<EdgeCode> codes_;
};

std::size_t scene_bytes(const mesh::TriangleMesh& mesh) {
  std::size_t constrained = 0;
  for (std::int32_t c : mesh.half_edge_constraint) constrained += c != mesh::kNone;
  // Twice the stop edges, for a growing vector; the codes live during the build only.
  return mesh.triangle_vertex.size() * (sizeof(EdgeBeyond) + sizeof(EdgeCode)) +
         mesh.triangle_count() * sizeof(SceneTriangle) + 2 * constrained * sizeof(StopEdge);
}

}  // namespace

Facing facing_color(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
                    std::uint32_t half_edge) {
  const mesh::Constraint& constraint =
      mesh.constraint[static_cast<std::size_t>(mesh.half_edge_constraint[half_edge])];
  const bool runs_as_constraint = mesh.origin(half_edge) == constraint.from;
  Facing facing;
  std::uint32_t owner = 0;
  double reach = 0;
  for (std::uint32_t i = constraint.piece_end; i > constraint.piece_begin; --i) {
    const mesh::SegmentPiece& piece = mesh.piece[i - 1];
    const bool first = facing.kind == ShaderKind::open;
    if (!first && attributes.curve[piece.segment] != owner) break;
    const FacingPiece side = facing_piece(attributes, piece, runs_as_constraint);
    if (side.color->kind == ShaderKind::open) continue;
    const double piece_reach = reach_to_side(mesh, attributes, piece, half_edge);
    // Within a lattice step two passages are the same line, and the first counts.
    if (!first && piece_reach < reach - mesh.lattice_step) continue;
    const curves::SegmentValues<Rgb>& color = side.color->color;
    facing = {side.color->kind, side.color->shader, lerp(color.start, color.end, side.u_origin),
              lerp(color.start, color.end, side.u_target), attributes.weight[piece.segment]};
    owner = attributes.curve[piece.segment];
    reach = piece_reach;
  }
  return facing;
}

SceneView Scene::view() const {
  const auto triangle_count = static_cast<std::int64_t>(triangle.size());
  return {edge_beyond.data(), stop.data(), triangle.data(), 64 * triangle_count + (1 << 20)};
}

Result<Scene> build_scene(Context& context, const mesh::TriangleMesh& mesh,
                          const curves::SegmentAttributes& attributes) {
  Scene scene;
  if (Status status = scene.charge.add(context, scene_bytes(mesh), "the visibility mesh");
      !status) {
    return status;
  }
  SceneBuilder(mesh, attributes, scene).build();
  return scene;
}

}  // namespace sfumato::gather
