#include "core/theory/levers/speed_plan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/theory/levers/lever_plan.h"
#include "core/theory/states/relative_speed.h"

namespace geargraph {
namespace {

constexpr double kSameHeight = 1e-6;  ///< of the distance between the axes

/// Places axes and lines; outer classes follow the classes that carry them.
class SpeedPlanner {
 public:
  SpeedPlanner(const Placement& placement, std::span<const Rational> rates, AxisGroupOrdinal mainAxis)
      : m_placement(placement), m_classes(*placement.classes), m_rates(rates) {
    m_plan.absence = SpeedPlanAbsence::none;
    m_plan.mainAxis = mainAxis;
    m_plan.axes.assign(m_classes.classes.size(), {});
    m_isPlaced.assign(m_classes.classes.size(), false);
  }

  SpeedPlan plan() {
    placeAxes();
    for (LinkOrdinal link = 0; link < static_cast<int>(m_classes.ofLink.size()); ++link) addLine(link);
    // Each axis is a point of the link that carries it, and of those that turn about it.
    for (const AxisGroupOrdinal each : m_classes.classes.ordinals()) {
      const SpeedPlan::Axis& axis = m_plan.axes[each];
      extend(m_classes.classes[each].rootLink, axis.height);
    }
    for (const MeshOrdinal mesh : m_placement.meshes.ordinals()) addMesh(mesh);
    return std::move(m_plan);
  }

 private:
  [[nodiscard]] Vector3 between(AxisGroupOrdinal from, AxisGroupOrdinal to) const {
    const AxisLine& line = m_placement.lineOfClass(from);
    const Vector3 apart = m_placement.lineOfClass(to).point - line.point;
    return apart - dot(apart, line.direction) * line.direction;
  }
  /// The class of the link's own axis; that of the ground is the main axis.
  [[nodiscard]] AxisGroupOrdinal classOf(LinkOrdinal link) const {
    return link == 0 ? m_plan.mainAxis : m_classes.classOfLink(link);
  }
  [[nodiscard]] Rational speedOf(LinkOrdinal link) const {
    Rational speed = 0;
    for (const SpeedAbout& part : absoluteSpeed(m_placement, m_rates, link))
      speed += Rational(directionSign(m_placement, part.axisGroup, m_plan.mainAxis)) * part.speed;
    return speed;
  }

  /// Those on the ground one beside the other, then each above the axis of its carrier.
  void placeAxes() {
    place(m_plan.mainAxis, 0);
    for (bool more = true; more;) {
      more = false;
      for (const auto& mesh : m_placement.meshes) {
        if (m_classes.classes[mesh->tailClass].rootLink != 0 ||
            m_classes.classes[mesh->headClass].rootLink != 0)
          continue;
        const bool fromTail = m_isPlaced[mesh->tailClass];
        if (fromTail == m_isPlaced[mesh->headClass]) continue;
        const AxisGroupOrdinal from = fromTail ? mesh->tailClass : mesh->headClass;
        const AxisGroupOrdinal to = fromTail ? mesh->headClass : mesh->tailClass;
        place(to, m_plan.axes[from].height + length(between(from, to)));
        more = true;
      }
    }
    for (const AxisGroupOrdinal each : m_classes.classes.ordinals()) {
      if (!m_isPlaced[each] && m_classes.classes[each].rootLink == 0)
        place(each, length(between(m_plan.mainAxis, each)));
    }
    for (bool more = true; more;) {
      more = false;
      for (const AxisGroupOrdinal each : m_classes.classes.ordinals()) {
        const LinkOrdinal carrier = m_classes.classes[each].rootLink;
        if (m_isPlaced[each] || !m_isPlaced[classOf(carrier)]) continue;
        const AxisGroupOrdinal from = classOf(carrier);
        place(each, m_plan.axes[from].height + length(between(from, each)));
        SpeedPlan::Axis& axis = m_plan.axes[each];
        axis.velocity = m_plan.axes[from].velocity +
                        speedOf(carrier).toDouble() * (axis.height - m_plan.axes[from].height);
        more = true;
      }
    }
  }
  void place(AxisGroupOrdinal axis, double height) {
    m_plan.axes[axis].height = height;
    m_isPlaced[axis] = true;
  }

  void addLine(LinkOrdinal link) {
    const SpeedPlan::Axis& axis = m_plan.axes[classOf(link)];
    m_plan.lines.push_back(
        {link, axis.height, link == 0 ? 0 : axis.velocity, speedOf(link), axis.height, axis.height});
  }
  void extend(LinkOrdinal link, double height) {
    SpeedPlan::Line& line = m_plan.lines[static_cast<std::size_t>(int{link})];
    line.low = std::min(line.low, height);
    line.high = std::max(line.high, height);
  }

  /// The height of the teeth, if both axes and that of their carrier are in one plane: the pitch point by the
  /// teeth, where the wheels have one velocity.
  [[nodiscard]] std::optional<double> heightOf(const MeshGeometry& mesh) const {
    const double tail = m_plan.axes[mesh.tailClass].height;
    const double head = m_plan.axes[mesh.headClass].height;
    const double size = length(between(mesh.tailClass, mesh.headClass));
    if (size == 0 || std::abs(std::abs(head - tail) - size) > kSameHeight * size) return std::nullopt;
    return tail + (head - tail) * mesh.tailTeeth / (mesh.tailTeeth - mesh.sign * mesh.headTeeth);
  }

  void addMesh(MeshOrdinal mesh) {
    const MeshGeometry& geometry = *m_placement.meshes[mesh];
    if (geometry.tailTeeth == geometry.sign * geometry.headTeeth) {
      m_plan.alike.push_back(mesh);
      return;
    }
    const auto height = heightOf(geometry);
    if (!height) {
      m_plan.apart.push_back(mesh);
      return;
    }
    extend(geometry.tail, *height);
    extend(geometry.head, *height);
    const SpeedPlan::Line& line = m_plan.lines[static_cast<std::size_t>(int{geometry.tail})];
    m_plan.crossings.push_back({mesh, *height, line.velocityAt(*height)});
  }

  const Placement& m_placement;
  const AxisGroups& m_classes;
  std::span<const Rational> m_rates;
  ByClass<bool> m_isPlaced;
  SpeedPlan m_plan;
};

}  // namespace

SpeedPlan speedPlanOf(const Placement& placement, std::span<const Rational> rates) {
  SpeedPlan none;
  const auto hasGeometry = [](const auto& mesh) { return mesh.has_value(); };
  if (!placement.tree || !placement.classes || placement.classes->classes.empty() ||
      !std::all_of(placement.meshes.begin(), placement.meshes.end(), hasGeometry))
    return none;
  const AxisGroupOrdinal mainAxis = mainAxisOf(placement);
  for (const AxisGroupOrdinal each : placement.classes->classes.ordinals()) {
    if (directionSign(placement, each, mainAxis) == 0) none.absence = SpeedPlanAbsence::directions;
  }
  if (none.absence == SpeedPlanAbsence::directions) return none;
  none.absence = SpeedPlanAbsence::noMotion;
  return rates.empty() ? none : SpeedPlanner(placement, rates, mainAxis).plan();
}

}  // namespace geargraph
