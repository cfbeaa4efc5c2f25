#include "core/presentation/painting/still_parts.h"

#include <utility>

namespace geargraph::inline painting {

bool StillParts::Part::looksLike(const Part& other) const {
  return solid == other.solid && levels == other.levels && pose.matrix() == other.pose.matrix() &&
         colour == other.colour && emphasis == other.emphasis && visibility == other.visibility;
}

StillParts::Layer StillParts::next(const View& view, std::vector<Part> parts) {
  const bool isSeenAlike = view == m_view;
  const bool stands =
      view.camera == m_view.camera && view.width == m_view.width && view.height == m_view.height;
  std::vector<bool> still(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    still[i] = i < m_parts.size() && parts[i].looksLike(m_parts[i]);
  bool holds = m_isKept && isSeenAlike && m_kept.size() <= parts.size();
  for (std::size_t i = 0; holds && i < m_kept.size(); ++i) holds = !m_kept[i] || still[i];
  m_view = view;
  m_parts = std::move(parts);
  m_isKept = false;
  if (!stands) return Layer::none;
  m_isKept = true;
  if (!holds) m_kept.clear();
  m_kept.resize(m_parts.size(), false);
  sort(still);
  return holds ? Layer::kept : Layer::anew;
}

// A few parts that have come to rest wait until they are worth a change of the layer.
void StillParts::sort(const std::vector<bool>& still) {
  std::size_t addable = 0, others = 0;
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    if (!m_kept[i]) (still[i] ? addable : others) += m_parts[i].solid->triangles.size();
  }
  const bool adds = 4 * addable > others;
  m_addedTriangles = adds ? addable : 0;
  m_added.assign(m_parts.size(), Visibility::hidden);
  m_rest.assign(m_parts.size(), Visibility::hidden);
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    if (m_kept[i]) continue;
    m_kept[i] = adds && still[i];
    (m_kept[i] ? m_added : m_rest)[i] = m_parts[i].visibility;
  }
}

}  // namespace geargraph::inline painting
