precision highp float;
precision highp int;
layout(local_size_x = LOCAL_SIZE) in;
layout(std430, binding = 0) readonly buffer Tables { ivec4 table[]; };
struct WalkPoint { float x; float y; int triangle; };
layout(std430, binding = 1) readonly buffer Points { WalkPoint points[]; };
layout(std430, binding = 2) buffer Results { float results[]; };
uniform int hit_begin;
uniform int blend_begin;
uniform int triangle_begin;
uniform int point_count;
uniform int numbers_of_point;
uniform float negligible_share;
uniform int step_limit;
int first_share;
ivec4 beyond_at(int i) { return table[i]; }
ivec4 hit_at(int i) { return table[hit_begin + i]; }
ivec4 blend_at(int i) { return table[blend_begin + i]; }
ivec4 triangle_at(int i) { return table[triangle_begin + i]; }
void add_share(int shader, float share) {
  P float sum = results[first_share + shader] + share;
  results[first_share + shader] = sum;
}
