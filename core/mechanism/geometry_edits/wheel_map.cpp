#include "core/mechanism/geometry_edits/wheel_map.h"

#include <algorithm>
#include <cmath>

#include "core/mechanism/placement/tolerance.h"

namespace geargraph {
namespace {

const MeshGeometry& geometryOf(const Placement& placement, int end) {
  return *placement.meshes[end / 2];
}

int linkOfEnd(const Placement& placement, int end) {
  const MeshGeometry& geometry = geometryOf(placement, end);
  return isTailEnd(end) ? geometry.tail : geometry.head;
}

std::optional<WheelId> namedWheel(const Mechanism& mechanism, int end) {
  const GearMesh& mesh = mechanism.gearMeshes[end / 2];
  return isTailEnd(end) ? mesh.tailWheel : mesh.headWheel;
}

/// Where along its axis the gear's plane lies.
double levelOf(const Placement& placement, int end) {
  const AxisLine& line = placement.lineOfClass(classOfEnd(placement, end));
  return dot(geometryOf(placement, end).pitchPoint - line.point, line.direction);
}

}  // namespace

int teethOf(const Mechanism& mechanism, int end) {
  const GearMesh& mesh = mechanism.gearMeshes[end / 2];
  return isTailEnd(end) ? mesh.tailTeeth : mesh.headTeeth;
}

int classOfEnd(const Placement& placement, int end) {
  const MeshGeometry& geometry = geometryOf(placement, end);
  return isTailEnd(end) ? geometry.tailClass : geometry.headClass;
}

bool WheelMap::isSame(const Mechanism& mechanism, const Placement& placement, int end, int other) const {
  if (linkOfEnd(placement, end) != linkOfEnd(placement, other)) return false;
  const auto name = namedWheel(mechanism, end);
  const auto otherName = namedWheel(mechanism, other);
  if (name || otherName) return name == otherName;
  if (teethOf(mechanism, end) != teethOf(mechanism, other)) return false;
  if (classOfEnd(placement, end) != classOfEnd(placement, other)) return false;
  const MeshGeometry& geometry = geometryOf(placement, end);
  if (touches(geometry.kind) != touches(geometryOf(placement, other).kind)) return false;
  if (pairKind(geometry.kind).axes != pairKind(geometryOf(placement, other).kind).axes) return false;
  const double size = std::abs(geometry.tailRadius) + std::abs(geometry.headRadius);
  return std::abs(levelOf(placement, end) - levelOf(placement, other)) <= kGeometryFits * size;
}

WheelMap::WheelMap(const Mechanism& mechanism, const Placement& placement)
    : m_wheelOf(2 * mechanism.gearMeshes.size(), -1) {
  const int ends = static_cast<int>(m_wheelOf.size());
  for (int end = 0; end < ends; ++end) {
    int wheel = 0;
    while (wheel < count() &&
           !isSame(mechanism, placement, m_ends[static_cast<std::size_t>(wheel)].front(), end))
      ++wheel;
    if (wheel == count()) {
      m_ends.emplace_back();
      m_link.push_back(linkOfEnd(placement, end));
      m_teeth.push_back(teethOf(mechanism, end));
    }
    m_ends[static_cast<std::size_t>(wheel)].push_back(end);
    m_wheelOf[static_cast<std::size_t>(end)] = wheel;
  }
  m_neighbours.resize(m_ends.size());
  for (int end = 0; end < ends; ++end) {
    const MeshGeometry& geometry = geometryOf(placement, end);
    m_neighbours[static_cast<std::size_t>(wheelOf(end))].push_back(
        {wheelOf(otherEnd(end)), geometry.kind, geometry.carrier});
  }
  for (auto& neighbours : m_neighbours) std::sort(neighbours.begin(), neighbours.end());
}

std::vector<int> WheelMap::identicalPlanets(int wheel) const {
  const auto at = static_cast<std::size_t>(wheel);
  const auto& neighbours = m_neighbours[at];
  std::vector<int> planets;
  // One neighbour on the ground's own axes: two idlers beside one wheel are no planets.
  if (neighbours.size() < 2 && neighbours.front().carrier == 0) return planets;
  for (std::size_t other = 0; other < m_neighbours.size(); ++other) {
    if (other == at || m_link[other] == m_link[at] || m_teeth[other] != m_teeth[at]) continue;
    if (m_neighbours[other] == neighbours) planets.push_back(static_cast<int>(other));
  }
  return planets;
}

}  // namespace geargraph
