#include "gpu/target.hpp"

#include "base/try.hpp"

namespace sfumato::gpu {

Result<Target> Target::create(Context& context, const Device& device, GLenum format,
                              std::size_t bytes, int width, int height, bool with_stencil) {
  Target target;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  constexpr std::size_t kStencilBytes = 4;
  const std::size_t pixel_bytes = bytes + (with_stencil ? kStencilBytes : 0);
  SFUMATO_TRY(target.charge_.add(context, pixels * pixel_bytes, "an image on the GPU"));
  target.width_ = width;
  target.height_ = height;
  SFUMATO_TRY(target.attach(device, format, with_stencil));
  return target;
}

Status Target::attach(const Device& device, GLenum format, bool with_stencil) {
  framebuffer_ = make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  texture_ = make_texture();
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glTexStorage2D(GL_TEXTURE_2D, 1, format, width_, height_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  if (with_stencil) {
    stencil_ = make_renderbuffer();
    glBindRenderbuffer(GL_RENDERBUFFER, stencil_.name());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width_, height_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                              stencil_.name());
  }
  if (glGetError() == GL_OUT_OF_MEMORY)
    return make_error(StatusCode::out_of_memory, "out of memory on the GPU");
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return ok_status();
  return make_error(StatusCode::unavailable, "no GPU can be used: " + device.name() +
                                                 " cannot draw to images of the kind needed");
}

void Target::begin(const PixelRect& rect) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, width_, height_);
  glScissor(rect.x0, rect.y0, rect.x1 - rect.x0, rect.y1 - rect.y0);
}

void Target::clear(float r, float g, float b, float a) const {
  glClearColor(r, g, b, a);
  glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void Target::copy_to(const Target& target, const PixelRect& rect) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer_.name());
  glScissor(rect.x0, rect.y0, rect.x1 - rect.x0, rect.y1 - rect.y0);
  glBlitFramebuffer(rect.x0, rect.y0, rect.x1, rect.y1, rect.x0, rect.y0, rect.x1, rect.y1,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace sfumato::gpu
