#pragma once

#include <memory>
#include <string>

#include "gpu/gl.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gpu {

/// The use of a device, which determines the features that its context needs.
enum class DeviceUse { draw, compute };

/// A context of OpenGL ES 3 without a window, by EGL, current in the calling thread until this is
/// destroyed; then the previous context is current again. libEGL and libGLESv2 are loaded at run
/// time and stay loaded, since drivers leave threads running.
class Device {
 public:
  /// Tries hardware first, then Mesa's software driver. Errors: unavailable.
  static Result<std::unique_ptr<Device>> create(DeviceUse use = DeviceUse::draw);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  /// Returns the driver's name for the device ("llvmpipe (LLVM 15.0.6, 256 bits)").
  const std::string& name() const { return name_; }
  /// Returns the largest width and height of textures and of render targets.
  int largest_side() const { return largest_side_; }
  /// Returns whether shaders support `precise`: a sum then follows the text, to the last bit.
  bool has_precise() const { return has_precise_; }
  /// Returns whether 32-bit float targets can be drawn to, and blended.
  bool blends_floats() const { return blends_floats_; }

 private:
  struct Egl;

  Device();
  const char* text(GLenum what) const;
  void read_name();
  Status read_limits();

  std::unique_ptr<Egl> egl_;
  std::string name_;
  int largest_side_ = 0;
  bool blends_floats_ = false;
  bool has_precise_ = false;
};

}  // namespace sfumato::gpu
