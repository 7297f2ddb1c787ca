// The sides of curves, six vertices each: quads over all pixels that a side may cut.
precision highp isampler2D;
uniform isampler2D hit_table;
uniform vec3 pixel_from_scene[2];
uniform vec2 target_size;

flat out vec2 begin;
flat out vec2 end;

// More than the diagonal of a pixel.
const float kReach = 1.5;

void main() {
  vec4 ends = intBitsToFloat(texelFetch(hit_table, table_texel(4 * gl_InstanceID), 0));
  begin = mapped(pixel_from_scene, ends.xy);
  end = mapped(pixel_from_scene, ends.zw);
  vec2 along = end - begin;
  along = kReach * (dot(along, along) > 0.0 ? normalize(along) : vec2(1.0, 0.0));
  bool at_end = gl_VertexID == 1 || gl_VertexID == 3 || gl_VertexID == 4;
  bool left = gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5;
  vec2 p = at_end ? end + along : begin - along;
  p += left ? vec2(along.y, -along.x) : vec2(-along.y, along.x);
  gl_Position = vec4(2.0 * p / target_size - 1.0, 0.0, 1.0);
}
