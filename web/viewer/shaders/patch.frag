// Evaluates a patch from its ten nodes (paper eq. 17 and 18), with image-domain shaders (eq. 6) if
// the layer has them.
//
// WITH_AREAS: the value at the centroid of the part of the pixel that the triangle covers, times
// its area.
// WITH_STRIPS: the change by a fine blur, as in raster::MixedPixels::add_blur.
// WITH_MARKS: 0 where either is not 0.
uniform int patch_order;
uniform int interpolation;
uniform float opacity;

#ifdef WITH_STRIPS
flat in vec4 strip_edge;
flat in vec4 strip_reach;
flat in int strip;
uniform usampler2D soft_edge;
uniform usampler2D triangle_node;
uniform sampler2D node_color;
#ifdef WITH_OPACITY
uniform usampler2D triangle_opacity_node;
uniform sampler2D node_opacity;
#endif
#elif !defined(WITH_MARKS)
flat in vec4 node[kNodes];
#ifdef WITH_PAINTS
flat in int triangle;
uniform usampler2D triangle_node;
#ifdef WITH_OPACITY
uniform usampler2D triangle_opacity_node;
#endif
#endif
#endif
#ifdef WITH_STRIPS
#elif defined(WITH_AREAS)
flat in vec4 corners;
flat in vec2 last_corner;
flat in int in_quarters;
#else
centroid in vec2 weight;
#endif

out vec4 fragment;

void cubic_basis(float w, float u, float v, out float basis[kNodes]) {
  basis = float[kNodes](
      0.5 * w * (3.0 * w - 1.0) * (3.0 * w - 2.0), 0.5 * u * (3.0 * u - 1.0) * (3.0 * u - 2.0),
      0.5 * v * (3.0 * v - 1.0) * (3.0 * v - 2.0), 4.5 * w * u * (3.0 * w - 1.0),
      4.5 * w * u * (3.0 * u - 1.0), 4.5 * u * v * (3.0 * u - 1.0), 4.5 * u * v * (3.0 * v - 1.0),
      4.5 * v * w * (3.0 * v - 1.0), 4.5 * v * w * (3.0 * w - 1.0), 27.0 * w * u * v);
}

// The value at an edge's centre follows from the cubic through its nodes: (-Zi + 9 Zij + 9 Zji -
// Zj) / 16.
void quadratic_basis(float w, float u, float v, out float basis[kNodes]) {
  float a = 0.25 * w * u, b = 0.25 * u * v, c = 0.25 * v * w;
  basis = float[kNodes](w * (2.0 * w - 1.0) - a - c, u * (2.0 * u - 1.0) - a - b,
                        v * (2.0 * v - 1.0) - b - c, 9.0 * a, 9.0 * a, 9.0 * b, 9.0 * b, 9.0 * c,
                        9.0 * c, 0.0);
}

