#include "core/mechanism/placement/placement.h"

#include <algorithm>
#include <cmath>

#include "core/mechanism/placement/axis_placer.h"
#include "core/mechanism/placement/bevel_arranger.h"
#include "core/mechanism/placement/crossing.h"
#include "core/mechanism/placement/pair_rule.h"
#include "core/mechanism/placement/slide.h"
#include "core/mechanism/placement/strand.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph {
namespace {

/// Is the tail's axis the inner one, nearer the ground?
bool tailIsInner(const Placement& placement, AxisGroupOrdinal tailClass, AxisGroupOrdinal headClass) {
  const auto& classes = placement.classes->classes;
  return classes[tailClass].depth <= classes[headClass].depth;
}

/// Chooses the half axes of bevel pairs that the file leaves open.
class SideChooser {
 public:
  SideChooser(const Mechanism& mechanism, const Placement& placement, const LineComparison& train)
      : m_mechanism(mechanism), m_placement(placement), m_train(train) {}

  /// The pair's places are relative to the point of the tail's line.
  BevelSides choose(MeshOrdinal mesh, const MeshAxisPath& word, const GearPair<double>& pair) {
    const auto [tail, head] = m_placement.tree->meshes[mesh];
    const bool inner = tailIsInner(m_placement, word.tailClass, word.headClass);
    const Vector3 apex = apexOf(pair);
    const ExactVector3 origin = exactLineOfClass(m_mechanism, m_placement, word.tailClass).point;
    BevelSides sides;
    sides.tail = side(tail, word.tailClass, word.carrier, head, apex, origin, inner);
    sides.head = side(head, word.headClass, word.carrier, tail, apex, origin, !inner);
    return sides;
  }

 private:
  int side(LinkOrdinal link, AxisGroupOrdinal axisGroup, LinkOrdinal carrier, int partner,
           const Vector3& apex, const ExactVector3& origin, bool inner) {
    const AxisLine& line = m_placement.lineOfClass(axisGroup);
    if (m_placement.classes->classOfLink(link) == axisGroup) {
      const JointOrdinal joint = m_placement.tree->joint[link];
      const AxisOrdinal axis = m_placement.tree->axisOf[joint];
      const AxisLine& own = m_placement.axes[axis];
      const double offset = m_mechanism.turningJoints[joint].offset.value();
      const bool silent = own.automatic && offset == 0;
      if (!silent) {
        // Places relative to the point of the tail's line, as those of the pair are.
        const Vector3 from = exactDifference(exactLine(m_mechanism, m_placement, axis).point, origin);
        const double along =
            dot(from - apex, line.direction) + m_placement.classes->orientationSign[joint] * offset;
        const double nothing =
            kSameLine * std::max({reachOf(from), reachOf(apex), std::abs(offset), m_train.size()});
        if (along > nothing) return 1;
        if (along < -nothing) return -1;
      }
    }
    if (!inner) return 1;
    return m_numbers.side(axisGroup, carrier, link, partner);
  }

  const Mechanism& m_mechanism;
  const Placement& m_placement;
  const LineComparison& m_train;
  SideNumbers m_numbers;
};

/// Finds what the geometry of meshes comes to.
class MeshLocator {
 public:
  MeshLocator(const Mechanism& mechanism, Placement& placement, const LineComparison& train,
              SpanByMesh<const int> bevelSizes)
      : m_mechanism(mechanism),
        m_placement(placement),
        m_bevelSizes(bevelSizes),
        m_module(placement.module.toDouble()),
        m_train(train),
        m_sides(mechanism, placement, train) {}

