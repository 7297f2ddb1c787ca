#include "gpu/walk_program.hpp"

#include <string>

namespace sfumato::gpu {
namespace {

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
  for (const char* part : {"walk_begin.glsl", "point_walk.glsl", "walk_end.glsl"})
    text += Program::text_of(part);
  return Program::create_compute(text);
}

}  // namespace sfumato::gpu
