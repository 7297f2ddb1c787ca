#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "gather/kernels/scene_layout.hpp"

/// point_walk.glsl as C++: the result of a device that respects `precise`, bit for bit. The
/// reference for devices in tests and benchmarks.
namespace sfumato::gather::glsl {

struct vec2 {
  float x = 0, y = 0;
  vec2() = default;
  vec2(float a, float b) : x(a), y(b) {}
};

struct vec4 {
  float x = 0, y = 0, z = 0, w = 0;
  vec4() = default;
  vec4(float a, float b, float c, float d) : x(a), y(b), z(c), w(d) {}
};

struct ivec4 {
  std::int32_t x, y, z, w;
};

using uint = std::uint32_t;

inline float intBitsToFloat(std::int32_t bits) {
  return std::bit_cast<float>(bits);
}
inline std::int32_t floatBitsToInt(float number) {
  return std::bit_cast<std::int32_t>(number);
}
inline float uintBitsToFloat(uint bits) {
  return std::bit_cast<float>(bits);
}
inline uint floatBitsToUint(float number) {
  return std::bit_cast<uint>(number);
}
inline float min(float a, float b) {
  return b < a ? b : a;
}
inline float max(float a, float b) {
  return a < b ? b : a;
}
inline float abs(float a) {
  return std::fabs(a);
}

/// The tables that the walk reads and adds to.
class WalkTables {
 public:
  /// shares   scene.shader_count numbers, or null where there are none; the walk adds to them
  WalkTables(const SceneView& scene, float* shares) : scene_(scene), shares_(shares) {}

 protected:
  ivec4 beyond_at(int i) const { return texel(scene_.edge_beyond, i); }
  ivec4 hit_at(int i) const { return texel(scene_.hit_edge, i); }
  ivec4 blend_at(int i) const { return texel(scene_.blend, i); }
  ivec4 triangle_at(int i) const { return texel(scene_.triangle, i); }
  void add_share(int shader, float share) { shares_[shader] += share; }

 private:
  template <class Row>
  static ivec4 texel(const Row* table, int i) {
    static_assert(sizeof(Row) % sizeof(ivec4) == 0);
    ivec4 result;
    __builtin_memcpy(
        &result, reinterpret_cast<const char*>(table) + sizeof result * static_cast<std::size_t>(i),
        sizeof result);
    return result;
  }

  const SceneView& scene_;
  float* shares_;
};

#define FN
#define P
#define STACK kStack

/// The walk without SceneView::blend. kStack: windows that may wait, a power of two.
template <int kStack>
class SharpPointWalk : private WalkTables {
 public:
  using WalkTables::WalkTables;
#define BLEND 0
#include "gather/point_walk.glsl"
#undef BLEND
};

/// The walk with SceneView::blend.
template <int kStack>
class BlendedPointWalk : private WalkTables {
 public:
  using WalkTables::WalkTables;
#define BLEND 1
#include "gather/point_walk.glsl"
#undef BLEND
};

#undef FN
#undef P
#undef STACK

}  // namespace sfumato::gather::glsl
