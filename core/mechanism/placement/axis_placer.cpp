#include "core/mechanism/placement/axis_placer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "core/mechanism/placement/bevel_arranger.h"
#include "core/mechanism/placement/mesh_geometry.h"
#include "core/mechanism/placement/pair_rule.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph {
namespace {

/// A vector at right angles: of z it is y, of y it is z, of x it is y.
ExactVector3 acrossOf(const ExactVector3& direction) {
  if (direction[0].isZero() && direction[2].isZero()) return {0, 0, 1};
  if (direction[1].isZero()) return {0, 1, 0};
  return cross(direction, ExactVector3{1, 0, 0});
}

class AxisPlacer {
 public:
  AxisPlacer(const Mechanism& mechanism, const JointTree* tree, const AxisGroups& classes,
             const ByMesh<std::optional<MeshAxisPath>>& words, const LineComparison* train)
      : m_mechanism(mechanism),
        m_classes(classes),
        m_words(words),
        m_train(train),
        m_lines(mechanism.axes.size()),
        m_meshesAt(mechanism.axes.size()),
        m_bevels(mechanism, tree, classes, words) {}

  PlacedAxes run() {
    takeGivenLines();
    collectMeshes();
    m_module = moduleOfGiven();
    standGivenBevels();
    placeOutward();
    PlacedAxes axes;
    axes.lines.reserve(m_lines.size());
    for (auto& placed : m_lines) {
      AxisLine& line =
          axes.lines.emplace_back(AxisLine{placed->point, placed->direction, placed->automatic, -1});
      if (!placed->automatic) continue;
      line.chosen = static_cast<int>(axes.chosen.size());
      axes.chosen.push_back(std::move(placed->exact));
    }
    axes.module = m_module;
    axes.bevelSizes = m_bevels.sizes();
    return axes;
  }

 private:
  struct Partner {
    MeshOrdinal mesh = 0;
    AxisOrdinal axis = 0;
  };

  struct PlacedLine {
    ExactLine exact;
    Vector3 point{};
    Vector3 direction{};
    bool automatic = false;
  };

  void takeGivenLines() {
    for (const AxisOrdinal at : m_lines.ordinals()) {
      const Axis& axis = m_mechanism.axes[at];
      if (axis.point && axis.direction) {
        setLine(at, lineOf(toFractions(*axis.point), toFractions(*axis.direction), false));
      }
    }
  }

  void setLine(AxisOrdinal axis, PlacedLine line) {
    m_bevels.setLine(axis, line.point, line.direction);
    m_lines[axis] = std::move(line);
  }

  void standGivenBevels() {
    std::set<std::pair<int, int>> seen;
    for (const AxisOrdinal axis : m_lines.ordinals()) {
      for (const Partner& partner : m_meshesAt[axis]) {
        const auto [a, b] = std::minmax<AxisOrdinal>(axis, partner.axis);
        if (!m_lines[a] || !m_lines[b] || !seen.insert({a, b}).second) continue;
        const PlacedLine& one = *m_lines[a];
        const PlacedLine& other = *m_lines[b];
        if (positionOfLines(one, other) == LinePosition::intersecting)
          m_bevels.stand(a, b, m_module.toDouble());
      }
    }
  }

  [[nodiscard]] LinePosition positionOfLines(const PlacedLine& a, const PlacedLine& b) const {
    const Vector3 apart = exactDifference(b.exact.point, a.exact.point);
    return positionOf({{0, 0, 0}, a.direction, apart, b.direction, 1, 1}, *m_train);
  }

  static PlacedLine lineOf(ExactVector3 point, ExactVector3 direction, bool automatic) {
    PlacedLine line{{std::move(point), std::move(direction)}, {}, {}, automatic};
    line.point = toDoubles(line.exact.point);
    line.direction = unitDirection(line.exact.direction);
    return line;
  }

  void collectMeshes() {
    for (const MeshOrdinal mesh : m_words.ordinals()) {
      if (!m_words[mesh]) continue;
      const AxisOrdinal tail = m_classes.classes[m_words[mesh]->tailClass].axis;
      const AxisOrdinal head = m_classes.classes[m_words[mesh]->headClass].axis;
      if (tail == head) continue;
      m_meshesAt[tail].push_back({mesh, head});
      m_meshesAt[head].push_back({mesh, tail});
    }
  }

  [[nodiscard]] const GearMesh& mesh(MeshOrdinal of) const { return m_mechanism.gearMeshes[of]; }

  [[nodiscard]] int distanceTeethOf(MeshOrdinal position) const {
    const GearMesh& of = mesh(position);
    return distanceTeeth(saidKind(of), of.tailTeeth, of.headTeeth);
  }

  /// The transverse module of a pair: that which it states, else the train's.
  [[nodiscard]] Rational moduleOf(MeshOrdinal position) const {
    return statedModule(mesh(position)).value_or(m_module);
  }

