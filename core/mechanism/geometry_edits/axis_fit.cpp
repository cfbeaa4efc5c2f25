#include "core/mechanism/geometry_edits/axis_fit.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/foundations/base/translation.h"
#include "core/mechanism/geometry_edits/module_fit.h"
#include "core/mechanism/geometry_edits/pin_rejection.h"
#include "core/mechanism/model/pins.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph {
namespace {

bool isZero(const ExactVector3& v) {
  return v[0].isZero() && v[1].isZero() && v[2].isZero();
}

/// A coordinate as a person would write it: exact where that is short, else the nearest double.
Number written(const Rational& value) {
  constexpr std::size_t kMaxLength = 24;
  Number exact(value);
  return exact.text().size() <= kMaxLength ? exact : Number::fromDouble(value.toDouble());
}

/// The new coordinates; one that is what it was keeps its spelling.
NumberTriple written(const ExactVector3& point, const std::optional<NumberTriple>& was) {
  NumberTriple triple;
  for (std::size_t i = 0; i < 3; ++i) {
    triple[i] = was && (*was)[i].exact() == point[i] ? (*was)[i] : written(point[i]);
  }
  return triple;
}

class AxisFitter {
 public:
  AxisFitter(const Mechanism& before, const Placement& placement, const std::map<AxisPair, Rational>& scales,
             const std::map<int, ExactVector3>& pinned)
      : m_before(before), m_placement(placement), m_scales(scales), m_pinned(pinned) {
    const std::size_t classes = placement.classes->classes.size();
    m_neighbours.resize(classes);
    m_along.resize(classes);
    m_shift.resize(classes);
    m_hasPins =
        std::any_of(before.axes.begin(), before.axes.end(), [](const Axis& axis) { return isPinned(axis); });
    for (AxisGroupOrdinal axisGroup = 0; axisGroup < static_cast<int>(classes); ++axisGroup) {
      m_lines.push_back(exactLineOfClass(before, placement, axisGroup));
      const int carrying = placement.classes->classOfLink(classAt(axisGroup).rootLink);
      if (carrying >= 0) m_along[axisGroup].push_back(carrying);
    }
    for (const auto& mesh : placement.meshes) {
      const auto tail = static_cast<std::size_t>(mesh->tailClass);
      const auto head = static_cast<std::size_t>(mesh->headClass);
      auto& lists = hasParallelAxes(mesh->kind) ? m_neighbours : m_along;
      lists[tail].push_back(mesh->headClass);
      lists[head].push_back(mesh->tailClass);
    }
    for (auto* lists : {&m_neighbours, &m_along}) {
      for (auto& list : *lists) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
      }
    }
  }

  /// By class: how far it moves.
  Expected<std::vector<ExactVector3>> run() {
    for (int placed = 0; placed < count(); ++placed) {
      const int next = nextClass();
      m_shift[next] = shiftOf(next);
      if (!m_rejections.empty()) return std::move(m_rejections);
    }
    if (m_hasPins || !m_pinned.empty()) checkHeld();
    if (!m_rejections.empty()) return std::move(m_rejections);
    std::vector<ExactVector3> shifts;
    for (auto& shift : m_shift) shifts.push_back(std::move(*shift));
    return shifts;
  }

 private:
  [[nodiscard]] int count() const { return static_cast<int>(m_shift.size()); }
  [[nodiscard]] const AxisGroups::Class& classAt(AxisGroupOrdinal axisGroup) const {
    return m_placement.classes->classes[axisGroup];
  }
  [[nodiscard]] bool isPlaced(AxisGroupOrdinal axisGroup) const { return m_shift[axisGroup].has_value(); }
  [[nodiscard]] std::vector<int> placedOf(const std::vector<int>& classes) const {
    std::vector<int> placed;
    std::copy_if(classes.begin(), classes.end(), std::back_inserter(placed),
                 [&](int c) { return isPlaced(c); });
    return placed;
  }
  [[nodiscard]] Rational scaleOf(int a, int b) const {
    const auto found = m_scales.find({std::min(a, b), std::max(a, b)});
    return found == m_scales.end() ? Rational(1) : found->second;
  }

  [[nodiscard]] bool isHeld(AxisGroupOrdinal axisGroup) const {
    return m_pinned.contains(axisGroup) || isPinned(axisOfClass(m_before, m_placement, axisGroup));
  }

