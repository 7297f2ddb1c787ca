#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gpu/gl.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gpu {

/// A program made from the texts of docs/gpu.md.
class Program {
 public:
  Program() = default;

  /// Compiles a program. Names like "patch.vert"; defines like "WITH_PAINTS". Errors: internal,
  /// with the compiler's message.
  static Result<Program> create(const Gl& gl, std::string_view vertex, std::string_view fragment,
                                const std::vector<std::string_view>& defines);

  /// Compiles a compute shader from its complete text. Errors: internal, as above.
  static Result<Program> create_compute(const Gl& gl, const std::string& text);

  /// Makes this the current program, to which the setters below apply.
  void use() const { gl_->UseProgram(object_.name()); }
  GLuint name() const { return object_.name(); }

  /// Returns a file of web/viewer/shaders, or point_walk.glsl.
  static std::string_view text_of(std::string_view name);

  void set(const char* uniform, int value) const;
  void set(const char* uniform, int x, int y) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, double x, double y) const;
  /// Sets the map as two rows.
  void set(const char* uniform, const Affine& map) const;
  /// Sets the linear part as a mat2.
  void set_linear(const char* uniform, const Affine& map) const;
  /// Binds `texture` to a texture unit for a sampler.
  void bind(const char* sampler, int unit, GLuint texture) const;

 private:
  explicit Program(const Gl& gl);
  Status link(std::string_view name) const;

  const Gl* gl_ = nullptr;
  GlObject object_;
};

}  // namespace sfumato::gpu
