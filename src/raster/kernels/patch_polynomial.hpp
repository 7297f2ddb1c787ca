#pragma once

#include "base/lanes.hpp"
#include "picture/patch.hpp"
#include "raster/kernels/triangle_frame.hpp"
#include "sfumato/picture/picture.hpp"

/// The patch of one triangle, patch_basis of picture/patch.hpp (paper eq. 17–18), as a polynomial
/// of (u, q), see triangle_frame.hpp. Compiled for every instruction set.
namespace sfumato::raster::inline SFUMATO_ISA {

/// Up to four channels: red, green, blue and opacity, or the weights of four shaders.
using Color4 = Lanes<4>;

/// The ten nodes of a triangle, node_order[3 top + middle], as top, middle, bottom, then tm, mt,
/// mb, bm, bt, tb (ij lies a third of the way from i to j), then the centre.
struct NodeOrderTable {
  std::uint8_t node[9][kNodesPerTriangle];
};

constexpr NodeOrderTable make_node_order() {
  NodeOrderTable table{};
  for (int t = 0; t < 3; ++t) {
    for (int m = 0; m < 3; ++m) {
      if (t == m) continue;
      const int b = 3 - t - m;
      const int order[] = {t,
                           m,
                           b,
                           edge_node(t, m),
                           edge_node(m, t),
                           edge_node(m, b),
                           edge_node(b, m),
                           edge_node(b, t),
                           edge_node(t, b),
                           kCenterNode};
      for (int i = 0; i < kNodesPerTriangle; ++i)
        table.node[3 * t + m][i] = static_cast<std::uint8_t>(order[i]);
    }
  }
  return table;
}

inline constexpr NodeOrderTable kNodeOrder = make_node_order();

/// The sum of c_ij u^i q^j over i + j <= 3.
struct PatchPolynomial {
  Color4 c00, c10, c20, c30, c01, c11, c21, c02, c12, c03;
};

/// A row of a patch: k[0] + k[1] u + k[2] u^2 + k[3] u^3.
struct RowPolynomial {
  Color4 k[4];
};

SFUMATO_INLINE Color4 color4(float x, float y, float z, float w) {
  Color4 color;
  color.part[0] = lane::Float<4>{x, y, z, w};
  return color;
}

/// Reads the channels for the lanes of a patch; `slot` is a node_slot(). ColorChannels: the colour
/// of a layer, and an unused lane.
struct ColorChannels {
  static constexpr int kCount = 3;

  SFUMATO_INLINE explicit ColorChannels(const LayerView& layer) : color(layer.color) {}

  SFUMATO_INLINE Color4 at(std::size_t slot) const {
    const float* value = color.node_value +
                         color.triangle_node[slot] * static_cast<std::size_t>(color.channel_count);
    return color4(value[0], value[1], value[2], 0);
  }

  FieldView color;
};

/// Colour and opacity.
struct ColorOpacityChannels {
  static constexpr int kCount = 4;

  SFUMATO_INLINE explicit ColorOpacityChannels(const LayerView& layer)
      : color(layer.color), opacity(layer.opacity) {}

  SFUMATO_INLINE Color4 at(std::size_t slot) const {
    const float* value = color.node_value +
                         color.triangle_node[slot] * static_cast<std::size_t>(color.channel_count);
    return color4(value[0], value[1], value[2],
                  opacity.node_value[opacity.triangle_node[slot] *
                                     static_cast<std::size_t>(opacity.channel_count)]);
  }

  FieldView color, opacity;
};

/// Channels [first, first + 4) of a field, 0 beyond its last.
struct WeightChannels {
  static constexpr int kCount = 4;

  SFUMATO_INLINE WeightChannels(const FieldView& weights, int first_channel)
      : field(weights), first(first_channel), count(weights.channel_count - first_channel) {}

  SFUMATO_INLINE Color4 at(std::size_t slot) const {
    const float* value = field.node_value +
                         field.triangle_node[slot] * static_cast<std::size_t>(field.channel_count) +
                         first;
    return color4(value[0], count > 1 ? value[1] : 0, count > 2 ? value[2] : 0,
                  count > 3 ? value[3] : 0);
  }

