#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/machine/solids/solid.h"
#include "core/presentation/painting/gl_api.h"

namespace geargraph::inline painting {

// Owners of what lives on the graphics card. Each keeps the table of functions it was made with; the context
// has to be current when it goes.

/// A linked shader program.
class GlProgram {
 public:
  /// `fragment` and `vertex` without the version line. What the compiler says, where it fails, is in log().
  GlProgram(const GlApi& gl, const char* vertex, const char* fragment);
  ~GlProgram() { m_gl.DeleteProgram(m_program); }
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  [[nodiscard]] const std::string& log() const { return m_log; }  ///< empty where all is well
  [[nodiscard]] GLint uniform(const char* name) const { return m_gl.GetUniformLocation(m_program, name); }
  void use() const { m_gl.UseProgram(m_program); }

 private:
  GLuint compiled(GLenum stage, const char* source);

  const GlApi& m_gl;
  GLuint m_program = 0;
  std::string m_log;
};

/// What differs from one place of a solid to the next.
struct SolidInstance {
  std::array<float, 16> modelView{};  ///< column by column
  std::array<float, 4> colour{};      ///< with alpha
  std::array<float, 4> accent{};      ///< alpha: how much of it
};

/// The instances of one draw, in a buffer that all solids read them from.
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

/// A solid on the graphics card: vertices, triangles and, once they are given, feature edges; painted at as
/// many places at once as there are instances.
class GlSolid {
 public:
  enum class Part { triangles, edges };

  GlSolid(const GlApi& gl, const Solid& solid, const GlInstances& instances);
  ~GlSolid();
  GlSolid(const GlSolid&) = delete;
  GlSolid& operator=(const GlSolid&) = delete;

  [[nodiscard]] bool hasEdges() const { return m_edgeIndices >= 0; }
  void setEdges(std::span<const std::uint32_t> edges);
  /// Of one instance. @pre edges, where they are asked for, have been given
  [[nodiscard]] std::size_t indices(Part part) const {
    return static_cast<std::size_t>(part == Part::triangles ? m_triangleIndices : m_edgeIndices);
  }
  /// The first `count` of the instances that are set. @pre edges, where they are painted, have been given
  void draw(Part part, std::size_t count) const;

 private:
  const GlApi& m_gl;
  GLuint m_vertexArray = 0;
  GLuint m_buffers[3] = {0, 0, 0};  ///< vertices, indices of triangles, of edges
  GLsizei m_triangleIndices = 0;
  GLsizei m_edgeIndices = -1;  ///< -1: not given yet
};

/// A framebuffer of its own: colours as a texture (or with several samples a pixel), depth and
/// stencil on demand.
class GlTarget {
 public:
  enum class Colours { rgba, coverage };
  GlTarget(const GlApi& gl, Colours colours, bool depth) : m_gl(gl), m_colours(colours), m_depth(depth) {}
  ~GlTarget() { release(); }
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;

  /// Makes or remakes it where size or samples changed. False where the driver refuses.
  bool ensure(int width, int height, int samples = 1);
  [[nodiscard]] GLuint framebuffer() const { return m_framebuffer; }
  [[nodiscard]] GLuint texture() const { return m_texture; }  ///< 0 with several samples
  void bind() const;  ///< for painting, with the viewport set to all of it

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

/// Coloured triangles in pixels, made anew each frame: the axis triad, lines in space.
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
  /// A vertex array with nothing in it, for shaders that make their own triangle.
  void bindEmpty() const { m_gl.BindVertexArray(m_empty); }

 private:
  const GlApi& m_gl;
  GLuint m_vertexArray = 0;
  GLuint m_empty = 0;
  GLuint m_buffer = 0;
};

}  // namespace geargraph::inline painting
