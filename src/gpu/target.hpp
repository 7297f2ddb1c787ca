#pragma once

#include "base/charge.hpp"
#include "gpu/device.hpp"
#include "raster/kernels/tile.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::gpu {

/// A texture that can be drawn to.
class Target {
 public:
  /// Makes a target.
  ///
  /// bytes         of a pixel's colour
  /// with_stencil  8 bits in addition
  ///
  /// Errors: limit (the budget), out_of_memory or unavailable, as the driver refuses.
  static Result<Target> create(Context& context, const Device& device, GLenum format,
                               std::size_t bytes, int width, int height, bool with_stencil = false);

  /// Directs subsequent draws to this target, limited to the pixels of `rect`.
  void begin(const PixelRect& rect) const;
  /// Sets the colour, and the stencil to 0.
  void clear(float r = 0, float g = 0, float b = 0, float a = 0) const;
  /// Copies the pixels of `rect` to the same place of another target.
  void copy_to(const Target& target, const PixelRect& rect) const;

  GLuint texture() const { return texture_.name(); }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  Status attach(const Device& device, GLenum format, bool with_stencil);

  int width_ = 0, height_ = 0;
  GlObject texture_, stencil_, framebuffer_;
  ScopedCharge charge_;
};

}  // namespace sfumato::gpu
