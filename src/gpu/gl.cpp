#include "gpu/gl.hpp"

#include <utility>

namespace sfumato::gpu {

GlObject& GlObject::operator=(GlObject&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(name_, other.name_);
  std::swap(delete_, other.delete_);
  return *this;
}

GlObject::~GlObject() {
  if (name_ != 0) delete_(*gl_, name_);
}

namespace {

template <auto kGenerate, auto kDelete>
GlObject make(const Gl& gl) {
  GLuint name = 0;
  (gl.*kGenerate)(1, &name);
  return {gl, name, [](const Gl& g, GLuint n) { (g.*kDelete)(1, &n); }};
}

}  // namespace

GlObject make_texture(const Gl& gl) {
  return make<&Gl::GenTextures, &Gl::DeleteTextures>(gl);
}

GlObject make_framebuffer(const Gl& gl) {
  return make<&Gl::GenFramebuffers, &Gl::DeleteFramebuffers>(gl);
}

GlObject make_renderbuffer(const Gl& gl) {
  return make<&Gl::GenRenderbuffers, &Gl::DeleteRenderbuffers>(gl);
}

GlObject make_buffer(const Gl& gl) {
  return make<&Gl::GenBuffers, &Gl::DeleteBuffers>(gl);
}

GlObject make_vertex_array(const Gl& gl) {
  return make<&Gl::GenVertexArrays, &Gl::DeleteVertexArrays>(gl);
}

}  // namespace sfumato::gpu
