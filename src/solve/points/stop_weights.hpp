#pragma once

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

/// A sparse matrix by rows, one for each point: the weight of each stop there. Multiplied by the
/// columns' values, rows give the results of PointEvaluator, except for paints.
struct WeightRows {
  std::vector<std::uint32_t> begin;   ///< per point, and one more: into `column` and `weight`
  std::vector<std::uint32_t> column;  ///< ascending in a row
  std::vector<float> weight;
  std::vector<float> paint;  ///< per point: the weight of each of StopWeights::shaders()
  TableMemory memory{"weights of stops"};
};

/// The linear map from the stops of one attribute of a layer to its values at points: gather::Rows
/// with the present blur.
class StopWeights {
 public:
  /// Prepares a layer. The options of PointEvaluator::create() count, except Ends: free ends are
  /// soft. The document is valid. Errors: bad_input (options), limit, cancelled. Cost: flattening
  /// and triangulating all curves, O(n log n) in their segments.
  static Result<StopWeights> create(Context& context, const Document& document, std::uint32_t layer,
                                    StopAttribute attribute, const DiffuseOptions& options);

  /// Returns the number of columns: the stops that curves::stop_count() counts, in that order.
  std::uint32_t column_count() const { return column_count_; }
  /// Returns the shaders of sides without stops, as indices into Document::shaders.
  std::span<const std::uint32_t> shaders() const { return places_.shader; }

  /// Returns the rows of points.
  ///
  /// points      layer frame, as for PointEvaluator::evaluate(). One that sees nothing has a row
  ///             without entries, and no paint.
  /// negligible  0 to 1: smaller weights may be left out for a point; the rest is scaled up
  /// Errors      bad_input (a point outside the prepared box), limit (memory, 4 billion entries),
  ///             cancelled
  /// Cost        2 to 5 microseconds of CPU a point and O(triangles), on the pool; the same bits
  ///             for any number of threads
  Result<WeightRows> at(Context& context, std::span<const Vec2> points, float negligible) const;

 private:
  std::uint32_t column_count_ = 0;
  Box frame_;  ///< the box that contains all points; empty: no part of the layer is visible
  mesh::TriangleMesh mesh_;           ///< the visibility mesh
  curves::SegmentAttributes values_;  ///< for the attribute
  curves::SegmentAttributes places_;  ///< curves::sample_stop_places()
  TableMemory memory_{"weights of stops"};
};

}  // namespace sfumato::solve
