// A layer's triangles; corner k of triangle t is vertex 3 t + k. Fragments receive the ten nodes as
// flat values, which come from the last vertex of a triangle.
//
// WITH_AREAS: two triangles, six vertices, over all pixels that a triangle touches.
// WITH_STRIPS: the same over the pixels that the strips of a soft edge touch.
// WITH_MARKS: only small triangles.
uniform usampler2D triangle_vertex;
uniform sampler2D vertex_position;
uniform usampler2D triangle_node;
uniform sampler2D node_color;
#ifdef WITH_OPACITY
uniform usampler2D triangle_opacity_node;
uniform sampler2D node_opacity;
#endif
uniform int first_triangle;
#ifdef WITH_STRIPS
uniform usampler2D soft_edge;
uniform sampler2D soft_reach;
uniform vec3 pixel_from_layer[2];
uniform vec2 target_size;

flat out vec4 strip_edge;
flat out vec4 strip_reach;
flat out int strip;
#elif defined(WITH_AREAS)
uniform vec3 pixel_from_layer[2];
uniform vec2 target_size;

uniform usampler2D is_bent;

flat out vec4 corners;
flat out vec2 last_corner;
flat out int in_quarters;
#else
uniform vec3 clip_from_layer[2];

/// Weights of corners 1 and 2 at the centroid of the covered part, which is never outside the
/// triangle.
centroid out vec2 weight;
#endif

#if !defined(WITH_STRIPS) && !defined(WITH_MARKS)
flat out vec4 node[kNodes];
#ifdef WITH_PAINTS
flat out int triangle;
#endif

vec4 node_value(int slot) {
  float opacity = 1.0;
#ifdef WITH_OPACITY
  opacity = table_value(node_opacity, table_index(triangle_opacity_node, slot)).r;
#endif
  return vec4(table_value(node_color, table_index(triangle_node, slot)).rgb, opacity);
}

void send_nodes(int t, bool is_last) {
  for (int i = 0; i < kNodes; ++i) node[i] = is_last ? node_value(kNodes * t + i) : vec4(0.0);
#ifdef WITH_PAINTS
  triangle = t;
#endif
}

#endif

vec2 corner_position(int t, int corner) {
  return table_value(vertex_position, table_index(triangle_vertex, 3 * t + corner)).rg;
}

/// Returns corner `corner` of two triangles over all pixels between two points.
vec4 box_corner(vec2 low, vec2 high, vec2 size, int corner) {
  bool right = corner == 1 || corner == 3 || corner == 4;
  bool below = corner == 2 || corner == 4 || corner == 5;
  vec2 p = vec2(right ? ceil(high.x) : floor(low.x), below ? ceil(high.y) : floor(low.y));
  return vec4(2.0 * p / size - 1.0, 0.0, 1.0);
}

#ifdef WITH_STRIPS
const uint kNoTriangle = 0xffffffffu;

vec2 slot_pixel(int slot) {
  return mapped(pixel_from_layer, corner_position(slot / 3, slot % 3));
}

vec2 reach_px(vec2 reach) {
  vec2 px = vec2(dot(pixel_from_layer[0].xy, reach), dot(pixel_from_layer[1].xy, reach));
  return px * min(1.0, kMostReach / max(length(px), 1e-6));
}

void main() {
  strip = gl_VertexID / 6;
  uint front = texelFetch(soft_edge, table_texel(3 * strip), 0).r;
  bool has_front = front != kNoTriangle;
  int slot = has_front ? int(front) : table_index(soft_edge, 3 * strip + 1);
  vec2 a = slot_pixel(slot), b = slot_pixel(3 * (slot / 3) + (slot + 1) % 3);
  vec4 reach = table_value(soft_reach, strip);
  strip_edge = has_front ? vec4(a, b) : vec4(b, a);
  strip_reach = vec4(reach_px(reach.xy), reach_px(reach.zw));
  vec4 far = strip_edge + kStripReach[3] * strip_reach;
  vec2 low = min(min(a, b), min(far.xy, far.zw)), high = max(max(a, b), max(far.xy, far.zw));
  gl_Position = box_corner(low, high, target_size, gl_VertexID % 6);
}
#elif defined(WITH_AREAS)
void main() {
  int t = first_triangle + gl_VertexID / 6, corner = gl_VertexID % 6;
  vec2 a = mapped(pixel_from_layer, corner_position(t, 0));
  vec2 b = mapped(pixel_from_layer, corner_position(t, 1));
  vec2 c = mapped(pixel_from_layer, corner_position(t, 2));
  corners = vec4(a, b);
  last_corner = c;
  bool bends = table_index(is_bent, t) != 0;
#ifdef WITH_MARKS
  if (!(bends && is_small(a, b, c))) a = b = c = vec2(-1.0);
#else
  in_quarters = int(bends && is_read_in_quarters(a, b, c));
  send_nodes(t, corner % 3 == 2);
#endif
  gl_Position = box_corner(min(a, min(b, c)), max(a, max(b, c)), target_size, corner);
}
#else
void main() {
  int t = first_triangle + gl_VertexID / 3, corner = gl_VertexID % 3;
  gl_Position = vec4(mapped(clip_from_layer, corner_position(t, corner)), 0.0, 1.0);
  weight = vec2(corner == 1, corner == 2);
  send_nodes(t, corner == 2);
}
#endif
