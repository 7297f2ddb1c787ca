// The triangles of a layer's curves: corner k of triangle t is vertex 3 t + k.
precision highp isampler2D;
uniform isampler2D triangle_table;
uniform vec3 clip_from_scene[2];

flat out float triangle;

void main() {
  int t = gl_VertexID / 3, k = gl_VertexID % 3;
  ivec4 first = texelFetch(triangle_table, table_texel(3 * t), 0);
  ivec4 second = texelFetch(triangle_table, table_texel(3 * t + 1), 0);
  vec2 p = intBitsToFloat(k == 0   ? first.xw
                          : k == 1 ? ivec2(first.y, second.x)
                                   : ivec2(first.z, second.y));
  triangle = float(t);
  gl_Position = vec4(mapped(clip_from_scene, p), 0.0, 1.0);
}
