#include "gather/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/boxes.hpp"
#include "base/poll.hpp"
#include "base/spatial_order.hpp"
#include "base/try.hpp"
#include "gather/scene/blind.hpp"
#include "gather/scene/far_field.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::gather {
namespace {

/// One blind open side is accepted for this many hit edges.
constexpr std::size_t kHitsPerBlindSide = 16;

/// Room in the tables of a scene that is extended, for the edges of some changed triangles.
constexpr std::size_t kMoreEdges = 4096;

/// Adds the watched half-edges of triangle i to the scene's.
Status watch_triangle(const Context& context, const mesh::TriangleMesh& mesh,
                      std::span<const std::uint8_t> is_watched, std::uint32_t i, Scene& scene) {
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (scene.triangle[i].edge[k] >= 0) continue;
    if (!mesh.has_segment(3 * scene.source[i] + k, is_watched)) continue;
    SFUMATO_TRY(scene.memory.push_back(context, scene.watched, 3 * i + k));
  }
  return ok_status();
}

class SceneBuilder {
 public:
  SceneBuilder(Context& context, const mesh::TriangleMesh& mesh,
               const curves::SegmentAttributes& attributes, Scene& scene)
      : context_(context), poll_(context), mesh_(mesh), attributes_(attributes), scene_(scene) {}

  Status build(bool will_be_extended) {
    scene_.origin = center_of_mesh();
    const auto half_edge_count = static_cast<std::uint32_t>(mesh_.triangle_vertex.size());
    SFUMATO_TRY(order_triangles());
    SFUMATO_TRY(memory_.resize(context_, codes_, half_edge_count));
    SFUMATO_TRY(find_codes());
    SFUMATO_TRY(context_.check());
    set_weight_unit();
    normalize_weights(0);
    set_channels();
    drop_blend_if_plain();
    SFUMATO_TRY(look_for_blind(will_be_extended));
    SFUMATO_TRY(scene_.memory.reserve(context_, scene_.edge_beyond, passage_count_));
    SFUMATO_TRY(scene_.memory.reserve(context_, scene_.triangle, scene_.source.size()));
    SFUMATO_TRY(for_each_half_edge([&](std::uint32_t h) {
      if (codes_[h] >= 0) scene_.edge_beyond.push_back(beyond(h));
    }));
    for (std::uint32_t t : scene_.source) {
      if (poll_.cancelled()) return context_.cancel_status();
      scene_.triangle.push_back(triangle(t));
    }
    scene_.memory.free(scene_.index);
    return context_.check();
  }

  /// Does extend_scene(). Returns false where more would have to change.
  Result<bool> extend(const Scene& before, std::span<const std::uint8_t> is_watched,
                      std::span<const std::uint8_t> is_same) {
    if (before.hit_edge.empty() || before.needs_blind_edges || !has_channels_of(before) ||
        !(center_of_mesh() == before.origin)) {
      return false;
    }
    SFUMATO_TRY(scene_.is_extended ? take_back(before) : copy(before));
    begin_as(before);
    if (before.has_blind_edges) SFUMATO_TRY(see_through_blind_edges());
    SFUMATO_TRY(list_changed(is_same));
    for (const std::uint32_t t : changed_) {
      if (poll_.cancelled()) return context_.cancel_status();
      SFUMATO_TRY(find_codes_of(t));
    }
    for (std::size_t i = before.hit_edge.size(); i < scene_.hit_edge.size(); ++i)
      if (scene_.hit_edge[i].weight > before.weight_unit) return false;
    if (before.blend.empty() && !is_plain_) return false;
    normalize_weights(before.hit_edge.size());
    drop_blend_if_plain();
    SFUMATO_TRY(scene_.memory.resize(context_, scene_.edge_beyond, passage_count_));
    for (const std::uint32_t t : changed_) {
      if (poll_.cancelled()) return context_.cancel_status();
      SFUMATO_TRY(place_changed(t));
      if (is_watched.empty()) continue;
      SFUMATO_TRY(watch_triangle(context_, mesh_, is_watched, scene_.index[t], scene_));
    }
    scene_.is_extended = !before.has_blind_edges;
    return true;
  }

 private:
  bool has_channels_of(const Scene& before) const {
    return before.base_channels == attributes_.base_channels &&
           static_cast<std::size_t>(before.shader_count) == attributes_.shader.size();
  }

