#include "core/mechanism/geometry_edits/teeth_fit.h"

#include <algorithm>
#include <set>
#include <string>

#include "core/foundations/base/translation.h"
#include "core/mechanism/geometry_edits/pin_rejection.h"
#include "core/mechanism/model/pins.h"

namespace geargraph {
namespace {

constexpr int kMinFollowing = 4;  ///< fewer teeth nobody cuts

class TeethFitter {
 public:
  TeethFitter(const Mechanism& mechanism, const Placement& placement, const WheelMap& wheels,
              const MeshChange& change)
      : m_mechanism(mechanism), m_placement(placement), m_wheels(wheels), m_change(change) {
    for (int end = 0; end < 2 * mechanism.c(); ++end) m_fit.teeth.push_back(teethOf(mechanism, end));
    for (MeshOrdinal mesh = 0; mesh < mechanism.c(); ++mesh) {
      if (hasParallelAxes(geometry(mesh).kind)) m_pairs[axisPairOf(geometry(mesh))].push_back(mesh);
    }
    for (int wheel = 0; wheel < wheels.count(); ++wheel) {
      if (isPinned(linkOf(wheels.ends(wheel).front()))) m_pinned.insert(wheel);
    }
  }

  Expected<TeethFit> run() {
    const int tail = 2 * m_change.mesh;
    if (m_change.tailTeeth != teethOf(m_mechanism, tail)) type(m_wheels.wheelOf(tail), m_change.tailTeeth);
    if (m_change.headTeeth != teethOf(m_mechanism, tail + 1))
      type(m_wheels.wheelOf(tail + 1), m_change.headTeeth);
    if (m_change.kind != geometry(m_change.mesh).kind)
      settle(axisPairOf(geometry(m_change.mesh)), m_change.mesh);
    while (m_rejections.empty()) {
      const auto next = nextPair();
      if (!next) break;
      settle(next->first, next->second);
    }
    // Also of meshes that no pair was settled by: their gears may have been given equal teeth.
    for (MeshOrdinal mesh = 0; m_rejections.empty() && mesh < m_mechanism.c(); ++mesh) {
      if (newReach(mesh) == 0) rejectEqual(mesh);
    }
    if (!m_rejections.empty()) return std::move(m_rejections);
    return std::move(m_fit);
  }

 private:
  [[nodiscard]] const MeshGeometry& geometry(MeshOrdinal mesh) const { return *m_placement.meshes[mesh]; }
  [[nodiscard]] MeshKind kindOf(MeshOrdinal mesh) const {
    return mesh == m_change.mesh ? m_change.kind : geometry(mesh).kind;
  }
  [[nodiscard]] int oldReach(MeshOrdinal mesh) const {
    return distanceTeeth(geometry(mesh).kind, teethOf(m_mechanism, 2 * mesh),
                         teethOf(m_mechanism, 2 * mesh + 1));
  }
  [[nodiscard]] int newReach(MeshOrdinal mesh) const {
    return distanceTeeth(kindOf(mesh), m_fit.teeth[static_cast<std::size_t>(2 * mesh)],
                         m_fit.teeth[static_cast<std::size_t>(2 * mesh + 1)]);
  }

  [[nodiscard]] const Link& linkOf(int end) const {
    const MeshGeometry& mesh = geometry(end / 2);
    return m_mechanism.links[isTailEnd(end) ? mesh.tail : mesh.head];
  }

  void type(int wheel, int teeth) {
    m_typed.insert(wheel);
    setTeeth(wheel, teeth);
  }

  void setTeeth(int wheel, int teeth) {
    std::vector<int> all = m_wheels.identicalPlanets(wheel);
    all.push_back(wheel);
    for (const int each : all) {
      if (m_pinned.contains(each)) rejectPinned(m_wheels.ends(each).front() / 2);
      m_changed.insert(each);
      for (const int end : m_wheels.ends(each)) m_fit.teeth[static_cast<std::size_t>(end)] = teeth;
    }
  }

