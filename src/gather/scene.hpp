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

/// The owner of the side of half-edge h on which h's own triangle lies. Precondition: h is
/// constrained.
Facing facing_side(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
                   std::uint32_t half_edge);

/// z_B of eq. 7: the value of the edge's other side. Not has_value() if there is nothing to blur
/// with.
Facing back_side(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
                 std::uint32_t half_edge);

/// The visibility mesh in the layout of the gather: single-precision coordinates relative to
/// `origin`. Half-edges whose facing side is open are walked through. Triangles have an order of
/// their own, in which neighbours are also near in memory, because memory access limits the speed
/// of a walk.
struct Scene {
  /// Of a Gatherer's: while anybody holds it, no other scene has the same.
  std::shared_ptr<const char> identity{};
  Vec2 origin;                          ///< layer frame
  std::vector<EdgeBeyond> edge_beyond;  ///< of half-edges that rays walk through
  std::vector<HitEdge> hit_edge;
  std::vector<HitBlend> blend;  ///< per hit edge; empty where all sides are sharp and curve_domain
  float weight_unit = 1;        ///< the largest weight k; weights are in units of it
  int base_channels = 3;        ///< as SegmentAttributes
  int shader_count = 0;
  std::vector<SceneTriangle> triangle;
  std::vector<std::uint32_t> source;  ///< per triangle: which of the visibility mesh it is
  /// Of a scene that came by extend_scene(): the inverse of `source`, and the triangles that are
  /// not as in the scene that it was made from, some of them twice.
  std::vector<std::uint32_t> index;
  std::vector<std::uint32_t> changed;
  bool is_extended = false;      ///< nothing else differs from that scene but what comes behind it
  bool has_blind_edges = false;  ///< rays may end at passages behind which nothing is (find_blind)
  bool needs_blind_edges = false;  ///< without them a gather would be much the slower
  /// Half-edges, 3 · triangle + corner, that stop rays and on which a watched segment lies.
  std::vector<std::uint32_t> watched;
  FarField far;                 ///< `mean` is null here
  std::vector<float> far_mean;  ///< of `far`; empty: there is none (add_far_field)
  TableMemory memory{"the visibility mesh"};

  SceneView view() const;
  int channel_count() const { return base_channels + shader_count; }
};

/// What a scene is for, beside being gathered from.
struct GatherUse {
  std::span<const std::uint8_t> is_watched{};  ///< per segment; empty: none is
  /// What only holds as long as no curve is inserted is left out, unless a gather would be much the
  /// slower: see extend_scene.
  bool will_be_extended = false;
  bool may_be_changed = false;  ///< free ends keep what FreeEnds::extend asks for
  /// Of the same curves, unless null: free ends count where this attribute differs, too, as they do
  /// for a field of both.
  const curves::SegmentAttributes* beside = nullptr;
};

/// Errors: limit, cancelled.
Result<Scene> build_scene(Context& context, const mesh::TriangleMesh& mesh,
                          const curves::SegmentAttributes& attributes, const GatherUse& use = {});

/// These segments are watched from now on, in place of others.
/// mesh     of the scene
/// Errors   limit (memory), cancelled
Status watch(const Context& context, const mesh::TriangleMesh& mesh,
             std::span<const std::uint8_t> is_watched, Scene& scene);

/// Makes a copy of `before` the scene of a mesh into which the watched segments were inserted
/// since, or out of which segments were taken (is_watched is empty then). Triangles keep their
/// indices. What only holds as long as no curve is inserted is left out.
/// is_same   per triangle of the mesh of `before`: 1 where this one has the same at the same index
/// attributes   as they were for `before`, and those of the inserted segments
/// used      a scene that was made from `before`, whose tables are taken for this one's, or null
/// Returns   nothing where more would have to change: `before` needs its blind edges, a layer that
///           was sharp is no more, there are other channels, or the weights need another unit
/// Errors    limit, cancelled
/// Cost      that of the copy, or of what changes in the one that is used; O(triangles)
Result<std::optional<Scene>> extend_scene(Context& context, const mesh::TriangleMesh& mesh,
                                          const curves::SegmentAttributes& attributes,
                                          std::span<const std::uint8_t> is_watched,
                                          const Scene& before,
                                          std::span<const std::uint8_t> is_same,
                                          Scene* used = nullptr);

}  // namespace sfumato::gather
