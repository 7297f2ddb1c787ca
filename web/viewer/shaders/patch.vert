// A layer's triangles; corner k of triangle t is vertex 3 t + k. The ten nodes go to the fragments
// as they are: the last vertex of a triangle is the one whose flat values count.
uniform usampler2D triangle_vertex;
uniform sampler2D vertex_position;
uniform usampler2D triangle_node;
uniform sampler2D node_color;
#ifdef WITH_OPACITY
uniform usampler2D triangle_opacity_node;
uniform sampler2D node_opacity;
#endif
uniform int first_triangle;
uniform vec3 clip_from_layer[2];

flat out vec4 node[10];
#ifdef WITH_PAINTS
flat out int triangle;
#endif
/// Weights of corners 1 and 2. At the centroid of what is covered: never outside the triangle.
centroid out vec2 weight;

vec4 node_value(int slot) {
  float opacity = 1.0;
#ifdef WITH_OPACITY
  opacity = table_value(node_opacity, table_index(triangle_opacity_node, slot)).r;
#endif
  return vec4(table_value(node_color, table_index(triangle_node, slot)).rgb, opacity);
}

void main() {
  int corner = gl_VertexID % 3;
  int t = first_triangle + gl_VertexID / 3;
  int vertex = table_index(triangle_vertex, 3 * t + corner);
  gl_Position = vec4(mapped(clip_from_layer, table_value(vertex_position, vertex).rg), 0.0, 1.0);
  weight = vec2(corner == 1, corner == 2);
  for (int i = 0; i < 10; ++i) node[i] = corner == 2 ? node_value(10 * t + i) : vec4(0.0);
#ifdef WITH_PAINTS
  triangle = t;
#endif
}
