#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "gather/kernels/scene_layout.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::gather {

/// The curve that a ray meets at a constrained edge, seen from one side. If several pieces lie on
/// the edge, this is the curve drawn last among those whose facing side is not open. If that curve
/// overlaps itself there, it is the passage that reached farthest to this side before welding; of
/// equal passages, the last.
struct Facing {
  ShaderKind kind = ShaderKind::open;
  std::uint32_t shader = 0;
  curves::FieldValue from;  ///< value at the start of the *half-edge* (its origin)
  curves::FieldValue to;    ///< value at its target
  float weight = 1;
  float blur_from = 0;  ///< blur radius at the origin, user units; 0: sharp
  float blur_to = 0;
  float fine_from = 0;  ///< SegmentSide::fine_radius
  float fine_to = 0;

  bool has_value() const {
    return kind == ShaderKind::curve_domain || kind == ShaderKind::image_domain;
  }
};

/// Returns the owner of the side of half-edge h that h's own triangle lies on. Precondition: h is
/// constrained.
Facing facing_side(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
                   std::uint32_t half_edge);

/// Returns z_B of eq. 7: the value of the edge's other side. Not has_value() if there is nothing to
/// blur with.
Facing back_side(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
                 std::uint32_t half_edge);

/// The visibility mesh in the layout of the gather: single-precision coordinates relative to
/// `origin`. Half-edges whose facing side is open are walked through. Triangles are sorted so that
/// neighbours are also near in memory, because memory access limits the speed of a walk.
struct Scene {
  /// Set by a Gatherer: while a pointer to it exists, no other scene has the same.
  std::shared_ptr<const char> identity{};
  Vec2 origin;                          ///< layer frame
  std::vector<EdgeBeyond> edge_beyond;  ///< for half-edges that rays walk through
  std::vector<HitEdge> hit_edge;
  std::vector<HitBlend> blend;  ///< per hit edge; empty where all sides are sharp and curve_domain
  float weight_unit = 1;        ///< the largest weight k; weights are in units of it
  int base_channels = 3;        ///< as SegmentAttributes
  int shader_count = 0;
  std::vector<SceneTriangle> triangle;
  std::vector<std::uint32_t> source;  ///< per triangle: its index in the visibility mesh
  /// Only after extend_scene(): the inverse of `source`, and the triangles that changed from the
  /// earlier scene, some of them twice.
  std::vector<std::uint32_t> index;
  std::vector<std::uint32_t> changed;
  bool is_extended = false;      ///< apart from these, only appended entries differ
  bool has_blind_edges = false;  ///< rays may end at passages with nothing behind them (find_blind)
  bool needs_blind_edges = false;  ///< without them a gather would be much slower
  /// Half-edges, 3 · triangle + corner, that stop rays and on which a watched segment lies.
  std::vector<std::uint32_t> watched;
  FarField far;                 ///< `mean` is null here
  std::vector<float> far_mean;  ///< for `far`; empty: there is none (add_far_field)
  TableMemory memory{"the visibility mesh"};

  float negligible = kNegligible;  ///< as SceneView

  SceneView view() const;
  int channel_count() const { return base_channels + shader_count; }
};

/// The uses of a scene beside gathering.
struct GatherUse {
  std::span<const std::uint8_t> is_watched{};  ///< per segment; empty: none is
  /// Leaves out the tables that are only valid until a curve is inserted, unless a gather would be
  /// much slower: see extend_scene.
  bool will_be_extended = false;
  bool may_be_changed = false;     ///< free ends keep the tables that FreeEnds::extend needs
  float negligible = kNegligible;  ///< as SceneView
  /// An attribute of the same curves, or null: free ends also count where this attribute differs,
  /// as in a field of both.
  const curves::SegmentAttributes* beside = nullptr;
};

/// Builds a scene. Errors: limit, cancelled.
Result<Scene> build_scene(Context& context, const mesh::TriangleMesh& mesh,
                          const curves::SegmentAttributes& attributes, const GatherUse& use = {});

/// Watches these segments from now on, instead of others.
///
/// mesh     of the scene
/// Errors   limit (memory), cancelled
Status watch(const Context& context, const mesh::TriangleMesh& mesh,
             std::span<const std::uint8_t> is_watched, Scene& scene);

/// Makes, from a copy of `before`, the scene of a mesh where the watched segments were inserted
/// since, or segments were removed (is_watched is then empty). Triangles keep their indices. Tables
/// that are only valid until a curve is inserted are left out.
///
/// is_same   per triangle of the mesh of `before`: 1 where this one has the same at the same index
/// attributes   as they were for `before`, followed by the inserted segments
/// used      a scene that was made from `before`, whose tables this one reuses, or null
/// Returns   nothing where more would have to change: `before` needs its blind edges, a layer is no
///           longer sharp, there are other channels, or the weights need another unit
/// Errors    limit, cancelled
/// Cost      that of the copy, or of the changes in the one that is used; O(triangles)
Result<std::optional<Scene>> extend_scene(Context& context, const mesh::TriangleMesh& mesh,
                                          const curves::SegmentAttributes& attributes,
                                          std::span<const std::uint8_t> is_watched,
                                          const Scene& before,
                                          std::span<const std::uint8_t> is_same,
                                          Scene* used = nullptr);

}  // namespace sfumato::gather
