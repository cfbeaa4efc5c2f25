#pragma once

#include <map>
#include <memory>

#include "core/presentation/gl_renderer/gl_passes.h"
#include "core/presentation/scene/frustum.h"
#include "core/presentation/scene/scene.h"

namespace geargraph {

/// The solids of a scene on the graphics card, each at the levels of detail used so far.
class GlSolidStore {
 public:
  GlSolidStore(const GlApi& gl, const GlInstances& instances) : m_gl(gl), m_instances(instances) {}

  /// Sets the scene. Solids that the previous scene also had are not uploaded again.
  void setScene(const Scene& scene);
  /// A solid of the scene at the level of detail for `pixels` per unit of its levels; uploaded, and its edges
  /// computed, on first use.
  [[nodiscard]] const GlSolid& get(std::size_t solid, double pixels, GlSolid::Part part);
  /// The bounds of all instances in their poses, as boundsOf(), and of each solid in its own frame. Boxes
  /// that the scene lacks are computed once.
  [[nodiscard]] const Bounds& bounds() const { return m_bounds; }
  [[nodiscard]] const BoundingSphere& sphereOf(std::size_t solid) const { return m_spheres[solid]; }
  /// The unit of the solid's levels, mm; 0 where it has no levels.
  [[nodiscard]] double unitOf(std::size_t solid) const {
    return solid < m_scene.levels.size() ? m_scene.levels[solid].unit : 0;
  }
  [[nodiscard]] const Scene& scene() const { return m_scene; }

 private:
  void measure();

  const GlApi& m_gl;
  const GlInstances& m_instances;
  Scene m_scene;  ///< keeps the solids alive, so that their addresses stay unique
  std::map<const Solid*, std::unique_ptr<GlSolid>> m_solids;
  std::vector<BoundingSphere> m_spheres;  ///< by solid
  Bounds m_bounds;
};

}  // namespace geargraph
