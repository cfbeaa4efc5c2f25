#include "core/presentation/gl_renderer/gl_passes.h"

#include <algorithm>

#include "core/presentation/gl_renderer/shaders.h"

namespace geargraph {
namespace {

constexpr int kShadowSide = 128;
constexpr double kShadowReach = 0.45;  // of the scene's radius: at this height a part darkens by 1/e

}  // namespace

GlPasses::GlPasses(const GlApi& gl)
    : m_gl(gl),
      m_gradient(gl, shaders::kFullVertex, shaders::kGradientFragment),
      m_lit(gl, shaders::kSolidVertex, (std::string(shaders::kLight) + shaders::kSolidFragment).c_str()),
      m_litByVertex(gl, (std::string(shaders::kLight) + shaders::kByVertexVertex).c_str(),
                    shaders::kByVertexFragment),
      m_flat(gl, shaders::kSolidVertex, shaders::kFlatFragment),
      m_disc(gl, shaders::kDiscVertex, shaders::kDiscFragment),
      m_shadow(gl, shaders::kShadowVertex, shaders::kShadowFragment),
      m_blur(gl, shaders::kFullVertex, shaders::kBlurFragment),
      m_halo(gl, shaders::kFullVertex, shaders::kHaloFragment),
      m_overlayProgram(gl, shaders::kOverlayVertex, shaders::kOverlayFragment),
      m_cap(gl, shaders::kCapVertex, shaders::kCapFragment) {
  m_at.litProjection = m_lit.uniform("u_projection");
  m_at.litUp = m_lit.uniform("u_up");
  m_at.litSection = m_lit.uniform("u_section");
  m_at.flatProjection = m_flat.uniform("u_projection");
  m_at.flatNearer = m_flat.uniform("u_nearer");
  m_at.flatSection = m_flat.uniform("u_section");
}

std::string GlPasses::log() const {
  return m_gradient.log() + m_lit.log() + m_litByVertex.log() + m_flat.log() + m_disc.log() + m_shadow.log() +
         m_blur.log() + m_halo.log() + m_overlayProgram.log() + m_cap.log();
}

void GlPasses::set(GLint uniform, const Eigen::Matrix4d& matrix) const {
  const Eigen::Matrix4f narrowed = matrix.cast<float>();
  m_gl.UniformMatrix4fv(uniform, 1, GL_FALSE, narrowed.data());
}

void GlPasses::bindTexture(GLuint texture) const {
  m_gl.ActiveTexture(GL_TEXTURE0);
  m_gl.BindTexture(GL_TEXTURE_2D, texture);
}

void GlPasses::gradient(const Rgb& top, const Rgb& bottom) const {
  m_gradient.use();
  set(m_gradient.uniform("u_top"), top);
  set(m_gradient.uniform("u_bottom"), bottom);
  m_overlay.bindEmpty();
  m_gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void GlPasses::disc(const FloorDisc& disc, const Eigen::Matrix4d& view, const Eigen::Matrix4d& projection,
                    const RenderStyle& style) const {
  m_disc.use();
  set(m_disc.uniform("u_modelView"), view);
  set(m_disc.uniform("u_projection"), projection);
  set(m_disc.uniform("u_disc"), disc);
  set(m_disc.uniform("u_colour"), style.disc);
  set(m_disc.uniform("u_shade"), style.shadow);
  m_gl.Uniform2f(m_disc.uniform("u_strength"), style.discStrength,
                 style.contactShadow ? style.shadowStrength : 0);
  m_gl.Uniform1i(m_disc.uniform("u_shadow"), 0);
  bindTexture(style.contactShadow ? m_shadowImage.texture() : 0);
  m_overlay.bindEmpty();
  m_gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void GlPasses::beginShadow(const FloorDisc& disc, double size) {
  m_shadowImage.ensure(kShadowSide, kShadowSide);
  m_shadowImage.bind();
  m_gl.Disable(GL_DEPTH_TEST);
  m_gl.Disable(GL_CULL_FACE);
  m_gl.ClearColor(0, 0, 0, 0);
  m_gl.Clear(GL_COLOR_BUFFER_BIT);
  m_gl.Enable(GL_BLEND);
  m_gl.BlendEquation(GL_MAX);
  m_shadow.use();
  set(m_shadow.uniform("u_disc"), disc);
  m_gl.Uniform1f(m_shadow.uniform("u_reach"), static_cast<float>(kShadowReach * size));
}

void GlPasses::endShadow() {
  m_gl.Disable(GL_BLEND);
  m_gl.BlendEquation(GL_FUNC_ADD);
  m_blurredImage.ensure(kShadowSide, kShadowSide);
  m_blur.use();
  m_gl.Uniform1i(m_blur.uniform("u_image"), 0);
  m_overlay.bindEmpty();
  constexpr float kTexel = 1.0F / kShadowSide;
  m_blurredImage.bind();
  bindTexture(m_shadowImage.texture());
  m_gl.Uniform2f(m_blur.uniform("u_step"), kTexel, 0);
  m_gl.DrawArrays(GL_TRIANGLES, 0, 3);
  m_shadowImage.bind();
  bindTexture(m_blurredImage.texture());
  m_gl.Uniform2f(m_blur.uniform("u_step"), 0, kTexel);
  m_gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void GlPasses::beginSection(const Eigen::Vector4d& plane) {
  m_section = plane.cast<float>();
  m_gl.Enable(GL_CLIP_DISTANCE0);
}

// The plane goes as well: llvmpipe may go on cutting after the switch is off.
void GlPasses::endSection() {
  m_section = {0, 0, 0, 1};
  m_gl.Disable(GL_CLIP_DISTANCE0);
}

void GlPasses::cap(const Eigen::Matrix4d& view, const Eigen::Matrix4d& projection, const CapSquare& square,
                   const Rgb& colour, bool leansLeft) const {
  const auto vector = [this](const char* name, const Eigen::Vector3d& value) {
    m_gl.Uniform3f(m_cap.uniform(name), static_cast<float>(value.x()), static_cast<float>(value.y()),
                   static_cast<float>(value.z()));
  };
  m_cap.use();
  set(m_cap.uniform("u_modelView"), view);
  set(m_cap.uniform("u_projection"), projection);
  set(m_cap.uniform("u_colour"), colour);
  vector("u_centre", square.centre);
  vector("u_right", square.right);
  vector("u_upward", square.upward);
  m_gl.Uniform2f(m_cap.uniform("u_hatch"), static_cast<float>(square.hatch), leansLeft ? -1.0F : 1.0F);
  m_overlay.bindEmpty();
  m_gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void GlPasses::beginLit(const Eigen::Matrix4d& view, const Eigen::Matrix4d& projection, bool byVertex) const {
  const auto up = [&](GLint uniform) {
    m_gl.Uniform3f(uniform, static_cast<float>(view(0, 2)), static_cast<float>(view(1, 2)),
                   static_cast<float>(view(2, 2)));
  };
  if (byVertex) {
    m_litByVertex.use();
    set(m_litByVertex.uniform("u_projection"), projection);
    return up(m_litByVertex.uniform("u_up"));
  }
  m_lit.use();
  set(m_at.litProjection, projection);
  m_gl.Uniform1f(m_lit.uniform("u_nearer"), 1);
  m_gl.Uniform4f(m_at.litSection, m_section[0], m_section[1], m_section[2], m_section[3]);
  up(m_at.litUp);
}

void GlPasses::beginFlat(const Eigen::Matrix4d& projection, float nearer) const {
  m_flat.use();
  set(m_at.flatProjection, projection);
  m_gl.Uniform1f(m_at.flatNearer, nearer);
  m_gl.Uniform4f(m_at.flatSection, m_section[0], m_section[1], m_section[2], m_section[3]);
}

void GlPasses::draw(const GlSolid& solid, GlSolid::Part part,
                    std::span<const SolidInstance> instances) const {
  m_instances.set(instances);
  solid.draw(part, instances.size());
}

void GlPasses::halo(GLuint mask, const Viewport& viewport, double pixelRatio, const Rgb& colour,
                    float strength) const {
  m_halo.use();
  m_gl.Uniform1i(m_halo.uniform("u_mask"), 0);
  m_gl.Uniform2f(m_halo.uniform("u_step"), static_cast<float>(pixelRatio / viewport.width),
                 static_cast<float>(pixelRatio / viewport.height));
  m_gl.Uniform4f(m_halo.uniform("u_halo"), colour.red, colour.green, colour.blue, strength);
  bindTexture(mask);
  m_overlay.bindEmpty();
  m_gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void GlPasses::overlay(std::span<const OverlayVertex> triangles, const Viewport& viewport,
                       float alpha) const {
  m_overlayProgram.use();
  m_gl.Uniform1f(m_overlayProgram.uniform("u_alpha"), alpha);
  m_gl.Uniform2f(m_overlayProgram.uniform("u_size"), static_cast<float>(viewport.width),
                 static_cast<float>(viewport.height));
  m_overlay.draw(triangles);
}

// Products are formed in double before they are narrowed, so that a far camera does not make parts tremble.
SolidInstance instanceAt(const Eigen::Matrix4d& modelView, const Rgb& colour, float alpha) {
  SolidInstance instance;
  Eigen::Map<Eigen::Matrix4f>(instance.modelView.data()) = modelView.cast<float>();
  instance.colour = {colour.red, colour.green, colour.blue, alpha};
  return instance;
}

Rgb colourOfNumber(std::uint32_t number) {
  const auto byte = [number](unsigned shift) {
    return static_cast<float>((number >> shift) & 255U) / 255.0F;
  };
  return {byte(0), byte(8), byte(16)};
}

void turnUpright(Image& image, bool isOpaque) {
  const std::size_t row = 4 * static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height / 2; ++y) {
    const auto upper = image.rgba.begin() + static_cast<std::ptrdiff_t>(row) * y;
    const auto lower = image.rgba.begin() + static_cast<std::ptrdiff_t>(row) * (image.height - 1 - y);
    std::swap_ranges(upper, upper + static_cast<std::ptrdiff_t>(row), lower);
  }
  for (std::size_t pixel = 0; !isOpaque && pixel < image.rgba.size(); pixel += 4) {
    const unsigned alpha = image.rgba[pixel + 3];
    if (alpha == 0 || alpha == 255) continue;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const unsigned value = (image.rgba[pixel + channel] * 255U + alpha / 2) / alpha;
      image.rgba[pixel + channel] = static_cast<std::uint8_t>(std::min(value, 255U));
    }
  }
}

std::optional<NumberedPixels::Place> NumberedPixels::nearestToMiddle() const {
  std::optional<Place> best;
  for (int i = 0; i < width * height; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Place place{numbers[at], depths[at], i % width - width / 2, i / width - height / 2};
    const auto away = [](const Place& p) { return p.right * p.right + p.up * p.up; };
    if (place.number != 0 && (!best || away(place) < away(*best))) best = place;
  }
  return best;
}

void NumberedPixels::turnUpright() {
  for (int row = 0; row < height / 2; ++row) {
    const auto swapRows = [&](auto& values) {
      const auto low = values.begin() + static_cast<std::ptrdiff_t>(row) * width;
      std::swap_ranges(low, low + width, values.end() - static_cast<std::ptrdiff_t>(row + 1) * width);
    };
    swapRows(numbers);
    swapRows(depths);
  }
}

NumberedPixels readNumbers(const GlApi& gl, int width, int height) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  NumberedPixels pixels{width, height, std::vector<std::uint32_t>(count), std::vector<float>(count)};
  std::vector<std::uint8_t> bytes(4 * count);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  gl.ReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, pixels.depths.data());
  for (std::size_t i = 0; i < count; ++i) {
    pixels.numbers[i] = bytes[4 * i] | (bytes[4 * i + 1] << 8U) | (bytes[4 * i + 2] << 16U);
  }
  return pixels;
}

}  // namespace geargraph