  FieldView field;
  int first, count;
};

/// Computes the cubic of s in [0, 1] that is 0 at 0, near at 1/3, far at 2/3 and end at 1.
SFUMATO_INLINE void edge_monomials(const Color4& near, const Color4& far, const Color4& end,
                                   Color4* c1, Color4* c2, Color4* c3) {
  *c1 = Color4(9) * near - Color4(4.5f) * far + end;
  *c2 = Color4(18) * far - Color4(22.5f) * near - Color4(4.5f) * end;
  *c3 = Color4(13.5f) * (near - far) + Color4(4.5f) * end;
}

/// Computes eq. 18 in monomials of u and v (v the weight of the bottom corner), from the
/// differences d of the nodes to the top one: exactly 0 for a constant patch.
SFUMATO_INLINE void cubic_monomials(const Color4 (&d)[kNodesPerTriangle], PatchPolynomial* p) {
  edge_monomials(d[3], d[4], d[1], &p->c10, &p->c20, &p->c30);
  edge_monomials(d[8], d[7], d[2], &p->c01, &p->c02, &p->c03);
  // The rest at mb, bm and the centre, after the two edge cubics, is u v (c11 + c21 u + c12 v).
  const Color4 a = Color4(4.5f) * (d[5] - d[4] - d[8]);
  const Color4 b = Color4(4.5f) * (d[6] - d[3] - d[7]);
  const Color4 c = Color4(9) * (d[9] - d[3] - d[8]);
  p->c11 = Color4(3) * c - a - b;
  p->c21 = Color4(3) * (a - c);
  p->c12 = Color4(3) * (b - c);
}

/// Computes eq. 17; an edge's centre comes from the cubic through its four nodes, as in
/// patch_basis.
SFUMATO_INLINE void quadratic_monomials(const Color4 (&d)[kNodesPerTriangle], PatchPolynomial* p) {
  const Color4 nine(0.5625f), one(0.0625f);
  const Color4 top_middle = nine * (d[3] + d[4]) - one * d[1];
  const Color4 top_bottom = nine * (d[8] + d[7]) - one * d[2];
  const Color4 middle_bottom = nine * (d[5] + d[6]) - one * (d[1] + d[2]);
  p->c10 = Color4(4) * top_middle - d[1];
  p->c20 = Color4(2) * d[1] - Color4(4) * top_middle;
  p->c01 = Color4(4) * top_bottom - d[2];
  p->c02 = Color4(2) * d[2] - Color4(4) * top_bottom;
  p->c11 = Color4(4) * (middle_bottom - top_middle - top_bottom);
  p->c30 = p->c21 = p->c12 = p->c03 = Color4(0);
}

SFUMATO_INLINE void linear_monomials(const Color4 (&d)[kNodesPerTriangle], PatchPolynomial* p) {
  p->c10 = d[1];
  p->c01 = d[2];
  p->c20 = p->c11 = p->c02 = p->c30 = p->c21 = p->c12 = p->c03 = Color4(0);
}

/// Substitutes v = q - m u, where m is the middle corner's q.
SFUMATO_INLINE void shear(float middle_q, PatchPolynomial* p) {
  const Color4 m(middle_q), two(2), three(3);
  p->c30 = p->c30 - m * (p->c21 - m * (p->c12 - m * p->c03));
  p->c21 = p->c21 - m * (two * p->c12 - three * m * p->c03);
  p->c12 = p->c12 - three * m * p->c03;
  p->c20 = p->c20 - m * (p->c11 - m * p->c02);
  p->c11 = p->c11 - two * m * p->c02;
  p->c10 = p->c10 - m * p->c01;
}

template <class Channels>
SFUMATO_INLINE PatchPolynomial patch_polynomial(const Channels& channels, PatchOrder patch_order,
                                                std::uint32_t triangle,
                                                const TriangleFrame& frame) {
  const std::size_t first_slot = node_slot(triangle, 0);
  const std::uint8_t* order = kNodeOrder.node[frame.corner_order];
  Color4 d[kNodesPerTriangle];
#pragma GCC unroll 10
  for (int i = 0; i < kNodesPerTriangle; ++i) d[i] = channels.at(first_slot + order[i]);
  PatchPolynomial p;
  p.c00 = d[0];
#pragma GCC unroll 9
  for (int i = 1; i < kNodesPerTriangle; ++i) d[i] = d[i] - d[0];
  if (patch_order == PatchOrder::cubic)
    cubic_monomials(d, &p);
  else if (patch_order == PatchOrder::quadratic)
    quadratic_monomials(d, &p);
  else
    linear_monomials(d, &p);
  shear(static_cast<float>(frame.middle_q), &p);
  return p;
}

SFUMATO_INLINE RowPolynomial row_polynomial(const PatchPolynomial& p, float row_q) {
  const Color4 q(row_q);
  return {{p.c00 + q * (p.c01 + q * (p.c02 + q * p.c03)), p.c10 + q * (p.c11 + q * p.c12),
           p.c20 + q * p.c21, p.c30}};
}

/// A point of a triangle; both coordinates in [0, 1].
struct PatchPoint {
  float u, q;
};

/// Returns the PatchPoint of an image point in the triangle, or outside it only by rounding.
SFUMATO_INLINE PatchPoint patch_point(const TriangleFrame& frame, double x, double y) {
  const double q = clamp_unit((y - frame.top_y) * frame.inverse_height);
  const double u = clamp_unit((x - frame.long_edge_x(y)) * frame.inverse_width);
  return {static_cast<float>(u), static_cast<float>(q)};
}

SFUMATO_INLINE Color4 patch_color(const PatchPolynomial& p, const PatchPoint& at) {
  const RowPolynomial row = row_polynomial(p, at.q);
  const Color4 u(at.u);
  return row.k[0] + u * (row.k[1] + u * (row.k[2] + u * row.k[3]));
}

}  // namespace sfumato::raster::inline SFUMATO_ISA
