#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/presentation/gl_renderer/gl_objects.h"
#include "core/presentation/gl_renderer/gl_passes.h"
#include "core/presentation/gl_renderer/gl_renderer.h"
#include "core/presentation/gl_renderer/gl_solid_store.h"
#include "core/presentation/gl_renderer/static_parts.h"
#include "core/presentation/scene/frustum.h"
#include "core/presentation/scene/renderer.h"

namespace geargraph {

/// The Renderer for OpenGL 3.3 core; made by makeGlRenderer().
class GlRenderer final : public Renderer {
 public:
  explicit GlRenderer(std::unique_ptr<GlApi> gl) : m_gl(std::move(gl)), m_passes(*m_gl) {
    m_name = reinterpret_cast<const char*>(m_gl->GetString(GL_RENDERER));  // NOLINT
    m_software = isSoftwareRenderer(m_name);
    m_gl->GetIntegerv(GL_MAX_SAMPLES, &m_maximumSamples);
    GLint renderbuffer = 0, texture = 0;
    m_gl->GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
    m_gl->GetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    m_maximumSide = std::min(renderbuffer, texture);
  }

  [[nodiscard]] std::string log() const { return m_passes.log(); }
  [[nodiscard]] const std::string& name() const override { return m_name; }
  [[nodiscard]] bool isSoftware() const override { return m_software; }
  [[nodiscard]] int maximumSide() const override { return m_maximumSide; }

  void setScene(const Scene& scene) override;
  void draw(const Frame& frame, unsigned framebuffer) override;
  [[nodiscard]] Image picture(const Frame& frame) override;
  [[nodiscard]] std::optional<Hit> pick(const Frame& frame, double x, double y) override;
  [[nodiscard]] VisibilityBuffer seen(const Frame& frame, int columns, int rows) override;

 private:
  [[nodiscard]] const Pose& pose(const Frame& frame, std::size_t instance) const {
    return frame.poses.empty() ? m_scene.instances[instance].pose : frame.poses[instance];
  }
  [[nodiscard]] Eigen::Matrix4d projection(const Frame& frame) const {
    return frame.camera.projection(frame.viewport, m_depths.centre, m_depths.radius);
  }
  /// From the clip cube -1..1 of the picture to the world.
  [[nodiscard]] Eigen::Matrix4d toWorld(const Frame& frame) const {
    return (projection(frame) * frame.camera.view().matrix()).inverse();
  }
  /// The clip matrix for culling: of the strip that is painted.
  [[nodiscard]] Eigen::Matrix4d clip(const Frame& frame) const {
    return m_strip.cut(frame.viewport.height) * projection(frame) * frame.camera.view().matrix();
  }
  [[nodiscard]] FloorDisc disc(const Frame& frame) const;
  [[nodiscard]] static Highlight emphasis(const Frame& frame, std::size_t instance) {
    return frame.emphasis.empty() ? Highlight::none : frame.emphasis[instance];
  }
  [[nodiscard]] static Visibility visibility(const Frame& frame, std::size_t instance) {
    return frame.visibility.empty() ? Visibility::solid : frame.visibility[instance];
  }
  /// Visits the instances that may be visible through this clip matrix and have the visibility `wanted`.
  template <class Visit>
  void eachInstance(const Frame& frame, const Eigen::Matrix4d& clip, Visibility wanted, GlSolid::Part part,
                    Visit visit);
  /// Draws a part of the same instances, equal solids by one instanced call: `instanceData` returns the data
  /// of an instance, or std::nullopt to skip it.
  template <class InstanceData>
  void drawAll(const Frame& frame, const Eigen::Matrix4d& clip, Visibility wanted, GlSolid::Part part,
               InstanceData instanceData);
  /// The solid at the level of detail for its size on the screen; uploaded on first use.
  [[nodiscard]] const GlSolid& detailed(const Frame& frame, std::size_t shape, const Eigen::Vector3d& middle,
                                        GlSolid::Part part);
  [[nodiscard]] int samplesOf(const Frame& frame) const {
    return std::clamp(frame.style.samples, 1, static_cast<int>(m_maximumSamples));
  }
  /// Draws all but the halo into m_sampled, which is bound then. False if the driver is out of memory.
  [[nodiscard]] bool paint(const Frame& frame);
  /// Binds a target that holds the strip, with the viewport placed for the whole picture.
  void bind(const GlTarget& target, const Viewport& picture) const;
  /// The part of the target that is painted.
  [[nodiscard]] Viewport extent(const Viewport& picture) const {
    return {picture.width, m_strip.rowsOf(picture.height)};
  }
  /// Resolves m_sampled into another framebuffer, which is bound then.
  void resolve(const Viewport& size, unsigned framebuffer);
  /// Paints `count` rows from `first`, counted from the lower edge, into the rows of the image. False if the
  /// driver is out of memory or the frame was stopped.
  [[nodiscard]] bool paintRows(const Frame& frame, int first, int count, Image& image);
  /// Copies the background and all unchanged parts from the layer into m_sampled. False if there is no layer.
  [[nodiscard]] bool paintLayer(const Frame& frame);
  void paintParts(const Frame& frame);
  [[nodiscard]] bool isLitByVertex(const Frame& frame) const;
  void beginSection(const Frame& frame);
  void drawFaces(const Frame& frame, Visibility wanted, float alpha);
  void drawCaps(const Frame& frame);
  void drawTranslucent(const Frame& frame);
  void drawMarks(const Frame& frame);

