#include "core/placement/placement.h"

#include "core/placement/axis_placer.h"
#include "core/placement/bevel_arranger.h"
#include "core/placement/tolerance.h"

namespace geargraph {
namespace {

GearPair<double> pairOf(const Mechanism& mechanism, const Placement& placement, int mesh, int tailClass,
                        int headClass) {
  const AxisLine& tail = placement.lineOfClass(tailClass);
  const AxisLine& head = placement.lineOfClass(headClass);
  const GearMesh& element = mechanism.gearMeshes[mesh];
  return {tail.point, tail.direction, head.point, head.direction, element.tailTeeth, element.headTeeth};
}

/// Is the tail's axis the inner one, nearer the ground?
bool tailIsInner(const Placement& placement, int tailClass, int headClass) {
  const auto& classes = placement.classes->classes;
  return classes[tailClass].depth <= classes[headClass].depth;
}

/// Chooses the half axes of bevel pairs that the file leaves open.
class SideChooser {
 public:
  SideChooser(const Mechanism& mechanism, const Placement& placement)
      : m_mechanism(mechanism), m_placement(placement) {}

  BevelSides choose(int mesh, const MeshWord& word, const GearPair<double>& pair) {
    const auto [tail, head] = m_placement.tree->meshes[mesh];
    const bool inner = tailIsInner(m_placement, word.tailClass, word.headClass);
    const Vector3 apex = apexOf(pair);
    BevelSides sides;
    sides.tail = side(tail, word.tailClass, word.carrier, head, apex, inner);
    sides.head = side(head, word.headClass, word.carrier, tail, apex, !inner);
    return sides;
  }

 private:
  int side(int link, int axisClass, int carrier, int partner, const Vector3& apex, bool inner) {
    const AxisLine& line = m_placement.lineOfClass(axisClass);
    if (link != 0 && m_placement.classes->classOfLink(*m_placement.tree, link) == axisClass) {
      const int joint = m_placement.tree->joint[link];
      const AxisLine& own = m_placement.axes[m_placement.tree->axisOf[joint]];
      const double offset = m_mechanism.turningJoints[joint].offset.value();
      const bool silent = own.automatic && offset == 0;
      const double along =
          silent ? 0 : dot(own.point - apex, line.direction) + m_placement.classes->sense[joint] * offset;
      const double nothing = kSameLine * (1 + length(own.point) + length(apex));
      if (along > nothing) return 1;
      if (along < -nothing) return -1;
    }
    if (!inner) return 1;
    return m_numbers.side(axisClass, carrier, link, partner);
  }

