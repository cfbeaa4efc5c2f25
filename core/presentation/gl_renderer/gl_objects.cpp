#include "core/presentation/gl_renderer/gl_objects.h"

#include <array>
#include <cstddef>

namespace geargraph {
namespace {

const void* offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);
}  // NOLINT

}  // namespace

GlProgram::GlProgram(const GlApi& gl, const char* vertex, const char* fragment) : m_gl(gl) {
  m_program = gl.CreateProgram();
  const GLuint stages[] = {compiled(GL_VERTEX_SHADER, vertex), compiled(GL_FRAGMENT_SHADER, fragment)};
  for (const GLuint stage : stages) gl.AttachShader(m_program, stage);
  gl.BindAttribLocation(m_program, 0, "a_position");
  gl.BindAttribLocation(m_program, 1, "a_normal");
  gl.BindAttribLocation(m_program, 2, "a_depth");
  gl.LinkProgram(m_program);
  for (const GLuint stage : stages) gl.DeleteShader(stage);
  GLint linked = 0;
  gl.GetProgramiv(m_program, GL_LINK_STATUS, &linked);
  if (linked != 0) return;
  std::array<char, 1024> text{};
  gl.GetProgramInfoLog(m_program, static_cast<GLsizei>(text.size()), nullptr, text.data());
  m_log += text.data();
  if (m_log.empty()) m_log = "a shader program did not link";
}

GLuint GlProgram::compiled(GLenum stage, const char* source) {
  const GLuint shader = m_gl.CreateShader(stage);
  const char* parts[] = {"#version 330 core\n", source};
  m_gl.ShaderSource(shader, 2, parts, nullptr);
  m_gl.CompileShader(shader);
  GLint fine = 0;
  m_gl.GetShaderiv(shader, GL_COMPILE_STATUS, &fine);
  if (fine == 0) {
    std::array<char, 1024> text{};
    m_gl.GetShaderInfoLog(shader, static_cast<GLsizei>(text.size()), nullptr, text.data());
    m_log += text.data();
  }
  return shader;
}

GlSolid::GlSolid(const GlApi& gl, const Solid& solid, const GlInstances& instances) : m_gl(gl) {
  m_triangleIndices = static_cast<GLsizei>(3 * solid.triangles.size());
  const auto vertexBytes = static_cast<GLsizeiptr>(solid.positions.size() * sizeof(Float3));
  const auto triangleBytes = static_cast<GLsizeiptr>(solid.triangles.size() * sizeof(Triangle));
  gl.GenVertexArrays(1, &m_vertexArray);
  gl.GenBuffers(3, m_buffers);
  gl.BindVertexArray(m_vertexArray);
  gl.BindBuffer(GL_ARRAY_BUFFER, m_buffers[0]);
  gl.BufferData(GL_ARRAY_BUFFER, 2 * vertexBytes, nullptr, GL_STATIC_DRAW);
  gl.BufferSubData(GL_ARRAY_BUFFER, 0, vertexBytes, solid.positions.data());
  gl.BufferSubData(GL_ARRAY_BUFFER, vertexBytes, vertexBytes, solid.normals.data());
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(1);
  gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 0, offset(static_cast<std::size_t>(vertexBytes)));
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffers[1]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, triangleBytes, solid.triangles.data(), GL_STATIC_DRAW);
  gl.BindBuffer(GL_ARRAY_BUFFER, instances.buffer());
  for (GLuint column = 0; column < 6; ++column) {  // four of the matrix, colour, accent
    const GLuint place = 2 + column;
    gl.EnableVertexAttribArray(place);
    gl.VertexAttribPointer(place, 4, GL_FLOAT, GL_FALSE, sizeof(SolidInstance),
                           offset(column * 4 * sizeof(float)));
    gl.VertexAttribDivisor(place, 1);
  }
  gl.BindVertexArray(0);
}

GlSolid::~GlSolid() {
  m_gl.DeleteVertexArrays(1, &m_vertexArray);
  m_gl.DeleteBuffers(3, m_buffers);
}

void GlSolid::setEdges(std::span<const std::uint32_t> edges) {
  m_edgeIndices = static_cast<GLsizei>(edges.size());
  m_gl.BindVertexArray(m_vertexArray);
  m_gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffers[2]);
  m_gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(edges.size_bytes()), edges.data(),
                  GL_STATIC_DRAW);
  m_gl.BindVertexArray(0);
}

