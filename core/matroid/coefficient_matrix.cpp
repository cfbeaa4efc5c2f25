#include "core/matroid/coefficient_matrix.h"

#include <algorithm>

#include "core/screws/screw.h"

namespace geargraph {

std::vector<CoefficientMatrix::Entry> CoefficientMatrix::row(int mesh) const {
  const MeshGeometry& geometry = *m_placement.meshes[mesh];
  const AxisClasses& classes = *m_placement.classes;
  std::vector<Entry> entries;
  for (const PathStep& step : treePath(m_model.tree(), geometry.tail, geometry.head)) {
    const bool tail = classes.classOf[step.joint] == geometry.tailClass;
    const double radius = classes.sense[step.joint] * (tail ? geometry.tailRadius : geometry.headRadius);
    // T is -1 where the walk from tail to head runs along the joint.
    entries.push_back({step.joint, tail, -step.direction * (radius < 0 ? -1 : 1), -step.direction * radius});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.joint < b.joint; });
  return entries;
}

std::optional<Rational> CoefficientMatrix::exactRadius(int mesh, bool tail) const {
  const MeshGeometry& geometry = *m_placement.meshes[mesh];
  const auto point = exactPitchPoint(m_mechanism, m_placement, mesh);
  if (!point) return std::nullopt;
  const ExactLine line =
      exactLineOfClass(m_mechanism, m_placement, tail ? geometry.tailClass : geometry.headClass);
  const Screw<Rational> screw = screwAbout(*point, line.point, line.direction);
  return (dot(screw.moment, screw.moment) / dot(screw.direction, screw.direction)).squareRoot();
}

Rational CoefficientMatrix::ratio(int mesh) const {
  return {m_model.meshRow(mesh).tailTeeth, m_model.meshRow(mesh).headTeeth};
}

}  // namespace geargraph
