#include "ui/canvas/place_grid.h"

#include <algorithm>
#include <cstdlib>

namespace geargraph {

PlaceGrid::PlaceGrid(int rings)
    : m_rings(rings),
      m_side(2 * rings + 2),
      m_steps(static_cast<std::size_t>(m_side) * static_cast<std::size_t>(m_side)) {}

void PlaceGrid::take(Span across, Span down) {
  const double most = m_rings;
  if (!(across.first <= most && across.last >= -most && across.first <= across.last)) return;
  if (!(down.first <= most && down.last >= -most && down.first <= down.last)) return;
  const auto columnOf = [&](double place) {
    return static_cast<int>(std::clamp(place, -most, most)) + m_rings;
  };
  const auto step = [&](int column, int row) -> int& {
    return m_steps[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_side) +
                   static_cast<std::size_t>(column)];
  };
  const int left = columnOf(across.first), right = columnOf(across.last) + 1;
  const int top = columnOf(down.first), bottom = columnOf(down.last) + 1;
  ++step(left, top);
  --step(right, top);
  --step(left, bottom);
  ++step(right, bottom);
}

std::optional<PlaceGrid::Place> PlaceGrid::nearestFree() const {
  std::vector<int> taken = m_steps;  // by how many rectangles
  const auto side = static_cast<std::size_t>(m_side);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (i % side > 0) taken[i] += taken[i - 1];
    if (i >= side) taken[i] += taken[i - side];
    if (i % side > 0 && i >= side) taken[i] -= taken[i - side - 1];
  }
  for (int ring = 0; ring <= m_rings; ++ring) {
    for (int down = -ring; down <= ring; ++down) {
      const int step = std::abs(down) == ring ? 1 : std::max(1, 2 * ring);
      for (int across = -ring; across <= ring; across += step) {
        const auto at =
            static_cast<std::size_t>(down + m_rings) * side + static_cast<std::size_t>(across + m_rings);
        if (taken[at] == 0) return Place{across, down};
      }
    }
  }
  return std::nullopt;
}

}  // namespace geargraph
