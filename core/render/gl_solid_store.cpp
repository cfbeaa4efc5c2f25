#include "core/render/gl_solid_store.h"

#include <utility>

#include "core/render/feature_edges.h"

namespace geargraph {

void GlSolidStore::measure(const Scene& scene) {
  std::map<const Solid*, std::size_t> known;
  for (std::size_t i = 0; i < m_scene.solids.size(); ++i) known.emplace(m_scene.solids[i].get(), i);
  std::vector<Eigen::AlignedBox3d> boxes;
  m_balls.clear();
  for (const auto& solid : scene.solids) {
    const auto place = known.find(solid.get());
    boxes.push_back(place == known.end() ? boundsOf(*solid) : m_boxes[place->second]);
    m_balls.push_back(Ball::about(boxes.back()));
  }
  m_boxes = std::move(boxes);
  m_bounds = {};
  for (const Instance& instance : scene.instances) {
    const Eigen::AlignedBox3d& box = m_boxes[instance.solid];
    for (int corner = 0; corner < 8 && !box.isEmpty(); ++corner)
      m_bounds.box.extend(instance.pose * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  }
}

void GlSolidStore::setScene(const Scene& scene) {
  measure(scene);
  std::map<const Solid*, std::unique_ptr<GlSolid>> solids;
  for (const auto& solid : scene.solids) {
    std::unique_ptr<GlSolid>& place = solids[solid.get()];
    const auto held = m_solids.find(solid.get());
    if (place == nullptr && held != m_solids.end()) place = std::move(held->second);
  }
  for (const DetailLevels& level : scene.levels) {
    for (const Solid* solid : {level.far.get(), level.close ? level.close->made() : nullptr}) {
      const auto held = m_solids.find(solid);
      if (held != m_solids.end() && held->second) solids[solid] = std::move(held->second);
    }
  }
  m_solids = std::move(solids);
  m_scene = scene;
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
