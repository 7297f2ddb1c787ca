// Edges that are curves, six vertices per edge: quads over all pixels that an edge may cut.
uniform usampler2D triangle_vertex;
uniform sampler2D vertex_position;
uniform usampler2D edge_slot;
uniform vec3 pixel_from_layer[2];
uniform vec2 target_size;

flat out vec2 begin;
flat out vec2 end;

// More than the diagonal of a pixel.
const float kReach = 1.5;

vec2 corner_pixel(int slot) {
  int vertex = table_index(triangle_vertex, slot);
  return mapped(pixel_from_layer, table_value(vertex_position, vertex).rg);
}

void main() {
  int slot = table_index(edge_slot, gl_InstanceID);
  int triangle = slot / 3;
  begin = corner_pixel(slot);
  end = corner_pixel(3 * triangle + (slot + 1) % 3);
  vec2 along = end - begin;
  along = kReach * (dot(along, along) > 0.0 ? normalize(along) : vec2(1.0, 0.0));
  bool at_end = gl_VertexID == 1 || gl_VertexID == 3 || gl_VertexID == 4;
  bool left = gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5;
  vec2 p = at_end ? end + along : begin - along;
  p += left ? vec2(along.y, -along.x) : vec2(-along.y, along.x);
  gl_Position = vec4(2.0 * p / target_size - 1.0, 0.0, 1.0);
}
