#pragma once

#include <GLES3/gl31.h>

/// OpenGL ES as functions that are loaded at run time; the library does not link to it.
namespace sfumato::gpu {

#define SFUMATO_GL_FUNCTIONS(F) \
  F(ActiveTexture)              \
  F(AttachShader)               \
  F(BindBuffer)                 \
  F(BindBufferBase)             \
  F(BindFramebuffer)            \
  F(BindRenderbuffer)           \
  F(BindTexture)                \
  F(BindVertexArray)            \
  F(BlendEquation)              \
  F(BlendFunc)                  \
  F(BlitFramebuffer)            \
  F(BufferData)                 \
  F(CheckFramebufferStatus)     \
  F(Clear)                      \
  F(ClearColor)                 \
  F(CompileShader)              \
  F(CreateProgram)              \
  F(CreateShader)               \
  F(DeleteBuffers)              \
  F(DeleteFramebuffers)         \
  F(DeleteProgram)              \
  F(DeleteRenderbuffers)        \
  F(DeleteShader)               \
  F(DeleteTextures)             \
  F(DeleteVertexArrays)         \
  F(Disable)                    \
  F(DrawArrays)                 \
  F(DrawArraysInstanced)        \
  F(Enable)                     \
  F(FramebufferRenderbuffer)    \
  F(FramebufferTexture2D)       \
  F(GenBuffers)                 \
  F(GenFramebuffers)            \
  F(GenRenderbuffers)           \
  F(GenTextures)                \
  F(GenVertexArrays)            \
  F(GetError)                   \
  F(GetIntegerv)                \
  F(GetProgramInfoLog)          \
  F(GetProgramiv)               \
  F(GetShaderInfoLog)           \
  F(GetShaderiv)                \
  F(GetString)                  \
  F(GetUniformBlockIndex)       \
  F(GetUniformLocation)         \
  F(LinkProgram)                \
  F(PixelStorei)                \
  F(ReadPixels)                 \
  F(RenderbufferStorage)        \
  F(Scissor)                    \
  F(ShaderSource)               \
  F(StencilFunc)                \
  F(StencilOp)                  \
  F(TexParameteri)              \
  F(TexStorage2D)               \
  F(TexSubImage2D)              \
  F(Uniform1f)                  \
  F(Uniform1i)                  \
  F(Uniform2f)                  \
  F(Uniform2i)                  \
  F(Uniform3fv)                 \
  F(UniformBlockBinding)        \
  F(UniformMatrix2fv)           \
  F(UseProgram)                 \
  F(Viewport)

/// The functions of OpenGL ES 3.1 for compute shaders.
#define SFUMATO_GL_COMPUTE_FUNCTIONS(F) \
  F(BufferSubData)                      \
  F(DispatchCompute)                    \
  F(Finish)                             \
  F(GetInteger64v)                      \
  F(MapBufferRange)                     \
  F(MemoryBarrier)                      \
  F(UnmapBuffer)

/// The functions, without their "gl": gl.DrawArrays(…). The functions for compute shaders are null
/// unless the context is of OpenGL ES 3.1.
struct Gl {
#define SFUMATO_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
  SFUMATO_GL_FUNCTIONS(SFUMATO_GL_MEMBER)
  SFUMATO_GL_COMPUTE_FUNCTIONS(SFUMATO_GL_MEMBER)
#undef SFUMATO_GL_MEMBER
};

/// An OpenGL object that is deleted with this, while its context is current. Movable.
class GlObject {
 public:
  using Delete = void (*)(const Gl&, GLuint);

  GlObject() = default;
  GlObject(const Gl& gl, GLuint name, Delete destroy) : gl_(&gl), name_(name), delete_(destroy) {}
  GlObject(GlObject&& other) noexcept : gl_(other.gl_), name_(other.name_), delete_(other.delete_) {
    other.name_ = 0;
  }
  GlObject& operator=(GlObject&& other) noexcept;
  ~GlObject();

  GLuint name() const { return name_; }

 private:
  const Gl* gl_ = nullptr;
  GLuint name_ = 0;
  Delete delete_ = nullptr;
};

GlObject make_texture(const Gl& gl);
GlObject make_framebuffer(const Gl& gl);
GlObject make_renderbuffer(const Gl& gl);
GlObject make_buffer(const Gl& gl);
GlObject make_vertex_array(const Gl& gl);

}  // namespace sfumato::gpu