  [[nodiscard]] bool isChanged(MeshOrdinal mesh) const {
    return m_changed.contains(m_wheels.wheelOf(2 * mesh)) ||
           m_changed.contains(m_wheels.wheelOf(2 * mesh + 1));
  }

  /// A pinned module is kept before others, and one of an external pair before that of an internal one.
  [[nodiscard]] int rankAsBase(MeshOrdinal mesh) const {
    return (isPinned(m_mechanism.gearMeshes[mesh]) ? 2 : 0) + (hasRing(kindOf(mesh)) ? 0 : 1);
  }

  /// A pair with a changed wheel that has no distance yet, and the mesh that gives it one.
  [[nodiscard]] std::optional<std::pair<AxisPair, int>> nextPair() const {
    for (const auto& [pair, meshes] : m_pairs) {
      if (m_fit.scales.contains(pair)) continue;
      int base = -1;
      for (const MeshOrdinal mesh : meshes) {
        if (!isChanged(mesh)) continue;
        if (base < 0 || rankAsBase(mesh) > rankAsBase(base)) base = mesh;
      }
      if (base >= 0) return std::pair(pair, base);
    }
    return std::nullopt;
  }

  void settle(const AxisPair& pair, int base) {
    if (newReach(base) == 0) return rejectEqual(base);
    const bool stays = areBothPinned(pair);
    for (const MeshOrdinal mesh : m_pairs.at(pair)) {
      if (mesh != base && !stays) bend(base, mesh);
    }
    if (stays) follow(base, Rational(1), true);
    const Rational scale = stays ? Rational(1) : Rational(newReach(base), oldReach(base));
    m_fit.scales[pair] = scale;
    m_given.insert({m_wheels.wheelOf(2 * base), m_wheels.wheelOf(2 * base + 1)});
    for (const MeshOrdinal mesh : m_pairs.at(pair)) {
      if (mesh != base) follow(mesh, scale, stays);
    }
  }

  [[nodiscard]] bool areBothPinned(const AxisPair& pair) const {
    return isPinned(axisOfClass(m_mechanism, m_placement, pair.first)) &&
           isPinned(axisOfClass(m_mechanism, m_placement, pair.second));
  }

  /// Where both wheels of `mesh` are held, one of them by a pin, and the other is the base's too: the count
  /// of that one with which both meshes get one distance.
  void bend(int base, MeshOrdinal mesh) {
    const Rational wanted = Rational(newReach(base), oldReach(base)) * Rational(oldReach(mesh));
    if (wanted == Rational(newReach(mesh)) || followingEnd(mesh, base) >= 0) return;
    for (const int end : {2 * mesh, 2 * mesh + 1}) {
      const int wheel = m_wheels.wheelOf(end);
      if (!m_pinned.contains(m_wheels.wheelOf(otherEnd(end))) || isHeld(wheel)) continue;
      for (const int own : {2 * base, 2 * base + 1}) {
        if (m_wheels.wheelOf(own) != wheel) continue;
        // (s z + k) / old is the same for both meshes.
        const auto [signB, restB] = distanceForm(own);
        const auto [signM, restM] = distanceForm(end);
        const int slope = signB * oldReach(mesh) - signM * oldReach(base);
        const int rest = restM * oldReach(base) - restB * oldReach(mesh);
        const bool whole = slope != 0 && rest % slope == 0 && rest / slope >= kMinFollowing;
        return whole ? setTeeth(wheel, rest / slope) : rejectPinned(mesh);
      }
    }
  }

  /// The mesh's reach by the teeth of the end.
  [[nodiscard]] DistanceForm distanceForm(int end) const {
    const bool isLarger = teethOf(m_mechanism, end) > teethOf(m_mechanism, otherEnd(end));
    return pairKind(kindOf(end / 2))
        .distanceForm(m_fit.teeth[static_cast<std::size_t>(otherEnd(end))], isLarger);
  }

