#pragma once

#include <string>
#include <string_view>
#include <utility>
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
  static Result<Program> create(std::string_view vertex, std::string_view fragment,
                                const std::vector<std::string_view>& defines);

  /// Compiles a compute shader from its complete text. Errors: internal, as above.
  static Result<Program> create_compute(const std::string& text);

  /// Makes this the current program, to which the setters below apply.
  void use() const { glUseProgram(object_.name()); }
  GLuint name() const { return object_.name(); }

  /// Returns a file of web/viewer/shaders, point_walk.glsl, or a file of src/gpu.
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
  explicit Program(GlObject object) : object_(std::move(object)) {}
  Status link(std::string_view name) const;

  GlObject object_;
};

}  // namespace sfumato::gpu
