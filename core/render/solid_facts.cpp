#include "core/render/solid_facts.h"

namespace geargraph {

void SolidFacts::addTo(Scene& scene) {
  scene.boxes.clear();
  for (std::size_t i = 0; i < scene.solids.size(); ++i) {
    scene.boxes.push_back(*m_boxes.of(scene.solids[i], [](const Solid& solid) { return boundsOf(solid); }));
    const bool isWheel = i < scene.levels.size() && scene.levels[i].far;
    const auto& shown = isWheel ? scene.levels[i].far : scene.solids[i];
    scene.edges[shown.get()] = m_edges.of(shown, [](const Solid& solid) { return featureEdges(solid); });
  }
  m_edges.forgetOthers();
  m_boxes.forgetOthers();
}

}  // namespace geargraph
