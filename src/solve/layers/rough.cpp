#include "solve/layers/rough.hpp"

#include <algorithm>
#include <limits>

namespace sfumato::solve {
namespace {

/// Smaller angles save few triangles, and double the error.
constexpr double kMinAngleDeg = 10;

/// Limits triangles in drawings of few curves, whose large smooth areas have no other limit.
constexpr double kMaxAreaFraction = 0.01;

}  // namespace

DiffuseOptions roughly(const DiffuseOptions& options) {
  DiffuseOptions rough = options;
  rough.max_error = std::numeric_limits<double>::infinity();
  rough.min_angle_deg = std::min(options.min_angle_deg, kMinAngleDeg);
  rough.max_area_fraction = std::min(options.max_area_fraction, kMaxAreaFraction);
  if (rough.tolerance) *rough.tolerance *= kRoughness;
  rough.gather = {};
  return rough;
}

}  // namespace sfumato::solve
