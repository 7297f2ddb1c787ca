#include "gpu/program.hpp"

#include <algorithm>

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

Status add_shader(GLuint program, GLenum kind, std::string_view name, const std::string& text) {
  const GLuint shader = glCreateShader(kind);
  const char* const source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  char log[kLogBytes] = "";
  if (!compiled) glGetShaderInfoLog(shader, kLogBytes, nullptr, log);
  glAttachShader(program, shader);
  glDeleteShader(shader);
  if (compiled) return ok_status();
  return make_error(StatusCode::internal,
                    "the shader " + std::string(name) + " does not compile: " + log);
}

GlObject make_program() {
  return {glCreateProgram(), [](GLuint n) { glDeleteProgram(n); }};
}

}  // namespace

Result<Program> Program::create(std::string_view vertex, std::string_view fragment,
                                const std::vector<std::string_view>& defines) {
  Program program(make_program());
  const GLuint name = program.name();
  SFUMATO_TRY(add_shader(name, GL_VERTEX_SHADER, vertex, assembled(vertex, defines)));
  SFUMATO_TRY(add_shader(name, GL_FRAGMENT_SHADER, fragment, assembled(fragment, defines)));
  SFUMATO_TRY(program.link(fragment));
  return program;
}

Result<Program> Program::create_compute(const std::string& text) {
  Program program(make_program());
  constexpr std::string_view kName = "point_walk.glsl";
  SFUMATO_TRY(add_shader(program.name(), GL_COMPUTE_SHADER, kName, text));
  SFUMATO_TRY(program.link(kName));
  return program;
}

std::string_view Program::text_of(std::string_view name) {
  return display::shader_text(name);
}

Status Program::link(std::string_view shader) const {
  glLinkProgram(name());
  GLint linked = 0;
  glGetProgramiv(name(), GL_LINK_STATUS, &linked);
  if (linked) return ok_status();
  char log[kLogBytes] = "";
  glGetProgramInfoLog(name(), kLogBytes, nullptr, log);
  return make_error(StatusCode::internal,
                    "the shader " + std::string(shader) + " does not link: " + log);
}

void Program::set(const char* uniform, int value) const {
  glUniform1i(glGetUniformLocation(name(), uniform), value);
}

void Program::set(const char* uniform, int x, int y) const {
  glUniform2i(glGetUniformLocation(name(), uniform), x, y);
}

void Program::set(const char* uniform, float value) const {
  glUniform1f(glGetUniformLocation(name(), uniform), value);
}

void Program::set(const char* uniform, double x, double y) const {
  glUniform2f(glGetUniformLocation(name(), uniform), static_cast<float>(x), static_cast<float>(y));
}

void Program::set(const char* uniform, const Affine& m) const {
  const float rows[6] = {static_cast<float>(m.a), static_cast<float>(m.c), static_cast<float>(m.e),
                         static_cast<float>(m.b), static_cast<float>(m.d), static_cast<float>(m.f)};
  glUniform3fv(glGetUniformLocation(name(), uniform), 2, rows);
}

void Program::set_linear(const char* uniform, const Affine& m) const {
  const float columns[4] = {static_cast<float>(m.a), static_cast<float>(m.b),
                            static_cast<float>(m.c), static_cast<float>(m.d)};
  glUniformMatrix2fv(glGetUniformLocation(name(), uniform), 1, GL_FALSE, columns);
}

void Program::bind(const char* sampler, int unit, GLuint texture) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
  set(sampler, unit);
}

}  // namespace sfumato::gpu
