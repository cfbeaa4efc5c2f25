#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/machine/solids/solid.h"
#include "core/presentation/gl_renderer/gl_api.h"

namespace geargraph {

// Owners of OpenGL objects. Each keeps a reference to the function table that it was made with; the context
// has to be current when it is destroyed.

/// A linked shader program.
class GlProgram {
 public:
  /// `vertex` and `fragment` without the version line. If compilation fails, log() has the compiler's
  /// messages.
  GlProgram(const GlApi& gl, const char* vertex, const char* fragment);
  ~GlProgram() { m_gl.DeleteProgram(m_program); }
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  [[nodiscard]] const std::string& log() const { return m_log; }  ///< empty on success
  [[nodiscard]] GLint uniform(const char* name) const { return m_gl.GetUniformLocation(m_program, name); }
  void use() const { m_gl.UseProgram(m_program); }

 private:
  GLuint compiled(GLenum stage, const char* source);

  const GlApi& m_gl;
  GLuint m_program = 0;
  std::string m_log;
};

/// The data of one instance of a solid.
struct SolidInstance {
  std::array<float, 16> modelView{};  ///< column by column
  std::array<float, 4> colour{};      ///< with alpha
  std::array<float, 4> accent{};      ///< alpha: its share in the colour
};

/// The instances of one draw call, in a buffer that all solids read.
class GlInstances {
 public:
  explicit GlInstances(const GlApi& gl) : m_gl(gl) { gl.GenBuffers(1, &m_buffer); }
  ~GlInstances() { m_gl.DeleteBuffers(1, &m_buffer); }
  GlInstances(const GlInstances&) = delete;
  GlInstances& operator=(const GlInstances&) = delete;

  [[nodiscard]] GLuint buffer() const { return m_buffer; }
  void set(std::span<const SolidInstance> instances) const;

 private:
  const GlApi& m_gl;
  GLuint m_buffer = 0;
};

/// A solid on the graphics card: vertices, triangles and, once set, feature edges; drawn with instancing.
class GlSolid {
 public:
  enum class Part { triangles, edges };

  GlSolid(const GlApi& gl, const Solid& solid, const GlInstances& instances);
  ~GlSolid();
  GlSolid(const GlSolid&) = delete;
  GlSolid& operator=(const GlSolid&) = delete;

  [[nodiscard]] bool hasEdges() const { return m_edgeIndices >= 0; }
  void setEdges(std::span<const std::uint32_t> edges);
  /// The number of indices of one instance. @pre for edges: they have been set
  [[nodiscard]] std::size_t indices(Part part) const {
    return static_cast<std::size_t>(part == Part::triangles ? m_triangleIndices : m_edgeIndices);
  }
  /// Draws the first `count` of the instances that are set. @pre for edges: they have been set
  void draw(Part part, std::size_t count) const;

 private:
  const GlApi& m_gl;
  GLuint m_vertexArray = 0;
  GLuint m_buffers[3] = {0, 0, 0};  ///< vertices, indices of triangles, of edges
  GLsizei m_triangleIndices = 0;
  GLsizei m_edgeIndices = -1;  ///< -1: not set yet
};

/// An offscreen framebuffer: colours as a texture (or multisampled), depth and stencil if wanted.
class GlTarget {
 public:
  enum class Colours { rgba, coverage };
  GlTarget(const GlApi& gl, Colours colours, bool depth) : m_gl(gl), m_colours(colours), m_depth(depth) {}
  ~GlTarget() { release(); }
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;

  /// Creates it, or recreates it if size or samples have changed. False if the driver fails or `stop` was
  /// requested, which is looked at between colours and depth: a software driver writes all their memory.
  bool ensure(int width, int height, int samples = 1, const std::stop_token& stop = {});
  [[nodiscard]] GLuint framebuffer() const { return m_framebuffer; }
  [[nodiscard]] GLuint texture() const { return m_texture; }  ///< 0 if multisampled
  void bind() const;  ///< for painting, with the viewport set to its full size

 private:
  void release();

  const GlApi& m_gl;
  Colours m_colours;
  bool m_depth;
  int m_width = 0;
  int m_height = 0;
  int m_samples = 0;
  GLuint m_framebuffer = 0;
  GLuint m_texture = 0;
  GLuint m_renderbuffers[2] = {0, 0};  ///< colour, depth
};

/// A vertex of coloured triangles in pixels, rebuilt for each frame: the axis triad, lines in space.
struct OverlayVertex {
  float x = 0;  ///< right from the left edge
  float y = 0;  ///< down from the upper edge
  float red = 0;
  float green = 0;
  float blue = 0;
  float depth = -1;  ///< OpenGL's: -1 nearest, 1 farthest
};

class GlOverlay {
 public:
  explicit GlOverlay(const GlApi& gl);
  ~GlOverlay();
  GlOverlay(const GlOverlay&) = delete;
  GlOverlay& operator=(const GlOverlay&) = delete;

  void draw(std::span<const OverlayVertex> triangles) const;
  /// Binds an empty vertex array, for shaders that generate their own triangle.
  void bindEmpty() const { m_gl.BindVertexArray(m_empty); }

 private:
  const GlApi& m_gl;
  GLuint m_vertexArray = 0;
  GLuint m_empty = 0;
  GLuint m_buffer = 0;
};

}  // namespace geargraph
