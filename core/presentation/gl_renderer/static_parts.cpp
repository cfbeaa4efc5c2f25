#include "core/presentation/gl_renderer/static_parts.h"

#include <utility>

namespace geargraph {

bool StaticParts::Part::looksLike(const Part& other) const {
  return solid == other.solid && levels == other.levels && pose.matrix() == other.pose.matrix() &&
         colour == other.colour && emphasis == other.emphasis && visibility == other.visibility;
}

StaticParts::Layer StaticParts::next(const View& view, std::vector<Part> parts) {
  const bool isSeenAlike = view == m_view;
  const bool stands =
      view.camera == m_view.camera && view.width == m_view.width && view.height == m_view.height;
  std::vector<bool> still(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    still[i] = i < m_parts.size() && parts[i].looksLike(m_parts[i]);
  bool holds = m_isCached && isSeenAlike && m_cached.size() <= parts.size();
  for (std::size_t i = 0; holds && i < m_cached.size(); ++i) holds = !m_cached[i] || still[i];
  m_view = view;
  m_parts = std::move(parts);
  m_isCached = false;
  if (!stands) return Layer::none;
  m_isCached = true;
  if (!holds) m_cached.clear();
  m_cached.resize(m_parts.size(), false);
  sort(still);
  return holds ? Layer::cached : Layer::anew;
}

// A few parts that have come to rest wait until they are worth a change of the layer.
void StaticParts::sort(const std::vector<bool>& still) {
  std::size_t addable = 0, others = 0;
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    if (!m_cached[i]) (still[i] ? addable : others) += m_parts[i].solid->triangles.size();
  }
  const bool adds = 4 * addable > others;
  m_addedTriangles = adds ? addable : 0;
  m_added.assign(m_parts.size(), Visibility::hidden);
  m_rest.assign(m_parts.size(), Visibility::hidden);
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    if (m_cached[i]) continue;
    m_cached[i] = adds && still[i];
    (m_cached[i] ? m_added : m_rest)[i] = m_parts[i].visibility;
  }
}

}  // namespace geargraph
