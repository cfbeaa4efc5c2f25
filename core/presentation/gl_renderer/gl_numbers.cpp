#include "core/presentation/gl_renderer/gl_renderer_class.h"

namespace geargraph {

void GlRenderer::drawNumbers(const Frame& frame, const Eigen::Matrix4d& cut) {
  const Eigen::Matrix4d through = projection(frame);
  const Eigen::Matrix4d view = frame.camera.view().matrix();
  m_gl->Disable(GL_BLEND);
  m_gl->Enable(GL_DEPTH_TEST);
  m_gl->DepthFunc(GL_LEQUAL);
  frame.section ? m_gl->Disable(GL_CULL_FACE)
                : m_gl->Enable(GL_CULL_FACE);  // of a cut solid the inside shows
  m_gl->ClearColor(0, 0, 0, 0);
  m_gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  if (frame.section) beginSection(frame);
  m_passes.beginFlat(cut * through, 1);
  m_gl->Enable(GL_STENCIL_TEST);  // translucent parts only where there is nothing else
  m_gl->StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  for (const Visibility wanted : {Visibility::solid, Visibility::translucent}) {
    wanted == Visibility::solid ? m_gl->StencilFunc(GL_ALWAYS, 1, 255) : m_gl->StencilFunc(GL_EQUAL, 0, 255);
    drawAll(frame, cut * through * view, wanted, GlSolid::Part::triangles,
            [&](std::size_t i) -> std::optional<SolidInstance> {
              return instanceAt(view * pose(frame, i).matrix(),
                                colourOfNumber(static_cast<std::uint32_t>(i + 1)));
            });
  }
  m_gl->Disable(GL_STENCIL_TEST);
  m_passes.endSection();
  m_gl->Disable(GL_CULL_FACE);
  m_gl->Disable(GL_DEPTH_TEST);
}

// The picture is cut to three by three pixels round the place before anything is painted, so a pick costs the
// vertices and hardly a pixel.
std::optional<Hit> GlRenderer::pick(const Frame& frame, double x, double y) {
  constexpr int kSide = 3;
  const double width = frame.viewport.width, height = frame.viewport.height;
  if (!(x >= 0 && x < width && y >= 0 && y < height) || !m_numbers.ensure(kSide, kSide)) return std::nullopt;
  Eigen::Matrix4d cut = Eigen::Matrix4d::Identity();
  cut(0, 0) = width / kSide;
  cut(1, 1) = height / kSide;
  cut(0, 3) = (width - 2 * (std::floor(x) + 0.5)) / kSide;
  cut(1, 3) = (2 * (std::floor(y) + 0.5) - height) / kSide;
  m_numbers.bind();
  drawNumbers(frame, cut);
  const auto place = readNumbers(*m_gl, kSide, kSide).nearestToMiddle();
  if (!place) return std::nullopt;
  const Eigen::Vector3d onScreen(2 * (std::floor(x) + 0.5 + place->right) / width - 1,
                                 1 - 2 * (std::floor(y) + 0.5 - place->up) / height, 2.0 * place->depth - 1);
  const Eigen::Vector4d met = toWorld(frame) * onScreen.homogeneous();
  const std::size_t instance = place->number - 1;
  return Hit{instance, m_scene.instances[instance].element, met.hnormalized()};
}

VisibilityBuffer GlRenderer::seen(const Frame& frame, int columns, int rows) {
  if (!m_cells.ensure(columns, rows)) return {};
  m_cells.bind();
  drawNumbers(frame, Eigen::Matrix4d::Identity());
  NumberedPixels pixels = readNumbers(*m_gl, columns, rows);
  pixels.turnUpright();
  return {columns, rows, std::move(pixels.numbers), std::move(pixels.depths), toWorld(frame)};
}

}  // namespace geargraph
