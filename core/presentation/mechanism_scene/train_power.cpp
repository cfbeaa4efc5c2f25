#include "core/presentation/mechanism_scene/train_power.h"

#include <array>
#include <cmath>
#include <map>
#include <span>

#include "core/foundations/base/position_index.h"
#include "core/presentation/diagrams/power_legend.h"

namespace geargraph {
namespace {

constexpr double kThrough = 0.34;    ///< length over the scene's radius: from one link into another
constexpr double kOneSide = 0.24;    ///< of one that ends or begins where teeth meet
constexpr double kEnd = 0.3;         ///< of one at the end of a shaft
constexpr double kNextBeyond = 1.2;  ///< lengths from one end arrow to the next one beyond it
constexpr int kMaxBeyond = 4;

Eigen::Vector3d vectorOf(const Vector3& vector) {
  return {vector[0], vector[1], vector[2]};
}

struct Line {
  Eigen::Vector3d point;
  Eigen::Vector3d direction;
};

/// Where a link is along a line.
struct Reach {
  double low = 0;
  double high = 0;
  [[nodiscard]] double middle() const { return 0.5 * (low + high); }
};

/// A link at an element, and the direction from the element into it.
struct Terminal {
  LinkOrdinal link = 0;
  Eigen::Vector3d side;
};

class ArrowMaker {
 public:
  ArrowMaker(const Mechanism& mechanism, const Placement& placement, const MechanismScene& stage)
      : m_mechanism(mechanism),
        m_placement(placement),
        m_stage(stage),
        m_bounds(boundsOf(stage.scene)),
        m_links(mechanism.links),
        m_joints(mechanism.turningJoints),
        m_meshes(mechanism.gearMeshes) {
    for (std::size_t i = 0; i < stage.scene.instances.size(); ++i)
      m_instances[stage.scene.instances[i].element].push_back(i);
    for (const SceneLabel& label : stage.labels)
      if (label.kind == LabelKind::joint)
        m_jointPlaces.try_emplace(label.element, stage.scene.instances[label.instance].pose * label.place);
  }

  void add(const DrawnFlow& flow) {
    switch (flow.element.kind) {
      case ElementKind::gearMesh:
        return addMesh(flow);
      case ElementKind::turningJoint:
        return addJoint(flow);
      case ElementKind::coupling:
        return addCoupling(flow);
      case ElementKind::link:
        if (flow.ports.empty()) return;
        return addAtEnd(flow, flow.ports.front(), lineOfLink(flow.ports.front().link));
      default:
        return;
    }
  }
  std::vector<PowerArrow> take() && { return std::move(m_arrows); }

 private:
  [[nodiscard]] double radius() const { return m_bounds.radius(); }

  [[nodiscard]] Line lineOf(int axis) const {
    const AxisLine& line = m_placement.axes[axis];
    return {vectorOf(line.point), vectorOf(line.direction)};
  }
  [[nodiscard]] Line lineOfJoint(JointOrdinal joint) const { return lineOf(m_placement.tree->axisOf[joint]); }
  /// That it turns about; that of the first joint for the ground.
  [[nodiscard]] Line lineOfLink(LinkOrdinal link) const {
    return lineOfJoint(std::max(0, m_placement.tree->joint[link]));
  }
  [[nodiscard]] std::optional<ElementId> moving(LinkOrdinal link) const {
    if (link == 0) return std::nullopt;
    return m_mechanism.links[link].id;
  }

  [[nodiscard]] std::optional<Reach> reachOf(LinkOrdinal link, const Line& line) const {
    const auto own = m_instances.find(m_mechanism.links[link].id);
    if (own == m_instances.end()) return std::nullopt;
    Reach reach{1e300, -1e300};
    for (const std::size_t at : own->second) {
      const Instance& instance = m_stage.scene.instances[at];
      const Eigen::AlignedBox3d box = m_stage.scene.boxOf(instance.solid);
      if (box.isEmpty()) continue;
      for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d point =
            instance.pose * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
        const double along = line.direction.dot(point - line.point);
        reach.low = std::min(reach.low, along);
        reach.high = std::max(reach.high, along);
      }
    }
    if (reach.low > reach.high) return std::nullopt;
    return reach;
  }
  [[nodiscard]] double middleOf(LinkOrdinal link, const Line& line) const {
    const auto reach = reachOf(link, line);
    return reach ? reach->middle() : line.direction.dot(m_bounds.centre() - line.point);
  }

  /// Two links along a line, and the directions into each.
  [[nodiscard]] std::array<Terminal, 2> along(const Line& line, int first, int second) const {
    const double apart = middleOf(second, line) - middleOf(first, line);
    const Eigen::Vector3d way = apart >= -1e-9 * radius() ? line.direction : Eigen::Vector3d(-line.direction);
    return {Terminal{first, -way}, Terminal{second, way}};
  }

