// A layer's triangles; corner k of triangle t is vertex 3 t + k. The ten nodes go to the fragments
// as they are: the last vertex of a triangle is the one whose flat values count.
//
// WITH_AREAS: two triangles over all pixels that a triangle touches, six vertices to it.
uniform usampler2D triangle_vertex;
uniform sampler2D vertex_position;
uniform usampler2D triangle_node;
uniform sampler2D node_color;
#ifdef WITH_OPACITY
uniform usampler2D triangle_opacity_node;
uniform sampler2D node_opacity;
#endif
uniform int first_triangle;
#ifdef WITH_AREAS
uniform vec3 pixel_from_layer[2];
uniform vec2 target_size;

flat out vec4 corners;
flat out vec2 last_corner;
#else
uniform vec3 clip_from_layer[2];

/// Weights of corners 1 and 2. At the centroid of what is covered: never outside the triangle.
centroid out vec2 weight;
#endif

flat out vec4 node[10];
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

vec2 corner_position(int t, int corner) {
  return table_value(vertex_position, table_index(triangle_vertex, 3 * t + corner)).rg;
}

void send_nodes(int t, bool is_last) {
  for (int i = 0; i < 10; ++i) node[i] = is_last ? node_value(10 * t + i) : vec4(0.0);
#ifdef WITH_PAINTS
  triangle = t;
#endif
}

#ifdef WITH_AREAS
void main() {
  int t = first_triangle + gl_VertexID / 6, corner = gl_VertexID % 6;
  vec2 a = mapped(pixel_from_layer, corner_position(t, 0));
  vec2 b = mapped(pixel_from_layer, corner_position(t, 1));
  vec2 c = mapped(pixel_from_layer, corner_position(t, 2));
  corners = vec4(a, b);
  last_corner = c;
  vec2 low = floor(min(a, min(b, c))), high = ceil(max(a, max(b, c)));
  bool right = corner == 1 || corner == 3 || corner == 4;
  bool below = corner == 2 || corner == 4 || corner == 5;
  vec2 p = vec2(right ? high.x : low.x, below ? high.y : low.y);
  gl_Position = vec4(2.0 * p / target_size - 1.0, 0.0, 1.0);
  send_nodes(t, corner % 3 == 2);
}
#else
void main() {
  int t = first_triangle + gl_VertexID / 3, corner = gl_VertexID % 3;
  gl_Position = vec4(mapped(clip_from_layer, corner_position(t, corner)), 0.0, 1.0);
  weight = vec2(corner == 1, corner == 2);
  send_nodes(t, corner == 2);
}
#endif