  Vec2 center_of_mesh() const {
    const Box box = box_of_points(mesh_.vertex_position);
    return box.empty() ? Vec2{} : box.center();
  }

  /// Works without blind edges, unless many sides of curves are open and nothing is seen through
  /// them, which makes a gather several times slower.
  Status look_for_blind(bool will_be_extended) {
    SFUMATO_TRY_ASSIGN(blind_, find_blind(context_, mesh_, codes_, memory_));
    std::size_t open_sides = 0;
    for (std::size_t h = 0; h < blind_.size(); ++h)
      open_sides += blind_[h] && mesh_.half_edge_constraint[h] != mesh::kNone;
    scene_.needs_blind_edges = open_sides > scene_.hit_edge.size() / kHitsPerBlindSide;
    scene_.has_blind_edges = !will_be_extended || scene_.needs_blind_edges;
    if (!scene_.has_blind_edges) std::ranges::fill(blind_, std::uint8_t{0});
    return context_.check();
  }

  /// Copies all tables of a scene except its watched half-edges, with room for the mesh's new
  /// triangles.
  Status copy(const Scene& before) {
    const std::size_t more = 3 * (mesh_.triangle_count() - before.triangle.size()) + kMoreEdges;
    Status status;
    const auto take = [&](const auto& from, auto& to, std::size_t room) {
      if (status) status = scene_.memory.assign(context_, from, to, room);
    };
    take(before.edge_beyond, scene_.edge_beyond, more);
    take(before.hit_edge, scene_.hit_edge, more);
    take(before.blend, scene_.blend, before.blend.empty() ? 0 : more);
    take(before.triangle, scene_.triangle, more);
    take(before.source, scene_.source, more);
    if (status) status = scene_.memory.reserve(context_, scene_.index, before.source.size() + more);
    if (status) status = scene_.memory.resize(context_, scene_.index, before.source.size());
    for (std::uint32_t i = 0; i < scene_.index.size(); ++i) scene_.index[scene_.source[i]] = i;
    scene_.changed.clear();
    return status;
  }

  /// Makes the tables of a scene that was made from `before` a copy of it.
  Status take_back(const Scene& before) {
    scene_.is_extended = false;
    scene_.edge_beyond.resize(before.edge_beyond.size());
    scene_.hit_edge.resize(before.hit_edge.size());
    scene_.blend.resize(before.blend.size());
    scene_.triangle.resize(before.triangle.size());
    scene_.source.resize(before.source.size());
    scene_.index.resize(before.source.size());
    for (const std::uint32_t i : scene_.changed) {
      if (poll_.cancelled()) return context_.cancel_status();
      if (i >= before.triangle.size()) continue;
      scene_.triangle[i] = before.triangle[i];
      for (const EdgeCode code : before.triangle[i].edge) {
        if (code < 0) continue;
        const auto passage = static_cast<std::size_t>(code);
        scene_.edge_beyond[passage] = before.edge_beyond[passage];
      }
    }
    scene_.changed.clear();
    return ok_status();
  }

  /// Copies the rest, except the watched half-edges. Call it after that.
  void begin_as(const Scene& before) {
    scene_.watched.clear();
    scene_.has_blind_edges = scene_.needs_blind_edges = false;
    scene_.origin = before.origin;
    scene_.weight_unit = before.weight_unit;
    passage_count_ = static_cast<std::uint32_t>(before.edge_beyond.size());
    is_plain_ = before.blend.empty();
    set_channels();
  }

  /// Gives each passage the codes of the edges behind it.
  Status see_through_blind_edges() {
    for (const SceneTriangle& from : scene_.triangle) {
      if (poll_.cancelled()) return context_.cancel_status();
      for (std::uint32_t k = 0; k < 3; ++k) {
        if (from.edge[k] < 0) continue;
        const auto twin = static_cast<std::uint32_t>(from.twin[k]);
        const SceneTriangle& behind = scene_.triangle[twin / 3];
        EdgeBeyond& passage = scene_.edge_beyond[static_cast<std::size_t>(from.edge[k])];
        passage.right = behind.edge[(twin + 1) % 3];
        passage.left = behind.edge[(twin + 2) % 3];
      }
    }
    return ok_status();
  }