  void drawBackground(const Frame& frame);
  void drawDisc(const Frame& frame);
  void drawShadow(const Frame& frame);
  void drawSolids(const Frame& frame);
  void drawEdges(const Frame& frame, Visibility wanted, float part);
  void drawTriad(const Frame& frame);
  void drawHalo(const Frame& frame, unsigned framebuffer);
  /// Draws the input of readNumbers() into the bound framebuffer; `cut`: matrix to the part of the picture.
  void drawNumbers(const Frame& frame, const Eigen::Matrix4d& cut);

  std::unique_ptr<GlApi> m_gl;
  GlPasses m_passes;
  std::string m_name;
  bool m_software = false;
  int m_maximumSide = 0;
  GLint m_maximumSamples = 1;

  GlSolidStore m_solids{*m_gl, m_passes.instances()};
  /// The rows of a large picture that are painted at a time.
  struct Strip {
    int bottom = 0;
    int height = 0;  ///< 0: the whole picture
    [[nodiscard]] int rowsOf(int picture) const { return height > 0 ? height : picture; }
    /// From the clip cube of the picture to that of the strip.
    [[nodiscard]] Eigen::Matrix4d cut(int picture) const {
      Eigen::Matrix4d cut = Eigen::Matrix4d::Identity();
      const double rows = rowsOf(picture);
      cut(1, 1) = picture / rows;
      cut(1, 3) = (picture - 2.0 * bottom - rows) / rows;
      return cut;
    }
  };
  Strip m_strip;

  const Scene& m_scene = m_solids.scene();
  const Bounds& m_bounds = m_solids.bounds();
  BoundingSphere m_depths{{0, 0, 0}, 2.5};  ///< everything between the near and far planes
  struct Batch {
    const GlSolid* solid = nullptr;
    bool isOpen = false;
    std::vector<SolidInstance> instances;
  };
  std::vector<Batch> m_batches;  ///< of the pass that is painted, in the order of the scene
  std::map<std::pair<const GlSolid*, bool>, std::size_t> m_batchOf;

  GlTarget m_sampled{*m_gl, GlTarget::Colours::rgba, true};
  GlTarget m_layer{*m_gl, GlTarget::Colours::rgba, true};
  StaticParts m_staticParts;
  GlTarget m_picture{*m_gl, GlTarget::Colours::rgba, false};
  GlTarget m_numbers{*m_gl, GlTarget::Colours::rgba, true};  ///< of a pick
  GlTarget m_cells{*m_gl, GlTarget::Colours::rgba, true};    ///< of a map
  GlTarget m_mask{*m_gl, GlTarget::Colours::coverage, false};
};

template <class Visit>
void GlRenderer::eachInstance(const Frame& frame, const Eigen::Matrix4d& clip, Visibility wanted,
                              GlSolid::Part part, Visit visit) {
  const Frustum frustum(clip);
  for (std::size_t i = 0; i < m_scene.instances.size() && !frame.stop.stop_requested(); ++i) {
    if (visibility(frame, i) != wanted) continue;
    const std::size_t shape = m_scene.instances[i].solid;
    const BoundingSphere& sphere = m_solids.sphereOf(shape);
    const Eigen::Vector3d middle = pose(frame, i) * sphere.centre;
    if (!frustum.mayShow(middle, sphere.radius)) continue;
    visit(i, detailed(frame, shape, middle, part));
  }
}

/// A picture that can be stopped waits for the driver after this many indices: queued work cannot be
/// cancelled, and a software rasterizer takes some 50 ms for them.
constexpr std::size_t kMaxQueuedIndices = 250'000;

// Batches are in the order of the scene, not of addresses, so that the same scene gives the same picture.
template <class InstanceData>
void GlRenderer::drawAll(const Frame& frame, const Eigen::Matrix4d& clip, Visibility wanted,
                         GlSolid::Part part, InstanceData instanceData) {
  m_batches.clear();
  m_batchOf.clear();
  eachInstance(frame, clip, wanted, part, [&](std::size_t i, const GlSolid& solid) {
    const std::optional<SolidInstance> instance = instanceData(i);
    if (!instance) return;
    const bool isOpen = m_scene.instances[i].isOpen;
    const auto [place, isNew] = m_batchOf.try_emplace({&solid, isOpen}, m_batches.size());
    if (isNew) m_batches.push_back({&solid, isOpen, {}});
    m_batches[place->second].instances.push_back(*instance);
  });
  const bool culls = m_gl->IsEnabled(GL_CULL_FACE) == GL_TRUE;
  std::size_t queued = 0;
  for (const Batch& batch : m_batches) {
    const std::size_t each = std::max<std::size_t>(1, batch.solid->indices(part));
    std::span<const SolidInstance> rest = batch.instances;
    if (batch.isOpen) m_gl->Disable(GL_CULL_FACE);
    while (!rest.empty() && !frame.stop.stop_requested()) {
      const std::size_t fitting =
          frame.stop.stop_possible() ? (kMaxQueuedIndices - queued) / each : rest.size();
      const std::size_t count = std::clamp<std::size_t>(fitting, 1, rest.size());
      m_passes.draw(*batch.solid, part, rest.first(count));
      rest = rest.subspan(count);
      queued += each * count;
      if (!frame.stop.stop_possible() || queued < kMaxQueuedIndices) continue;
      m_gl->Finish();
      if (frame.pause) frame.pause();
      queued = 0;
    }
    if (batch.isOpen && culls) m_gl->Enable(GL_CULL_FACE);
  }
}

}  // namespace geargraph