  [[nodiscard]] Rational moduleOfGiven() const {
    for (std::size_t i = 0; i < m_words.size(); ++i) {
      if (!m_words[i] || !touches(saidKind(mesh(static_cast<int>(i))))) continue;
      const auto& a = m_lines[m_classes.classes[m_words[i]->tailClass].axis];
      const auto& b = m_lines[m_classes.classes[m_words[i]->headClass].axis];
      const int teeth = distanceTeethOf(static_cast<int>(i));
      if (!a || !b || teeth == 0) continue;
      if (positionOfLines(*a, *b) != LinePosition::parallel) continue;
      const ExactVector3 off = cross(a->exact.direction, b->exact.point - a->exact.point);
      const Rational square = dot(off, off) / dot(a->exact.direction, a->exact.direction);
      if (square.isZero()) continue;
      const auto root = square.squareRoot();
      return (root ? *root : Rational::fromDouble(std::sqrt(square.toDouble()))) * Rational(2, teeth);
    }
    return kDefaultModule;
  }

  void placeOutward() {
    std::vector<AxisOrdinal> queue;
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
      if (m_lines[i]) queue.push_back(static_cast<int>(i));
    }
    std::size_t next = 0;
    for (std::size_t seed = 0;; ++seed) {
      for (; next < queue.size(); ++next) placeNeighbours(queue[next], queue);
      while (seed < m_lines.size() && m_lines[seed]) ++seed;
      if (seed >= m_lines.size()) return;
      placeAlone(static_cast<int>(seed), queue.empty());
      queue.push_back(static_cast<int>(seed));
    }
  }

  /// A new group: at the origin, or beside all that is there.
  void placeAlone(AxisOrdinal axis, bool first) {
    const Axis& element = m_mechanism.axes[axis];
    ExactVector3 point{0, 0, 0};
    if (!first) {
      double farthest = 0;
      for (const auto& line : m_lines) {
        if (line) farthest = std::max(farthest, line->point[1]);
      }
      point[1] = Rational::fromDouble(std::ceil(farthest)) + Rational(50) * m_module;
    }
    if (element.point) point = toFractions(*element.point);
    setLine(axis,
            lineOf(point, element.direction ? toFractions(*element.direction) : ExactVector3{0, 0, 1}, true));
  }

  void placeNeighbours(AxisOrdinal axis, std::vector<AxisOrdinal>& queue) {
    std::map<LinkOrdinal, std::vector<Partner>> open;  // by carrier
    for (const Partner& partner : m_meshesAt[axis]) {
      if (m_lines[partner.axis]) continue;
      std::vector<Partner>& list = open[m_words[partner.mesh]->carrier];
      const auto same =
          std::find_if(list.begin(), list.end(), [&](const Partner& p) { return p.axis == partner.axis; });
      if (same == list.end()) {
        list.push_back(partner);
      } else if (!touches(saidKind(mesh(same->mesh)))) {
        *same = partner;  // wheels that touch say how far
      }
    }
    for (const auto& [carrier, list] : open) {
      int apex = 0;
      for (std::size_t i = 0; i < list.size(); ++i) {
        place(axis, list[i], static_cast<int>(i), static_cast<int>(list.size()), apex);
        queue.push_back(list[i].axis);
      }
    }
  }

  /// Axis `partner` beside the placed one, as number `index` of `count` round it. `apex`: where along the
  /// placed one the last bevel axis of its carrier meets it, in the arranger's steps.
  void place(AxisOrdinal axis, const Partner& partner, int index, int count, int& apex) {
    const PlacedLine& from = *m_lines[axis];
    const Axis& element = m_mechanism.axes[partner.axis];
    const ExactVector3 outward = spoke(from.exact.direction, index, count);
    const GearMesh& drawn = mesh(partner.mesh);
    if (hasSkewAxes(saidKind(drawn))) {
      placeCrossed(axis, partner.axis, outward, pairRule(saidKind(drawn)).crossedDistance(drawn, m_module));
      return;
    }
    const bool bevel = element.direction ? !isParallel(from.exact.direction, toFractions(*element.direction))
                                         : hasIntersectingAxes(saidKind(mesh(partner.mesh)));
    ExactVector3 point;
    ExactVector3 direction;
    if (bevel) {
      direction = element.direction ? toFractions(*element.direction) : outward;
      if (!element.point) {
        apex = m_bevels.place(axis, partner.axis, unitDirection(direction), m_module.toDouble(), apex);
        point = from.exact.point +
                scaledTo(from.exact.direction, Rational(BevelArranger::kStep * apex) * m_module);
      }
    } else {
      const Rational distance = moduleOf(partner.mesh) * Rational(distanceTeethOf(partner.mesh), 2);
      point = from.exact.point + scaledTo(outward, distance);
      direction = from.exact.direction;
      if (const auto held = heldByTwo(axis, partner)) point = *held;
    }
    if (element.point) point = toFractions(*element.point);
    if (element.direction) direction = toFractions(*element.direction);
    setLine(partner.axis, lineOf(point, direction, true));
  }

