#include "solve/layers/rough.hpp"

#include <algorithm>
#include <limits>

namespace sfumato::solve {
namespace {

/// With smaller angles there are few triangles less, and twice the error.
constexpr double kMinAngleDeg = 10;

/// Drawings of a few curves are smooth over long distances, where nothing is refined.
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