  /// The unplaced class that is pinned, else the one that most placed ones hold; of equals the one nearest
  /// the ground, then the first.
  [[nodiscard]] int nextClass() const {
    int best = -1;
    std::tuple<int, int, int, int> bestRank;
    for (AxisGroupOrdinal axisGroup = 0; axisGroup < count(); ++axisGroup) {
      if (isPlaced(axisGroup)) continue;
      const auto at = static_cast<std::size_t>(axisGroup);
      const int meshes = static_cast<int>(placedOf(m_neighbours[at]).size());
      const int others = static_cast<int>(placedOf(m_along[at]).size());
      const std::tuple rank{isHeld(axisGroup) ? 1 : 0, meshes, others > 0 ? 1 : 0, -classAt(axisGroup).depth};
      if (best < 0 || rank > bestRank) {
        best = axisGroup;
        bestRank = rank;
      }
    }
    return best;
  }

  ExactVector3 shiftOf(AxisGroupOrdinal axisGroup) {
    const auto at = static_cast<std::size_t>(axisGroup);
    if (const auto pinned = m_pinned.find(axisGroup); pinned != m_pinned.end())
      return pinned->second - m_lines[at].point;
    if (isHeld(axisGroup)) return {};
    const std::vector<int> neighbours = placedOf(m_neighbours[at]);
    if (neighbours.empty()) {
      const std::vector<int> along = placedOf(m_along[at]);
      return along.empty() ? ExactVector3{} : *m_shift[along.front()];
    }
    const ExactVector3& first = *m_shift[neighbours.front()];
    const bool rigid = std::all_of(neighbours.begin(), neighbours.end(), [&](int other) {
      return scaleOf(axisGroup, other) == 1 && isZero(*m_shift[other] - first);
    });
    if (rigid) return first;
    if (neighbours.size() == 1) {
      const Rational growth = scaleOf(axisGroup, neighbours.front()) - Rational(1);
      return first + growth * radial(neighbours.front(), axisGroup);
    }
    return heldByTwo(axisGroup, neighbours);
  }

  /// Axes that are held may not have the distances that their wheels ask for.
  void checkHeld() {
    for (std::size_t m = 0; m < m_placement.meshes.size() && m_rejections.empty(); ++m) {
      const MeshGeometry& mesh = *m_placement.meshes[m];
      if (!hasParallelAxes(mesh.kind)) continue;
      const ExactVector3 was = radial(mesh.tailClass, mesh.headClass);
      const ExactVector3 shift = *m_shift[mesh.headClass] - *m_shift[mesh.tailClass];
      const Vector3 direction = unit(toDoubles(m_lines[mesh.tailClass].direction));
      const double now = length(cross(direction, toDoubles(was + shift)));
      const double wanted = length(toDoubles(was)) * scaleOf(mesh.tailClass, mesh.headClass).toDouble();
      if (std::abs(now - wanted) <= kGeometryFits * wanted) continue;
      if (m_hasPins) {
        m_rejections.push_back(pinRejection(m_before, m_placement, static_cast<int>(m)));
      } else {
        reject(mesh.headClass, {mesh.tailClass});
      }
    }
  }

  /// From one line to a parallel other, at right angles to both, as they were.
  [[nodiscard]] ExactVector3 radial(int from, int to) const {
    const ExactLine& line = m_lines[from];
    const ExactVector3 between = m_lines[to].point - line.point;
    const Rational along = dot(between, line.direction) / dot(line.direction, line.direction);
    return between - along * line.direction;
  }

  /// Where the new distances from two neighbours meet; any others have to agree.
  ExactVector3 heldByTwo(AxisGroupOrdinal axisGroup, const std::vector<int>& neighbours) {
    struct Circle {
      Vector3 centre;
      double radius = 0;
    };
    std::vector<Circle> circles;
    const Vector3 old = toDoubles(m_lines[axisGroup].point);
    for (const int other : neighbours) {
      const Vector3 off = toDoubles(radial(other, axisGroup));
      circles.push_back(
          {old - off + toDoubles(*m_shift[other]), length(off) * scaleOf(axisGroup, other).toDouble()});
    }
    const Vector3 direction = unit(toDoubles(m_lines[axisGroup].direction));
    const Vector3 between = circles[1].centre - circles[0].centre;
    const double distance = length(between);
    const double a = circles[0].radius, b = circles[1].radius;
    if (distance < 1e-9 * (a + b) || distance > (a + b) * (1 + 1e-12) || distance < std::abs(a - b)) {
      reject(axisGroup, neighbours);
      return {};
    }
    const Vector3 forward = unit(between);
    const Vector3 sideways = cross(direction, forward);
    const Vector3 was = toDoubles(radial(neighbours[0], axisGroup));
    const Vector3 wasBetween = toDoubles(radial(neighbours[0], neighbours[1]));
    const double side = dot(was, cross(direction, wasBetween)) < 0 ? -1 : 1;
    const double along = (distance * distance + a * a - b * b) / (2 * distance);
    const double up = std::sqrt(std::max(0.0, a * a - along * along));
    const Vector3 point = circles[0].centre + along * forward + (side * up) * sideways;
    for (const Circle& circle : circles) {
      const Vector3 off = point - circle.centre;
      if (std::abs(length(off) - circle.radius) > kGeometryFits * circle.radius)
        reject(axisGroup, neighbours);
    }
    ExactVector3 shift;
    for (std::size_t i = 0; i < 3; ++i) shift[i] = Rational::fromDouble(point[i] - old[i]);
    return shift;
  }