  const Mechanism& m_mechanism;
  const Placement& m_placement;
  SideNumbers m_numbers;
};

Vector3 valuesOf(const NumberTriple& triple) {
  return {triple[0].value(), triple[1].value(), triple[2].value()};
}

std::optional<MeshGeometry> located(const Mechanism& mechanism, Placement& placement, int mesh,
                                    const MeshWord& word, int bevelSize, SideChooser& sides) {
  const GearMesh& element = mechanism.gearMeshes[mesh];
  const auto pair = pairOf(mechanism, placement, mesh, word.tailClass, word.headClass);
  MeshGeometry geometry;
  geometry.tail = placement.tree->meshes[mesh].tail;
  geometry.head = placement.tree->meshes[mesh].head;
  geometry.carrier = word.carrier;
  geometry.tailClass = word.tailClass;
  geometry.headClass = word.headClass;
  geometry.derived = !element.pitchPoint;
  if (element.pitchPoint) {
    geometry.pitchPoint = valuesOf(*element.pitchPoint);
  } else {
    switch (positionOf(pair)) {
      case LinePosition::skew:
        placement.diagnostics.push_back(skewAxes(mechanism, mesh, pair));
        return std::nullopt;
      case LinePosition::meeting:
        geometry.sides = sides.choose(mesh, word, pair);
        geometry.bevelSize = bevelSize;
        geometry.pitchPoint =
            bevelPitchPoint(pair, geometry.sides, placement.module.toDouble() * bevelSize / kUsualBevelSize);
        break;
      case LinePosition::parallel:
        if (element.kind == MeshKind::internal && element.tailTeeth == element.headTeeth) {
          placement.diagnostics.push_back(equalInternalTeeth(mechanism, mesh));
          return std::nullopt;
        }
        geometry.pitchPoint = parallelPitchPoint(
            pair, element.kind == MeshKind::internal,
            tailIsInner(placement, word.tailClass, word.headClass) ? pair.tailPoint : pair.headPoint);
    }
  }
  return checkedGeometry(mechanism, mesh, pair, geometry, placement.diagnostics);
}

}  // namespace

Placement placementOf(const Mechanism& mechanism) {
  return placementOf(mechanism, JointTree::of(mechanism));
}

Placement placementOf(const Mechanism& mechanism, std::optional<JointTree> tree) {
  Placement placement;
  std::vector<AxisLine> given = givenLines(mechanism);
  if (!tree) {
    placement.meshes.resize(mechanism.gearMeshes.size());
    PlacedAxes placed = placedAxes(mechanism, std::move(given), nullptr, AxisClasses(), {});
    placement.axes = std::move(placed.lines);
    placement.module = std::move(placed.module);
    return placement;
  }
  placement.tree = std::move(tree);
  placement.classes.emplace(mechanism, *placement.tree, given, placement.diagnostics);
  std::vector<std::optional<MeshWord>> words;
  words.reserve(mechanism.gearMeshes.size());
  ClassPath path;
  for (int mesh = 0; mesh < mechanism.c(); ++mesh) {
    words.push_back(
        meshWord(mechanism, *placement.classes, *placement.tree, mesh, path, placement.diagnostics));
  }
  PlacedAxes placed = placedAxes(mechanism, std::move(given), &*placement.tree, *placement.classes, words);
  placement.axes = std::move(placed.lines);
  placement.module = std::move(placed.module);
  SideChooser sides(mechanism, placement);
  placement.meshes.reserve(words.size());
  for (int mesh = 0; mesh < mechanism.c(); ++mesh) {
    placement.meshes.push_back(
        words[mesh] ? located(mechanism, placement, mesh, *words[mesh], placed.bevelSizes[mesh], sides)
                    : std::nullopt);
  }
  return placement;
}

ExactLine exactLineOfClass(const Mechanism& mechanism, const Placement& placement, int axisClass) {
  return exactLine(mechanism, placement.lineOfClass(axisClass), placement.classes->classes[axisClass].axis);
}

std::optional<ExactVector3> exactPitchPoint(const Mechanism& mechanism, const Placement& placement,
                                            int mesh) {
  const MeshGeometry& geometry = *placement.meshes[mesh];
  if (!geometry.derived) {
    const NumberTriple& point = *mechanism.gearMeshes[mesh].pitchPoint;
    return ExactVector3{point[0].exact(), point[1].exact(), point[2].exact()};
  }
  const ExactLine tail = exactLineOfClass(mechanism, placement, geometry.tailClass);
  const ExactLine head = exactLineOfClass(mechanism, placement, geometry.headClass);
  const GearMesh& element = mechanism.gearMeshes[mesh];
  const GearPair<Rational> pair{tail.point,     tail.direction,    head.point,
                                head.direction, element.tailTeeth, element.headTeeth};
  if (geometry.kind == MeshKind::bevel)
    return bevelPitchPoint(pair, geometry.sides,
                           Rational(geometry.bevelSize, kUsualBevelSize) * placement.module);
  const bool inner = tailIsInner(placement, geometry.tailClass, geometry.headClass);
  return parallelPitchPoint(pair, geometry.kind == MeshKind::internal,
                            inner ? pair.tailPoint : pair.headPoint);
}

}  // namespace geargraph