  /// False, and a diagnostic, where it comes to nothing.
  bool locate(MeshOrdinal mesh, const MeshAxisPath& word, MeshGeometry& geometry) {
    const GearMesh& element = m_mechanism.gearMeshes[mesh];
    const AxisLine& tail = m_placement.lineOfClass(word.tailClass);
    const AxisLine& head = m_placement.lineOfClass(word.headClass);
    takePlaces(word, tail, head, element, geometry);
    const GearPair<double> pair{{0, 0, 0},      tail.direction,    geometry.tailToHead,
                                head.direction, element.tailTeeth, element.headTeeth};
    geometry.tail = m_placement.tree->meshes[mesh].tail;
    geometry.head = m_placement.tree->meshes[mesh].head;
    geometry.carrier = word.carrier;
    geometry.tailClass = word.tailClass;
    geometry.headClass = word.headClass;
    geometry.tailTeeth = element.tailTeeth;
    geometry.headTeeth = element.headTeeth;
    if (slides(saidKind(element)) || isSliding(word.tailClass) || isSliding(word.headClass)) {
      if (!placeSlide(m_mechanism, mesh, pair, isSliding(word.tailClass), isSliding(word.headClass), geometry,
                      m_placement.diagnostics))
        return false;
      geometry.pitchPoint = tail.point + geometry.tailToPitch;
      return true;
    }
    geometry.weights = {element.tailTeeth, element.headTeeth};
    const LinePosition position = positionOf(pair, m_train);
    if (!touches(saidKind(element))) {
      const bool inner = tailIsInner(m_placement, word.tailClass, word.headClass);
      if (!placeStrand(m_mechanism, mesh, pair, position, inner ? pair.tailPoint : pair.headPoint, geometry,
                       m_placement.diagnostics))
        return false;
      geometry.pitchPoint = tail.point + geometry.tailToPitch;
      return true;
    }
    if (hasSkewAxes(saidKind(element))) {
      SkewChoice choice;
      if (pairKind(saidKind(element)).isOffset) {
        choice.sides = m_sides.choose(mesh, word, pair);
        choice.module = element.module ? element.module->value() : m_module;
      }
      if (!pairRule(saidKind(element))
               .placeSkew(m_mechanism, mesh, pair, position, choice, geometry, m_placement.diagnostics))
        return false;
      if (geometry.derived) geometry.pitchPoint = tail.point + geometry.tailToPitch;
      return true;
    }
    if (position == LinePosition::skew) return reject(skewAxes(m_mechanism, mesh, pair));
    if (!element.pitchPoint) {
      if (!derivePitchPoint(mesh, pair, word, position, geometry))
        return reject(equalInternalTeeth(m_mechanism, mesh));
      geometry.pitchPoint = tail.point + geometry.tailToPitch;
    }
    return checkGeometry(m_mechanism, mesh, pair, position, geometry, m_placement.diagnostics);
  }

 private:
  [[nodiscard]] bool isSliding(AxisGroupOrdinal axisGroup) const {
    return m_placement.classes->classes[axisGroup].kind == JointKind::sliding;
  }

  bool reject(Diagnostic why) {
    m_placement.diagnostics.push_back(std::move(why));
    return false;
  }

  /// The head's line and a given pitch point, seen from the tail's line: by doubles, and where their rounding
  /// could show in a mesh of this extent, by fractions.
  void takePlaces(const MeshAxisPath& word, const AxisLine& tail, const AxisLine& head,
                  const GearMesh& element, MeshGeometry& geometry) const {
    constexpr double kNegligible = 1e-10;
    geometry.tailToHead = head.point - tail.point;
    double reach = reachOf(tail.point) + reachOf(head.point);
    double extent = reachOf(geometry.tailToHead);
    if (element.pitchPoint) {
      geometry.pitchPoint = toDoubles(*element.pitchPoint);
      geometry.tailToPitch = geometry.pitchPoint - tail.point;
      reach += reachOf(geometry.pitchPoint);
      extent = std::max(extent, reachOf(geometry.tailToPitch));
    }
    if (roundingOf(reach) <= kNegligible * extent || roundingOf(reach) <= kNegligible * m_train.size())
      return;
    const ExactVector3 origin = exactLineOfClass(m_mechanism, m_placement, word.tailClass).point;
    geometry.tailToHead =
        exactDifference(exactLineOfClass(m_mechanism, m_placement, word.headClass).point, origin);
    if (element.pitchPoint) geometry.tailToPitch = exactDifference(toFractions(*element.pitchPoint), origin);
  }

  /// False where a pair with a ring has equal teeth.
  bool derivePitchPoint(MeshOrdinal mesh, const GearPair<double>& pair, const MeshAxisPath& word,
                        LinePosition position, MeshGeometry& geometry) {
    geometry.derived = true;
    const MeshKind said = saidKind(m_mechanism.gearMeshes[mesh]);
    const MeshKind kind = pairKind(said).axes == position ? said : usualKind(position);
    if (distanceTeeth(kind, pair.tailTeeth, pair.headTeeth) == 0) return false;
    PitchPlace<double> place;
    if (position == LinePosition::intersecting) {
      geometry.sides = place.sides = m_sides.choose(mesh, word, pair);
      if (!m_bevelSizes.empty()) geometry.bevelSize = m_bevelSizes[mesh];
      const std::optional<Number>& stated = m_mechanism.gearMeshes[mesh].module;
      place.module = stated ? stated->value() : m_module * geometry.bevelSize / kUsualBevelSize;
    } else {
      const bool inner = tailIsInner(m_placement, word.tailClass, word.headClass);
      place.level = inner ? pair.tailPoint : pair.headPoint;
    }
    geometry.tailToPitch = pairRule(kind).pitchPoint(pair, place);
    return true;
  }

