#pragma once

#include <epoxy/gl.h>

#include <utility>

/// OpenGL ES by epoxy, which finds the functions at run time; the library does not link to a
/// driver.
namespace sfumato::gpu {

/// An OpenGL object that is deleted with this, while its context is current. Movable.
class GlObject {
 public:
  using Delete = void (*)(GLuint);

  GlObject() = default;
  GlObject(GLuint name, Delete destroy) : name_(name), delete_(destroy) {}
  GlObject(GlObject&& other) noexcept
      : name_(std::exchange(other.name_, 0)), delete_(other.delete_) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(delete_, other.delete_);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0) delete_(name_);
  }

  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
  Delete delete_ = nullptr;
};

GlObject make_texture();
GlObject make_framebuffer();
GlObject make_renderbuffer();
GlObject make_buffer();
GlObject make_vertex_array();

}  // namespace sfumato::gpu