  /// Axis `placed` across the axis `by`, at a distance along `outward`.
  void placeCrossed(AxisOrdinal by, AxisOrdinal placed, const ExactVector3& outward,
                    const Rational& distance) {
    const PlacedLine& from = *m_lines[by];
    const Axis& element = m_mechanism.axes[placed];
    const ExactVector3 direction =
        element.direction ? toFractions(*element.direction) : cross(from.exact.direction, outward);
    const ExactVector3 point =
        element.point ? toFractions(*element.point) : from.exact.point + scaledTo(outward, distance);
    setLine(placed, lineOf(point, direction, true));
  }

  static bool isParallel(const ExactVector3& a, const ExactVector3& b) {
    const ExactVector3 normal = cross(a, b);
    return normal[0].isZero() && normal[1].isZero() && normal[2].isZero();
  }

  /// Direction number `index` of `count` even ones round an axis; the first is acrossOf(), quarters are
  /// exact.
  static ExactVector3 spoke(const ExactVector3& direction, int index, int count) {
    const ExactVector3 first = acrossOf(direction);
    if (index == 0) return first;
    if (2 * index == count) return Rational(-1) * first;
    const double angle = 2 * std::numbers::pi * index / count;
    const ExactVector3 second = scaledTo(cross(direction, first), lengthOf(first));
    // The rational point of the circle at tan(angle / 2): unit length stays exact.
    const Rational half =
        4 * index % count == 0
            ? Rational(4 * index == count ? 1 : -1)
            : Rational::fromDouble(std::ldexp(std::round(std::ldexp(std::tan(angle / 2), 30)), -30));
    const Rational scale = (Rational(1) + half * half).inverse();
    return (scale * (Rational(1) - half * half)) * first + (scale * Rational(2) * half) * second;
  }

  static Rational lengthOf(const ExactVector3& v) {
    const Rational square = dot(v, v);
    const auto root = square.squareRoot();
    return root ? *root : Rational::fromDouble(std::sqrt(square.toDouble()));
  }
  static ExactVector3 scaledTo(const ExactVector3& v, const Rational& size) {
    return (size / lengthOf(v)) * v;
  }

  /// Where the circles of two placed parallel neighbours on one carrier cross; nothing where there is no
  /// second neighbour or they miss each other.
  [[nodiscard]] std::optional<ExactVector3> heldByTwo(AxisOrdinal axis, const Partner& partner) const {
    const PlacedLine& a = *m_lines[axis];
    for (const Partner& other : m_meshesAt[partner.axis]) {
      if (other.axis == axis || !m_lines[other.axis] || !hasParallelAxes(saidKind(mesh(other.mesh))))
        continue;
      const PlacedLine& b = *m_lines[other.axis];
      if (!isParallel(a.exact.direction, b.exact.direction)) continue;
      const auto reach = [&](MeshOrdinal of) { return moduleOf(of).toDouble() / 2 * distanceTeethOf(of); };
      const double radiusA = reach(partner.mesh);
      const double radiusB = reach(other.mesh);
      Vector3 between = exactDifference(b.exact.point, a.exact.point);
      between = between - dot(between, a.direction) * a.direction;
      const double distance = length(between);
      if (distance <= kSameLine * (radiusA + radiusB) || distance > radiusA + radiusB ||
          distance < std::abs(radiusA - radiusB))
        continue;
      const double along = (distance * distance + radiusA * radiusA - radiusB * radiusB) / (2 * distance);
      const double up = std::sqrt(std::max(0.0, radiusA * radiusA - along * along));
      const Vector3 forward = unit(between);
      const Vector3 from = along * forward + up * cross(a.direction, forward);
      return a.exact.point + ExactVector3{Rational::fromDouble(from[0]), Rational::fromDouble(from[1]),
                                          Rational::fromDouble(from[2])};
    }
    return std::nullopt;
  }

  const Mechanism& m_mechanism;
  const AxisGroups& m_classes;
  const ByMesh<std::optional<MeshAxisPath>>& m_words;
  const LineComparison* m_train;  ///< as given; none without a tree, where nothing is compared
  ByAxis<std::optional<PlacedLine>> m_lines;
  ByAxis<std::vector<Partner>> m_meshesAt;
  Rational m_module = kDefaultModule;
  BevelArranger m_bevels;
};

}  // namespace

std::optional<Rational> statedModule(const GearMesh& mesh) {
  if (!mesh.module) return std::nullopt;
  const double helix = helixOf(mesh);
  if (helix == 0) return mesh.module->exact();
  return Rational::fromDouble(mesh.module->value() / std::cos(helix));
}

PlacedAxes placedAxes(const Mechanism& mechanism, ByAxis<AxisLine> given, const JointTree* tree,
                      const AxisGroups& classes, const ByMesh<std::optional<MeshAxisPath>>& words) {
  // All given is the usual case, and needs no fractions.
  const bool open =
      std::any_of(given.begin(), given.end(), [](const AxisLine& axis) { return axis.automatic; });
  if (open) {
    std::optional<LineComparison> train;
    if (tree != nullptr) train.emplace(mechanism, *tree->graph, given);
    return AxisPlacer(mechanism, tree, classes, words, train ? &*train : nullptr).run();
  }
  return {std::move(given), {}, kDefaultModule, {}};
}

}  // namespace geargraph
