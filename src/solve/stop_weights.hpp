#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/document/stop_place.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::solve {

/// A sparse matrix by rows, one to a point: how much each stop counts there. With the columns'
/// values, rows give what PointEvaluator gives, but for paints.
struct WeightRows {
  std::vector<std::uint32_t> begin;   ///< per point, and one more: into `column` and `weight`
  std::vector<std::uint32_t> column;  ///< ascending in a row
  std::vector<float> weight;
  std::vector<float> paint;  ///< per point: the weight of each of StopWeights::shaders()
  TableMemory memory{"weights of stops"};
};

/// The linear map from the stops of one attribute of a layer to its values at points: gather::Rows
/// with the blur as it is.
class StopWeights {
 public:
  /// Of the options those count that PointEvaluator::create() heeds, but Ends: free ends are soft.
  /// The document is valid. Errors: bad_input (options), limit, cancelled. Cost: flattening and the
  /// triangulation of all curves, O(n log n) in their segments.
  static Result<StopWeights> create(Context& context, const Document& document, std::uint32_t layer,
                                    StopAttribute attribute, const DiffuseOptions& options);

  /// Columns: the stops that curves::stop_count() counts, in that order.
  std::uint32_t column_count() const { return column_count_; }
  /// What sides show beside stops, as indices into Document::shaders.
  std::span<const std::uint32_t> shaders() const { return places_.shader; }

  /// points      layer frame, as for PointEvaluator::evaluate(). One that sees nothing has a row
  ///             without entries, and no paint.
  /// negligible  0 to 1: what counts less for a point may be left out; the rest is scaled up
  /// Errors      bad_input (a point outside what was prepared), limit (memory, 4 billion entries),
  ///             cancelled
  /// Cost        2 to 5 microseconds of CPU a point and O(triangles), on the pool; the same bits
  ///             for any number of threads
  Result<WeightRows> at(Context& context, std::span<const Vec2> points, float negligible) const;

 private:
  std::uint32_t column_count_ = 0;
  Box frame_;                         ///< where points may lie; empty: nothing of the layer shows
  mesh::TriangleMesh mesh_;           ///< the visibility mesh
  curves::SegmentAttributes values_;  ///< of the attribute
  curves::SegmentAttributes places_;  ///< curves::sample_stop_places()
  TableMemory memory_{"weights of stops"};
};

}  // namespace sfumato::solve
