// The declarations that src/gather/point_walk.glsl, which follows, needs.
precision highp isampler2D;

#define FN
#define P
#define STACK 8
#ifdef WITH_BLUR
#define BLEND 1
#else
#define BLEND 0
#endif

uniform isampler2D beyond_table;
uniform isampler2D hit_table;
uniform isampler2D triangle_table;

ivec4 beyond_at(int i) {
  return texelFetch(beyond_table, table_texel(i), 0);
}
ivec4 hit_at(int i) {
  return texelFetch(hit_table, table_texel(i), 0);
}
ivec4 triangle_at(int i) {
  return texelFetch(triangle_table, table_texel(i), 0);
}
#ifdef WITH_BLUR
uniform isampler2D blend_table;
ivec4 blend_at(int i) {
  return texelFetch(blend_table, table_texel(i), 0);
}
// Exact pixels do not support layers with image-domain shaders.
void add_share(int shader, float share) {}
#endif