  /// `strict`: the axes cannot give way, so that a wheel has to.
  void follow(MeshOrdinal mesh, const Rational& scale, bool strict) {
    const Rational wanted = scale * Rational(oldReach(mesh));
    if (wanted == Rational(newReach(mesh)) || (!wanted.isInteger() && !strict)) return;
    const int reachWanted = static_cast<int>(wanted.toDouble());
    const int end = followingEnd(mesh);
    if (end < 0) {
      if (strict || m_pinned.contains(m_wheels.wheelOf(2 * mesh)) ||
          m_pinned.contains(m_wheels.wheelOf(2 * mesh + 1)))
        rejectPinned(mesh);
      return;
    }
    const auto [sign, rest] = distanceForm(end);
    const int teeth = sign * (reachWanted - rest);
    if (teeth < kMinFollowing || teeth > kMaxTeeth) {
      const LinkOrdinal link = isTailEnd(end) ? geometry(mesh).tail : geometry(mesh).head;
      return reject(mesh,
                    translated("gear %1 would need %2 teeth to stay coaxial. What fits: a smaller change.",
                               {std::to_string(m_mechanism.linkLabel(link)), std::to_string(teeth)}));
    }
    setTeeth(m_wheels.wheelOf(end), teeth);
    m_given.insert(m_wheels.wheelOf(end));
  }

  /// Are the wheel's teeth given, typed or pinned?
  [[nodiscard]] bool isHeld(int wheel) const {
    return m_given.contains(wheel) || m_typed.contains(wheel) || m_pinned.contains(wheel);
  }

  /// The end whose wheel is not given: of two, the one that no changed wheel is, of an internal pair the
  /// ring. No wheel of the mesh `without` counts.
  [[nodiscard]] int followingEnd(MeshOrdinal mesh, int without = -1) const {
    int best = -1;
    for (const int end : {2 * mesh, 2 * mesh + 1}) {
      const int wheel = m_wheels.wheelOf(end);
      if (isHeld(wheel) || m_changed.contains(wheel)) continue;
      if (without >= 0 &&
          (wheel == m_wheels.wheelOf(2 * without) || wheel == m_wheels.wheelOf(2 * without + 1)))
        continue;
      if (best < 0 || teethOf(m_mechanism, end) > teethOf(m_mechanism, best)) best = end;
    }
    return best;
  }

  void rejectPinned(MeshOrdinal mesh) {
    if (m_rejections.empty()) m_rejections.push_back(pinRejection(m_mechanism, m_placement, mesh));
  }

  void rejectEqual(MeshOrdinal mesh) {
    reject(mesh, translated("an internal pair needs different tooth counts, the ring the larger one."));
  }

  void reject(MeshOrdinal mesh, const std::string& why) {
    const GearMesh& element = m_mechanism.gearMeshes[mesh];
    const GearMesh& edited = m_mechanism.gearMeshes[m_change.mesh];
    m_rejections.push_back({Code::teethGeometry,
                            translated("Mesh %1: %2", {std::to_string(m_mechanism.meshLabel(mesh)), why}),
                            {element.id, element.tail, element.head, edited.id},
                            {},
                            0,
                            0});
  }

  const Mechanism& m_mechanism;
  const Placement& m_placement;
  const WheelMap& m_wheels;
  MeshChange m_change;
  TeethFit m_fit;
  std::map<AxisPair, std::vector<int>> m_pairs;
  std::set<int> m_pinned;   ///< wheels
  std::set<int> m_typed;    ///< wheels whose teeth the change names
  std::set<int> m_changed;  ///< wheels with new teeth
  std::set<int> m_given;    ///< wheels whose teeth a settled pair stands on
  Diagnostics m_rejections;
};

}  // namespace

AxisPair axisPairOf(const MeshGeometry& geometry) {
  return {std::min(geometry.tailClass, geometry.headClass), std::max(geometry.tailClass, geometry.headClass)};
}

Expected<TeethFit> fitTeeth(const Mechanism& mechanism, const Placement& placement, const WheelMap& wheels,
                            const MeshChange& change) {
  return TeethFitter(mechanism, placement, wheels, change).run();
}

}  // namespace geargraph
