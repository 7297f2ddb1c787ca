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

GlObject make_texture(const Gl& gl) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  return {gl, name, [](const Gl& g, GLuint n) { g.DeleteTextures(1, &n); }};
}

GlObject make_framebuffer(const Gl& gl) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  return {gl, name, [](const Gl& g, GLuint n) { g.DeleteFramebuffers(1, &n); }};
}

GlObject make_renderbuffer(const Gl& gl) {
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  return {gl, name, [](const Gl& g, GLuint n) { g.DeleteRenderbuffers(1, &n); }};
}

GlObject make_buffer(const Gl& gl) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  return {gl, name, [](const Gl& g, GLuint n) { g.DeleteBuffers(1, &n); }};
}

GlObject make_vertex_array(const Gl& gl) {
  GLuint name = 0;
  gl.GenVertexArrays(1, &name);
  return {gl, name, [](const Gl& g, GLuint n) { g.DeleteVertexArrays(1, &n); }};
}

}  // namespace sfumato::gpu
