// The edges of a layer's triangles, six vertices to an edge, three edges to a triangle.
uniform usampler2D triangle_vertex;
uniform sampler2D vertex_position;
uniform usampler2D edge_is_curve;
uniform int first_triangle;
uniform vec3 pixel_from_layer[2];
uniform vec2 target_size;
uniform float line_scale;

flat out vec2 begin;
flat out vec2 end;
flat out float half_width;
flat out int is_curve;

vec2 corner_pixel(int slot) {
  int vertex = table_index(triangle_vertex, slot);
  return mapped(pixel_from_layer, table_value(vertex_position, vertex).rg);
}

void main() {
  int edge = 3 * first_triangle + gl_VertexID / 6;
  int triangle = edge / 3;
  begin = corner_pixel(edge);
  end = corner_pixel(3 * triangle + (edge + 1) % 3);
  is_curve = table_index(edge_is_curve, edge);
  half_width = line_scale * (is_curve != 0 ? 0.9 : 0.4);

  vec2 along = end - begin;
  along = dot(along, along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
  vec2 reach = (half_width + 1.0) * along;
  int corner = gl_VertexID % 6;
  bool at_end = corner == 1 || corner == 3 || corner == 4;
  bool left = corner == 2 || corner == 4 || corner == 5;
  vec2 p = at_end ? end + reach : begin - reach;
  p += left ? vec2(reach.y, -reach.x) : vec2(-reach.y, reach.x);
  gl_Position = vec4(2.0 * p / target_size - 1.0, 0.0, 1.0);
}
