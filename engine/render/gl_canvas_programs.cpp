#include "render/gl_canvas_programs.hpp"

#include <string>

namespace blossom {
namespace {

template <class GetLog>
Diagnostics refusal(const ProgramSource& source, const char* what, GetLog&& get_log) {
  std::string log(1024, '\0');
  GLsizei length = 0;
  get_log(static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return {{"", 0, 0, "", std::string("OpenGL refuses the ") + source.name + " program's " + what + ": " + log}};
}

}  // namespace

Checked<GLuint> make_program(const GlFunctions& gl, bool is_es, const ProgramSource& source) {
  struct Stage {
    GLenum type;
    const char* name;
    const char* common;
    const char* text;
  };
  const std::array<Stage, 2> stages = {
      {{GL_VERTEX_SHADER, "vertex stage", shaders::common_vertex, source.vertex},
       {GL_FRAGMENT_SHADER, "fragment stage", shaders::common_fragment, source.fragment}}};
  const GLuint program = gl.CreateProgram();
  Diagnostics wrong;
  for (const auto& stage : stages) {
    const GLuint shader = gl.CreateShader(stage.type);
    const std::array<const char*, 4> texts = {is_es ? shaders::es_header : shaders::core_header, shaders::common,
                                              stage.common, stage.text};
    gl.ShaderSource(shader, static_cast<GLsizei>(texts.size()), texts.data(), nullptr);
    gl.CompileShader(shader);
    GLint compiled = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == 0) {
      wrong = refusal(source, stage.name, [&](GLsizei size, GLsizei* length, char* text) {
        gl.GetShaderInfoLog(shader, size, length, text);
      });
    }
    gl.AttachShader(program, shader);
    gl.DeleteShader(shader);  // lives on as long as the program
  }
  if (wrong.empty()) {
    gl.LinkProgram(program);
    GLint linked = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == 0) {
      wrong = refusal(source, "linking", [&](GLsizei size, GLsizei* length, char* text) {
        gl.GetProgramInfoLog(program, size, length, text);
      });
    }
  }
  if (wrong.empty()) return program;
  gl.DeleteProgram(program);
  return wrong;
}

}  // namespace blossom
