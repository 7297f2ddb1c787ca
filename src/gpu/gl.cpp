#include "gpu/gl.hpp"

namespace sfumato::gpu {

// Epoxy's functions are macros for pointers that it sets at the first call.
#define SFUMATO_GL_MAKER(maker, kind)                       \
  GlObject maker() {                                        \
    GLuint name = 0;                                        \
    glGen##kind(1, &name);                                  \
    return {name, [](GLuint n) { glDelete##kind(1, &n); }}; \
  }
SFUMATO_GL_MAKER(make_texture, Textures)
SFUMATO_GL_MAKER(make_framebuffer, Framebuffers)
SFUMATO_GL_MAKER(make_renderbuffer, Renderbuffers)
SFUMATO_GL_MAKER(make_buffer, Buffers)
SFUMATO_GL_MAKER(make_vertex_array, VertexArrays)
#undef SFUMATO_GL_MAKER

}  // namespace sfumato::gpu
