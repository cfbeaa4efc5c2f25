#include "core/presentation/gl_renderer/gl_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/presentation/gl_renderer/gl_renderer_class.h"
#include "core/presentation/gl_renderer/mark_lines.h"
#include "core/presentation/gl_renderer/triad.h"

namespace geargraph {
namespace {

constexpr float kHoverTint = 0.10F;
constexpr float kSelectedTint = 0.22F;
constexpr float kTranslucentFaces = 0.14F;  // opacity of translucent faces
constexpr float kTranslucentEdges = 0.35F;  // of the strength of their edges
constexpr float kCoveredMark = 0.25F;       // how much of a line is seen through a solid
constexpr double kHaloReach = 4;            // logical pixels, and one more
/// Samples of a picture that may be stopped that are painted at a time: a rasterizer in software takes some
/// 30 ms to get memory for their colours, to clear and to resolve them, which cannot be stopped.
constexpr std::size_t kMaxStripSamples = 4'000'000;
constexpr double kHatches = 90;          // lines across the scene
constexpr double kFullEdgeHeight = 560;  // logical pixels of a picture whose edges have their full strength

}  // namespace

const GlSolid& GlRenderer::detailed(const Frame& frame, std::size_t shape, const Eigen::Vector3d& middle,
                                    GlSolid::Part part) {
  const double nearest =
      (middle - frame.camera.eye()).dot(frame.camera.forward()) - m_solids.sphereOf(shape).radius;
  const double pixelsAtTarget = m_solids.unitOf(shape) / frame.camera.millimetresPerPixel(frame.viewport);
  return m_solids.get(
      shape, pixelsAtTarget * frame.camera.distance() / std::max(nearest, 1e-3 * frame.camera.distance()),
      part);
}

// As wide as the train stands in its reference pose, and a little more for the carriers that will swing out.
FloorDisc GlRenderer::disc(const Frame& frame) const {
  if (m_bounds.box.isEmpty()) return {};
  const Eigen::Vector3d centre = m_bounds.centre();
  const double radius = m_bounds.radius();
  const double half = 0.5 * m_bounds.box.sizes().head<2>().norm();
  return {centre.x(), centre.y(), frame.floor.value_or(m_bounds.box.min().z()) - 0.02 * radius,
          std::max(1.25 * half, 0.6 * radius)};
}

void GlRenderer::draw(const Frame& frame, unsigned framebuffer) {
  if (!paint(frame)) return;
  resolve(frame.viewport, framebuffer);
  drawHalo(frame, framebuffer);
  m_gl->Disable(GL_BLEND);
  m_gl->UseProgram(0);
}

bool GlRenderer::paint(const Frame& frame) {
  const Viewport& size = frame.viewport;
  if (!m_sampled.ensure(size.width, m_strip.rowsOf(size.height), samplesOf(frame), frame.stop)) return false;
  const bool isFirst = m_strip.bottom == 0;  // of a picture's strips, which all have the same shadow
  if (isFirst && frame.style.contactShadow && !m_scene.instances.empty()) drawShadow(frame);
  m_gl->BlendEquation(GL_FUNC_ADD);
  m_gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (paintLayer(frame)) {
    Frame rest = frame;
    rest.visibility = m_staticParts.rest();
    paintParts(rest);
  } else {
    bind(m_sampled, size);
    drawBackground(frame);
    drawDisc(frame);
    paintParts(frame);
  }
  drawMarks(frame);
  m_gl->Disable(GL_DEPTH_TEST);
  if (frame.style.triad) drawTriad(frame);
  return true;
}

// Only where the processor paints: a card is quicker than any copy.
bool GlRenderer::paintLayer(const Frame& frame) {
  const bool hasTranslucentParts = std::find(frame.visibility.begin(), frame.visibility.end(),
                                             Visibility::translucent) != frame.visibility.end();
  if (!m_software || m_strip.height > 0 || samplesOf(frame) > 1 || frame.style.contactShadow ||
      frame.section || hasTranslucentParts)
    return false;
  const auto& [width, height] = frame.viewport;
  if (!m_layer.ensure(width, height)) return false;
  std::vector<StaticParts::Part> parts;
  for (std::size_t i = 0; i < m_scene.instances.size(); ++i) {
    const Instance& instance = m_scene.instances[i];
    const bool hasLevels = instance.solid < m_scene.levels.size();
    parts.push_back({m_scene.solids[instance.solid],
                     hasLevels ? m_scene.levels[instance.solid] : DetailLevels{}, pose(frame, i),
                     instance.colour, emphasis(frame, i), visibility(frame, i)});
  }
  const StaticParts::Layer layer =
      m_staticParts.next({width, height, frame.pixelRatio, frame.camera, frame.style, isLitByVertex(frame),
                          projection(frame) * frame.camera.view().matrix()},
                         std::move(parts));
  if (layer == StaticParts::Layer::none) return false;
  if (layer == StaticParts::Layer::anew || m_staticParts.hasAdded()) {
    m_layer.bind();
    if (layer == StaticParts::Layer::anew) drawBackground(frame);
    Frame added = frame;
    added.visibility = m_staticParts.added();
    paintParts(added);
  }
  m_gl->BindFramebuffer(GL_READ_FRAMEBUFFER, m_layer.framebuffer());
  m_gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, m_sampled.framebuffer());
  m_gl->BlitFramebuffer(0, 0, width, height, 0, 0, width, height,
                        GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
  // The disc follows the train's size, and is behind all parts: painted where there are none, it need not be
  // in the layer.
  m_sampled.bind();
  m_gl->Enable(GL_DEPTH_TEST);
  m_gl->DepthFunc(GL_LEQUAL);
  m_gl->DepthMask(GL_FALSE);
  drawDisc(frame);
  m_gl->DepthMask(GL_TRUE);
  return true;
}

void GlRenderer::paintParts(const Frame& frame) {
  m_gl->Enable(GL_BLEND);
  m_gl->Enable(GL_DEPTH_TEST);
  m_gl->DepthFunc(GL_LEQUAL);
  m_gl->Enable(GL_CULL_FACE);
  m_gl->CullFace(GL_BACK);
  if (frame.section) beginSection(frame);
  drawSolids(frame);
  drawTranslucent(frame);
  m_passes.endSection();
  m_gl->Disable(GL_CULL_FACE);
}

void GlRenderer::bind(const GlTarget& target, const Viewport& picture) const {
  target.bind();
  if (m_strip.height > 0) m_gl->Viewport(0, -m_strip.bottom, picture.width, picture.height);
}

void GlRenderer::resolve(const Viewport& size, unsigned framebuffer) {
  m_gl->BindFramebuffer(GL_READ_FRAMEBUFFER, m_sampled.framebuffer());
  m_gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  m_gl->BlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
  m_gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

void GlRenderer::drawBackground(const Frame& frame) {
  m_gl->ClearColor(0, 0, 0, 0);
  m_gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  m_gl->Disable(GL_DEPTH_TEST);
  m_gl->Disable(GL_CULL_FACE);
  m_gl->Disable(GL_BLEND);
  if (!frame.style.transparent) m_passes.gradient(frame.style.groundTop, frame.style.groundBottom);
}

void GlRenderer::drawDisc(const Frame& frame) {
  m_gl->Disable(GL_CULL_FACE);
  m_gl->Enable(GL_BLEND);
  const FloorDisc ground = disc(frame);
  if (m_scene.instances.empty() || frame.camera.eye().z() < ground.z) return;
  m_passes.disc(ground, frame.camera.view().matrix(), projection(frame), frame.style);
}

// The range of depths stays while the train changes a little, so that what is kept of it holds.
void GlRenderer::setScene(const Scene& scene) {
  m_solids.setScene(scene);
  const double radius = m_bounds.radius();
  const bool holds = (m_bounds.centre() - m_depths.centre).norm() + 2 * radius <= m_depths.radius &&
                     m_depths.radius <= 4 * radius;
  if (!holds) m_depths = {m_bounds.centre(), 2.5 * radius};
}

void GlRenderer::drawShadow(const Frame& frame) {
  const FloorDisc ground = disc(frame);
  m_passes.beginShadow(ground, m_bounds.radius());
  Eigen::Matrix4d seenFromAbove = Eigen::Matrix4d::Identity() / ground.radius;
  seenFromAbove(0, 3) = -ground.x / ground.radius;
  seenFromAbove(1, 3) = -ground.y / ground.radius;
  seenFromAbove.row(2) *= 1e-6;  // however high
  seenFromAbove(3, 3) = 1;
  drawAll(frame, seenFromAbove, Visibility::solid, GlSolid::Part::triangles,
          [&](std::size_t i) -> std::optional<SolidInstance> {
            if (!m_scene.instances[i].castsShadow) return std::nullopt;
            return instanceAt(pose(frame, i).matrix(), Rgb{});
          });
  m_passes.endShadow();
}

// In the frame of the eye, as the shaders take it.
void GlRenderer::beginSection(const Frame& frame) {
  const Pose view = frame.camera.view();
  const Eigen::Vector3d normal = view.linear() * frame.section->normal;
  Eigen::Vector4d plane;
  plane << normal, frame.section->offset + normal.dot(view.translation());
  m_passes.beginSection(plane);
}

void GlRenderer::drawSolids(const Frame& frame) {
  if (frame.style.faces != Faces::wireframe) {
    drawFaces(frame, Visibility::solid, 1);
    if (frame.section) drawCaps(frame);
  }
  if (frame.style.edges || frame.style.faces != Faces::shaded) drawEdges(frame, Visibility::solid, 1);
}

bool GlRenderer::isLitByVertex(const Frame& frame) const {
  const auto isOpen = [](const Instance& instance) { return instance.isOpen; };
  return frame.style.litByVertex && !frame.section &&
         std::none_of(m_scene.instances.begin(), m_scene.instances.end(), isOpen);
}

void GlRenderer::drawFaces(const Frame& frame, Visibility wanted, float alpha) {
  const Eigen::Matrix4d view = frame.camera.view().matrix();
  m_gl->Enable(GL_POLYGON_OFFSET_FILL);
  m_gl->PolygonOffset(1, 1);
  if (alpha == 1) m_gl->Disable(GL_BLEND);  // which reads every pixel before it writes it
  const bool isDrawing = frame.style.faces == Faces::hiddenLine;
  m_passes.beginLit(view, projection(frame), isLitByVertex(frame));
  drawAll(frame, clip(frame), wanted, GlSolid::Part::triangles,
          [&](std::size_t i) -> std::optional<SolidInstance> {
            const Highlight state = emphasis(frame, i);
            const float tint = state == Highlight::selected  ? kSelectedTint
                               : state == Highlight::hovered ? kHoverTint
                               : isDrawing                   ? 1
                                                             : 0;
            const bool isPaper = isDrawing && state == Highlight::none;
            const Rgb& accent = isPaper ? frame.style.groundTop : frame.style.accent;
            SolidInstance instance =
                instanceAt(view * pose(frame, i).matrix(), m_scene.instances[i].colour, alpha);
            instance.accent = {accent.red, accent.green, accent.blue, tint};
            return instance;
          });
  m_gl->Enable(GL_BLEND);
  m_gl->Disable(GL_POLYGON_OFFSET_FILL);
}

// A ray that has left a closed solid once more often than it has entered it, on the kept side of the plane,
// went in through the cut: there the stencil holds 1, and the plane is the solid's face.
void GlRenderer::drawCaps(const Frame& frame) {
  const CutPlane& section = *frame.section;
  const Eigen::Matrix4d view = frame.camera.view().matrix(), through = projection(frame);
  CapSquare square;
  square.hatch = 2 * m_bounds.radius() / kHatches;
  const Eigen::Vector3d right = section.normal.unitOrthogonal();
  m_gl->Enable(GL_STENCIL_TEST);
  int count = 0;
  constexpr auto kTriangles = GlSolid::Part::triangles;
  eachInstance(frame, clip(frame), Visibility::solid, kTriangles, [&](std::size_t i, const GlSolid& solid) {
    const BoundingSphere& sphere = m_solids.sphereOf(m_scene.instances[i].solid);
    const Eigen::Vector3d centre = pose(frame, i) * sphere.centre;
    const double above = section.normal.dot(centre) - section.offset;
    if (std::abs(above) > sphere.radius || m_scene.instances[i].isOpen) return;
    m_gl->Disable(GL_CULL_FACE);
    m_gl->Disable(GL_DEPTH_TEST);
    m_gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    m_gl->StencilFunc(GL_ALWAYS, 0, 255);
    m_gl->StencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
    m_gl->StencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
    m_passes.beginFlat(through, 1);
    const SolidInstance instance = instanceAt(view * pose(frame, i).matrix(), Rgb{});
    m_passes.draw(solid, GlSolid::Part::triangles, {&instance, 1});
    m_gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    m_gl->Enable(GL_DEPTH_TEST);
    m_gl->StencilFunc(GL_NOTEQUAL, 0, 255);
    m_gl->StencilOp(GL_ZERO, GL_ZERO, GL_ZERO);
    square.centre = centre - above * section.normal;
    square.right = sphere.radius * right;
    square.upward = sphere.radius * section.normal.cross(right);
    m_passes.cap(view, through, square, m_scene.instances[i].colour, ++count % 2 == 0);
    m_gl->Enable(GL_CULL_FACE);
  });
  m_gl->Disable(GL_STENCIL_TEST);
}

// Depth first, colour second: of a translucent part only the nearest faces are seen, once.
void GlRenderer::drawTranslucent(const Frame& frame) {
  if (std::find(frame.visibility.begin(), frame.visibility.end(), Visibility::translucent) ==
      frame.visibility.end())
    return;
  if (frame.style.faces != Faces::wireframe) {
    m_gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawFaces(frame, Visibility::translucent, 1);
    m_gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    drawFaces(frame, Visibility::translucent, kTranslucentFaces);
  }
  drawEdges(frame, Visibility::translucent, kTranslucentEdges);
}

void GlRenderer::drawEdges(const Frame& frame, Visibility wanted, float part) {
  const Eigen::Matrix4d view = frame.camera.view().matrix();
  // In a small picture lines of one pixel would cover the teeth that they are to show.
  const double fade = std::clamp(frame.viewport.height / (kFullEdgeHeight * frame.pixelRatio), 0.55, 1.0);
  const bool coloured = frame.style.faces == Faces::wireframe;
  const float full = frame.style.faces == Faces::shaded ? frame.style.edgeStrength : 0.85F;
  const float strength = part * full * static_cast<float>(fade);
  m_passes.beginFlat(projection(frame), 0.9993F);
  m_gl->DepthMask(GL_FALSE);
  const Rgb& ink = frame.style.faces == Faces::hiddenLine ? frame.style.letters : frame.style.edge;
  drawAll(frame, clip(frame), wanted, GlSolid::Part::edges,
          [&](std::size_t i) -> std::optional<SolidInstance> {
            const bool marked = coloured && emphasis(frame, i) != Highlight::none;
            const Rgb& own = marked ? frame.style.accent : m_scene.instances[i].colour;
            return instanceAt(view * pose(frame, i).matrix(), coloured ? own : ink, strength);
          });
  m_gl->DepthMask(GL_TRUE);
}

void GlRenderer::drawMarks(const Frame& frame) {
  if (frame.marks.empty()) return;
  const Eigen::Matrix4d clip = projection(frame) * frame.camera.view().matrix();
  const std::vector<OverlayVertex> triangles =
      markTriangles(frame.marks, clip, frame.viewport, frame.pixelRatio);
  m_gl->Enable(GL_DEPTH_TEST);
  m_gl->DepthMask(GL_FALSE);
  m_gl->DepthFunc(GL_GREATER);
  m_passes.overlay(triangles, frame.viewport, kCoveredMark);
  m_gl->DepthFunc(GL_LEQUAL);
  m_passes.overlay(triangles, frame.viewport);
  m_gl->DepthMask(GL_TRUE);
}

void GlRenderer::drawTriad(const Frame& frame) {
  m_passes.overlay(axisTriad(frame.camera, frame.viewport, frame.pixelRatio, frame.style), frame.viewport);
}

void GlRenderer::drawHalo(const Frame& frame, unsigned framebuffer) {
  const Eigen::Matrix4d view = frame.camera.view().matrix();
  const Viewport size = extent(frame.viewport);
  for (const Highlight wanted : {Highlight::hovered, Highlight::selected}) {
    if (std::find(frame.emphasis.begin(), frame.emphasis.end(), wanted) == frame.emphasis.end()) continue;
    if (!m_mask.ensure(size.width, size.height)) return;
    bind(m_mask, frame.viewport);
    m_gl->Disable(GL_BLEND);
    m_gl->ClearColor(0, 0, 0, 0);
    m_gl->Clear(GL_COLOR_BUFFER_BIT);
    if (frame.section) beginSection(frame);
    m_passes.beginFlat(projection(frame), 1);
    for (const Visibility shown : {Visibility::solid, Visibility::translucent}) {
      drawAll(frame, clip(frame), shown, GlSolid::Part::triangles,
              [&](std::size_t i) -> std::optional<SolidInstance> {
                if (emphasis(frame, i) != wanted) return std::nullopt;
                return instanceAt(view * pose(frame, i).matrix(), Rgb{1, 1, 1});
              });
    }
    m_passes.endSection();
    m_gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    m_gl->Viewport(0, 0, size.width, size.height);
    m_gl->Enable(GL_BLEND);
    const float strength = wanted == Highlight::selected ? 0.95F : 0.55F;
    m_passes.halo(m_mask.texture(), size, frame.pixelRatio, frame.style.accent, strength);
  }
}

Image GlRenderer::picture(const Frame& frame) {
  Frame cut = frame;
  cut.viewport.width = std::clamp(frame.viewport.width, 1, m_maximumSide);
  cut.viewport.height = std::clamp(frame.viewport.height, 1, m_maximumSide);
  const auto [width, height] = cut.viewport;
  const auto samplesOfRow = static_cast<std::size_t>(width) * static_cast<std::size_t>(samplesOf(cut));
  const bool isInStrips =
      frame.stop.stop_possible() && samplesOfRow * static_cast<std::size_t>(height) > kMaxStripSamples;
  const int rows = isInStrips ? std::max(1, static_cast<int>(kMaxStripSamples / samplesOfRow)) : height;
  const auto bytesOfRow = 4 * static_cast<std::size_t>(width);
  Image image{width, height, {}};
  image.rgba.reserve(bytesOfRow * static_cast<std::size_t>(height));
  bool isPainted = true;
  for (int first = 0; isPainted && first < height; first += rows) {
    const int count = std::min(rows, height - first);
    if (isInStrips) {
      // The halo of what lies beyond the edge reaches into the strip.
      const int margin = static_cast<int>(std::ceil(kHaloReach * frame.pixelRatio));
      const int painted = std::min(height, rows + 2 * margin);  // all the same, for the same memory
      m_strip = {std::clamp(first - margin, 0, height - painted), painted};
    }
    image.rgba.resize(bytesOfRow * static_cast<std::size_t>(first + count));
    isPainted = paintRows(cut, first, count, image);
  }
  m_strip = {};
  if (!isPainted) return {};
  turnUpright(image, !frame.style.transparent);
  return image;
}

bool GlRenderer::paintRows(const Frame& frame, int first, int count, Image& image) {
  const Viewport size = extent(frame.viewport);
  // Without samples there is nothing to resolve: it is read from where it was painted.
  const bool isPlain = samplesOf(frame) == 1;
  if (!isPlain && !m_picture.ensure(size.width, size.height, 1, frame.stop)) return false;
  if (!paint(frame) || frame.stop.stop_requested()) return false;
  if (!isPlain) resolve(size, m_picture.framebuffer());
  drawHalo(frame, isPlain ? m_sampled.framebuffer() : m_picture.framebuffer());
  m_gl->Disable(GL_BLEND);
  m_gl->UseProgram(0);
  if (frame.stop.stop_requested()) return false;
  m_gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
  m_gl->ReadPixels(
      0, first - m_strip.bottom, size.width, count, GL_RGBA, GL_UNSIGNED_BYTE,
      image.rgba.data() + 4 * static_cast<std::size_t>(first) * static_cast<std::size_t>(size.width));
  if (frame.pause) frame.pause();
  return true;
}

bool isSoftwareRenderer(std::string_view name) {
  constexpr std::array<std::string_view, 4> kProcessors{"llvmpipe", "softpipe", "SWR", "Software Rasterizer"};
  return std::any_of(kProcessors.begin(), kProcessors.end(),
                     [&](std::string_view known) { return name.find(known) != std::string_view::npos; });
}

Expected<std::unique_ptr<Renderer>> makeGlRenderer(const GetProcAddress& getProcAddress) {
  const auto rejected = [](const std::string& why) {
    Diagnostic diagnostic;
    diagnostic.code = Code::graphics;
    diagnostic.message = translated("No 3D pictures: %1. Install a driver with OpenGL 3.3 or newer.", {why});
    return diagnostic;
  };
  auto gl = std::make_unique<GlApi>();
  const std::string missing = gl->load(getProcAddress);
  if (!missing.empty()) return rejected(translated("the driver has no %1", {missing}));
  GLint major = 0, minor = 0;
  gl->GetIntegerv(GL_MAJOR_VERSION, &major);
  gl->GetIntegerv(GL_MINOR_VERSION, &minor);
  if (10 * major + minor < 33) {
    return rejected(
        translated("the driver offers OpenGL %1", {std::to_string(major) + "." + std::to_string(minor)}));
  }
  auto renderer = std::make_unique<GlRenderer>(std::move(gl));
  if (!renderer->log().empty())
    return rejected(translated("the driver rejects a shader: %1", {renderer->log()}));
  return std::unique_ptr<Renderer>(std::move(renderer));
}

}  // namespace geargraph