  void reject(AxisGroupOrdinal axisGroup, const std::vector<int>& neighbours) {
    if (!m_rejections.empty()) return;
    Diagnostic why;
    why.code = Code::teethGeometry;
    std::string names;
    for (std::size_t m = 0; m < m_placement.meshes.size(); ++m) {
      const MeshGeometry& mesh = *m_placement.meshes[m];
      const int other = mesh.tailClass == axisGroup ? mesh.headClass : mesh.tailClass;
      if (mesh.tailClass != axisGroup && mesh.headClass != axisGroup) continue;
      if (std::find(neighbours.begin(), neighbours.end(), other) == neighbours.end()) continue;
      names += (names.empty() ? "" : ", ") + std::to_string(m_before.meshLabel(static_cast<int>(m)));
      why.elements.emplace_back(m_before.gearMeshes[m].id);
    }
    const AxisId axis = m_before.axes[classAt(axisGroup).axis].id;
    why.elements.emplace_back(axis);
    why.message = translated(
        "There is no place for axis %1 where the wheels of meshes %2 would touch at these tooth counts. "
        "What fits: a smaller change, or other teeth first.",
        {axis.text(), names});
    m_rejections.push_back(std::move(why));
  }

  const Mechanism& m_before;
  const Placement& m_placement;
  const std::map<AxisPair, Rational>& m_scales;
  const std::map<int, ExactVector3>& m_pinned;
  bool m_hasPins = false;                  ///< of the user
  ByClass<ExactLine> m_lines;              ///< as they were
  ByClass<std::vector<int>> m_neighbours;  ///< parallel ones it meshes with
  ByClass<std::vector<int>> m_along;       ///< those it goes along with
  ByClass<std::optional<ExactVector3>> m_shift;
  Diagnostics m_rejections;
};

/// The pitch point of a mesh in the edited document, where `was` was its pitch point before.
class PitchPointFitter {
 public:
  PitchPointFitter(const Mechanism& before, const Placement& placement, const Mechanism& edited,
                   const std::vector<ExactVector3>& shifts)
      : m_before(before), m_placement(placement), m_edited(edited), m_shifts(shifts) {}

  [[nodiscard]] ExactVector3 pointOf(MeshOrdinal mesh) {
    const MeshGeometry& was = *m_placement.meshes[mesh];
    const ExactLine tail = lineNow(was.tailClass);
    const ExactLine head = lineNow(was.headClass);
    const GearMesh& element = m_edited.gearMeshes[mesh];
    if (hasIntersectingAxes(was.kind)) return bevelPoint(mesh, was, tail, head);
    if (hasSkewAxes(was.kind)) return crossedPoint(was, tail, head);
    const GearPair<Rational> pair{tail.point,     tail.direction,    head.point,
                                  head.direction, element.tailTeeth, element.headTeeth};
    const bool alike = turnsAlike(element.kind.value_or(was.kind));
    const NumberTriple& point = *m_before.gearMeshes[mesh].pitchPoint;
    const ExactVector3 level{point[0].exact(), point[1].exact(), point[2].exact()};
    return parallelPitchPoint(pair, alike, level + m_shifts[static_cast<std::size_t>(was.tailClass)]);
  }

 private:
  /// On the common perpendicular of both axes, at the share of their distance where it was.
  [[nodiscard]] static ExactVector3 crossedPoint(const MeshGeometry& was, const ExactLine& tail,
                                                 const ExactLine& head) {
    const ExactVector3 normal = cross(tail.direction, head.direction);
    const ExactVector3 between = head.point - tail.point;
    const Rational square = dot(normal, normal);
    const ExactVector3 foot =
        tail.point + (dot(cross(between, head.direction), normal) / square) * tail.direction;
    const ExactVector3 other =
        head.point + (dot(cross(between, tail.direction), normal) / square) * head.direction;
    const double share = was.tailPitchRadius() / (was.tailPitchRadius() + was.headPitchRadius());
    return foot + Rational::fromDouble(share) * (other - foot);
  }