  /// Lists changed triangles. New triangles come last, in their own order.
  Status list_changed(std::span<const std::uint8_t> is_same) {
    const std::uint32_t count = mesh_.triangle_count();
    const auto first_new = static_cast<std::uint32_t>(scene_.source.size());
    SFUMATO_TRY(scene_.memory.resize_all(context_, count, scene_.triangle, scene_.source));
    SFUMATO_TRY(scene_.memory.resize(context_, scene_.index, count));
    std::iota(scene_.source.begin() + first_new, scene_.source.end(), first_new);
    std::iota(scene_.index.begin() + first_new, scene_.index.end(), first_new);
    for (std::uint32_t t = 0; t < count; ++t) {
      if (t < is_same.size() && is_same[t]) continue;
      SFUMATO_TRY(memory_.push_back(context_, changed_, t));
    }
    return ok_status();
  }

  /// Updates a triangle that changed, and its neighbours' entries about it.
  Status place_changed(std::uint32_t t) {
    SFUMATO_TRY(scene_.memory.make_room(context_, scene_.changed, 4));
    place(t);
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      place_passage(h);
      if (mesh_.half_edge_twin[h] == mesh::kNone) continue;
      const auto twin = static_cast<std::uint32_t>(mesh_.half_edge_twin[h]);
      place(twin / 3);
      place_passage(twin);
    }
    return ok_status();
  }

  void place(std::uint32_t t) {
    scene_.triangle[scene_.index[t]] = triangle(t);
    scene_.changed.push_back(scene_.index[t]);
  }

  void place_passage(std::uint32_t h) {
    const EdgeCode code = code_at(h);
    if (code >= 0) scene_.edge_beyond[static_cast<std::size_t>(code)] = beyond(h);
  }

  Status order_triangles() {
    TableMemory scratch("the visibility mesh");
    std::vector<Vec2> center;
    SFUMATO_TRY(scratch.resize(context_, center, mesh_.triangle_count()));
    SFUMATO_TRY(scene_.memory.resize(context_, scene_.index, mesh_.triangle_count()));
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        center[t] = center[t] + mesh_.vertex_position[mesh_.origin(h)];
      }
    }
    SFUMATO_TRY(spatial_order(context_, center, scene_.memory, scene_.source));
    for (std::uint32_t i = 0; i < scene_.source.size(); ++i) scene_.index[scene_.source[i]] = i;
    return ok_status();
  }

  Status find_codes() {
    for (std::uint32_t t : scene_.source) {
      if (poll_.cancelled()) return context_.cancel_status();
      SFUMATO_TRY(find_codes_of(t));
    }
    return ok_status();
  }

  /// Makes room for the hit edges of a triangle before its codes are computed.
  Status find_codes_of(std::uint32_t t) {
    SFUMATO_TRY(scene_.memory.make_room(context_, scene_.hit_edge, 3));
    SFUMATO_TRY(scene_.memory.make_room(context_, scene_.blend, 3));
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) code_at(h) = code(h);
    return ok_status();
  }

  /// Visits half-edges in the order of the scene's triangles.
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

  /// Drops the blends of a plain scene: the kernel without blur and image-domain shaders is faster.
  void drop_blend_if_plain() {
    if (is_plain_) scene_.memory.free(scene_.blend);
  }

  void set_channels() {
    scene_.base_channels = attributes_.base_channels;
    scene_.shader_count = static_cast<int>(attributes_.shader.size());
  }

  // Sets the unit of weights. Only ratios of weights matter; the largest becomes 1, so that no sum
  // overflows.
  void set_weight_unit() {
    float largest = 0;
    for (const HitEdge& edge : scene_.hit_edge) largest = std::max(largest, edge.weight);
    if (largest > 0) scene_.weight_unit = largest;
  }

  /// Normalizes the weights of the hit edges from `first` on. The last blends belong to them.
  void normalize_weights(std::size_t first) {
    const std::size_t blends_before = scene_.hit_edge.size() - scene_.blend.size();
    for (std::size_t i = first; i < scene_.hit_edge.size(); ++i) {
      HitEdge& edge = scene_.hit_edge[i];
      HitBlend& blend = scene_.blend[i - blends_before];
      edge.weight /= scene_.weight_unit;
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
    const bool blind = is_blind(h);
    return {x(apex),
            y(apex),
            blind ? kBorder : code_behind(next_half_edge(twin)),
            blind ? kBorder : code_behind(previous_half_edge(twin)),
            static_cast<float>(normal.x),
            static_cast<float>(normal.y),
            static_cast<float>(-dot(normal, a))};
  }

  /// Returns the code of a half-edge. Packets contain neighbours on both sides of a blind
  /// half-edge: SceneTriangle keeps its code.
  EdgeCode code_behind(std::uint32_t h) const { return is_blind(h) ? kBorder : code_at(h); }
  bool is_blind(std::uint32_t h) const { return !blind_.empty() && blind_[h] != 0; }

  /// Returns the code of a half-edge of the mesh: while a scene is built its triangles do not exist
  /// yet.
  EdgeCode code_at(std::uint32_t h) const {
    return codes_.empty() ? scene_.triangle[scene_.index[h / 3]].edge[h % 3] : codes_[h];
  }
  EdgeCode& code_at(std::uint32_t h) {
    return codes_.empty() ? scene_.triangle[scene_.index[h / 3]].edge[h % 3] : codes_[h];
  }

  SceneTriangle triangle(std::uint32_t t) const {
    SceneTriangle triangle{};
    for (std::uint32_t k = 0; k < 3; ++k) {
      triangle.x[k] = x(mesh_.origin(3 * t + k));
      triangle.y[k] = y(mesh_.origin(3 * t + k));
      triangle.edge[k] = code_at(3 * t + k);
      const std::int32_t twin = mesh_.half_edge_twin[3 * t + k];
      triangle.twin[k] = -1;
      if (twin != mesh::kNone) {
        const auto h = static_cast<std::uint32_t>(twin);
        triangle.twin[k] = static_cast<std::int32_t>(3 * scene_.index[h / 3] + h % 3);
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
  std::vector<EdgeCode> codes_;      ///< per half-edge of the mesh; empty where extended
  std::vector<std::uint8_t> blind_;  ///< per half-edge, see find_blind; also empty where extended
  std::vector<std::uint32_t> changed_;  ///< for extend(): triangles that changed
  std::uint32_t passage_count_ = 0;
  bool is_plain_ = true;
};

}  // namespace

SceneView Scene::view() const {
  const auto triangle_count = static_cast<std::int64_t>(triangle.size());
  SceneView view{
      edge_beyond.data(), hit_edge.data(), blend.empty() ? nullptr : blend.data(), base_channels,
      shader_count,       triangle.data(), 64 * triangle_count + (1 << 20)};
  view.far = far;
  view.negligible = negligible;
  if (!far_mean.empty()) view.far.mean = far_mean.data();
  return view;
}

Result<Scene> build_scene(Context& context, const mesh::TriangleMesh& mesh,
                          const curves::SegmentAttributes& attributes, const GatherUse& use) {
  Scene scene;
  scene.negligible = use.negligible;
  SceneBuilder builder(context, mesh, attributes, scene);
  SFUMATO_TRY(builder.build(use.will_be_extended));
  if (!use.is_watched.empty()) SFUMATO_TRY(watch(context, mesh, use.is_watched, scene));
  const bool is_for_changes = use.will_be_extended || !use.is_watched.empty();
  if (!is_for_changes) SFUMATO_TRY(add_far_field(context, scene));
  return scene;
}

Status watch(const Context& context, const mesh::TriangleMesh& mesh,
             std::span<const std::uint8_t> is_watched, Scene& scene) {
  scene.watched.clear();
  RarePoll<8192> poll(context);
  for (std::uint32_t i = 0; i < scene.source.size(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    SFUMATO_TRY(watch_triangle(context, mesh, is_watched, i, scene));
  }
  return ok_status();
}

Result<std::optional<Scene>> extend_scene(Context& context, const mesh::TriangleMesh& mesh,
                                          const curves::SegmentAttributes& attributes,
                                          std::span<const std::uint8_t> is_watched,
                                          const Scene& before,
                                          std::span<const std::uint8_t> is_same, Scene* used) {
  std::optional<Scene> scene(std::in_place);
  if (used) scene.emplace(std::move(*used));
  SFUMATO_TRY_ASSIGN(
      const bool is_done,
      SceneBuilder(context, mesh, attributes, *scene).extend(before, is_watched, is_same));
  if (!is_done) scene.reset();
  return scene;
}

}  // namespace sfumato::gather