void GlSolid::draw(Part part, std::size_t count) const {
  const bool isEdges = part == Part::edges;
  m_gl.BindVertexArray(m_vertexArray);
  m_gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffers[isEdges ? 2 : 1]);
  m_gl.DrawElementsInstanced(isEdges ? GL_LINES : GL_TRIANGLES, isEdges ? m_edgeIndices : m_triangleIndices,
                             GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(count));
  m_gl.BindVertexArray(0);
}

void GlInstances::set(std::span<const SolidInstance> instances) const {
  m_gl.BindBuffer(GL_ARRAY_BUFFER, m_buffer);
  m_gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data(),
                  GL_STREAM_DRAW);
}

bool GlTarget::ensure(int width, int height, int samples, const std::stop_token& stop) {
  if (m_framebuffer != 0 && width == m_width && height == m_height && samples == m_samples) return true;
  release();
  m_width = width;
  m_height = height;
  m_samples = samples;
  const GLenum format = m_colours == Colours::rgba ? GL_RGBA8 : GL_R8;
  m_gl.GenFramebuffers(1, &m_framebuffer);
  m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
  m_gl.GenRenderbuffers(2, m_renderbuffers);
  const GLsizei stored = samples > 1 ? samples : 0;
  if (samples > 1) {
    m_gl.BindRenderbuffer(GL_RENDERBUFFER, m_renderbuffers[0]);
    m_gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, stored, format, width, height);
    m_gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_renderbuffers[0]);
  } else {
    m_gl.GenTextures(1, &m_texture);
    m_gl.BindTexture(GL_TEXTURE_2D, m_texture);
    const GLenum channels = m_colours == Colours::rgba ? GL_RGBA : GL_RED;
    m_gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, channels,
                    GL_UNSIGNED_BYTE, nullptr);
    m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    m_gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_texture, 0);
  }
  if (stop.stop_requested()) {
    release();
    return false;
  }
  if (m_depth) {
    m_gl.BindRenderbuffer(GL_RENDERBUFFER, m_renderbuffers[1]);
    m_gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, stored, GL_DEPTH24_STENCIL8, width, height);
    m_gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                 m_renderbuffers[1]);
  }
  const bool isComplete = m_gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (!isComplete) release();  // the next call tries again
  return isComplete;
}

void GlTarget::bind() const {
  m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
  m_gl.Viewport(0, 0, m_width, m_height);
}

void GlTarget::release() {
  if (m_framebuffer == 0) return;
  m_gl.DeleteFramebuffers(1, &m_framebuffer);
  m_gl.DeleteTextures(1, &m_texture);
  m_gl.DeleteRenderbuffers(2, m_renderbuffers);
  m_framebuffer = 0;
  m_texture = 0;
}

GlOverlay::GlOverlay(const GlApi& gl) : m_gl(gl) {
  gl.GenVertexArrays(1, &m_empty);
  gl.GenVertexArrays(1, &m_vertexArray);
  gl.GenBuffers(1, &m_buffer);
  gl.BindVertexArray(m_vertexArray);
  gl.BindBuffer(GL_ARRAY_BUFFER, m_buffer);
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(OverlayVertex), nullptr);
  gl.EnableVertexAttribArray(1);
  gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(OverlayVertex), offset(2 * sizeof(float)));
  gl.EnableVertexAttribArray(2);
  gl.VertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, sizeof(OverlayVertex), offset(5 * sizeof(float)));
  gl.BindVertexArray(0);
}

GlOverlay::~GlOverlay() {
  m_gl.DeleteVertexArrays(1, &m_vertexArray);
  m_gl.DeleteVertexArrays(1, &m_empty);
  m_gl.DeleteBuffers(1, &m_buffer);
}

void GlOverlay::draw(std::span<const OverlayVertex> triangles) const {
  m_gl.BindVertexArray(m_vertexArray);
  m_gl.BindBuffer(GL_ARRAY_BUFFER, m_buffer);
  m_gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size_bytes()), triangles.data(),
                  GL_STREAM_DRAW);
  m_gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles.size()));
  m_gl.BindVertexArray(0);
}

}  // namespace geargraph
