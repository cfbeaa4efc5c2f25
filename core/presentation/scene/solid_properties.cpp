#include "core/presentation/scene/solid_properties.h"

#include <utility>

namespace geargraph {

void SolidProperties::addBoxesTo(Scene& scene, const std::stop_token& stop) {
  scene.boxes.clear();
  const auto box = [](const Solid& solid) { return boundsOf(solid); };
  for (const auto& solid : scene.solids) {
    if (stop.stop_requested()) return;
    scene.boxes.push_back(*m_boxes.of(solid, box));
  }
}

void SolidProperties::addOutlinesTo(Scene& scene, const std::stop_token& stop) {
  scene.outlines.reset();
  const std::size_t samples = outlineSamples(scene);
  if (std::exchange(m_samples, samples) != samples) m_outlines = {};
  auto outlines = std::make_shared<SolidOutlines>();
  for (const auto& solid : scene.solids) {
    if (stop.stop_requested()) return;
    outlines->push_back(*m_outlines.of(solid, [&](const Solid& found) { return outlineOf(found, samples); }));
  }
  scene.outlines = std::move(outlines);
}

void SolidProperties::addEdgesTo(Scene& scene, const std::stop_token& stop) {
  constexpr double kWindow = 1000;  // pixels that a train fills
  const double pixels = kWindow / (2 * boundsOf(scene).radius());
  const auto add = [&](const std::shared_ptr<const Solid>& solid) {
    scene.edges[solid.get()] = m_edges.of(solid, [](const Solid& found) { return featureEdges(found); });
  };
  for (std::size_t i = 0; i < scene.solids.size() && !stop.stop_requested(); ++i) {
    add(scene.solids[i]);  // of a smaller window
    if (i >= scene.levels.size()) continue;
    const DetailLevels& levels = scene.levels[i];
    add(levels.chosen(scene.solids[i], levels.unit * pixels));
  }
}

void SolidProperties::forgetOthers() {
  m_edges.forgetOthers();
  m_boxes.forgetOthers();
  m_outlines.forgetOthers();
}

}  // namespace geargraph
