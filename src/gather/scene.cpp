#include "gather/scene.hpp"

#include <algorithm>

#include "base/box.hpp"
#include "gather/spatial_order.hpp"

namespace sfumato::gather {
namespace {

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
    order_triangles();
    codes_.resize(half_edge_count);
    for_each_half_edge([&](std::uint32_t h) { codes_[h] = code(h); });
    normalize_weights();
    scene_.edge_beyond.reserve(passage_count_);
    for_each_half_edge([&](std::uint32_t h) {
      if (codes_[h] >= 0) scene_.edge_beyond.push_back(beyond(h));
    });
    scene_.triangle.reserve(order_.size());
    for (std::uint32_t t : order_) scene_.triangle.push_back(triangle(t));
  }

 private:
  void order_triangles() {
    std::vector<Vec2> center(mesh_.triangle_count());
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        center[t] = center[t] + mesh_.vertex_position[mesh_.origin(h)];
      }
    }
    order_ = spatial_order(center);
    new_index_.resize(order_.size());
    for (std::uint32_t i = 0; i < order_.size(); ++i) new_index_[order_[i]] = i;
  }

  /// In the order of the scene's triangles.
  template <class Body>
  void for_each_half_edge(Body body) const {
    for (std::uint32_t t : order_) {
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) body(h);
    }
  }

  float x(std::uint32_t vertex) const {
    return static_cast<float>(mesh_.vertex_position[vertex].x - scene_.origin.x);
  }
  float y(std::uint32_t vertex) const {
    return static_cast<float>(mesh_.vertex_position[vertex].y - scene_.origin.y);
  }

  EdgeCode code(std::uint32_t h) {
    if (mesh_.half_edge_constraint[h] != mesh::kNone) {
      const Facing facing = facing_color(mesh_, attributes_, h);
      if (facing.kind == ShaderKind::barrier) return kBorder;
      if (facing.kind != ShaderKind::open) {
        scene_.stop.push_back(stop_edge(h, facing));
        return stop_code(static_cast<std::uint32_t>(scene_.stop.size() - 1));
      }
    }
    if (mesh_.half_edge_twin[h] == mesh::kNone) return kBorder;
    return static_cast<EdgeCode>(passage_count_++);
  }

  StopEdge stop_edge(std::uint32_t h, const Facing& facing) const {
    StopEdge edge{};
    edge.ax = x(mesh_.origin(h)), edge.ay = y(mesh_.origin(h));
    edge.bx = x(mesh_.target(h)), edge.by = y(mesh_.target(h));
    edge.ex = edge.bx - edge.ax, edge.ey = edge.by - edge.ay;
    edge.length_squared = edge.ex * edge.ex + edge.ey * edge.ey;
    edge.kind = static_cast<std::uint32_t>(facing.kind);
    edge.shader = facing.shader;
    edge.weight = facing.weight;
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
    const Vec2 a = mesh_.vertex_position[mesh_.origin(h)] - scene_.origin;
    const Vec2 along = mesh_.vertex_position[mesh_.target(h)] - scene_.origin - a;
    const Vec2 normal = Vec2{-along.y, along.x} / length(along);
    return {x(apex),
            y(apex),
            codes_[mesh::TriangleMesh::next(twin)],
            codes_[mesh::TriangleMesh::previous(twin)],
            static_cast<float>(normal.x),
            static_cast<float>(normal.y),
            static_cast<float>(-dot(normal, a))};
  }

  SceneTriangle triangle(std::uint32_t t) const {
    SceneTriangle triangle{};
    for (std::uint32_t k = 0; k < 3; ++k) {
      triangle.x[k] = x(mesh_.origin(3 * t + k));
      triangle.y[k] = y(mesh_.origin(3 * t + k));
      triangle.edge[k] = codes_[3 * t + k];
      const std::int32_t twin = mesh_.half_edge_twin[3 * t + k];
      triangle.twin[k] = -1;
      if (twin != mesh::kNone) {
        const auto h = static_cast<std::uint32_t>(twin);
        triangle.twin[k] = static_cast<std::int32_t>(3 * new_index_[h / 3] + h % 3);
      }
    }
    return triangle;
  }

  const mesh::TriangleMesh& mesh_;
  const curves::SegmentAttributes& attributes_;
  Scene& scene_;
  std::vector<std::uint32_t> order_;      ///< the mesh's triangles in the scene's order
  std::vector<std::uint32_t> new_index_;  ///< its inverse
  std::vector<EdgeCode> codes_;           ///< per half-edge of the mesh
  std::uint32_t passage_count_ = 0;
};

std::size_t scene_bytes(const mesh::TriangleMesh& mesh) {
  std::size_t constrained = 0;
  for (std::int32_t c : mesh.half_edge_constraint) constrained += c != mesh::kNone;
  // Twice the stop edges, for a growing vector; some of the rest lives during the build only.
  return mesh.triangle_vertex.size() * (sizeof(EdgeBeyond) + sizeof(EdgeCode)) +
         mesh.triangle_count() * (sizeof(SceneTriangle) + sizeof(Vec2) + 16) +
         2 * constrained * sizeof(StopEdge);
}

}  // namespace

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