  void put(const DrawnFlow& flow, PowerArrow arrow) {
    arrow.element = flow.element;
    arrow.isKnown = flow.isDetermined;
    arrow.isAssumed = flow.isAssumed;
    if (!flow.isDetermined) arrow.given = arrow.delivered = arrow.circulating = 0;
    if (flow.isDetermined) arrow.tint = tintOfFlow(flow, m_mechanism);
    for (std::optional<int>* link : {&arrow.giver, &arrow.taker})
      if (*link) *link = m_mechanism.linkLabel(**link);
    m_arrows.push_back(std::move(arrow));
  }

  static const Eigen::Vector3d& sideOf(std::span<const Terminal> terminals, LinkOrdinal link) {
    for (const Terminal& terminal : terminals)
      if (terminal.link == link) return terminal.side;
    return terminals.back().side;
  }

  /// At a point: one arrow where all that leaves one link enters another, else one for each port.
  void addAt(const DrawnFlow& flow, const Eigen::Vector3d& point, const std::optional<ElementId>& movesWith,
             std::span<const Terminal> terminals) {
    const std::size_t first = m_arrows.size();
    PowerArrow arrow;
    arrow.movesWith = movesWith;
    const auto through = [&](const Terminal& from, const Terminal& to) {
      Eigen::Vector3d way = to.side - from.side;
      way = way.norm() > 1e-6 ? way.normalized() : to.side;
      arrow.from = point - 0.5 * kThrough * radius() * way;
      arrow.to = point + 0.5 * kThrough * radius() * way;
      arrow.giver = from.link;
      arrow.taker = to.link;
    };
    if (!flow.isDetermined) {
      through(terminals[0], terminals[1]);
      return put(flow, arrow);
    }
    if (isOne(flow)) {
      const bool isFirst = flow.ports[0].power < 0;
      const DrawnPort& from = flow.ports[isFirst ? 0 : 1];
      const DrawnPort& to = flow.ports[isFirst ? 1 : 0];
      through({from.link, sideOf(terminals, from.link)}, {to.link, sideOf(terminals, to.link)});
      arrow.given = -from.power;
      arrow.delivered = to.power;
      arrow.circulating = std::max(std::abs(from.circulating), std::abs(to.circulating));
      put(flow, arrow);
    } else {
      for (const DrawnPort& port : flow.ports) put(flow, oneSided(port, point, movesWith, terminals));
    }
    if (first < m_arrows.size()) m_arrows[first].lost = flow.lost;
  }

  static bool isOne(const DrawnFlow& flow) {
    if (flow.ports.size() != 2) return false;
    const DrawnPort& a = flow.ports[0];
    const DrawnPort& b = flow.ports[1];
    return a.power * b.power < 0 && (a.circulating == 0) == (b.circulating == 0) &&
           std::abs(a.power + b.power) <= kAsOneFlow * std::max(std::abs(a.power), std::abs(b.power));
  }

  [[nodiscard]] PowerArrow oneSided(const DrawnPort& port, const Eigen::Vector3d& point,
                                    const std::optional<ElementId>& movesWith,
                                    std::span<const Terminal> terminals) const {
    PowerArrow arrow;
    arrow.movesWith = movesWith;
    arrow.circulating = std::abs(port.circulating);
    const Eigen::Vector3d inside = point + kOneSide * radius() * sideOf(terminals, port.link);
    arrow.from = port.power < 0 ? inside : point;
    arrow.to = port.power < 0 ? point : inside;
    (port.power < 0 ? arrow.giver : arrow.taker) = port.link;
    (port.power < 0 ? arrow.given : arrow.delivered) = std::abs(port.power);
    return arrow;
  }

  /// A gear is on the side of its axis where they touch; that of an internal gear on the other one.
  void addMesh(const DrawnFlow& flow) {
    const MeshOrdinal mesh = m_meshes.at(MeshId(flow.element.id));
    const auto& geometry = m_placement.meshes[mesh];
    if (!geometry) return;
    const Eigen::Vector3d pitch = vectorOf(geometry->pitchPoint);
    const bool isInternal = hasRing(geometry->kind);
    const bool isTailRing = isInternal && std::abs(geometry->tailRadius) > std::abs(geometry->headRadius);
    const auto gear = [&](LinkOrdinal link, AxisGroupOrdinal axisGroup, bool isRing) {
      const AxisLine& axis = m_placement.lineOfClass(axisGroup);
      const Eigen::Vector3d point = vectorOf(axis.point), direction = vectorOf(axis.direction);
      const Eigen::Vector3d way = point + direction.dot(pitch - point) * direction - pitch;
      return Terminal{link, (isRing ? -1.0 : 1.0) * way.normalized()};
    };
    const std::array terminals{gear(geometry->tail, geometry->tailClass, isTailRing),
                               gear(geometry->head, geometry->headClass, isInternal && !isTailRing),
                               Terminal{geometry->carrier, vectorOf(geometry->normal).normalized()}};
    addAt(flow, pitch, moving(geometry->carrier), terminals);
  }