/// weight: the weights of corners 1 and 2.
void patch_basis(vec2 weight, out float basis[kNodes]) {
  float u = max(weight.x, 0.0), v = max(weight.y, 0.0), w = max(1.0 - u - v, 0.0);
  if (patch_order == 3) {
    cubic_basis(w, u, v, basis);
  } else if (patch_order == 2) {
    quadratic_basis(w, u, v, basis);
  } else {
    basis = float[kNodes](w, u, v, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
  }
}

#ifdef WITH_PAINTS
uniform sampler2D color_weight;
#ifdef WITH_OPACITY
uniform sampler2D opacity_weight;
#endif
uniform ivec2 paint_count;
uniform float paint_step;

/// Returns four weights, of a field with `groups` times four of them.
vec4 paint_weights(usampler2D nodes, sampler2D values, int triangle, int groups, int group,
                   float basis[kNodes]) {
  vec4 first = table_value(values, groups * table_index(nodes, kNodes * triangle) + group);
  vec4 sum = first;
  for (int i = 1; i < kNodes; ++i) {
    int slot = table_index(nodes, kNodes * triangle + i);
    sum += basis[i] * (table_value(values, groups * slot + group) - first);
  }
  return sum;
}

void add_paints(int triangle, float basis[kNodes], inout vec4 value) {
  vec2 pixel = floor(gl_FragCoord.xy / paint_step) + 0.5;
  int groups = (paint_count.x + 3) / 4;
  vec4 weights;
  for (int i = 0; i < paint_count.x; ++i) {
    if ((i & 3) == 0)
      weights = paint_weights(triangle_node, color_weight, triangle, groups, i >> 2, basis);
    if (weights[i & 3] == 0.0) continue;
    value.rgb += weights[i & 3] * from_code(interpolation, paint_color(i, pixel).rgb);
  }
#ifdef WITH_OPACITY
  groups = (paint_count.y + 3) / 4;
  for (int i = 0; i < paint_count.y; ++i) {
    if ((i & 3) == 0)
      weights = paint_weights(triangle_opacity_node, opacity_weight, triangle, groups, i >> 2,
                              basis);
    if (weights[i & 3] == 0.0) continue;
    vec4 color = paint_color(paint_count.x + i, pixel);
    value.a += weights[i & 3] * color.a * dot(color.rgb, vec3(0.2126, 0.7152, 0.0722));
  }
#endif
}
#endif

/// Converts a colour of the interpolation space, with an opacity, to its painted form.
vec4 shown(vec4 value) {
  float alpha = opacity * clamp(value.a, 0.0, 1.0);
  return vec4(alpha * clamped_code(interpolation, value.rgb), alpha);
}

#if !defined(WITH_STRIPS) && !defined(WITH_MARKS)
vec4 patch_value(vec2 weight) {
  float basis[kNodes];
  patch_basis(weight, basis);
  // Sum differences to one node, so that a constant patch gives exactly its constant.
  vec4 value = node[0];
  for (int i = 1; i < kNodes; ++i) value += basis[i] * (node[i] - node[0]);
#ifdef WITH_PAINTS
  add_paints(triangle, basis, value);
#endif
  return shown(value);
}
#endif

#if defined(WITH_AREAS) || defined(WITH_STRIPS)
float cross_product(vec2 a, vec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// Returns the integrals of dx dy, x dx dy and y dx dy over the area left of the line from a to b,
/// on which x and y are linear: by Green's theorem the integrals of x dy, x² / 2 dy and x y dy
/// along the line.
vec3 piece_integral(vec2 a, vec2 b) {
  return (b.y - a.y) * vec3(0.5 * (a.x + b.x), (a.x * (a.x + b.x) + b.x * b.x) / 6.0,
                            (a.x * (2.0 * a.y + b.y) + b.x * (a.y + 2.0 * b.y)) / 6.0);
}

/// Returns the same for an edge whose points are clamped to the square [-1/2, 1/2]². The sum over a
/// polygon's edges is the integral over the part of the polygon in the square.
vec3 edge_integral(vec2 a, vec2 b) {
  if (a.y == b.y) return vec3(0.0);
  vec2 rows = clamp((vec2(-0.5, 0.5) - a.y) / (b.y - a.y), 0.0, 1.0);
  vec2 p = mix(a, b, min(rows.x, rows.y)), q = mix(a, b, max(rows.x, rows.y));
  vec2 columns = vec2(0.0, 1.0);
  if (p.x != q.x) columns = clamp((vec2(-0.5, 0.5) - p.x) / (q.x - p.x), 0.0, 1.0);
  vec2 m = mix(p, q, min(columns.x, columns.y)), n = mix(p, q, max(columns.x, columns.y));
  p = clamp(p, -0.5, 0.5);
  q = clamp(q, -0.5, 0.5);
  m = clamp(m, -0.5, 0.5);
  n = clamp(n, -0.5, 0.5);
  return piece_integral(p, m) + piece_integral(m, n) + piece_integral(n, q);
}

// Smaller parts of a pixel change nothing and have no centroid. They are not discarded, so that the
// stencil test may come first.
const float kLeastPart = 1e-5;

#ifdef WITH_STRIPS
uniform float turn;

vec4 node_value(int slot) {
  float alpha = 1.0;
#ifdef WITH_OPACITY
  alpha = table_value(node_opacity, table_index(triangle_opacity_node, slot)).r;
#endif
  return vec4(table_value(node_color, table_index(triangle_node, slot)).rgb, alpha);
}

/// Returns the triangle's value on its edge 3 t + k, at a share of the way along it.
vec4 edge_value(int slot, float along) {
  int t = slot / 3, k = slot % 3;
  vec3 corner_weight = vec3(0.0);
  corner_weight[k] = 1.0 - along;
  corner_weight[(k + 1) % 3] = along;
  float basis[kNodes];
  patch_basis(corner_weight.yz, basis);
  vec4 first = node_value(kNodes * t), value = first;
  for (int i = 1; i < kNodes; ++i) value += basis[i] * (node_value(kNodes * t + i) - first);
#ifdef WITH_PAINTS
  add_paints(t, basis, value);
#endif
  return value;
}

void add_strips(vec4 areas, float along) {
  const uint kNoTriangle = 0xffffffffu;
  uint front = texelFetch(soft_edge, table_texel(3 * strip), 0).r;
  uint back = texelFetch(soft_edge, table_texel(3 * strip + 1), 0).r;
  float contrast = uintBitsToFloat(texelFetch(soft_edge, table_texel(3 * strip + 2), 0).r);
  vec4 side, across;
  if (front != kNoTriangle) side = edge_value(int(front), along);
  if (back != kNoTriangle) across = edge_value(int(back), 1.0 - along);
  if (front == kNoTriangle) side = vec4(across.rgb, 0.0);
  if (back == kNoTriangle) across = vec4(side.rgb, 0.0);
  across = contrast * (across - side);
  vec4 inner = shown(side + 0.5 * across);
  fragment = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    vec4 outer = shown(side + 0.125 * float(3 - i) * across);
    fragment += areas[i] * (inner - outer);
    inner = outer;
  }
}

void main() {
  vec2 from = strip_edge.xy - gl_FragCoord.xy, to = strip_edge.zw - gl_FragCoord.xy;
  vec3 edge = edge_integral(from, to), sum;
  vec4 areas;
  for (int i = 0; i < 4; ++i) {
    vec2 far_from = from + kStripReach[i] * strip_reach.xy;
    vec2 far_to = to + kStripReach[i] * strip_reach.zw;
    sum = edge + edge_integral(to, far_to) + edge_integral(far_to, far_from) +
          edge_integral(far_from, from);
    areas[i] = turn * sum.x;
  }
#ifdef WITH_MARKS
  if (abs(sum.x) < kLeastPart) discard;
  fragment = vec4(0.0);
#else
  fragment = vec4(0.0);
  if (abs(sum.x) < kLeastPart) return;
  vec2 along = to - from;
  add_strips(areas, clamp(dot(sum.yz / sum.x - from, along) / dot(along, along), 0.0, 1.0));
#endif
}
#elif defined(WITH_MARKS)
void main() {
  vec2 a = corners.xy - gl_FragCoord.xy, b = corners.zw - gl_FragCoord.xy;
  vec2 c = last_corner - gl_FragCoord.xy;
  vec3 sum = edge_integral(a, b) + edge_integral(b, c) + edge_integral(c, a);
  if (abs(sum.x) < kLeastPart) discard;
  fragment = vec4(0.0);
}
#else
/// Returns the triangle's value in a square of the pixel about `place`, times the area.
vec4 part_value(vec2 a, vec2 b, vec2 c, vec2 place, float size) {
  vec2 at_a = (a - place) / size, at_b = (b - place) / size, at_c = (c - place) / size;
  vec3 sum = edge_integral(at_a, at_b) + edge_integral(at_b, at_c) + edge_integral(at_c, at_a);
  if (abs(sum.x) < kLeastPart) sum = vec3(0.0);
  vec2 p = sum.x == 0.0 ? a : place + size * clamp(sum.yz / sum.x, -0.5, 0.5);
  float twice_area = cross_product(b - a, c - a);
  vec2 weight = vec2(cross_product(p - a, c - a), cross_product(b - a, p - a)) /
                (twice_area == 0.0 ? 1.0 : twice_area);
  return size * size * abs(sum.x) * patch_value(clamp(weight, 0.0, 1.0));
}

void main() {
  vec2 a = corners.xy - gl_FragCoord.xy, b = corners.zw - gl_FragCoord.xy;
  vec2 c = last_corner - gl_FragCoord.xy;
  if (in_quarters == 0) {
    fragment = part_value(a, b, c, vec2(0.0), 1.0);
    return;
  }
  fragment = vec4(0.0);
  for (int i = 0; i < 4; ++i)
    fragment += part_value(a, b, c, vec2(i & 1, i >> 1) * 0.5 - 0.25, 0.5);
}
#endif
#else
void main() {
  fragment = patch_value(weight);
}
#endif
