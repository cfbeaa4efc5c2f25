#include "core/teaching/derivation/comparison_families.h"

#include <memory>
#include <string>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

/// Adds links, axes, joints and meshes with ids that count up.
class Sketch {
 public:
  explicit Sketch(std::string name) {
    m_mechanism.name = std::move(name);
    m_mechanism.links.push_back({LinkId("0"), "ground"});
  }

  int axis(const NumberTriple& point, const NumberTriple& direction) {
    const int position = static_cast<int>(m_mechanism.axes.size());
    m_mechanism.axes.push_back({AxisId("a" + std::to_string(position)), point, direction});
    return position;
  }
  int link(int parent, int axis) {
    const int position = static_cast<int>(m_mechanism.links.size());
    m_mechanism.links.push_back({LinkId(std::to_string(position)), {}});
    m_mechanism.turningJoints.push_back({JointId("j" + std::to_string(position)), id(parent), id(position),
                                         m_mechanism.axes[axis].id, Number(0)});
    return position;
  }
  void mesh(int tail, int tailTeeth, int head, int headTeeth, MeshKind kind, const NumberTriple& pitchPoint) {
    GearMesh mesh;
    mesh.id = MeshId("m" + std::to_string(m_mechanism.gearMeshes.size()));
    mesh.tail = id(tail);
    mesh.head = id(head);
    mesh.tailTeeth = tailTeeth;
    mesh.headTeeth = headTeeth;
    mesh.kind = kind;
    mesh.pitchPoint = pitchPoint;
    m_mechanism.gearMeshes.push_back(std::move(mesh));
  }
  [[nodiscard]] Mechanism take() { return std::move(m_mechanism); }

 private:
  [[nodiscard]] LinkId id(int link) const { return m_mechanism.links[link].id; }
  Mechanism m_mechanism;
};

/// Teeth that differ from gear to gear: no product of ratios is 1.
int teethOf(int gear) {
  return 17 + gear;
}

NumberTriple place(int x, int y, int z) {
  return {x, y, z};
}

/// Module 2: a gear of N teeth has the radius N.
Mechanism chainOf(int gears) {
  Sketch sketch("Chain of " + std::to_string(gears) + " gears");
  int x = 0;
  int before = 0;
  for (int gear = 0; gear < gears; ++gear) {
    if (gear > 0) x += teethOf(gear - 1) + teethOf(gear);
    const int link = sketch.link(0, sketch.axis(place(x, 0, 0), place(0, 0, 1)));
    if (gear > 0) {
      sketch.mesh(before, teethOf(gear - 1), link, teethOf(gear), MeshKind::external,
                  place(x - teethOf(gear), 0, 0));
    }
    before = link;
  }
  return sketch.take();
}

Mechanism stackOf(int sets) {
  Sketch sketch(std::to_string(sets) + " planetary sets in line");
  const int center = sketch.axis(place(0, 0, 0), place(0, 0, 1));
  int sun = sketch.link(0, center);
  for (int set = 0; set < sets; ++set) {
    const int sunTeeth = teethOf(2 * set) + 2;
    const int planetTeeth = teethOf(2 * set + 1);
    const int z = 30 * set;
    const int carrier = sketch.link(0, center);
    const int planet = sketch.link(carrier, sketch.axis(place(sunTeeth + planetTeeth, 0, 0), place(0, 0, 1)));
    sketch.mesh(sun, sunTeeth, planet, planetTeeth, MeshKind::external, place(sunTeeth, 0, z));
    sketch.mesh(planet, planetTeeth, 0, sunTeeth + 2 * planetTeeth, MeshKind::internal,
                place(sunTeeth + 2 * planetTeeth, 0, z));
    sun = carrier;
  }
  return sketch.take();
}

/// Axes z, x, z, x, ... through the origin. Arm d is driven by d gears, one about each axis up to its own, of
/// which the last is the arm itself.
Mechanism wristOf(int arms) {
  Sketch sketch("Wrist of " + std::to_string(arms) + " arms");
  std::vector<int> axes;
  for (int arm = 0; arm < arms; ++arm)
    axes.push_back(sketch.axis(place(0, 0, 0), arm % 2 == 0 ? place(0, 0, 1) : place(1, 0, 0)));
  std::vector<int> armLinks{0};
  for (int arm = 0; arm < arms; ++arm)
    armLinks.push_back(sketch.link(armLinks.back(), axes[static_cast<std::size_t>(arm)]));
  int pair = 0;
  for (int driven = 2; driven <= arms; ++driven) {
    int before = sketch.link(0, axes.front());
    for (int level = 2; level <= driven; ++level, ++pair) {
      const bool isArm = level == driven;
      const int link = isArm ? armLinks[static_cast<std::size_t>(driven)]
                             : sketch.link(armLinks[static_cast<std::size_t>(level) - 1],
                                           axes[static_cast<std::size_t>(level) - 1]);
      const int tailTeeth = teethOf(pair);
      const int headTeeth = teethOf(pair + 1);
      // The radius of a gear is its distance from its axis: along the other axis for axes at right angles.
      const int size = driven;
      const bool isTailUpright = level % 2 == 0;  // axis level - 1 is z
      sketch.mesh(before, tailTeeth, link, headTeeth, MeshKind::bevel,
                  isTailUpright ? place(size * tailTeeth, 0, size * headTeeth)
                                : place(size * headTeeth, 0, size * tailTeeth));
      before = link;
    }
  }
  return sketch.take();
}

/// Uses the first step of the analysis only: the second one checks all wheels for collisions, which took
/// over 80 % of the time.
FamilyCount countOf(TrainFamily family, int size) {
  const SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(familyTrain(family, size)));
  const auto comparison = compareMethods(*snapshot, ComparisonDepth::numbers);
  GEARGRAPH_REQUIRE(comparison.has_value());
  return {family,
          size,
          comparison->links,
          comparison->meshes,
          comparison->matroid.setUp,
          comparison->matroid.numbers,
          comparison->ttGraph.numbers};
}

}  // namespace

std::string familyName(TrainFamily family) {
  switch (family) {
    case TrainFamily::chain:
      return translated("gears in a row");
    case TrainFamily::stack:
      return translated("planetary sets in line");
    case TrainFamily::wrist:
      return translated("arms of a bevel-gear wrist");
  }
  return "";
}

std::string familyText(TrainFamily family, int size) {
  return std::to_string(size) + ' ' + familyName(family);
}

Mechanism familyTrain(TrainFamily family, int size) {
  switch (family) {
    case TrainFamily::chain:
      GEARGRAPH_REQUIRE(size >= 2);
      return chainOf(size);
    case TrainFamily::stack:
      GEARGRAPH_REQUIRE(size >= 1);
      return stackOf(size);
    case TrainFamily::wrist:
      GEARGRAPH_REQUIRE(size >= 1);
      return wristOf(size);
  }
  return emptyMechanism();
}

const std::vector<FamilyCount>& familyCounts() {
  static const std::vector<FamilyCount> counts = [] {
    std::vector<FamilyCount> all;
    for (const int size : {2, 4, 8, 16, 32}) all.push_back(countOf(TrainFamily::chain, size));
    for (const int size : {2, 3, 4, 8, 16}) all.push_back(countOf(TrainFamily::stack, size));
    for (const int size : {2, 3, 4, 5, 6}) all.push_back(countOf(TrainFamily::wrist, size));
    return all;
  }();
  return counts;
}

}  // namespace geargraph