  void addJoint(const DrawnFlow& flow) {
    const JointOrdinal joint = m_joints.at(JointId(flow.element.id));
    const Line line = lineOfJoint(joint);
    if (flow.isDetermined && flow.ports.size() == 1) return addAtEnd(flow, flow.ports.front(), line);
    const TurningJoint& turning = m_mechanism.turningJoints[joint];
    const int child = m_placement.tree->child[joint];
    const auto place = m_jointPlaces.find(flow.element);
    const Eigen::Vector3d point = place != m_jointPlaces.end()
                                      ? place->second
                                      : Eigen::Vector3d(line.point + middleOf(child, line) * line.direction);
    addAt(flow, point, moving(child), along(line, m_links.at(turning.tail), m_links.at(turning.head)));
  }

  void addCoupling(const DrawnFlow& flow) {
    if (flow.ports.empty()) return;
    const int first = flow.ports.front().link;
    const Line line = lineOfLink(first);
    if (flow.ports.size() == 1) return addAtEnd(flow, flow.ports.front(), line);
    const int second = flow.ports[1].link;
    const double middle = 0.5 * (middleOf(first, line) + middleOf(second, line));
    addAt(flow, line.point + middle * line.direction, moving(first), along(line, first, second));
  }

  /// Into the end of a link that is farther out, or out of it; where another arrow is, at the other end, then
  /// beyond.
  void addAtEnd(const DrawnFlow& flow, const DrawnPort& port, const Line& line) {
    const double middle = line.direction.dot(m_bounds.centre() - line.point);
    const Reach reach = reachOf(port.link, line).value_or(Reach{middle, middle});
    const double length = kEnd * radius();
    const bool isHigh = reach.high - middle >= middle - reach.low;
    Eigen::Vector3d end = line.point;
    Eigen::Vector3d out = line.direction;
    for (int tried = 0; tried < 2 * kMaxBeyond; ++tried) {
      const bool atHigh = (tried % 2 == 0) == isHigh;
      out = atHigh ? line.direction : Eigen::Vector3d(-line.direction);
      const double beyond = kNextBeyond * length * (tried / 2);
      end = line.point + (atHigh ? reach.high : reach.low) * line.direction + beyond * out;
      if (isFree(end + 0.5 * length * out, length)) break;
    }
    m_ends.push_back(end + 0.5 * length * out);
    PowerArrow arrow;
    arrow.movesWith = moving(port.link);
    arrow.circulating = std::abs(port.circulating);
    const bool enters = port.power > 0;
    arrow.from = enters ? Eigen::Vector3d(end + length * out) : end;
    arrow.to = enters ? end : Eigen::Vector3d(end + length * out);
    (enters ? arrow.taker : arrow.giver) = port.link;
    (enters ? arrow.delivered : arrow.given) = std::abs(port.power);
    put(flow, arrow);
  }
  [[nodiscard]] bool isFree(const Eigen::Vector3d& middle, double length) const {
    return std::none_of(m_ends.begin(), m_ends.end(), [&](const Eigen::Vector3d& other) {
      return (other - middle).norm() < kNextBeyond * length * 0.99;
    });
  }

  const Mechanism& m_mechanism;
  const Placement& m_placement;
  const MechanismScene& m_stage;
  Bounds m_bounds;
  PositionIndex<LinkTag> m_links;
  PositionIndex<JointTag> m_joints;
  PositionIndex<MeshTag> m_meshes;
  std::map<ElementId, std::vector<std::size_t>> m_instances;
  std::map<ElementId, Eigen::Vector3d> m_jointPlaces;
  std::vector<Eigen::Vector3d> m_ends;  ///< middles of the arrows at ends
  std::vector<PowerArrow> m_arrows;
};

}  // namespace

double ScenePower::largest() const {
  double most = picture.largest;
  for (const PowerArrow& arrow : arrows) most = std::max(most, arrow.power());
  return most;
}

ScenePower stagePower(PowerPicture picture, const Mechanism& mechanism, const Placement& placement,
                      const MechanismScene& stage) {
  ScenePower power;
  if (!picture.isEmpty() && placement.tree && !stage.scene.instances.empty()) {
    ArrowMaker maker(mechanism, placement, stage);
    for (const DrawnFlow& flow : picture.flows) maker.add(flow);
    power.arrows = std::move(maker).take();
  }
  power.picture = std::move(picture);
  return power;
}

}  // namespace geargraph
