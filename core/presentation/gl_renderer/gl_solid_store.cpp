#include "core/presentation/gl_renderer/gl_solid_store.h"

#include <utility>

#include "core/presentation/scene/feature_edges.h"

namespace geargraph {

void GlSolidStore::measure() {
  for (std::size_t i = m_scene.boxes.size(); i < m_scene.solids.size(); ++i)
    m_scene.boxes.push_back(m_scene.boxOf(i));
  m_spheres.clear();
  for (const Eigen::AlignedBox3d& box : m_scene.boxes) m_spheres.push_back(BoundingSphere::about(box));
  m_bounds = boundsOf(m_scene);
}

void GlSolidStore::setScene(const Scene& scene) {
  std::map<const Solid*, std::unique_ptr<GlSolid>> solids;
  for (const auto& solid : scene.solids) {
    std::unique_ptr<GlSolid>& place = solids[solid.get()];
    const auto held = m_solids.find(solid.get());
    if (place == nullptr && held != m_solids.end()) place = std::move(held->second);
  }
  for (const DetailLevels& levels : scene.levels) {
    for (const DetailLevels::LodLevel& level : levels.finer) {
      const auto held = m_solids.find(level.solid->solidIfReady());
      if (held != m_solids.end() && held->second) solids[held->first] = std::move(held->second);
    }
  }
  m_solids = std::move(solids);
  m_scene = scene;
  measure();
}

const GlSolid& GlSolidStore::get(std::size_t solid, double pixels, GlSolid::Part part) {
  const std::shared_ptr<const Solid>* detail = &m_scene.solids[solid];
  if (solid < m_scene.levels.size()) detail = &m_scene.levels[solid].chosen(*detail, pixels);
  std::unique_ptr<GlSolid>& place = m_solids[detail->get()];
  if (place == nullptr) place = std::make_unique<GlSolid>(m_gl, **detail, m_instances);
  if (part == GlSolid::Part::edges && !place->hasEdges()) {
    const auto known = m_scene.edges.find(detail->get());
    place->setEdges(known != m_scene.edges.end() ? *known->second : featureEdges(**detail));
  }
  return *place;
}

}  // namespace geargraph