  const Mechanism& m_mechanism;
  Placement& m_placement;
  SpanByMesh<const int> m_bevelSizes;  ///< none where no bevel pair was placed
  double m_module = 0;
  const LineComparison& m_train;
  SideChooser m_sides;
};

void take(PlacedAxes& placed, Placement& placement) {
  placement.axes = std::move(placed.lines);
  placement.chosen = std::move(placed.chosen);
  placement.module = std::move(placed.module);
}

}  // namespace

Placement placementOf(const Mechanism& mechanism) {
  return placementOf(mechanism, JointTree::of(mechanism));
}

Placement placementOf(const Mechanism& mechanism, std::optional<JointTree> tree) {
  Placement placement;
  ByAxis<AxisLine> given = givenLines(mechanism);
  if (!tree) {
    placement.meshes.resize(mechanism.gearMeshes.size());
    PlacedAxes placed = placedAxes(mechanism, std::move(given), nullptr, AxisGroups(), {});
    take(placed, placement);
    return placement;
  }
  placement.tree = std::move(tree);
  placement.classes.emplace(mechanism, *placement.tree, given, placement.diagnostics);
  ByMesh<std::optional<MeshAxisPath>> words;
  words.reserve(mechanism.gearMeshes.size());
  AxisGroupPath path;
  for (MeshOrdinal mesh = 0; mesh < mechanism.c(); ++mesh) {
    words.push_back(
        meshWord(mechanism, *placement.classes, *placement.tree, mesh, path, placement.diagnostics));
  }
  PlacedAxes placed = placedAxes(mechanism, std::move(given), &*placement.tree, *placement.classes, words);
  take(placed, placement);
  const LineComparison train(mechanism, *placement.tree->graph, placement.axes);
  MeshLocator locator(mechanism, placement, train, placed.bevelSizes);
  placement.meshes.reserve(words.size());
  for (MeshOrdinal mesh = 0; mesh < mechanism.c(); ++mesh) {
    auto& geometry = placement.meshes.emplace_back();
    if (words[mesh] && !locator.locate(mesh, *words[mesh], geometry.emplace())) geometry.reset();
  }
  return placement;
}

ExactLine exactLine(const Mechanism& mechanism, const Placement& placement, AxisOrdinal axis) {
  const AxisLine& line = placement.axes[axis];
  if (line.chosen >= 0) return placement.chosen[line.chosen];
  const Axis& given = mechanism.axes[axis];
  return {toFractions(*given.point), toFractions(*given.direction)};
}

ExactLine exactLineOfClass(const Mechanism& mechanism, const Placement& placement,
                           AxisGroupOrdinal axisGroup) {
  return exactLine(mechanism, placement, placement.classes->classes[axisGroup].axis);
}

std::optional<ExactVector3> exactPitchPoint(const Mechanism& mechanism, const Placement& placement,
                                            MeshOrdinal mesh) {
  const MeshGeometry& geometry = *placement.meshes[mesh];
  if (!touches(geometry.kind)) return std::nullopt;
  if (!geometry.derived) {
    return toFractions(*mechanism.gearMeshes[mesh].pitchPoint);
  }
  if (hasSkewAxes(geometry.kind)) return std::nullopt;
  const ExactLine tail = exactLineOfClass(mechanism, placement, geometry.tailClass);
  const ExactLine head = exactLineOfClass(mechanism, placement, geometry.headClass);
  const GearMesh& element = mechanism.gearMeshes[mesh];
  const GearPair<Rational> pair{tail.point,     tail.direction,    head.point,
                                head.direction, element.tailTeeth, element.headTeeth};
  const bool inner = tailIsInner(placement, geometry.tailClass, geometry.headClass);
  const Rational module = element.module ? element.module->exact()
                                         : Rational(geometry.bevelSize, kUsualBevelSize) * placement.module;
  return pairRule(geometry.kind)
      .exactPitchPoint(pair, {inner ? pair.tailPoint : pair.headPoint, geometry.sides, module});
}

}  // namespace geargraph
