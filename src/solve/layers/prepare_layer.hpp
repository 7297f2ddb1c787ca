#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "mesh/mesher.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "solve/fields/field_solver.hpp"

namespace sfumato::solve {

/// A layer's curves as polylines, and their visibility mesh.
struct FlatMesh {
  curves::FlatCurves flat;
  ScopedCharge charge;      ///< for the polylines
  mesh::Mesher mesher;      ///< not refined
  mesh::TriangleMesh mesh;  ///< returned by the mesher
};

/// A layer's curves as polylines.
struct ChargedCurves {
  curves::FlatCurves flat;
  ScopedCharge charge;
};

/// Triangles without an edge longer than this are not made smaller, layer units.
struct SmallestEdges {
  double missed;   ///< where the patch misses the exact values
  double blurred;  ///< where a blur has a smaller radius
};

/// The first step of every way to evaluate a layer: its curves flattened, meshed and prepared for
/// gathering.
struct PreparedLayer {
  mesh::Mesher mesher;
  PreparedField color;
  /// Present if any curve has opacity and `color` does not contain it.
  std::optional<PreparedField> opacity;
  Box frame;  ///< the area of the patch mesh, layer frame
  SmallestEdges smallest_edges;
  bool is_mesh_refined = false;          ///< Mesher::refine was called
  bool is_exact = false;                 ///< to be gathered at its pixels
  std::optional<FlatMesh> flat_mesh{};   ///< for LayerUse::drags
  std::optional<ChargedCurves> bowed{};  ///< the polylines with their bows, if those are kept
};

/// The view of some instances on a layer.
struct LayerView {
  Box window;    ///< the part of the layer frame that they bring into the viewport
  double scale;  ///< artboard units per layer unit, for the instance that enlarges it most

  friend bool operator==(const LayerView&, const LayerView&) = default;
};

/// The view of all instances on a layer.
struct LayerSight {
  Box viewport;      ///< the part of the layer frame that any instance brings into the viewport
  double scale = 1;  ///< artboard units per layer unit, for the instance that enlarges it most
  std::vector<LayerView> views{};  ///< instances whose scales share a power of two are combined
  std::size_t instance_count = 0;

  friend bool operator==(const LayerSight&, const LayerSight&) = default;
};

/// Returns the sight of a layer. Empty viewport: no instance shows a part of the layer.
LayerSight sight_of_layer(const Document& document, std::uint32_t layer, const Box& viewport);

/// Returns sight_of_layer() of every layer. Errors: limit (memory), cancelled. Cost: O(stack
/// items).
Result<std::vector<LayerSight>> sights_of_layers(const Context& context, const Document& document,
                                                 const Box& viewport);

/// The purpose of the preparation. points: exact values at single points. patches: one field may
/// hold colour and opacity if the same curves have both, and blur radii too small for the mesh are
/// treated as fine ones. drags: as patches, and keeps the tables that drags start from.
enum class LayerUse : std::uint8_t { points, patches, drags };

/// A layer's curves as polylines, with the other parts of the document that its fields need.
struct FlatLayer {
  const curves::FlatCurves& flat;
  std::span<const Curve> curves;
  InterpolationSpace interpolation = InterpolationSpace::srgb;
  bool is_joint = false;     ///< one field holds colour and opacity: opacity_goes_with_color
  bool has_opacity = false;  ///< there is a field of opacity, although none of these curves has it
};

/// One attribute, before its gatherer is made.
struct SampledField {
  curves::SegmentAttributes attributes;
  TableMemory memory;  ///< of the attributes
};

struct SampledFields {
  SampledField color;
  std::optional<SampledField> opacity;  ///< as PreparedLayer
};

struct PreparedFields {
  PreparedField color;
  std::optional<PreparedField> opacity;  ///< as PreparedLayer
};

class LayerUnits;

/// Flattens a layer. Errors: limit (an instance shows more of its layer than coordinates reach,
/// memory, counts), cancelled.
Result<curves::FlatCurves> flatten_layer(Context& context, const Layer& layer,
                                         const LayerSight& sight, const LayerUnits& units);

/// Samples the fields.
///
/// fine_radius   blurs of at most this radius become fine ones; empty: none do
/// Errors        limit (memory), cancelled
Result<SampledFields> sample_fields(const Context& context, const FlatLayer& layer,
                                    const DiffuseOptions& options,
                                    std::optional<double> fine_radius);

/// The data for fields of a mesh that was edited or will be.
struct FieldEdits {
  gather::GatherUse use{};  ///< without `beside`
  /// The field of the mesh before the watched segments were inserted or removed; null: no change,
  /// or there is no such field.
  const PreparedField* color_before = nullptr;
  const PreparedField* opacity_before = nullptr;
  std::span<const std::uint8_t> is_same{};  ///< as gather::MeshChange
  /// The field of the last frame, whose tables are reused; null or empty: none.
  std::optional<PreparedField>* color_used = nullptr;
  std::optional<PreparedField>* opacity_used = nullptr;
  const mesh::TriangleMesh* whole = nullptr;  ///< as gather::MeshChange
  /// Whether the layer has one field elsewhere, and two here: free ends then count as they do
  /// there.
  bool is_parted = false;
};

/// Prepares the fields.
///
/// visibility   mesher.visibility_mesh()
/// Errors       limit, cancelled
Result<PreparedFields> prepare_fields(Context& context, const mesh::Mesher& mesher,
                                      const mesh::TriangleMesh& visibility, SampledFields sampled,
                                      gather::Ends ends, const FieldEdits& edits = {});

/// Prepares a layer. Adds to `stats` if not null. Errors: limit (an instance shows more of its
/// layer than coordinates reach, memory, counts), cancelled.
///
/// side_by_side   for patches: refines the mesh while the fields are prepared, which takes more
///                memory at a time
Result<PreparedLayer> prepare_layer(Context& context, const Document& document, std::uint32_t layer,
                                    const LayerSight& sight, const DiffuseOptions& options,
                                    DiffuseStats* stats, LayerUse use = LayerUse::points,
                                    bool side_by_side = false);

/// Checks that the lengths and counts in the options are within their ranges.
Status validate(const DiffuseOptions& options);

}  // namespace sfumato::solve
