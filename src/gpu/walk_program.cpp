#include "gpu/walk_program.hpp"

#include <string>

namespace sfumato::gpu {
namespace {

constexpr const char* kBefore = R"(
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
)";

constexpr const char* kAfter = R"(
void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= point_count) {
    return;
  }
  int first = numbers_of_point * i;
  first_share = first + 5;
  for (int k = first_share; k < first + numbers_of_point; ++k) {
    results[k] = 0.0;
  }
  gather(vec2(points[i].x, points[i].y), points[i].triangle, negligible_share, step_limit);
  results[first] = failed ? -1.0 : weight;
  results[first + 1] = value.x;
  results[first + 2] = value.y;
  results[first + 3] = value.z;
  results[first + 4] = value.w;
}
)";

std::string define(const char* name, const std::string& value) {
  return std::string("#define ") + name + " " + value + "\n";
}

}  // namespace

Result<Program> walk_program(const Device& device, const WalkShape& shape, bool blends) {
  const bool is_precise = shape.is_precise && device.has_precise();
  std::string text = "#version 310 es\n";
  if (is_precise) text += "#extension GL_EXT_gpu_shader5 : require\n";
  text += define("FN", "") + define("P", is_precise ? "precise" : "");
  text += define("STACK", std::to_string(shape.stack)) + define("BLEND", blends ? "1" : "0");
  text += define("LOCAL_SIZE", std::to_string(shape.local_size));
  text += kBefore;
  text += Program::text_of("point_walk.glsl");
  text += kAfter;
  return Program::create_compute(device.gl(), text);
}

}  // namespace sfumato::gpu
