#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "gather/point_list.hpp"
#include "gather/scene/scene.hpp"
#include "gather/scene/share_bound.hpp"
#include "sfumato/gather/options.hpp"

namespace sfumato::gather {

class FreeEnds;
class Gatherer;

/// How a mesh was made from another one by inserting the watched segments, or by removing them.
struct MeshChange {
  /// The gatherer of that mesh, made with will_be_extended or may_be_changed, or by such a change;
  /// null: none.
  const Gatherer* before = nullptr;
  /// Per triangle of that mesh: 1 where the present one has the same at the same index.
  std::span<const std::uint8_t> is_same{};
  Gatherer* used = nullptr;  ///< a gatherer whose tables the new one reuses, or null
  /// That mesh, where segments were removed: call forget_before() then.
  const mesh::TriangleMesh* whole = nullptr;
};

/// Stands for an unknown triangle of the visibility mesh.
inline constexpr std::uint32_t kUnknownPlace = 0xffffffff;

/// The points in each triangle of a visibility mesh.
struct PointPlaces {
  std::vector<std::uint32_t> begin{};  ///< per triangle, and one more: into `slot`
  std::vector<std::uint32_t> slot{};
  TableMemory memory{"the places of points"};
};

/// How much an insertion may change at points that were gathered without it.
struct InsertedShare {
  const ShareBound& bound;
  std::span<const std::uint8_t>
      weight;  ///< per slot: the weight_class() of the weight gathered there
};

/// The places of points in the visibility mesh of one gatherer, and how that mesh became another's.
struct KnownPlaces {
  const PointPlaces& points;  ///< from its locate()
  /// Per triangle of its mesh: 1 where the other one has the same at the same index.
  std::span<const std::uint8_t> is_same;
  const ShareBound* bound = nullptr;  ///< for the inserted curves, or null
  /// Per slot: the weight_class() of the weight gathered there.
  std::span<const std::uint8_t> weight{};
};

/// Gathers one attribute at points (paper eq. 2–11), in closed form over the exact visible set, or
/// by Monte Carlo rays. Holds the data of one visibility mesh that both methods need.
///
/// Channels of a gathered value: Z_C / W (SegmentAttributes::base_channels of them), then one W_s /
/// W for each of SegmentAttributes::shader.
class Gatherer {
 public:
  /// Makes a gatherer. `visibility` is validated; it is read, not kept. `ends`: the terms of free
  /// ends. `change` saves work; list_changes() needs its data about the gatherer before. Errors:
  /// limit, cancelled.
  static Result<Gatherer> create(Context& context, const mesh::TriangleMesh& visibility,
                                 const curves::SegmentAttributes& attributes,
                                 Ends ends = Ends::paper, const GatherUse& use = {},
                                 const MeshChange& change = {});

  Gatherer(Gatherer&&) noexcept;
  Gatherer& operator=(Gatherer&&) noexcept;
  ~Gatherer();

  /// Releases the data about the change that made this. Call it before another gatherer is made
  /// from this.
  void forget_before();

  /// Watches these segments until forget_watched(). Precondition: none is watched, and visibility
  /// is as it was for create(). Errors: limit (memory), cancelled.
  Status watch(const Context& context, const mesh::TriangleMesh& visibility,
               std::span<const std::uint8_t> is_watched);
  void forget_watched();

  /// Does TableMemory::leave_budget() for all tables.
  std::size_t leave_budget();

  int channel_count() const;

  /// Returns the largest weight of the curves; W and ShareBound's weights are in units of it.
  float weight_unit() const;

  /// Gathers at points.
  ///
  /// points   layer frame, inside the visibility mesh's hull; neighbours in the list, and points of
  ///          a group, should be neighbours in the plane. Not on a curve that has the attribute,
  ///          nor on a vertex.
  /// out      channel_count() floats per slot. Where nothing is hit: 0.
  /// hit      optional, per slot: 1 where any ray hits, else 0.
  /// weighs   `hit` gets weight_class() of W instead of 1, where the method is exact
  /// place    optional, per slot: the triangle of the visibility mesh that contains it, where the
  ///          method is exact
  /// Errors   limit, cancelled (out unspecified). The same bits for any thread count and SIMD
  ///          level.
  Status gather(Context& context, const PointList& points, const GatherOptions& options,
                std::span<float> out, std::span<std::uint8_t> hit = {}, bool weighs = false,
                std::span<std::uint32_t> place = {}) const;

  /// Locates points in the visibility mesh. Points as in gather().
  ///
  /// known    per slot: the triangle, or kUnknownPlace; slots beyond its end are unknown
  /// Errors   limit (memory), cancelled
  Result<PointPlaces> locate(Context& context, const PointList& points,
                             std::span<const std::uint32_t> known = {}) const;

  /// Sets may_differ[slot] to 1 for points where gather() may give another value than that of
  /// `before`, where the two meshes, on one lattice, differ by the watched segments of either.
  /// Never too few, except for moves by the weld. Other slots stay unchanged. Points as in
  /// gather(). Errors: limit (memory), cancelled.
  ///
  /// inserted   unless null: leaves out points that see it where its bound holds; none is marked
  /// yet
  Status find_changes(Context& context, const Gatherer& before, const PointList& points,
                      std::span<std::uint8_t> may_differ,
                      const InsertedShare* inserted = nullptr) const;

  /// Lists such slots, each once, among points whose places are known, where the meshes differ only
  /// by this one's watched segments, whichever was first; with a bound, without the slots where the
  /// bound proves that the change is too small to matter. The list is allocated from `memory`.
  /// Errors: limit (memory), cancelled. Cost: O(triangles of the visibility mesh), and the points
  /// that may differ.
  Status list_changes(Context& context, const Gatherer& before, std::span<const Vec2> position,
                      const KnownPlaces& known, TableMemory& memory,
                      std::vector<std::uint32_t>& changed) const;

  /// Sets depends[slot] to 1 for points whose value in a base channel may be other than 0, where
  /// only watched segments have one there. Never too few. Other slots stay unchanged. Points as in
  /// gather(). Errors: limit (memory), cancelled.
  Status find_dependents(Context& context, const PointList& points, int channel,
                         std::span<std::uint8_t> depends) const;

 private:
  struct State;
  Result<std::vector<std::uint32_t>> triangles_of(Context& context, const PointList& points,
                                                  std::span<const std::uint32_t> known,
                                                  TableMemory& memory) const;
  static Status mark_reached(Context& context, const State& state, const FreeEnds& ends,
                             const PointList& points, std::span<std::uint8_t> reached);
  static Status mark_viewers(Context& context, const State& state, const PointList& points,
                             std::span<std::uint8_t> sees);
  explicit Gatherer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace sfumato::gather
