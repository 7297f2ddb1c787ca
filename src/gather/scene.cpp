#include "gather/scene.hpp"

#include <algorithm>
#include <cmath>

#include "base/poll.hpp"
#include "base/spatial_order.hpp"
#include "gather/blind.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::gather {
namespace {

class SceneBuilder {
 public:
  SceneBuilder(Context& context, const mesh::TriangleMesh& mesh,
               const curves::SegmentAttributes& attributes, Scene& scene)
      : context_(context), poll_(context), mesh_(mesh), attributes_(attributes), scene_(scene) {}

  Status build() {
    Box box;
    for (Vec2 p : mesh_.vertex_position) box.extend(p);
    scene_.origin = box.empty() ? Vec2{} : box.center();
    const auto half_edge_count = static_cast<std::uint32_t>(mesh_.triangle_vertex.size());
    Status status = order_triangles();
    if (status) status = memory_.resize(context_, codes_, half_edge_count);
    if (status) status = find_codes();
    if (status) status = context_.check();
    if (!status) return status;
    normalize_weights();
    drop_blend_if_plain();
    Result<std::vector<std::uint8_t>> blind = find_blind(context_, mesh_, codes_, memory_);
    if (!blind) return blind.status();
    blind_ = std::move(*blind);
    status = scene_.memory.reserve(context_, scene_.edge_beyond, passage_count_);
    if (status) status = scene_.memory.reserve(context_, scene_.triangle, scene_.source.size());
    if (!status) return status;
    status = for_each_half_edge([&](std::uint32_t h) {
      if (codes_[h] >= 0) scene_.edge_beyond.push_back(beyond(h));
    });
    if (!status) return status;
    for (std::uint32_t t : scene_.source) {
      if (poll_.cancelled()) return context_.cancel_status();
      scene_.triangle.push_back(triangle(t));
    }
    return context_.check();
  }

  /// Lists the half-edges on which a watched segment lies and stops rays.
  Status watch(std::span<const std::uint8_t> is_watched) {
    for (std::uint32_t i = 0; i < scene_.source.size(); ++i) {
      if (poll_.cancelled()) return context_.cancel_status();
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t h = 3 * scene_.source[i] + k;
        if (codes_[h] >= 0 || !mesh_.has_segment(h, is_watched)) continue;
        Status status = scene_.memory.push_back(context_, scene_.watched, 3 * i + k);
        if (!status) return status;
      }
    }
    return ok_status();
  }

