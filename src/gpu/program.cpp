#include "gpu/program.hpp"

#include <algorithm>
#include <string>

#include "base/try.hpp"
#include "display/embedded.hpp"

namespace sfumato::gpu {
namespace {

constexpr int kLogBytes = 1000;

std::string assembled(std::string_view name, const std::vector<std::string_view>& defines) {
  std::string text = "#version 300 es\n";
  for (std::string_view define : defines) text += "#define " + std::string(define) + " 1\n";
  text += Program::text_of("common.glsl");
  const bool has_paints = std::find(defines.begin(), defines.end(), "WITH_PAINTS") != defines.end();
  if (has_paints && name.ends_with(".frag")) text += Program::text_of("paint.glsl");
  text += Program::text_of(name);
  return text;
}

Status add_shader(const Gl& gl, GLuint program, GLenum kind, std::string_view name,
                  const std::string& text) {
  const GLuint shader = gl.CreateShader(kind);
  const char* const source = text.c_str();
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  GLint compiled = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  char log[kLogBytes] = "";
  if (!compiled) gl.GetShaderInfoLog(shader, kLogBytes, nullptr, log);
  gl.AttachShader(program, shader);
  gl.DeleteShader(shader);
  if (compiled) return ok_status();
  return make_error(StatusCode::internal,
                    "the shader " + std::string(name) + " does not compile: " + log);
}

}  // namespace

Program::Program(const Gl& gl)
    : gl_(&gl),
      object_(gl, gl.CreateProgram(), [](const Gl& g, GLuint n) { g.DeleteProgram(n); }) {}

Result<Program> Program::create(const Gl& gl, std::string_view vertex, std::string_view fragment,
                                const std::vector<std::string_view>& defines) {
  Program program(gl);
  const GLuint name = program.name();
  SFUMATO_TRY(add_shader(gl, name, GL_VERTEX_SHADER, vertex, assembled(vertex, defines)));
  SFUMATO_TRY(add_shader(gl, name, GL_FRAGMENT_SHADER, fragment, assembled(fragment, defines)));
  SFUMATO_TRY(program.link(fragment));
  return program;
}

Result<Program> Program::create_compute(const Gl& gl, const std::string& text) {
  Program program(gl);
  constexpr std::string_view kName = "point_walk.glsl";
  SFUMATO_TRY(add_shader(gl, program.name(), GL_COMPUTE_SHADER, kName, text));
  SFUMATO_TRY(program.link(kName));
  return program;
}

std::string_view Program::text_of(std::string_view name) {
  return display::shader_text(name);
}

Status Program::link(std::string_view shader) const {
  gl_->LinkProgram(name());
  GLint linked = 0;
  gl_->GetProgramiv(name(), GL_LINK_STATUS, &linked);
  if (linked) return ok_status();
  char log[kLogBytes] = "";
  gl_->GetProgramInfoLog(name(), kLogBytes, nullptr, log);
  return make_error(StatusCode::internal,
                    "the shader " + std::string(shader) + " does not link: " + log);
}

void Program::set(const char* uniform, int value) const {
  gl_->Uniform1i(gl_->GetUniformLocation(name(), uniform), value);
}

void Program::set(const char* uniform, int x, int y) const {
  gl_->Uniform2i(gl_->GetUniformLocation(name(), uniform), x, y);
}

void Program::set(const char* uniform, float value) const {
  gl_->Uniform1f(gl_->GetUniformLocation(name(), uniform), value);
}

void Program::set(const char* uniform, double x, double y) const {
  gl_->Uniform2f(gl_->GetUniformLocation(name(), uniform), static_cast<float>(x),
                 static_cast<float>(y));
}

void Program::set(const char* uniform, const Affine& m) const {
  const float rows[6] = {static_cast<float>(m.a), static_cast<float>(m.c), static_cast<float>(m.e),
                         static_cast<float>(m.b), static_cast<float>(m.d), static_cast<float>(m.f)};
  gl_->Uniform3fv(gl_->GetUniformLocation(name(), uniform), 2, rows);
}

void Program::set_linear(const char* uniform, const Affine& m) const {
  const float columns[4] = {static_cast<float>(m.a), static_cast<float>(m.b),
                            static_cast<float>(m.c), static_cast<float>(m.d)};
  gl_->UniformMatrix2fv(gl_->GetUniformLocation(name(), uniform), 1, GL_FALSE, columns);
}

void Program::bind(const char* sampler, int unit, GLuint texture) const {
  gl_->ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_->BindTexture(GL_TEXTURE_2D, texture);
  set(sampler, unit);
}

}  // namespace sfumato::gpu
