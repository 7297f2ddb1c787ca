#include "patches/patch.hpp"

namespace sfumato {
namespace {

using Basis = std::array<double, kNodesPerTriangle>;

/// Eq. 18.
Basis cubic_basis(double w, double u, double v) {
  return {0.5 * w * (3 * w - 1) * (3 * w - 2), 0.5 * u * (3 * u - 1) * (3 * u - 2),
          0.5 * v * (3 * v - 1) * (3 * v - 2), 4.5 * w * u * (3 * w - 1),
          4.5 * w * u * (3 * u - 1),           4.5 * u * v * (3 * u - 1),
          4.5 * u * v * (3 * v - 1),           4.5 * v * w * (3 * v - 1),
          4.5 * v * w * (3 * w - 1),           27 * w * u * v};
}

/// Eq. 17, each edge centre read from the cubic through the edge's four nodes:
/// (−Zi + 9 Zij + 9 Zji − Zj) / 16.
Basis quadratic_basis(double w, double u, double v) {
  Basis basis{w * (2 * w - 1), u * (2 * u - 1), v * (2 * v - 1), 0, 0, 0, 0, 0, 0, 0};
  const double edge[3] = {4 * w * u, 4 * u * v, 4 * v * w};
  for (int k = 0; k < 3; ++k) {
    basis[k] -= edge[k] / 16;
    basis[(k + 1) % 3] -= edge[k] / 16;
    basis[3 + 2 * k] += 9 * edge[k] / 16;
    basis[4 + 2 * k] += 9 * edge[k] / 16;
  }
  return basis;
}

}  // namespace

std::array<double, kNodesPerTriangle> patch_basis(PatchOrder order, double w, double u, double v) {
  switch (order) {
    case PatchOrder::linear:
      return {w, u, v, 0, 0, 0, 0, 0, 0, 0};
    case PatchOrder::quadratic:
      return quadratic_basis(w, u, v);
    case PatchOrder::cubic:
      break;
  }
  return cubic_basis(w, u, v);
}

}  // namespace sfumato
