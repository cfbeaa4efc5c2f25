#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/foundations/base/translation.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/train_diagnostics.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// A gear beside another that it meshes with, and where it stands about that one's axis.
struct Planet {
  GearOrdinal gear = 0;
  double azimuth = 0;
};

class NeighbourFinder {
 public:
  NeighbourFinder(const Mechanism& mechanism, const Placement& placement, const GearTrain& train)
      : m_mechanism(mechanism), m_train(train) {
    for (const TrainMesh& mesh : train.meshes) {
      const LinkOrdinal carrier = placement.meshes[mesh.mesh]->carrier;
      addPlanet(mesh.tailGear, mesh.headGear, carrier);
      addPlanet(mesh.headGear, mesh.tailGear, carrier);
      m_said.insert(std::minmax(&gear(mesh.tailGear), &gear(mesh.headGear)));
    }
    for (auto& [centre, planets] : m_planets) check(gear(centre.first), planets);
  }

  Diagnostics found;

 private:
  [[nodiscard]] const TrainGear& gear(int g) const { return m_train.gears[static_cast<std::size_t>(g)]; }
  void addPlanet(int centre, int planet, LinkOrdinal carrier);
  void check(const TrainGear& centre, std::vector<Planet>& planets);
  void report(const TrainGear& centre, const TrainGear& a, const TrainGear& b, double overlap);
  /// Modules by which the tips of both reach into each other; below 0 they pass.
  [[nodiscard]] static double overlap(const TrainGear& a, const TrainGear& b);

  const Mechanism& m_mechanism;
  const GearTrain& m_train;
  std::map<std::pair<int, int>, std::vector<Planet>> m_planets;    ///< by centre and carrier
  std::set<std::pair<const TrainGear*, const TrainGear*>> m_said;  ///< pairs that mesh, or were met: a sun
                                                                   ///< and a ring have the same planets
};

void NeighbourFinder::addPlanet(int centre, int planet, LinkOrdinal carrier) {
  const TrainGear& middle = gear(centre);
  const TrainGear& round = gear(planet);
  if (isRing(round.spec) || round.spec.coneAngle > pi / 2) return;  // a ring about the centre
  const bool bevel = isConical(round.spec);
  const Vector3d out = bevel ? Vector3d(round.pose.linear().col(2))
                             : Vector3d(round.pose.translation() - middle.pose.translation());
  const Vector3d seen = middle.pose.linear().transpose() * out;
  m_planets[{centre, carrier}].push_back({planet, std::atan2(seen.y(), seen.x())});
}

double NeighbourFinder::overlap(const TrainGear& a, const TrainGear& b) {
  const Vector3d axis = a.pose.linear().col(2);
  if (isConical(a.spec)) {
    const auto tipCone = [](const GearSpec& spec) {
      return spec.coneAngle +
             std::atan((spec.addendum + spec.profileShift) * spec.module / coneDistance(spec));
    };
    const double angle = std::acos(std::clamp(axis.dot(b.pose.linear().col(2)), -1.0, 1.0));
    return (tipCone(a.spec) + tipCone(b.spec) - angle) * coneDistance(a.spec) / a.spec.module;
  }
  const Vector3d apart = b.pose.translation() - a.pose.translation();
  const double along = apart.dot(axis);
  if (std::abs(along) >= (a.spec.faceWidth + b.spec.faceWidth) / 2) return -1;
  const double distance = (apart - along * axis).norm();
  return (nominalTipRadius(a.spec) + nominalTipRadius(b.spec) - distance) / a.spec.module;
}

void NeighbourFinder::check(const TrainGear& centre, std::vector<Planet>& planets) {
  if (planets.size() < 2) return;
  std::sort(planets.begin(), planets.end(),
            [](const Planet& a, const Planet& b) { return a.azimuth < b.azimuth; });
  for (std::size_t i = 0; i < planets.size(); ++i) {
    const TrainGear& a = gear(planets[i].gear);
    const TrainGear& b = gear(planets[(i + 1) % planets.size()].gear);
    if (a.axisGroup == b.axisGroup || a.spec.kind != b.spec.kind) continue;
    constexpr double kTouch = 1e-6;
    const double depth = overlap(a, b);
    if (depth > kTouch && m_said.insert(std::minmax(&a, &b)).second) report(centre, a, b, depth);
  }
}

void NeighbourFinder::report(const TrainGear& centre, const TrainGear& a, const TrainGear& b, double depth) {
  const auto label = [&](const TrainGear& g) { return std::to_string(m_mechanism.linkLabel(g.link)); };
  std::string message =
      translated("The wheels of links %1 and %2 beside gear %3 interfere: their tips overlap by %4 modules.",
                 {label(a), label(b), centre.name, fixedText(depth, 2)});
  message += ' ';
  const double orbit =
      (a.pose.translation() - centre.pose.translation()).cross(Vector3d(centre.pose.linear().col(2))).norm();
  const double tip = nominalTipRadius(a.spec);
  if (a.spec == b.spec && isDisc(a.spec) && tip < orbit) {
    message += translated("At most %1 of them fit round it, at equal distances.",
                          {std::to_string(static_cast<int>(pi / std::asin(tip / orbit)))});
  } else {
    message += translated("Move one of them, or give it fewer teeth.");
  }
  std::vector<ElementId> elements;
  for (const TrainGear* g : {&a, &b}) {
    elements.emplace_back(m_mechanism.links[g->link].id);
  }
  found.push_back(makeDiagnostic(Detail::planetsOverlap, std::move(message), std::move(elements)));
}

}  // namespace

Diagnostics neighbourDiagnostics(const Mechanism& mechanism, const Placement& placement,
                                 const GearTrain& train) {
  return NeighbourFinder(mechanism, placement, train).found;
}

}  // namespace geargraph
