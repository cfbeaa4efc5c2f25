#include "core/render/gl_solid_store.h"

#include <utility>

#include "core/render/feature_edges.h"

namespace geargraph {

void GlSolidStore::setScene(const Scene& scene) {
  std::map<const Solid*, std::unique_ptr<GlSolid>> solids;
  for (const auto& solid : scene.solids) {
    std::unique_ptr<GlSolid>& place = solids[solid.get()];
    const auto known = m_solids.find(solid.get());
    if (place == nullptr && known != m_solids.end()) place = std::move(known->second);
  }
  for (const DetailLevels& level : scene.levels) {
    for (const auto& solid : {level.far, level.close}) {
      const auto known = m_solids.find(solid.get());
      if (known != m_solids.end() && known->second) solids[solid.get()] = std::move(known->second);
    }
  }
  m_solids = std::move(solids);
  m_scene = scene;
}

const GlSolid& GlSolidStore::get(std::size_t solid, double pixels) {
  const std::shared_ptr<const Solid>* detail = &m_scene.solids[solid];
  if (solid < m_scene.levels.size()) detail = &m_scene.levels[solid].chosen(*detail, pixels);
  std::unique_ptr<GlSolid>& place = m_solids[detail->get()];
  if (place != nullptr) return *place;
  const auto known = m_scene.edges.find(detail->get());
  const auto edges = known != m_scene.edges.end()
                         ? known->second
                         : std::make_shared<const std::vector<std::uint32_t>>(featureEdges(**detail));
  place = std::make_unique<GlSolid>(m_gl, **detail, *edges, m_instances);
  return *place;
}

}  // namespace geargraph
