#pragma once

#include <cstddef>

#include "gather/scene/scene.hpp"
#include "gpu/device.hpp"
#include "gpu/gl.hpp"

namespace sfumato::gpu {

/// A scene's tables in one buffer of the device, in the layout that walk_program() reads.
class WalkTables {
 public:
  /// Returns the bytes of a scene.
  static std::size_t bytes_of(const gather::Scene& scene);

  explicit WalkTables(const gather::Scene& scene);

  const std::shared_ptr<const char>& scene_identity() const { return scene_identity_; }
  std::size_t bytes() const { return bytes_; }
  bool has_blends() const { return has_blends_; }
  GLuint buffer() const { return buffer_.name(); }

  // The first texels of these tables.
  GLint hit_begin() const { return hit_begin_; }
  GLint blend_begin() const { return blend_begin_; }
  GLint triangle_begin() const { return triangle_begin_; }

 private:
  std::shared_ptr<const char> scene_identity_;
  std::size_t bytes_;
  bool has_blends_;
  GLint hit_begin_ = 0, blend_begin_ = 0, triangle_begin_ = 0;
  GlObject buffer_;
};

}  // namespace sfumato::gpu