 private:
  Status order_triangles() {
    TableMemory scratch("the visibility mesh");
    std::vector<Vec2> center;
    Status status = scratch.resize(context_, center, mesh_.triangle_count());
    if (status) status = memory_.resize(context_, new_index_, mesh_.triangle_count());
    if (!status) return status;
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        center[t] = center[t] + mesh_.vertex_position[mesh_.origin(h)];
      }
    }
    status = spatial_order(context_, center, scene_.memory, scene_.source);
    if (!status) return status;
    for (std::uint32_t i = 0; i < scene_.source.size(); ++i) new_index_[scene_.source[i]] = i;
    return status;
  }

  /// Room for the hit edges of a triangle is made before its codes are asked for.
  Status find_codes() {
    for (std::uint32_t t : scene_.source) {
      if (poll_.cancelled()) return context_.cancel_status();
      Status status = scene_.memory.make_room(context_, scene_.hit_edge, 3);
      if (status) status = scene_.memory.make_room(context_, scene_.blend, 3);
      if (!status) return status;
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) codes_[h] = code(h);
    }
    return ok_status();
  }

  /// In the order of the scene's triangles.
  template <class Body>
  Status for_each_half_edge(Body body) {
    for (std::uint32_t t : scene_.source) {
      if (poll_.cancelled()) return context_.cancel_status();
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) body(h);
    }
    return ok_status();
  }

  float x(std::uint32_t vertex) const {
    return static_cast<float>(mesh_.vertex_position[vertex].x - scene_.origin.x);
  }
  float y(std::uint32_t vertex) const {
    return static_cast<float>(mesh_.vertex_position[vertex].y - scene_.origin.y);
  }

  EdgeCode code(std::uint32_t h) {
    if (mesh_.half_edge_constraint[h] != mesh::kNone) {
      const Facing facing = facing_side(mesh_, attributes_, h);
      if (facing.kind == ShaderKind::barrier) return kBorder;
      if (facing.kind != ShaderKind::open) {
        scene_.hit_edge.push_back(hit_edge_of(h, facing));
        scene_.blend.push_back(blend_of(h, facing));
        return hit_code(static_cast<std::uint32_t>(scene_.hit_edge.size() - 1));
      }
    }
    if (mesh_.half_edge_twin[h] == mesh::kNone) return kBorder;
    return static_cast<EdgeCode>(passage_count_++);
  }

  HitEdge hit_edge_of(std::uint32_t h, const Facing& facing) const {
    HitEdge edge{};
    edge.ax = x(mesh_.origin(h)), edge.ay = y(mesh_.origin(h));
    edge.bx = x(mesh_.target(h)), edge.by = y(mesh_.target(h));
    edge.ex = edge.bx - edge.ax, edge.ey = edge.by - edge.ay;
    edge.length_squared = edge.ex * edge.ex + edge.ey * edge.ey;
    edge.weight = facing.weight;
    set_values(facing, edge.middle, edge.half_change);
    return edge;
  }

  static void set_values(const Facing& facing, float (&middle)[kValueChannels],
                         float (&half_change)[kValueChannels]) {
    if (facing.kind != ShaderKind::curve_domain) return;
    const auto& from = facing.from.channel;
    const auto& to = facing.to.channel;
    for (std::size_t c = 0; c < kValueChannels; ++c) {
      middle[c] = 0.5f * (from[c] + to[c]);
      half_change[c] = 0.5f * (to[c] - from[c]);
    }
  }

  static std::int32_t shader_slot(const Facing& facing) {
    return facing.kind == ShaderKind::image_domain ? static_cast<std::int32_t>(facing.shader) : -1;
  }

  HitBlend blend_of(std::uint32_t h, const Facing& facing) {
    HitBlend blend{};
    blend.front_shader = shader_slot(facing);
    blend.back_shader = -1;
    const bool is_image = blend.front_shader >= 0;
    const bool asks_for_blur = facing.blur_from > 0 || facing.blur_to > 0;
    const Facing back = asks_for_blur ? back_side(mesh_, attributes_, h) : Facing{};
    is_plain_ = is_plain_ && !is_image && !back.has_value();
    if (!back.has_value()) return blend;
    const HitEdge& edge = scene_.hit_edge.back();
    blend.inverse_length = 1 / std::sqrt(edge.length_squared);
    blend.blur_middle = 0.5f * (facing.blur_from + facing.blur_to);
    blend.blur_half_change = 0.5f * (facing.blur_to - facing.blur_from);
    blend.back_shader = shader_slot(back);
    set_values(back, blend.back_middle, blend.back_half_change);
    return blend;
  }

  /// The kernel without blur and image-domain shaders is the faster one.
  void drop_blend_if_plain() {
    scene_.base_channels = attributes_.base_channels;
    scene_.shader_count = static_cast<int>(attributes_.shader.size());
    if (is_plain_) scene_.memory.free(scene_.blend);
  }

  // Only ratios of weights matter; the largest becomes 1, so that no sum overflows.
  void normalize_weights() {
    float largest = 0;
    for (const HitEdge& edge : scene_.hit_edge) largest = std::max(largest, edge.weight);
    if (!(largest > 0)) return;
    scene_.weight_unit = largest;
    for (std::size_t i = 0; i < scene_.hit_edge.size(); ++i) {
      HitEdge& edge = scene_.hit_edge[i];
      HitBlend& blend = scene_.blend[i];
      edge.weight /= largest;
      for (float* values :
           {edge.middle, edge.half_change, blend.back_middle, blend.back_half_change}) {
        for (int c = 0; c < kValueChannels; ++c) values[c] *= edge.weight;
      }
    }
  }

  EdgeBeyond beyond(std::uint32_t h) const {
    const auto twin = static_cast<std::uint32_t>(mesh_.half_edge_twin[h]);
    const std::uint32_t apex = mesh_.apex(twin);
    const Vec2 a = mesh_.vertex_position[mesh_.origin(h)] - scene_.origin;
    const Vec2 along = mesh_.vertex_position[mesh_.target(h)] - scene_.origin - a;
    const Vec2 normal = Vec2{-along.y, along.x} / length(along);
    const bool blind = blind_[h] != 0;
    return {x(apex),
            y(apex),
            blind ? kBorder : code_behind(next_half_edge(twin)),
            blind ? kBorder : code_behind(previous_half_edge(twin)),
            static_cast<float>(normal.x),
            static_cast<float>(normal.y),
            static_cast<float>(-dot(normal, a))};
  }

  /// Packets hold neighbours on both sides of a blind half-edge: SceneTriangle keeps its code.
  EdgeCode code_behind(std::uint32_t h) const { return blind_[h] ? kBorder : codes_[h]; }

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

  Context& context_;
  RarePoll<8192> poll_;
  const mesh::TriangleMesh& mesh_;
  const curves::SegmentAttributes& attributes_;
  Scene& scene_;
  TableMemory memory_{"the visibility mesh"};
  std::vector<std::uint32_t> new_index_;  ///< the inverse of Scene::source
  std::vector<EdgeCode> codes_;           ///< per half-edge of the mesh
  std::vector<std::uint8_t> blind_;       ///< per half-edge, see find_blind
  std::uint32_t passage_count_ = 0;
  bool is_plain_ = true;
};

}  // namespace

SceneView Scene::view() const {
  const auto triangle_count = static_cast<std::int64_t>(triangle.size());
  return {
      edge_beyond.data(), hit_edge.data(), blend.empty() ? nullptr : blend.data(), base_channels,
      shader_count,       triangle.data(), 64 * triangle_count + (1 << 20)};
}

Result<Scene> build_scene(Context& context, const mesh::TriangleMesh& mesh,
                          const curves::SegmentAttributes& attributes,
                          std::span<const std::uint8_t> is_watched) {
  Scene scene;
  SceneBuilder builder(context, mesh, attributes, scene);
  Status status = builder.build();
  if (status && !is_watched.empty()) status = builder.watch(is_watched);
  if (!status) return status;
  return scene;
}

}  // namespace sfumato::gather
