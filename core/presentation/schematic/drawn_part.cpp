#include "core/presentation/schematic/drawn_part.h"

#include <set>
#include <unordered_map>

#include "core/mechanism/placement/planet_groups.h"

namespace geargraph {
namespace {

using Positions = std::unordered_map<LinkId, std::size_t>;

Positions positionsOf(const Mechanism& mechanism) {
  Positions positions;
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) positions[mechanism.links[i].id] = i;
  return positions;
}

/// Which links and joints make the tree round the ground.
struct Reached {
  std::vector<bool> links;
  std::vector<bool> joints;
};

Reached reachedFromGround(const Mechanism& mechanism, const Positions& positions) {
  std::vector<std::vector<std::size_t>> jointsAt(mechanism.links.size());
  for (std::size_t j = 0; j < mechanism.turningJoints.size(); ++j) {
    jointsAt[positions.at(mechanism.turningJoints[j].tail)].push_back(j);
    jointsAt[positions.at(mechanism.turningJoints[j].head)].push_back(j);
  }
  Reached reached{std::vector<bool>(mechanism.links.size()),
                  std::vector<bool>(mechanism.turningJoints.size())};
  std::vector<std::size_t> queue{0};
  reached.links[0] = true;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (const std::size_t j : jointsAt[queue[next]]) {
      const TurningJoint& joint = mechanism.turningJoints[j];
      const std::size_t tail = positions.at(joint.tail);
      const std::size_t other = tail == queue[next] ? positions.at(joint.head) : tail;
      if (reached.links[other]) continue;
      reached.links[other] = true;
      reached.joints[j] = true;
      queue.push_back(other);
    }
  }
  return reached;
}

/// Takes elements out of a part, keeping its labels in step.
class PartFilter {
 public:
  explicit PartFilter(DrawnPart& part) : m_part(part) {}

  void keep(const std::vector<bool>& links, const std::vector<bool>& joints,
            const std::vector<bool>& meshes) {
    Mechanism& m = m_part.mechanism;
    std::set<AxisId> dropped;
    std::set<AxisId> used;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      (joints[j] ? used : dropped).insert(m.turningJoints[j].axis);
    }
    std::set<LinkId> gone;
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (!links[i]) gone.insert(m.links[i].id);
    }
    std::set<JointId> goneJoints;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      if (!joints[j]) goneJoints.insert(m.turningJoints[j].id);
    }
    thin(m.links, m_part.linkLabels, links);
    thin(m.turningJoints, m_part.jointLabels, joints);
    thin(m.gearMeshes, m_part.meshLabels, meshes);
    std::erase_if(m.axes, [&](const Axis& a) { return dropped.contains(a.id) && !used.contains(a.id); });
    std::erase_if(m.wheels, [&](const Wheel& wheel) { return gone.contains(wheel.link); });
    if (m.inputs) std::erase_if(*m.inputs, [&](const Input& i) { return goneJoints.contains(i.joint); });
  }

 private:
  template <class Element>
  static void thin(std::vector<Element>& elements, std::vector<int>& labels, const std::vector<bool>& kept) {
    std::vector<Element> left;
    std::vector<int> leftLabels;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (!kept[i]) continue;
      left.push_back(std::move(elements[i]));
      leftLabels.push_back(labels[i]);
    }
    elements = std::move(left);
    labels = std::move(leftLabels);
  }

  DrawnPart& m_part;
};

std::vector<bool> meshesBetween(const Mechanism& mechanism, const Positions& positions,
                                const std::vector<bool>& links) {
  std::vector<bool> kept;
  for (const GearMesh& mesh : mechanism.gearMeshes) {
    kept.push_back(links[positions.at(mesh.tail)] && links[positions.at(mesh.head)]);
  }
  return kept;
}

void dropUntied(DrawnPart& part) {
  const Mechanism& m = part.mechanism;
  const Positions positions = positionsOf(m);
  const Reached reached = reachedFromGround(m, positions);
  for (std::size_t i = 0; i < m.links.size(); ++i) {
    if (!reached.links[i]) part.loose.push_back(part.linkLabels[i]);
  }
  for (std::size_t j = 0; j < m.turningJoints.size(); ++j) {
    const bool tied = reached.links[positions.at(m.turningJoints[j].tail)];
    if (!reached.joints[j] && tied) part.closing.push_back(part.jointLabels[j]);
  }
  PartFilter(part).keep(reached.links, reached.joints, meshesBetween(m, positions, reached.links));
}

void omitIdentical(DrawnPart& part, const PlacedMechanism& placed) {
  const Mechanism& m = part.mechanism;
  const Placement& placement = placed.placement();
  if (!placement.tree) return;
  std::vector<bool> links(m.links.size(), true);
  std::vector<bool> joints(m.turningJoints.size(), true);
  for (const auto& set : equalPlanets(m, placement, PlanetScope::drawn)) {
    DrawnPart::Planets planets;
    planets.count = static_cast<int>(set.size());
    for (std::size_t g = 0; g < set.size(); ++g) {
      const PlanetGroup& group = set[g];
      for (std::size_t k = 0; k < group.links.size(); ++k) {
        const auto link = static_cast<std::size_t>(group.links[k]);
        const auto joint = static_cast<std::size_t>(group.joints[k]);
        (g == 0 ? planets.drawn : planets.others).push_back(part.linkLabels[link]);
        if (g == 0) continue;
        links[link] = joints[joint] = false;
        part.represented.push_back({m.links[set[0].links[k]].id, m.links[link].id});
        part.represented.push_back({m.turningJoints[set[0].joints[k]].id, m.turningJoints[joint].id});
      }
      for (std::size_t k = 0; g > 0 && k < group.meshes.size(); ++k) {
        part.represented.push_back({m.gearMeshes[set[0].meshes[k]].id, m.gearMeshes[group.meshes[k]].id});
      }
    }
    part.planets.push_back(std::move(planets));
  }
  PartFilter(part).keep(links, joints, meshesBetween(m, positionsOf(m), links));
}

}  // namespace

DrawnPart drawnPart(const PlacedMechanism& document) {
  const Mechanism& mechanism = document.mechanism();
  DrawnPart part;
  part.mechanism = mechanism;
  for (int i = 0; i <= mechanism.n(); ++i) part.linkLabels.push_back(mechanism.linkLabel(i));
  for (int j = 0; j < mechanism.t(); ++j) part.jointLabels.push_back(mechanism.jointLabel(j));
  for (int m = 0; m < mechanism.c(); ++m) part.meshLabels.push_back(mechanism.meshLabel(m));
  dropUntied(part);
  omitIdentical(part, part.isWhole() ? document : PlacedMechanism(part.mechanism));
  return part;
}

}  // namespace geargraph