  /// Axes that coincide after the edit share a class, so a class of before is found by its axis. Only where
  /// the program places it, the edited document has to be placed.
  [[nodiscard]] ExactLine lineNow(int classBefore) {
    const AxisOrdinal axis = m_placement.classes->classes[classBefore].axis;
    const Axis& stated = m_edited.axes[axis];
    if (stated.point && stated.direction) return {toFractions(*stated.point), toFractions(*stated.direction)};
    if (!m_now) m_now = placementOf(m_edited);
    return exactLine(m_edited, *m_now, axis);
  }

  /// On the same half axes as before, at the module of the mesh: radius over teeth.
  [[nodiscard]] ExactVector3 bevelPoint(MeshOrdinal mesh, const MeshGeometry& was, const ExactLine& tail,
                                        const ExactLine& head) const {
    const GearMesh& element = m_edited.gearMeshes[mesh];
    const GearPair<double> pair{toDoubles(tail.point),     toDoubles(tail.direction), toDoubles(head.point),
                                toDoubles(head.direction), element.tailTeeth,         element.headTeeth};
    const AxisLine& oldTail = m_placement.lineOfClass(was.tailClass);
    const AxisLine& oldHead = m_placement.lineOfClass(was.headClass);
    const Vector3 off = was.pitchPoint - apexOf(GearPair<double>{oldTail.point, oldTail.direction,
                                                                 oldHead.point, oldHead.direction, 1, 1});
    // P - O = x u_A + y u_B; the signs of x and y are the half axes.
    const double cosine = dot(oldTail.direction, oldHead.direction);
    const double x = dot(off, oldTail.direction - cosine * oldHead.direction);
    const double y = dot(off, oldHead.direction - cosine * oldTail.direction);
    const BevelSides sides{x < 0 ? -1 : 1, y < 0 ? -1 : 1};
    const Vector3 point = bevelPitchPoint(pair, sides, *moduleOf(m_before, m_placement, mesh));
    return {Rational::fromDouble(point[0]), Rational::fromDouble(point[1]), Rational::fromDouble(point[2])};
  }

  const Mechanism& m_before;
  const Placement& m_placement;
  const Mechanism& m_edited;
  const std::vector<ExactVector3>& m_shifts;
  std::optional<Placement> m_now;  ///< of the edited document, when asked for
};

bool meshChanged(const GearMesh& a, const GearMesh& b) {
  return a.tailTeeth != b.tailTeeth || a.headTeeth != b.headTeeth || a.kind != b.kind;
}

}  // namespace

Expected<Mechanism> fitAxes(const Mechanism& before, const Placement& placement, Mechanism edited,
                            const std::map<AxisPair, Rational>& scales,
                            const std::map<int, ExactVector3>& pinned) {
  const auto shifts = AxisFitter(before, placement, scales, pinned).run();
  if (!shifts) return shifts.error();
  std::set<int> moved;  // axes; several classes of one name go with the first
  for (std::size_t c = 0; c < shifts->size(); ++c) {
    const AxisOrdinal axis = placement.classes->classes[c].axis;
    Axis& element = edited.axes[axis];
    const ExactVector3& shift = (*shifts)[c];
    if (!element.point || isZero(shift) || !moved.insert(axis).second) continue;
    const NumberTriple& at = *element.point;
    element.point = written(ExactVector3{at[0].exact(), at[1].exact(), at[2].exact()} + shift, element.point);
  }
  PitchPointFitter fitter(before, placement, edited, *shifts);
  std::vector<std::pair<int, ExactVector3>> points;
  for (MeshOrdinal mesh = 0; mesh < edited.c(); ++mesh) {
    const GearMesh& element = edited.gearMeshes[mesh];
    const MeshGeometry& was = *placement.meshes[mesh];
    const bool stays = !meshChanged(before.gearMeshes[mesh], element) &&
                       isZero((*shifts)[static_cast<std::size_t>(was.tailClass)]) &&
                       isZero((*shifts)[static_cast<std::size_t>(was.headClass)]);
    if (element.pitchPoint && !stays) points.emplace_back(mesh, fitter.pointOf(mesh));
  }
  for (const auto& [mesh, point] : points) {
    auto& stated = edited.gearMeshes[mesh].pitchPoint;
    stated = written(point, stated);
  }
  return edited;
}

}  // namespace geargraph
