#include "core/machine/train/wheel_sharing.h"

#include <algorithm>

#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

/// In larger planes wheels share what is equal, whether all pass or not.
constexpr std::size_t kMaxAsked = 200;
constexpr double kTip = 1;  // modules beyond the pitch circle
constexpr double kRim = 3;  // the same of a ring's rim

}  // namespace

WheelSharing::WheelSharing(const Mechanism& mechanism, const Placement& placement) {
  for (std::size_t m = 0; m < placement.meshes.size(); ++m) {
    if (!placement.meshes[m]) continue;
    const GearMesh& drawn = mechanism.gearMeshes[m];
    const int tail = placement.meshes[m]->tail, head = placement.meshes[m]->head;
    m_meshing.insert({tail, drawn.tailTeeth, head, drawn.headTeeth});
    m_meshing.insert({head, drawn.headTeeth, tail, drawn.tailTeeth});
  }
  for (std::size_t c = 0; c < placement.classes->classes.size(); ++c)
    m_orbits.push_back(orbitOf(static_cast<int>(c), placement));
}

WheelSharing::WheelDisc WheelSharing::roundOf(const TrainWheel& wheel) {
  const double radius = wheel.workingRadius;
  const double module = 2 * radius / wheel.spec.teeth;
  const bool ring = isRing(wheel.spec);
  return {wheel.link,
          wheel.spec.teeth,
          wheel.axisGroup,
          ring ? radius - kTip * module : 0,
          radius + (ring ? kRim : kTip) * module,
          wheel.axis};
}

/// Planets of one carrier stand where they are drawn; whether they have room there is a diagnostic of its
/// own.
bool WheelSharing::pass(const WheelDisc& a, const WheelDisc& b) const {
  if (m_meshing.contains({a.link, a.teeth, b.link, b.teeth})) return true;
  if (a.axisGroup == b.axisGroup) return a.outer <= b.inner || b.outer <= a.inner;
  const WheelOrbit& one = m_orbits[a.axisGroup];
  const WheelOrbit& other = m_orbits[b.axisGroup];
  if (one.carrier == other.carrier) return true;
  const double distance = nearestAxes(one, other, a.axis);
  return distance >= a.outer + b.outer || distance + a.outer <= b.inner || distance + b.outer <= a.inner;
}

std::span<const GearOrdinal> WheelSharing::planeOf(std::optional<GearOrdinal> wheel) const {
  if (!wheel || *wheel >= m_rounds.count() || !m_rounds[*wheel]) return {};
  return m_wheels[m_planes[*wheel]];
}

/// Do all in the plane of one pass all in that of the other, but for the two that mesh?
bool WheelSharing::passWith(std::optional<GearOrdinal> tail, const TrainWheel& tailWheel,
                            std::optional<GearOrdinal> head, const TrainWheel& headWheel) const {
  const auto tails = planeOf(tail), heads = planeOf(head);
  if (!tails.empty() && tails.data() == heads.data()) return true;
  if (tails.size() + heads.size() > kMaxAsked) return true;
  const WheelDisc newTail = roundOf(tailWheel), newHead = roundOf(headWheel);
  const auto passes = [&](GearOrdinal tailAt, GearOrdinal headAt) {
    if (tailAt == tail.value_or(-1) && headAt == head.value_or(-1)) return true;
    return pass(tailAt < 0 ? newTail : *m_rounds[tailAt], headAt < 0 ? newHead : *m_rounds[headAt]);
  };
  const GearOrdinal none[] = {-1};
  const std::span<const GearOrdinal> all = tails.empty() ? none : tails,
                                     others = heads.empty() ? none : heads;
  return std::all_of(all.begin(), all.end(), [&](GearOrdinal a) {
    return std::all_of(others.begin(), others.end(), [&](GearOrdinal b) { return passes(a, b); });
  });
}

WheelSharing::Choice WheelSharing::choose(const TrainWheel& tail, std::span<const GearOrdinal> tails,
                                          const TrainWheel& head, std::span<const GearOrdinal> heads) const {
  for (const int t : tails) {
    for (const int h : heads) {
      if (passWith(t, tail, h, head)) return {t, h};
    }
  }
  for (const int t : tails) {
    if (passWith(t, tail, {}, head)) return {t, {}};
  }
  for (const int h : heads) {
    if (passWith({}, tail, h, head)) return {{}, h};
  }
  return {};
}

/// The wheel's plane; a new one where it has none.
WheelSharing::PlaneOrdinal WheelSharing::take(GearOrdinal wheel, const TrainWheel& as) {
  if (m_rounds.count() <= wheel) {
    m_rounds.resize(static_cast<std::size_t>(wheel) + 1);
    m_planes.resize(static_cast<std::size_t>(wheel) + 1, -1);
  }
  if (!m_rounds[wheel]) {
    m_rounds[wheel] = roundOf(as);
    m_planes[wheel] = m_wheels.count();
    m_wheels.push_back({wheel});
  }
  return m_planes[wheel];
}

void WheelSharing::join(GearOrdinal tail, const TrainWheel& tailWheel, GearOrdinal head,
                        const TrainWheel& headWheel) {
  PlaneOrdinal into = take(tail, tailWheel), from = take(head, headWheel);
  if (into == from) return;
  if (m_wheels[into].size() < m_wheels[from].size()) std::swap(into, from);
  for (const GearOrdinal w : m_wheels[from]) {
    m_planes[w] = into;
    m_wheels[into].push_back(w);
  }
  m_wheels[from].clear();
}

}  // namespace geargraph
