#include "core/presentation/diagrams/power_picture.h"

#include <algorithm>
#include <cmath>

namespace geargraph {
namespace {

ElementId elementOf(const Mechanism& mechanism, const ElementPower& element) {
  const auto at = static_cast<std::size_t>(element.position);
  switch (element.kind) {
    case ElementPower::Kind::mesh:
      return mechanism.gearMeshes[at].id;
    case ElementPower::Kind::joint:
      return mechanism.turningJoints[at].id;
    case ElementPower::Kind::coupling:
      return mechanism.couplings[at].id;
    case ElementPower::Kind::load:
    case ElementPower::Kind::balance:
      break;
  }
  return mechanism.links[element.ports.front().link].id;
}

DrawnFlow drawnFlow(const Mechanism& mechanism, const ElementPower& element, double least) {
  DrawnFlow flow;
  flow.element = elementOf(mechanism, element);
  flow.isDetermined = element.isDetermined;
  flow.isAssumed = element.isAssumed;
  for (const PowerPort& port : element.ports) {
    const double power = port.power.number();
    if (std::abs(power) > least) flow.ports.push_back({port.link, power, 0});
  }
  if (element.kind == ElementPower::Kind::mesh) flow.lost = std::max(0.0, -element.fed().number());
  return flow;
}

std::vector<double> membersOf(const StaticsSolution& solution, MeshOrdinal mesh) {
  std::vector<double> members(solution.selfStresses.size());
  for (std::size_t i = 0; i < members.size(); ++i)
    for (const auto& [unknown, weight] : solution.selfStresses[i])
      if (unknown == mesh) members[i] = weight.toDouble();
  return members;
}

/// Where a loop enters a link and where it leaves it: of the elements on the loop those that deliver and take
/// most there.
void addLoop(const Circulation& loop, std::vector<DrawnFlow>& flows, const std::vector<char>& isOnLoop) {
  for (const LinkOrdinal link : loop.links) {
    DrawnPort* most = nullptr;
    DrawnPort* least = nullptr;
    for (std::size_t i = 0; i < flows.size(); ++i) {
      if (isOnLoop[i] == 0) continue;
      for (DrawnPort& port : flows[i].ports) {
        if (port.link != link) continue;
        if (port.power > 0 && (most == nullptr || port.power > most->power)) most = &port;
        if (port.power < 0 && (least == nullptr || port.power < least->power)) least = &port;
      }
    }
    if (most == nullptr || least == nullptr) continue;
    const double power = loop.power.number();
    most->circulating = std::min(most->power, most->circulating + power);
    least->circulating = std::max(least->power, least->circulating - power);
  }
}

void addLoops(const Mechanism& mechanism, const std::vector<Circulation>& circulations,
              PowerPicture& picture) {
  constexpr double kNoticeable = 1e-3;
  for (const Circulation& each : circulations) {
    if (each.power.number() <= kNoticeable * picture.fed) continue;
    DrawnLoop loop{each.power.number(), {}, {}};
    for (const LinkOrdinal link : each.links) loop.links.push_back(mechanism.linkLabel(link));
    std::vector<char> isOnLoop(picture.flows.size());
    for (const MeshOrdinal mesh : each.meshes) loop.meshes.push_back(mechanism.meshLabel(mesh));
    for (std::size_t i = 0; i < picture.flows.size(); ++i) {
      const ElementId& element = picture.flows[i].element;
      const bool isMeshOfLoop = std::any_of(each.meshes.begin(), each.meshes.end(), [&](MeshOrdinal mesh) {
        return ElementId(mechanism.gearMeshes[mesh].id) == element;
      });
      isOnLoop[i] = isMeshOfLoop || element.kind == ElementKind::coupling ? 1 : 0;
    }
    addLoop(each, picture.flows, isOnLoop);
    picture.loops.push_back(std::move(loop));
  }
}

}  // namespace

PowerPicture powerPicture(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
                          const StaticsReport& report, LinkOrdinal observer) {
  PowerPicture picture;
  picture.observer = mechanism.linkLabel(observer);
  if (!report.flow || !report.sums) return picture;
  picture.fed = report.sums->fed.number();
  const PowerFlow seen =
      observer == 0 ? PowerFlow() : powerFlowSeenFrom(mechanism, model, placement, report, observer);
  const PowerFlow& flow = observer == 0 ? *report.flow : seen;
  for (const ElementPower& element : flow.elements)
    for (const PowerPort& port : element.ports)
      if (element.isDetermined) picture.largest = std::max(picture.largest, std::abs(port.power.number()));
  constexpr double kRounding = 1e-9;
  for (const ElementPower& element : flow.elements) {
    DrawnFlow drawn = drawnFlow(mechanism, element, kRounding * picture.largest);
    if ((!drawn.isDetermined || drawn.isAssumed) && element.kind == ElementPower::Kind::mesh)
      drawn.members = membersOf(report.solution(), element.position);
    if (!drawn.ports.empty() || !drawn.isDetermined) picture.flows.push_back(std::move(drawn));
  }
  if (observer == 0 && report.circulations) addLoops(mechanism, *report.circulations, picture);
  return picture;
}

}  // namespace geargraph
