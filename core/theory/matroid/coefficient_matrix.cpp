#include "core/theory/matroid/coefficient_matrix.h"

#include <algorithm>

#include "core/theory/matroid/screw.h"

namespace geargraph {

std::vector<CoefficientMatrix::Entry> CoefficientMatrix::row(MeshOrdinal mesh) const {
  std::vector<Entry> entries;
  appendRow(mesh, entries);
  return entries;
}

void CoefficientMatrix::appendRow(MeshOrdinal mesh, std::vector<Entry>& entries) const {
  const MeshGeometry& geometry = *m_placement.meshes[mesh];
  const AxisGroups& classes = *m_placement.classes;
  const SpanningTree& tree = m_model.tree();
  const auto first = static_cast<std::ptrdiff_t>(entries.size());
  const int meeting = tree.commonAncestor(geometry.tail, geometry.head);
  // T is -1 where the walk from tail to head runs along the joint.
  const auto climb = [&](LinkOrdinal node, int sign) {
    for (; node != meeting; node = tree.parent(node)) {
      const JointOrdinal joint = tree.jointToParent(node);
      const bool tail = classes.classOf[joint] == geometry.tailClass;
      const double radius =
          classes.orientationSign[joint] * (tail ? geometry.tailRadius : geometry.headRadius);
      const int direction = sign * tree.directionToGround(joint);
      entries.push_back({joint, tail, direction * (radius < 0 ? -1 : 1), direction * radius});
    }
  };
  climb(geometry.tail, -1);
  climb(geometry.head, 1);
  std::sort(entries.begin() + first, entries.end(),
            [](const Entry& a, const Entry& b) { return a.joint < b.joint; });
}

std::optional<Rational> CoefficientMatrix::exactRadius(MeshOrdinal mesh, bool tail) const {
  const MeshGeometry& geometry = *m_placement.meshes[mesh];
  const auto point = exactPitchPoint(m_mechanism, m_placement, mesh);
  if (!point) return std::nullopt;
  const ExactLine line =
      exactLineOfClass(m_mechanism, m_placement, tail ? geometry.tailClass : geometry.headClass);
  const Screw<Rational> screw = screwAbout(*point, line.point, line.direction);
  return (dot(screw.moment, screw.moment) / dot(screw.direction, screw.direction)).squareRoot();
}

PiNumber CoefficientMatrix::piRatio(MeshOrdinal mesh) const {
  const KinematicModel::MeshRow& row = m_model.meshRow(mesh);
  return {Rational(row.tailTeeth, row.headTeeth), -row.pi};
}

}  // namespace geargraph
