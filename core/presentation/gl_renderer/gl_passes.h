#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/presentation/gl_renderer/gl_objects.h"
#include "core/presentation/scene/camera.h"
#include "core/presentation/scene/image.h"
#include "core/presentation/scene/render_style.h"

namespace geargraph {

/// The floor disc below the train: centre (x, y), height z and radius, mm.
struct FloorDisc {
  double x = 0;
  double y = 0;
  double z = 0;
  double radius = 1;
};

/// A square in the cutting plane, with the spacing of its hatching, mm.
struct CapSquare {
  Eigen::Vector3d centre;
  Eigen::Vector3d right;   ///< half a side
  Eigen::Vector3d upward;  ///< half a side
  double hatch = 1;
};

/// The shader programs of the renderer with their uniforms; only this class knows what to set and in which
/// order. Everything of one kind is drawn between its begin...() and the next one.
class GlPasses {
 public:
  explicit GlPasses(const GlApi& gl);

  /// The messages of the shader compiler; empty on success.
  [[nodiscard]] std::string log() const;

  void gradient(const Rgb& top, const Rgb& bottom) const;
  void disc(const FloorDisc& disc, const Eigen::Matrix4d& view, const Eigen::Matrix4d& projection,
            const RenderStyle& style) const;

  /// Begins the image of the contact shadow, seen from above; the scene's `size` determines up to which
  /// height parts cast it.
  void beginShadow(const FloorDisc& disc, double size);
  void endShadow();

  /// Until endSection() the parts of solids with normal . x > offset (in the eye's frame) are clipped.
  void beginSection(const Eigen::Vector4d& plane);
  void endSection();
  /// Draws the cut face where the stencil is set, within a square of the plane.
  void cap(const Eigen::Matrix4d& view, const Eigen::Matrix4d& projection, const CapSquare& square,
           const Rgb& colour, bool leansLeft) const;

  /// `byVertex`: RenderStyle::litByVertex, for closed solids without a section.
  void beginLit(const Eigen::Matrix4d& view, const Eigen::Matrix4d& projection, bool byVertex) const;
  void beginFlat(const Eigen::Matrix4d& projection, float nearer) const;
  /// To be called after beginShadow() (model matrices to the world then), beginLit() or beginFlat().
  void draw(const GlSolid& solid, GlSolid::Part part, std::span<const SolidInstance> instances) const;
  [[nodiscard]] const GlInstances& instances() const { return m_instances; }

  void halo(GLuint mask, const Viewport& viewport, double pixelRatio, const Rgb& colour,
            float strength) const;
  void overlay(std::span<const OverlayVertex> triangles, const Viewport& viewport, float alpha = 1) const;

 private:
  void set(GLint uniform, const Eigen::Matrix4d& matrix) const;
  void set(GLint uniform, const Rgb& colour) const {
    m_gl.Uniform3f(uniform, colour.red, colour.green, colour.blue);
  }
  void set(GLint uniform, const FloorDisc& disc) const {
    m_gl.Uniform4f(uniform, static_cast<float>(disc.x), static_cast<float>(disc.y),
                   static_cast<float>(disc.z), static_cast<float>(disc.radius));
  }
  void bindTexture(GLuint texture) const;

  const GlApi& m_gl;
  GlOverlay m_overlay{m_gl};
  GlInstances m_instances{m_gl};
  GlProgram m_gradient, m_lit, m_litByVertex, m_flat, m_disc, m_shadow, m_blur, m_halo, m_overlayProgram,
      m_cap;
  Eigen::Vector4f m_section{0, 0, 0, 1};
  GlTarget m_shadowImage{m_gl, GlTarget::Colours::coverage, false};
  GlTarget m_blurredImage{m_gl, GlTarget::Colours::coverage, false};

  struct Uniforms {  // of the programs that are used several times per picture
    GLint litProjection, litUp, litSection;
    GLint flatProjection, flatNearer, flatSection;
  } m_at{};
};

/// An instance with its model matrix to the eye's frame (for shadows, to the world).
[[nodiscard]] SolidInstance instanceAt(const Eigen::Matrix4d& modelView, const Rgb& colour, float alpha = 1);
/// A colour that encodes a number, for NumberedPixels.
[[nodiscard]] Rgb colourOfNumber(std::uint32_t number);

/// Converts an image read from OpenGL (rows upwards, premultiplied alpha) to an Image (rows downwards,
/// straight alpha). `isOpaque`: all alphas are 1.
void turnUpright(Image& image, bool isOpaque);

/// The numbers of instances (plus 1; 0 is the background) and the depths in some pixels, row by row.
struct NumberedPixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> numbers;
  std::vector<float> depths;

  struct Place {
    std::uint32_t number = 0;
    float depth = 1;
    int right = 0;  ///< pixels from the middle
    int up = 0;
  };
  [[nodiscard]] std::optional<Place> nearestToMiddle() const;
  void turnUpright();
};

/// Reads the pixels from the bound framebuffer's lower left corner; the lowest row is the first.
[[nodiscard]] NumberedPixels readNumbers(const GlApi& gl, int width, int height);

}  // namespace geargraph
